#include <core/scenario/read/asked.hpp>

#include <algorithm>

namespace pmreport::scenario {

void Asked::note_key(const Value& table, std::string_view key, bool needed) {
  std::vector<Name>& names = keys[&table];
  const auto found = std::ranges::find(names, key, &Name::key);
  if (found == names.end())
    names.push_back({std::string(key), needed});
  else
    found->needed = found->needed || needed;
}

}  // namespace pmreport::scenario
