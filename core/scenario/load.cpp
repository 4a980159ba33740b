#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/load_part.hpp>
#include <core/text/text.hpp>
#include <memory>

namespace pmreport::scenario {
namespace {

constexpr Dimension force{1, 1, -2, 0}, moment{2, 1, -2, 0}, acceleration{1, 0, -2, 0};

std::string shown(const std::string& name, const std::vector<Value>& components) {
  std::vector<std::string> texts;
  for (const Value& v : components) texts.push_back(v.kind == Value::Kind::text ? printable(v.text) : fmt::format("{}", v.number));
  return fmt::format("{} = ({})", name, fmt::join(texts, ", "));
}

// Three components, each an expression of t.
void read_wrench_part(const Entry* entry, const Dimension& dimension, std::size_t first, LoadPart& out, const Reader& reader) {
  if (entry == nullptr) return;
  const auto* components = reader.list(entry->value, 3, "three components, x y z in base axes");
  if (components == nullptr) return;
  for (std::size_t k = 0; k < 3; ++k)
    if (auto written = reader.expression((*components)[k], dimension, Time::allowed))
      out.components[first + k] = {entry->key, written->place, std::move(written->expression)};
  out.load.description += shown(entry->key, *components) + "\n";
}

}  // namespace

LoadPart read_load(const Entry* entry, const Reader& reader) {
  LoadPart out;
  out.components.resize(6);
  std::string gravity = "no gravity: the bodies are weightless";
  if (const Value* content = table_of(entry, "load", reader)) {
    TableReader table(*content, "[load]", entry->place, reader);
    read_wrench_part(table.find("force"), force, 0, out, reader);
    read_wrench_part(table.find("moment"), moment, 3, out, reader);
    if (const Entry* e = table.find("gravity"))
      if (const auto* components = reader.list(e->value, 3, "three components, x y z in base axes")) {
        for (int k = 0; k < 3; ++k)
          out.load.gravity(k) = reader.quantity((*components)[static_cast<std::size_t>(k)], acceleration).value_or(0);
        gravity = shown("gravity", *components);
      }
    table.finish();
  }
  out.load.description += gravity;
  out.load.at = [components = std::make_shared<const std::vector<std::optional<LoadPart::Component>>>(out.components)](double t) {
    Eigen::Matrix<double, 6, 1> wrench = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t k = 0; k < 6; ++k)
      if ((*components)[k]) wrench(static_cast<Eigen::Index>(k)) = (*components)[k]->expression.at(t).value;
    return wrench;
  };
  return out;
}

Load sampled(LoadPart part, const std::vector<double>& time, Diagnostics& diagnostics) {
  Load out = std::move(part.load);
  out.force.assign(time.size(), Eigen::Vector3d::Zero());
  out.moment = out.force;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!part.components[k]) continue;
    const LoadPart::Component& component = *part.components[k];
    if (time.size() > 1) {
      const Behaviour own = behaviour(component.expression, time.front(), time.back());
      if (!own.complete)
        diagnostics.add(component.place, fmt::format("{} wavers or switches more often than can be looked at", component.key),
                        "look at a shorter motion, or at a slower load");
      for (const Switch& s : own.switches) out.knots.push_back(s.time());
      out.steps.insert(out.steps.end(), own.steps.begin(), own.steps.end());
    }
    for (std::size_t i = 0; i < time.size(); ++i) {
      const Jet<double> x = component.expression.at(time[i]);
      if (!finite(Jet<double>(x.value), time[i], component.place, component.key, diagnostics)) break;
      (k < 3 ? out.force : out.moment)[i](static_cast<Eigen::Index>(k % 3)) = x.value;
    }
  }
  for (std::vector<double>* times : {&out.knots, &out.steps}) {
    std::sort(times->begin(), times->end());
    times->erase(std::unique(times->begin(), times->end()), times->end());
  }
  return out;
}

}  // namespace pmreport::scenario
