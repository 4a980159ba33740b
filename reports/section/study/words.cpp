#include <reports/section/study/words.hpp>

#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

constexpr int digits = 5;
constexpr std::size_t reasons_told = 4;

bool wide(const Bracketed& x) { return x.width() > 0; }

}  // namespace

DisplayUnit unit_of(const StudyOptions& o, std::size_t number, const std::vector<const Judged*>& all) {
  double largest = 0;
  for (const Judged* j : all)
    if (j->made() && j->numbers[number].known()) largest = std::max(largest, std::abs(j->numbers[number].value));
  return display_unit(o.numbers[number].unit, largest);
}

DisplayUnit unit_of(const StudiedParameter& p) {
  return display_unit(p.unit, std::max({std::abs(p.from), std::abs(p.to), std::abs(p.own)}));
}

std::string cell(const Bracketed& x, const DisplayUnit& unit) {
  if (!x.known()) return "–";
  return wide(x) ? bracket_number({x.low, x.high}, unit.per_si) : typeset(format_number(x.value * unit.per_si, digits));
}

std::string cell(const std::vector<Bracketed>& numbers, std::size_t number, const DisplayUnit& unit) {
  return number < numbers.size() ? cell(numbers[number], unit) : "–";
}

std::string with_unit(const Bracketed& x, const std::string& unit) {
  if (!x.known()) return "no value";
  return wide(x) ? bracket({x.low, x.high}, unit) : show(x.value, unit, digits);
}

std::string heading(const std::string& name, const DisplayUnit& unit) {
  return unit.label.empty() ? name : fmt::format("{} [{}]", name, unit.label);
}

std::string place_of(const StudyOptions& o, const std::vector<double>& values) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < o.over.size(); ++i)
    out.push_back(fmt::format("{} = {}", o.over[i].name, show(values[i], o.over[i].unit, digits)));
  return listed(out, "and");
}

std::string remark(const Judged& j) {
  if (!j.made()) return printable(j.why);
  std::string out;
  for (const std::string& n : j.notes) out += (out.empty() ? "" : "; ") + printable(n);
  return out;
}

std::string change(const Bracketed& now, const Bracketed& before) {
  if (!now.known() || !before.known()) return "–";
  const analysis::Order order = order_of(now, before);
  if (order == analysis::Order::equal) return "the same";
  if (order == analysis::Order::open) return "not told apart";
  if (before.value == 0) return order == analysis::Order::greater ? "more" : "less";
  const double share = now.value / before.value - 1;
  return typeset(fmt::format("{:+.3g} %", 100 * share));
}

std::string failures(const std::vector<const Judged*>& all) {
  std::vector<std::pair<std::string, int>> reasons;
  int failed = 0;
  for (const Judged* j : all) {
    if (j->made()) continue;
    ++failed;
    const auto known = std::ranges::find(reasons, j->why, &std::pair<std::string, int>::first);
    if (known != reasons.end())
      ++known->second;
    else
      reasons.emplace_back(j->why, 1);
  }
  if (failed == 0) return {};
  std::ranges::stable_sort(reasons, [](const auto& x, const auto& y) { return x.second > y.second; });
  std::string out = fmt::format("{} of {} could not be made or judged: ", failed, plural(static_cast<int>(all.size()), "variant"));
  for (std::size_t i = 0; i < std::min(reasons.size(), reasons_told); ++i)
    out += fmt::format("{}{} ({})", i == 0 ? "" : "; ", printable(reasons[i].first), reasons[i].second);
  if (reasons.size() > reasons_told)
    out += fmt::format("; and {}", plural(static_cast<int>(reasons.size() - reasons_told), "other reason"));
  return out + ".";
}

std::string cut_off(const std::vector<const Judged*>& all) {
  const auto n = static_cast<int>(std::ranges::count_if(all, [](const Judged* j) { return j->cut_off; }));
  if (n == 0) return {};
  return fmt::format("The workspace of {} of {} may go on beyond the scanned range; what lies there does not count.", n,
                     plural(static_cast<int>(all.size()), "variant"));
}

void add_columns(const StudyOptions& o, const std::vector<const Judged*>& all, document::Data& data) {
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    const std::string& unit = o.numbers[n].unit;
    const auto number_of = [&](const Judged& j) { return n < j.numbers.size() ? j.numbers[n] : Bracketed{}; };
    const bool brackets = std::ranges::any_of(all, [&](const Judged* j) { return wide(number_of(*j)); });
    const auto column = [&](const char* which, double Bracketed::*part) {
      data.headings.push_back(fmt::format("{}{}{}", o.numbers[n].own, which, unit.empty() ? "" : " [" + unit + "]"));
      data.columns.emplace_back();
      for (const Judged* j : all) data.columns.back().push_back(number_of(*j).*part);
    };
    column("", &Bracketed::value);
    if (!brackets) continue;
    column("_low", &Bracketed::low);
    column("_high", &Bracketed::high);
  }
}

const std::string& title_of(const StudyOptions& o, std::size_t number) { return o.numbers[number].title; }

const std::string& label_of(const StudyOptions& o, std::size_t number) { return o.numbers[number].label; }

}  // namespace pmreport::section
