#include <reports/section/assembly/assembly.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/core.h>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

void read_moment(const scenario::Entry& e, const scenario::Reading& r, AssemblyOptions& options) {
  options.time = read_time(e.value, r.span, r.reader).value_or(options.time);
}

void read_actuators(const scenario::Entry& e, const scenario::Reading& r, AssemblyOptions& options) {
  const scenario::Value* given = table_of(&e, "section.actuators", r.reader);
  if (given == nullptr || !r.mechanism.topology) return;
  scenario::TableReader values(*given, "actuators", e.place, r.reader);
  const scenario::Movables movables(r.mechanism);
  options.actuators.resize(static_cast<Eigen::Index>(movables.actuators.size()));
  for (std::size_t i = 0; i < movables.actuators.size(); ++i) {  // those left out stay at home
    const scenario::Moved& m = movables.actuators[i];
    const scenario::Entry* one = values.find(m.name);
    options.actuators(static_cast<Eigen::Index>(i)) =
        one != nullptr ? r.reader.quantity(one->value, parse_unit(m.unit)->dimension).value_or(m.home) : m.home;
  }
  values.finish();
}

void complete(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options) {
  const scenario::Entry *time = table.find("time"), *actuators = table.find("actuators");
  if (time == nullptr) static_cast<AssemblyOptions&>(options).time = r.span ? r.span->begin : 0;
  if (time != nullptr && actuators != nullptr)
    r.reader.diagnostics().add(actuators->place, "the actuator values are given twice: here and by a time of the motion",
                               "keep one of the two");
}

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"assembly.modes", "", "real assembly modes that are isolated"},
          {"assembly.continua", "", "continua of poses with the same actuator values"},
          {"assembly.further", "", "poses of the platform with the same actuator values that its coordinates cannot express"},
          {"assembly.own_working_mode", "", "real assembly modes in the working mode of the scenario"},
          {"assembly.nearest", "m", "least distance along the motion to another assembly mode", false, true}};
}

// Nobody knows how many modes there will be that are followed along the motion; of a platform on six legs there were ten.
MemoryNeed::Part memory_of(const scenario::Loaded& loaded, const scenario::Section&, bool) {
  constexpr double of_sample = 32e3;
  const int samples = loaded.trajectory.samples();
  return {of_sample * samples, fmt::format("assembly modes along {} samples", samples), "fewer samples"};
}

}  // namespace

const SectionKind& assembly_kind() {
  static const SectionKind kind{
      {.name = "assembly",
       .purpose = "every pose that the actuator values of one moment allow, and how near the motion comes to another",
       .keys = {keys::of<AssemblyOptions>("time", Shape::quantity(Dimension{0, 0, 1, 0}), "of the motion, whose actuator values count",
                                          "its beginning", read_moment),
                keys::of<AssemblyOptions>("actuators", Shape::values_of("actuators"),
                                          "values that count instead, `{q1 = \"210 mm\"}`, those left out at home", "", read_actuators),
                keys::boolean<AssemblyOptions>("working_modes", &AssemblyOptions::working_modes,
                                               "whether all working modes are searched, or that of the scenario alone")},
       .needs = {.motion = false, .pictures = true},
       .quantities = quantities,
       .make_options = scenario::plain_options<AssemblyOptions>,
       .complete = complete},
      [](const Context& c, const scenario::Section& s) {
        return assembly_section(c.analysis, options_of<AssemblyOptions>(s), c.stage, c.progress);
      },
      false,
      memory_of};
  return kind;
}

}  // namespace pmreport::section
