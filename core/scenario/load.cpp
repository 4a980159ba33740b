#include <fmt/format.h>

#include <array>
#include <core/scenario/parts.hpp>
#include <core/scenario/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr Dimension force{1, 1, -2, 0}, moment{2, 1, -2, 0}, acceleration{1, 0, -2, 0};

std::string shown(const std::string& name, const std::vector<Value>& components) {
  std::vector<std::string> texts;
  for (const Value& v : components) texts.push_back(v.kind == Value::Kind::text ? printable(v.text) : fmt::format("{}", v.number));
  return fmt::format("{} = ({})", name, fmt::join(texts, ", "));
}

// Three components, each an expression of t, at every sample.
void read_wrench_part(const Entry* entry, const Dimension& dimension, const std::vector<double>& time, std::vector<Eigen::Vector3d>& out,
                      std::string& description, const Reader& reader) {
  out.assign(time.size(), Eigen::Vector3d::Zero());
  if (entry == nullptr) return;
  const auto* components = reader.list(entry->value, 3, "three components, x y z in base axes");
  if (components == nullptr) return;
  for (int k = 0; k < 3; ++k) {
    const auto written = reader.expression((*components)[static_cast<std::size_t>(k)], dimension, Time::allowed);
    if (!written) continue;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const Jet<double> x = written->expression.at(time[i]);
      if (!finite(Jet<double>(x.value), time[i], written->place, entry->key, reader.diagnostics())) break;
      out[i](k) = x.value;
    }
  }
  description += shown(entry->key, *components) + "\n";
}

}  // namespace

Load read_load(const Entry* entry, const std::vector<double>& time, const Reader& reader) {
  Load load;
  load.force.assign(time.size(), Eigen::Vector3d::Zero());
  load.moment = load.force;
  std::string gravity = "no gravity: the bodies are weightless";
  if (const Value* content = table_of(entry, "load", reader)) {
    TableReader table(*content, "[load]", entry->place, reader);
    read_wrench_part(table.find("force"), force, time, load.force, load.description, reader);
    read_wrench_part(table.find("moment"), moment, time, load.moment, load.description, reader);
    if (const Entry* e = table.find("gravity"))
      if (const auto* components = reader.list(e->value, 3, "three components, x y z in base axes")) {
        for (int k = 0; k < 3; ++k) load.gravity(k) = reader.quantity((*components)[static_cast<std::size_t>(k)], acceleration).value_or(0);
        gravity = shown("gravity", *components);
      }
    table.finish();
  }
  load.description += gravity;
  return load;
}

}  // namespace pmreport::scenario
