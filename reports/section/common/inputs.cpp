#include <reports/section/common/inputs.hpp>

#include <core/scenario/read/document.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using document::Input;
using scenario::Entry, scenario::Value;

namespace {

constexpr std::size_t longest = 400;  // bytes of a text that is told as written

const Entry* entry_of(const Value* table, std::string_view key) {
  if (table == nullptr) return nullptr;
  const auto at = std::ranges::find(table->entries, key, &Entry::key);
  return at != table->entries.end() ? &*at : nullptr;
}
const Value* value_of(const Value* table, std::string_view key) {
  const Entry* e = entry_of(table, key);
  return e != nullptr ? &e->value : nullptr;
}

std::string cut(std::string text) {
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // between characters
  return text.substr(0, end) + "…";
}

std::string written(const Value& v) {
  switch (v.kind) {
    case Value::Kind::text:
      return v.text;
    case Value::Kind::integer:
    case Value::Kind::number:
      return fmt::format("{}", v.number);
    case Value::Kind::boolean:
      return v.boolean ? "true" : "false";
    case Value::Kind::array: {
      std::string out;
      for (const Value& item : v.items)
        if (out.size() < longest) out += (out.empty() ? "" : ", ") + written(item);
      return "[" + out + "]";
    }
    default:
      return "";
  }
}

void add(const std::string& name, const Entry& e, std::vector<Input>& out) {
  const Value& v = e.value;
  if (v.kind == Value::Kind::table) {
    for (const Entry& below : v.entries) add(name + "." + below.key, below, out);
    return;
  }
  const bool tables = v.kind == Value::Kind::array && !v.items.empty() && v.items.front().kind == Value::Kind::table;
  Input one{name};
  one.text = tables ? fmt::format("{} {}", v.items.size(), v.items.size() == 1 ? "table" : "tables") : cut(written(v));
  one.source = "scenario";
  one.line = tables ? v.items.front().place.line : e.place.line;
  out.push_back(std::move(one));
}

}  // namespace

std::vector<Input> inputs_of(const Analysis& a) {
  const scenario::Scenario& s = a.scenario();
  scenario::Diagnostics unheard(s.file.string(), s.text);  // all that is wrong was told when it was read
  const Value document = scenario::parse_document(s.text, s.file.string(), unheard);
  const Value* given = value_of(value_of(&document, "mechanism"), "parameters");

  std::vector<Input> out;
  const mechanics::Machine& m = a.machine();
  for (std::size_t i = 0; i < m.info().parameters.size(); ++i) {
    const mechanics::ParameterInfo& p = m.info().parameters[i];
    Input one{"mechanism.parameters." + p.name};
    if (p.kind == PM_CHOICE)
      one.text = p.choices[static_cast<std::size_t>(m.values()[i][0])];
    else
      one.numbers = m.values()[i], one.list = p.kind == PM_NUMBERS, one.unit = p.unit;
    const bool set = std::ranges::find(s.parameters_set, i) != s.parameters_set.end();
    one.source = set ? "scenario" : "default of the plugin";
    if (const Entry* e = entry_of(given, p.name); set && e != nullptr) one.line = e->place.line;
    out.push_back(std::move(one));
  }
  for (const char* table : {"motion", "load", "drive", "limits", "elasticity", "element"})
    if (const Entry* e = entry_of(&document, table)) add(table, *e, out);
  return out;
}

}  // namespace pmreport::section
