#include <core/analysis/columns.hpp>

#include <fmt/core.h>

namespace pmreport::analysis {

namespace {

void add(std::vector<Column>& out, OfStiffness what, const char* unit, const char* group, const char* title) {
  out.push_back({column_of(what).name(), unit, group, title});
}

void add_of_beams(std::vector<Column>& out, const Topology& t, OfElement what, const char* unit, const char* words) {
  for (const Element& e : t.elements)
    if (e.kind == ElementKind::beam)
      out.push_back({column_of(e, what).name(), unit, "beam_" + word_of(what), fmt::format("{} of {}", words, e.name)});
}

}  // namespace

std::vector<Column> stiffness_columns(const Topology& t) {
  std::vector<Column> out;
  for (const auto& [vector, unit, words] :
       {std::tuple{OfPlatform::deflection, "m", "deflection"}, {OfPlatform::deflection_turn, "rad", "turn by deflection"}})
    for (std::size_t axis = 0; axis < 3; ++axis)
      out.push_back({column_of(vector, axis).name(), unit, word_of(vector), fmt::format("{} of the tool, {}", words, "xyz"[axis])});
  add(out, OfStiffness::deflection_size, "m", "deflection_size", "size of the deflection");
  add(out, OfStiffness::load_deflection, "m", "deflection_share", "deflection by the load");
  add(out, OfStiffness::weight_deflection, "m", "deflection_share", "deflection by the weights, sag");
  add(out, OfStiffness::inertia_deflection, "m", "deflection_share", "deflection by inertia");
  for (const Element& e : t.elements)
    out.push_back({column_of(e, OfElement::share).name(), "", "element_share", fmt::format("share of {} in the deflection", e.name)});
  add_of_beams(out, t, OfElement::axial, "N", "axial force, tension positive,");
  add_of_beams(out, t, OfElement::bending, "N*m", "largest bending moment");
  add_of_beams(out, t, OfElement::torque, "N*m", "torque");
  add_of_beams(out, t, OfElement::buckling, "", "buckling load over the compression");
  add(out, OfStiffness::pF_max, "m/N", "pF", "largest translation by a unit force");
  add(out, OfStiffness::pF_min, "m/N", "pF", "smallest translation by a unit force");
  add(out, OfStiffness::pT_max, "1/N", "pT", "largest translation by a unit moment, rotation by a unit force");
  add(out, OfStiffness::pT_min, "1/N", "pT", "smallest translation by a unit moment, rotation by a unit force");
  add(out, OfStiffness::PhiT_max, "rad/N/m", "PhiT", "largest rotation by a unit moment");
  add(out, OfStiffness::PhiT_min, "rad/N/m", "PhiT", "smallest rotation by a unit moment");
  for (int mode = 1; mode <= 6; ++mode)
    out.push_back({frequency_column(mode).name(), "Hz", "frequency", fmt::format("natural frequency {}", mode)});
  return out;
}

bool of_compliance(const Column& c) { return c.group == "pF" || c.group == "pT" || c.group == "PhiT" || c.group == "frequency"; }

}  // namespace pmreport::analysis
