// [drive]: what stands between the motors and the actuators.
#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/measured_part.hpp>
#include <core/scenario/sizing_part.hpp>
#include <core/text/text.hpp>
#include <numbers>

namespace pmreport::scenario {
namespace {

using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

bool linear(const Actuator& a) { return a.sense() == Sense::linear; }

// What one table says. A key that is there keeps its place although its value may be wrong, and told.
struct Said {
  std::optional<double> efficiency, lead, ratio, inertia, stiffness;  // [-], [m], [-], [kg m^2], [N/m] or [N m/rad]
  std::optional<EfficiencyConvention> convention;
  const Entry *lead_at = nullptr, *ratio_at = nullptr, *inertia_at = nullptr;
};

// `stiffness_unit`: of the actuators that the table is for; nullptr: they differ.
Said read_said(const Value& content, TableReader& table, const char* stiffness_unit) {
  const Reader& reader = table.read();
  Said out;
  const auto read = [&](const char* key, double least, double most, const char* unit, std::optional<double>& value) {
    const Entry* e = table.find(key);
    if (e != nullptr) value = read_within(*e, least, most, unit, {}, reader);
    return e;
  };
  read("efficiency", 0.001, 1, "", out.efficiency);
  if (const Entry* e = table.find("convention"))
    if (const auto word = reader.word(e->value, {"power", "divides"}, "the conventions"))
      out.convention = *word == 0 ? EfficiencyConvention::by_power : EfficiencyConvention::always_divides;
  out.lead_at = read("lead", 0.001, 10000, "mm", out.lead);
  out.ratio_at = read("ratio", 0.001, 1e6, "", out.ratio);
  out.inertia_at = read("inertia", 0, 1000, "kg*m^2", out.inertia);
  if (stiffness_unit != nullptr)
    read("stiffness", 1e-9, 1e15, stiffness_unit, out.stiffness);
  else if (const Entry* e = table.find("stiffness"))
    reader.diagnostics().add(e->place, "linear and rotary actuators have stiffnesses of different units",
                             "give it in [drive.NAME] of each");
  if (content.entries.empty())
    reader.diagnostics().add(table.place(), "expected what the drive is made of, seen an empty table",
                             "add, for instance, efficiency = 0.9");
  return out;
}

// The lead is of screws, the ratio of what turns; `subject`: "psi is" or "all actuators are".
void refuse_lead(const Said& said, const std::string& subject, const Reader& reader) {
  if (said.lead_at != nullptr)
    reader.diagnostics().add(said.lead_at->place, fmt::format("a lead is of a screw, and {} rotary", subject),
                             "write ratio = 50, the motor's turns per turn of the joint");
}
void refuse_ratio(const Said& said, const std::string& subject, const Reader& reader) {
  if (said.ratio_at != nullptr)
    reader.diagnostics().add(said.ratio_at->place, fmt::format("a ratio is of gears to a rotary actuator, and {} linear", subject),
                             "write lead = \"5 mm\", the way per turn of the screw");
}

constexpr const char* give_lead = "lead = \"5 mm\"";
constexpr const char* give_ratio = "ratio = 50, or ratio = 1 for a motor on the joint itself";

void refuse_inertia(Place place, const std::vector<const Actuator*>& lacking, const Reader& reader) {
  std::vector<std::string> names;
  for (const Actuator* a : lacking) names.push_back(a->name);
  const auto screws = std::count_if(lacking.begin(), lacking.end(), [](const Actuator* a) { return linear(*a); });
  const char* what = screws == 0                                          ? "a ratio"
                     : static_cast<std::size_t>(screws) == lacking.size() ? "the lead of a screw"
                                                                          : "a lead or a ratio";
  reader.diagnostics().add(
      place, fmt::format("the inertia of a motor acts on its actuator through {}, which is not given for {}", what, listed(names, "and")),
      how_to_give_motor(*lacking.front()));
}

}  // namespace

std::string how_to_give_motor(const Actuator& a) {
  return fmt::format("add to [drive], or to [drive.{}], {}", a.name, linear(a) ? give_lead : give_ratio);
}

std::vector<DriveTrain> read_drives(const Entry* entry, const MechanismPart& mechanism, const Reader& reader) {
  const Value* content = table_of(entry, "drive", reader);
  if (content == nullptr || !mechanism.topology) return {};
  const std::vector<Actuator>& actuators = mechanism.topology->actuators;
  TableReader table(*content, "[drive]", entry->place, reader);
  constexpr const char *of_linear = "N/um", *of_rotary = "N*m/rad";
  const auto screws = std::ranges::count_if(actuators, linear);
  const Said all = read_said(*content, table,
                             screws == 0                                            ? of_rotary
                             : static_cast<std::size_t>(screws) == actuators.size() ? of_linear
                                                                                    : nullptr);
  if (std::none_of(actuators.begin(), actuators.end(), linear)) refuse_lead(all, "all actuators are", reader);
  if (std::all_of(actuators.begin(), actuators.end(), linear)) refuse_ratio(all, "all actuators are", reader);

  std::vector<DriveTrain> drives;
  std::vector<const Actuator*> lacking;
  for (const Actuator& a : actuators) {
    Said own;
    if (const Entry* e = table.find(a.name))
      if (const Value* of_one = table_of(e, "drive." + a.name, reader)) {
        TableReader one(*of_one, fmt::format("[drive.{}]", a.name), e->place, reader);
        own = read_said(*of_one, one, linear(a) ? of_linear : of_rotary);
        one.finish();
        linear(a) ? refuse_ratio(own, a.name + " is", reader) : refuse_lead(own, a.name + " is", reader);
      }
    const auto either = [](const auto& first, const auto& second) { return first ? first : second; };
    DriveTrain d;
    d.efficiency = either(own.efficiency, all.efficiency).value_or(1);
    d.convention = either(own.convention, all.convention).value_or(EfficiencyConvention::by_power);
    d.inertia = either(own.inertia, all.inertia).value_or(0);
    d.stiffness = either(own.stiffness, all.stiffness).value_or(0);
    if (const auto lead = either(own.lead, all.lead); linear(a) && lead) d.ratio = 2 * std::numbers::pi / *lead;
    if (const auto ratio = either(own.ratio, all.ratio); !linear(a) && ratio) d.ratio = *ratio;
    const bool geared = linear(a) ? own.lead_at != nullptr || all.lead_at != nullptr : own.ratio_at != nullptr || all.ratio_at != nullptr;
    if (d.inertia > 0 && !geared) {
      if (own.inertia_at != nullptr)
        refuse_inertia(own.inertia_at->place, {&a}, reader);
      else
        lacking.push_back(&a);
    }
    drives.push_back(d);
  }
  if (!lacking.empty()) refuse_inertia(all.inertia_at->place, lacking, reader);
  table.finish();
  return drives;
}

}  // namespace pmreport::scenario
