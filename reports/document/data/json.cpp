#include <algorithm>
#include <cmath>
#include <reports/document/data/json_proof.hpp>
#include <reports/document/data/results.hpp>
#include <reports/document/data/sha256.hpp>
#include <reports/document/names.hpp>
#include <reports/document/tally.hpp>
#include <reports/document/text.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

namespace {

// JSON has no NaN: null, and the status that every number carries says why.
void put_number(Json& into, const char* key, double value) { into[key] = std::isfinite(value) ? Json(value) : Json(nullptr); }
const char* status_of(double value) { return std::isfinite(value) ? "ok" : "not finite"; }

// "not_decided", a key.
std::string key_of(Verdict verdict) {
  std::string key = word_of(verdict);
  std::ranges::replace(key, ' ', '_');
  return key;
}

Json json_of(const Tally& tally) {
  Json out{{"total", tally.total()}};
  for (std::size_t i = 0; i < verdicts; ++i) out[key_of(static_cast<Verdict>(i))] = tally.counts[i];
  return out;
}

Json json_of(const Evidence& line) {
  const Verdict verdict = line.verdict();
  Json out{{"claim", line.claim}, {"how", line.how}, {"state", key_of(verdict)}, {"passed", verdict == Verdict::passed}};
  put_number(out, "value", line.value);
  out["status"] = line.stated ? word_of(*line.stated) : status_of(line.value);
  if (!line.reason.empty()) out["reason"] = line.reason;
  put_number(out, "tolerance", line.tolerance);
  out["unit"] = line.unit;
  return out;
}

Json json_of(const Check& check) {
  Json out{{"name", check.name}, {"passed", check.passed}, {"measured", check.measured}, {"limit", check.limit}};
  put_number(out, "value", check.value);
  out["status"] = status_of(check.value);
  put_number(out, "bound", check.bound);
  out["decided_by"] = check.proved ? "proof" : "samples";
  if (std::isfinite(check.bracket.low) && std::isfinite(check.bracket.high)) out["bracket"] = {check.bracket.low, check.bracket.high};
  out.update({{"unit", check.unit}, {"message", check.message}, {"line", check.line}});
  return out;
}

Json json_of(const Value& value) {
  Json out{{"section", value.section}, {"name", value.name}};
  put_number(out, "value", value.value);
  out["status"] = status_of(value.value);
  out["unit"] = value.unit;
  return out;
}

Json json_of(const KeyNumber& k) {
  Json out{{"what", k.what}, {"value", k.value}, {"limit", k.limit}, {"where", k.where}, {"section", k.section}};
  put_number(out, "number", k.number);
  put_number(out, "bound", k.bound);
  put_number(out, "used", k.used);
  out["unit"] = k.unit;
  return out;
}

Json json_of(const Input& i) {
  Json out{{"name", i.name}};
  if (!i.text.empty() || (i.numbers.empty() && !i.list))
    out["value"] = i.text;
  else
    out["value"] = i.list ? Json(i.numbers) : Json(i.numbers.front());
  out.update({{"unit", i.unit}, {"source", i.source}, {"line", i.line > 0 ? Json(i.line) : Json()}});
  return out;
}

Json json_of(const Finding& f) { return {{"kind", name_of(f.kind)}, {"text", f.text}, {"section", f.section}}; }

template <class Items>
Json list_of(const Items& items) {
  Json out = Json::array();
  for (const auto& item : items) out.push_back(json_of(item));
  return out;
}

void add_warnings(Json& out, const std::string& section, const Paragraph& paragraph) {
  const Json told{{"section", section}, {"text", paragraph.text}};
  if (paragraph.tone == Paragraph::Tone::warning && std::ranges::find(out, told) == out.end()) out.push_back(told);
}

Json warnings_of(const Report& r) {
  Json out = Json::array();
  for (const Finding& f : r.findings)
    if (f.kind == Finding::Kind::fault) out.push_back({{"section", f.section}, {"text", f.text}});
  for (const Section& section : r.sections) {
    for (const Block& block : section.blocks) {
      if (const auto* paragraph = std::get_if<Paragraph>(&block)) add_warnings(out, section.id, *paragraph);
    }
  }
  return out;
}

Json sections_of(const Report& r) {
  Json out = Json::array();
  for (const Section& section : r.sections) {
    Json evidence = Json::array();
    for (const Block& block : section.blocks) {
      const auto* proof = std::get_if<Proof>(&block);
      if (!proof) continue;
      for (const Evidence& line : proof->lines) evidence.push_back(json_of(line));
    }
    const bool passed = tally_evidence(section).failed() == 0;
    out.push_back(
        {{"id", section.id}, {"kind", section.kind}, {"title", clean(section.title)}, {"passed", passed}, {"evidence", evidence}});
  }
  return out;
}

Json figure_list(const Report& r, const Names& names) {
  Json out = Json::array();
  const auto figures = figures_of(r);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string stem = "figures/" + names.figures[i];
    out.push_back({{"id", figures[i]->id},
                   {"caption", figures[i]->caption},
                   {"svg", stem + ".svg"},
                   {"pdf", stem + ".pdf"},
                   {"data", data_file(r, names, *figures[i])}});
  }
  return out;
}

