#include <reports/document/data/json_proof.hpp>

#include <cmath>

namespace pmreport::document {

namespace {

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json json_of(const Bracket& b) { return Json::array({number(b.low), number(b.high)}); }

template <class Items, class One>
Json list_of(const Items& items, One&& one) {
  Json out = Json::array();
  for (const auto& item : items) out.push_back(one(item));
  return out;
}

Json json_of(const EveryInstant::Broken& b) {
  Json out{{"begin", json_of(b.begin)}, {"end", json_of(b.end)}};
  if (!b.side.empty()) out.update({{"side", b.side}, {"worst", json_of(b.worst)}});
  out["at"] = number(b.at);
  return out;
}

Json json_of(const EveryInstant::Claim& c) {
  Json out{{"about", c.about}};
  if (!c.subject.empty()) out.update({{"subject", c.subject}, {"unit", c.unit}, {"range", json_of(c.range)}});
  out["state"] = c.state;
  if (!c.reason.empty()) out["reason"] = c.reason;
  out["broken"] = list_of(c.broken, [](const auto& b) { return json_of(b); });
  out["undecided"] = list_of(c.undecided, [](const auto& b) { return json_of(b); });
  return out;
}

}  // namespace

Json json_of(const EveryInstant& p) {
  Json out{{"examined", p.unexamined.empty()}, {"sentence", p.sentence}};
  if (!p.unexamined.empty()) {
    out["reason"] = p.unexamined;
    return out;
  }
  out.update({{"begin", number(p.begin)},
              {"end", number(p.end)},
              {"intervals", p.intervals},
              {"evaluations", p.evaluations},
              {"exhausted", p.exhausted},
              {"resolution", number(p.resolution)}});
  out["claims"] = list_of(p.claims, [](const auto& c) { return json_of(c); });
  out["meetings"] = list_of(p.meetings, [](const auto& m) { return Json{{"what", m.what}, {"time", json_of(m.time)}}; });
  out["extremes"] = list_of(p.extremes, [](const auto& e) {
    return Json{{"column", e.column},
                {"unit", e.unit},
                {"least", json_of(e.least)},
                {"at_least", number(e.at_least)},
                {"largest", json_of(e.largest)},
                {"at_largest", number(e.at_largest)}};
  });
  return out;
}

}  // namespace pmreport::document
