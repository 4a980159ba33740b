#include <reports/section/kinds.hpp>

#include <fmt/core.h>

namespace pmreport::section {

namespace {

std::string words_of(const scenario::Key& key) {
  const std::string head =
      key.shape.kind == scenario::Shape::Kind::tables ? fmt::format("`[[section.{}]]`", key.name) : fmt::format("`{}`", key.name);
  std::string out = fmt::format("{}, {}: {}", head, key.meaning, scenario::words_of(key.shape));
  if (key.required()) return out + "; needed";
  return key.unset.empty() ? out : fmt::format("{}; {} if left out", out, key.unset);
}

}  // namespace

std::string kinds_as_markdown(scenario::Kinds kinds) {
  std::string out = "| kind | shows | its keys |\n|---|---|---|\n";
  for (const scenario::SectionKind* kind : kinds) {
    std::string shows = kind->purpose;
    for (const scenario::NeededTable& table : kind->tables) shows += fmt::format("; needs `[{}]`", table.name);
    if (kind->several) shows += "; may stand several times";
    std::string keys;
    for (const scenario::Key& key : kind->keys) keys += (keys.empty() ? "" : "<br>") + words_of(key);
    out += fmt::format("| `{}` | {} | {} |\n", kind->name, shows, keys);
  }
  return out;
}

}  // namespace pmreport::section
