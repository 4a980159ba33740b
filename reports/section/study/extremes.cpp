#include <reports/section/study/extremes.hpp>

#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

namespace {

bool has(const Judged& j, std::size_t number) { return number < j.numbers.size() && j.numbers[number].known(); }

std::string alike_words(const ExtremeVariant& e) {
  const auto n = static_cast<int>(e.alike.size());
  return n == 0 ? "" : fmt::format(" ({} {} not told apart from it)", plural(n, "other"), n == 1 ? "is" : "are");
}

}  // namespace

std::optional<ExtremeVariant> extreme(const std::vector<const Judged*>& all, std::size_t number, bool largest) {
  std::optional<ExtremeVariant> out;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!has(*all[k], number)) continue;
    const double x = all[k]->numbers[number].value;
    const double best = out ? all[out->index]->numbers[number].value : 0;
    if (!out || (largest ? x > best : x < best)) out = ExtremeVariant{k, {}};
  }
  if (!out) return out;
  const Bracketed& own = all[out->index]->numbers[number];
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == out->index || !has(*all[k], number)) continue;
    const analysis::Order order = order_of(all[k]->numbers[number], own);
    if (order == analysis::Order::open || order == analysis::Order::equal) out->alike.push_back(k);
  }
  return out;
}

std::string extremes_sentence(const StudyOptions& o, std::size_t number, const std::vector<const Judged*>& all,
                              const std::function<std::string(std::size_t)>& where) {
  const std::optional<ExtremeVariant> high = extreme(all, number, true), low = extreme(all, number, false);
  std::string title = title_of(o, number);
  if (!high) return fmt::format("No variant has a {}.", title);
  const std::string& unit = o.numbers[number].unit;
  const auto value = [&](const ExtremeVariant& e) { return with_unit(all[e.index]->numbers[number], unit); };
  if (std::ranges::all_of(all, [&](const Judged* j) {
        return !has(*j, number) || order_of(j->numbers[number], all[high->index]->numbers[number]) == analysis::Order::equal;
      }))
    return fmt::format("The {} is {} throughout.", title, value(*high));
  const auto known = static_cast<std::size_t>(std::ranges::count_if(all, [&](const Judged* j) { return has(*j, number); }));
  if (high->alike.size() + 1 == known && low->alike.size() + 1 == known && known > 1) {
    Bracketed span = all[high->index]->numbers[number];
    for (const Judged* j : all)
      if (has(*j, number)) span.low = std::min(span.low, j->numbers[number].low), span.high = std::max(span.high, j->numbers[number].high);
    return fmt::format("The {} lies within {}, of all variants; their brackets do not tell them apart.", title, with_unit(span, unit));
  }
  return fmt::format("The {} is largest, {}, {}{}, and smallest, {}, {}{}.", title, value(*high), where(high->index), alike_words(*high),
                     value(*low), where(low->index), alike_words(*low));
}

void add_values_of_variants(const StudyOptions& o, const std::vector<const Judged*>& all, std::size_t most, Result& out) {
  const auto add = [&](std::string name, const std::string& unit, double x) { out.values.push_back({"study", std::move(name), unit, x}); };
  add("variants", "", static_cast<double>(all.size()));
  add("failed", "", static_cast<double>(std::ranges::count_if(all, [](const Judged* j) { return !j->made(); })));
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    const StudiedNumber& number = o.numbers[n];
    if (const auto e = extreme(all, n, true)) add("largest_" + number.own, number.unit, all[e->index]->numbers[n].value);
    if (const auto e = extreme(all, n, false)) add("smallest_" + number.own, number.unit, all[e->index]->numbers[n].value);
    for (std::size_t k = 0; k < std::min(most, all.size()); ++k)
      if (has(*all[k], n)) add(fmt::format("{}_{}", number.own, k + 1), number.unit, all[k]->numbers[n].value);
  }
}

}  // namespace pmreport::section
