// Options of the sections `dynamics` and `reactions`.
#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::size_t most_equations = 12;  // each fills a table of its own

// Adds what `list` does not have yet; else tells.
template <class T>
void add_once(std::vector<T>& list, const T& x, const Value& item, const Reader& reader) {
  if (std::find(list.begin(), list.end(), x) != list.end())
    reader.diagnostics().add(item.place, fmt::format("{} is given twice", in_quotes(item.text)), "remove one of the two");
  else
    list.push_back(x);
}

}  // namespace

void read_dynamics(TableReader& table, const std::optional<TimeSpan>& span, SectionRequest& request) {
  if (const Entry* e = table.find("equations"))
    for (const Value& item : items_of(*e, most_equations, table.read()))
      if (const auto t = read_time(item, span, table.read())) add_once(request.equations, *t, item, table.read());
}

void read_reactions(TableReader& table, const MechanismPart& mechanism, SectionRequest& request) {
  const Entry* e = table.find("joints");
  if (e == nullptr || !mechanism.topology) return;
  std::vector<std::string> names;
  for (const Joint& j : mechanism.topology->joints) names.push_back(j.name);
  for (const Value& item : items_of(*e, names.size(), table.read()))
    if (const auto index = table.read().word(item, names, "the joints"))
      add_once(request.joints, static_cast<int>(*index), item, table.read());
}

}  // namespace pmreport::scenario