Json snapshot_list(const Report& r, const Names& names) {
  Json out = Json::array();
  const auto pictures = pictures_of(r);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    out.push_back({{"id", pictures[i]->id},
                   {"caption", pictures[i]->caption},
                   {"png", "snapshots/" + names.pictures[i] + ".png"},
                   {"width", pictures[i]->width},
                   {"height", pictures[i]->height}});
    if (!names.drawn[i]) continue;
    out.back()["svg"] = "snapshots/" + names.pictures[i] + ".svg";
    out.back()["pdf"] = "snapshots/" + names.pictures[i] + ".pdf";
  }
  return out;
}

Json data_list(const Report& r, const Names& names) {
  Json out = Json::array();
  for (std::size_t i = 0; i < r.data.size(); ++i) {
    const Data& data = r.data[i];
    out.push_back({{"name", data.name},
                   {"csv", "data/" + names.data[i] + ".csv"},
                   {"columns", data.headings},
                   {"rows", !data.words.empty()     ? data.words.front().size()
                            : !data.columns.empty() ? data.columns.front().size()
                                                    : 0}});
  }
  return out;
}

Json export_list(const Report& r, const Names& names) {
  Json out = Json::array();
  for (std::size_t i = 0; i < r.files.size(); ++i) {
    const File& file = r.files[i];
    out.push_back(
        {{"name", "data/" + names.files[i]}, {"title", clean(file.title)}, {"bytes", file.bytes.size()}, {"sha256", sha256(file.bytes)}});
  }
  return out;
}

}  // namespace

std::string to_json(const Report& r) {
  const Names names = names_of(r);
  const Provenance& from = r.provenance;
  Json out{{"schema", results_schema},
           {"schema_version", 2},
           {"title", clean(r.title)},
           {"author", clean(r.author)},
           {"description", clean(r.description)}};
  out["mechanism"] = {{"name", from.mechanism}, {"title", r.mechanism_title}, {"source", r.source}};
  out["provenance"] = {{"program", from.program},
                       {"version", from.version},
                       {"plugin_build", from.plugin_build},
                       {"scenario", from.scenario_name},
                       {"scenario_sha256", from.scenario_sha256}};
  out["verdict"] = {{"passed", r.passed()}, {"checks", json_of(tally_checks(r))}, {"evidence", json_of(tally_evidence(r))}};
  out["key_numbers"] = list_of(r.key_numbers);
  out["findings"] = list_of(r.findings);
  out["assumptions"] = r.assumptions;
  out["not_asked"] = r.not_asked;
  out["inputs"] = list_of(r.inputs);
  out["warnings"] = warnings_of(r);
  out["checks"] = list_of(r.checks);
  out["sections"] = sections_of(r);
  if (r.every_instant) out["proof"] = json_of(*r.every_instant);
  out["values"] = list_of(r.values);
  out["figures"] = figure_list(r, names);
  out["snapshots"] = snapshot_list(r, names);
  out["data"] = data_list(r, names);
  if (!r.files.empty()) out["exports"] = export_list(r, names);
  out["files"] = files_of(names);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<std::vector<std::string>> files_listed_in(const std::string& results) {
  const Json json = Json::parse(results, nullptr, false);
  if (!json.is_object() || json.value("schema", Json()) != results_schema) return std::nullopt;
  const Json files = json.value("files", Json());
  if (!files.is_array()) return std::nullopt;
  std::vector<std::string> out;
  for (const Json& file : files) {
    if (file.is_string()) out.push_back(file.get<std::string>());
  }
  return out;
}

}  // namespace pmreport::document
