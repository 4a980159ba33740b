#include <reports/section/common/limits.hpp>

#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pmreport::section {

std::string limit_sentence(const Analysis& a, const LimitBreach& b) {
  const int first = b.samples.front(), last = b.samples.back();
  std::string s = fmt::format("t = {}{}: {} is {}, the limit is {}", show_time(a, first), first == last ? "" : " to " + show_time(a, last),
                              b.subject, show(b.value, b.unit), show(b.limit, b.unit));
  if (b.samples.size() > 1)
    s += fmt::format(" (worst at t = {}, {})", show_time(a, b.worst), plural(static_cast<int>(b.samples.size()), "sample"));
  return s + ".";
}

std::vector<std::string> limit_sentences(const Analysis& a) {
  std::vector<std::string> out;
  for (const LimitBreach& b : limit_breaches(a)) out.push_back(limit_sentence(a, b));
  return out;
}

}  // namespace pmreport::section
