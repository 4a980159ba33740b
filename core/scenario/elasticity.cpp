#include <core/scenario/elasticity_part.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/scenario/section/reading.hpp>
#include <core/scenario/sizing_part.hpp>
#include <core/text/text.hpp>
#include <pmreport/elastic.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

namespace pmreport::scenario {
namespace {

using mechanics::ElasticSettings;

const std::vector<std::string> kinds{"beams", "rails", "drives", "bearings"}, bendings{"none", "couples", "full"};
const std::vector<std::string> material_words(std::begin(material_names), std::end(material_names));

template <class List>
std::vector<std::string> names_of(const List& list) {
  std::vector<std::string> out;
  for (const auto& x : list) out.push_back(x.name);
  return out;
}

std::optional<double> quantity_above_zero(const Entry& e, double least, double most, const char* unit, const Reader& reader) {
  return read_within(e, least, most, unit, "", reader);
}

// material = "steel", or its numbers: material = { modulus = "210 GPa", shear_modulus = "81 GPa", expansion = 1.2e-5 }.
std::optional<Material> read_material(const Entry& e, const std::string& where, const Reader& reader) {
  if (e.value.kind == Value::Kind::text) {
    const auto word = reader.word(e.value, material_words, "the materials");
    return word ? std::optional(materials[*word]) : std::nullopt;
  }
  const Value* content = table_of(&e, where, reader);
  if (content == nullptr) return std::nullopt;
  TableReader table(*content, where, e.place, reader);
  const Entry *modulus = table.need("modulus", "modulus = \"210 GPa\""), *shear = table.find("shear_modulus"),
              *expansion = table.find("expansion");
  table.finish();
  Material out;
  if (modulus != nullptr) out.modulus = quantity_above_zero(*modulus, 1e-9, 1e6, "GPa", reader).value_or(0);
  out.shear_modulus = shear != nullptr ? quantity_above_zero(*shear, 1e-9, 1e6, "GPa", reader).value_or(0) : out.modulus / 2.6;
  if (expansion != nullptr)
    out.expansion = read_within(*expansion, -0.01, 0.01, "", "it is by kelvin: 1.2e-5 of steel", reader).value_or(0);
  return out.modulus > 0 && out.shear_modulus > 0 ? std::optional(out) : std::nullopt;
}

// A 6 x 6 compliance, symmetric and of no negative energy.
linear::Matrix6d read_compliance(const Entry& e, const Reader& reader) {
  linear::Matrix6d out = linear::Matrix6d::Zero();
  const auto* rows = reader.list(e.value, 6, "rows of six numbers");
  if (rows == nullptr) return out;
  for (std::size_t r = 0; r < 6; ++r) {
    const auto* row = reader.list((*rows)[r], 6, "numbers of a row");
    if (row == nullptr) return linear::Matrix6d::Zero();
    for (std::size_t c = 0; c < 6; ++c) {
      const auto x = reader.quantity((*row)[c], {});
      if (!x) return linear::Matrix6d::Zero();
      out(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = *x;
    }
  }
  const linear::Vector6d size = out.diagonal().cwiseAbs().cwiseSqrt();
  const linear::Matrix6d scale = size * size.transpose();
  if (((out - out.transpose()).cwiseAbs().array() > 1e-9 * scale.array()).any()) {
    reader.diagnostics().add(e.value.place, fmt::format("expected a symmetric matrix for {}", e.key),
                             "it is a compliance: displacements (m, rad) by a unit force and moment (N, N m)");
    return linear::Matrix6d::Zero();
  }
  out = (0.5 * (out + out.transpose())).eval();
  for (Eigen::Index r = 0; r < 6; ++r)
    if (!(out(r, r) >= 0) || (out(r, r) == 0 && !out.row(r).isZero(0))) {
      reader.diagnostics().add(e.value.place, fmt::format("{} has negative energy: row {} of it has {} on the diagonal", e.key, r + 1,
                                                          out(r, r) < 0 ? "a negative number" : "nothing"));
      return linear::Matrix6d::Zero();
    }
  const linear::Vector6d unit = size.unaryExpr([](double x) { return x > 0 ? 1 / x : 0; });
  if (linear::symmetric_eigen(linear::Matrix6d(unit.asDiagonal() * out * unit.asDiagonal())).values(0) < -1e-9) {
    reader.diagnostics().add(e.value.place, fmt::format("{} has negative energy: some load would move along itself backwards", e.key));
    return linear::Matrix6d::Zero();
  }
  return out;
}

// The joints that an element names.
class Joints {
 public:
  Joints(const Topology& t, const Reader& reader) : names_(names_of(t.joints)), reader_(reader) {}
  std::optional<int> one(const Value& v) const {
    const auto i = reader_.word(v, names_, "the joints");
    return i ? std::optional(static_cast<int>(*i)) : std::nullopt;
  }
  std::optional<std::pair<int, int>> two(const Entry& e, const char* what) const {
    const auto* list = reader_.list(e.value, 2, what);
    if (list == nullptr) return std::nullopt;
    const auto a = one((*list)[0]), b = one((*list)[1]);
    return a && b ? std::optional(std::pair(*a, *b)) : std::nullopt;
  }

 private:
  std::vector<std::string> names_;
  const Reader& reader_;
};

std::optional<CrossSection> read_section(TableReader& table) {
  const Reader& reader = table.read();
  const Entry *diameter = table.find("diameter"), *bore = table.find("bore"), *width = table.find("width"), *height = table.find("height");
  const auto length = [&](const Entry* e, double least) {
    return e != nullptr ? read_within(*e, least, 1e4, "mm", "", reader) : std::nullopt;
  };
  if (diameter == nullptr && width == nullptr) {
    reader.diagnostics().add(table.place(), "expected the section of the element, which is not there",
                             "write diameter = \"30 mm\", with bore = \"20 mm\" for a tube, or width and height");
    return std::nullopt;
  }
  if (diameter != nullptr && width != nullptr) {
    reader.diagnostics().add(width->place, "a section is round or rectangular, not both", "keep diameter, or width and height");
    return std::nullopt;
  }
  if (diameter != nullptr) {
    if (height != nullptr) reader.diagnostics().add(height->place, "a round section has no height", "remove it");
    const auto outer = length(diameter, 0.001), inner = length(bore, 0);
    if (!outer) return std::nullopt;
    if (inner && *inner >= *outer) {
      reader.diagnostics().add(bore->value.place, "expected a bore less than the diameter", "a bore that leaves no wall carries nothing");
      return std::nullopt;
    }
    return tube(*outer, inner.value_or(0));
  }
  if (bore != nullptr) reader.diagnostics().add(bore->place, "a bore is of a round section", "remove it, or write diameter");
  const auto x = length(width, 0.001), y = height != nullptr ? length(height, 0.001) : x;
  return x && y ? std::optional(rectangle(*x, *y)) : std::nullopt;
}

std::optional<Element> read_element(const Value& content, const Topology& t, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  TableReader table(content, "[[element]]", content.place, reader);
  const Joints joints(t, reader);
  const Entry* name = table.need("name", "name = \"leg1\"");
  Element e;
  if (name != nullptr) e.name = reader.text(name->value).value_or("");
  const Entry *bar = table.find("beam"), *along = table.find("rail"), *at = table.find("joint"), *drive = table.find("drive");
  const auto given = std::ranges::count_if(std::array{bar, along, at, drive}, [](const Entry* x) { return x != nullptr; });
  const auto material = [&] {
    const Entry* m = table.need("material", "material = \"steel\"");
    return m != nullptr ? read_material(*m, "[[element]] material", reader) : std::nullopt;
  };
  bool sound = name != nullptr && given == 1;
  if (given != 1)
    diagnostics.add(content.place, fmt::format("expected one of beam, rail, joint and drive in an element, seen {}", given),
                    "beam = [\"A1\", \"B1\"] runs from joint to joint, joint = \"B1\" gives way itself");
  if (given == 1 && (bar != nullptr || along != nullptr)) {
    e.kind = bar != nullptr ? ElementKind::beam : ElementKind::rail;
    const auto ends = bar != nullptr ? joints.two(*bar, "joints at the ends of a beam")
                                     : joints.two(*along, "joints: the slide, and what loads the rail");
    const auto section = read_section(table);
    const auto made_of = material();
    sound = sound && ends && section && made_of;
    if (ends) e.from = ends->first, e.to = ends->second;
    if (section) e.section = *section;
    if (made_of) e.material = *made_of;
    if (bar != nullptr) {
      if (const Entry* x = table.find("buckling_length"))
        e.buckling_length = read_within(*x, 0, 10, "", "1 between hinges, 2 with a free end", reader).value_or(1);
      if (const Entry* x = table.find("bending"))
        if (const auto word = reader.word(x->value, bendings, "the ways to bend")) e.bends = static_cast<Bending>(*word);
    } else if (const Entry* x = table.find("offset")) {
      e.offset = read_within(*x, 0, 1e6, "mm", "the free length of a rail is its travel and the offset, which is never negative", reader)
                     .value_or(0);
    }
  } else if (given == 1 && at != nullptr) {
    e.kind = ElementKind::bearing;
    const auto joint = joints.one(at->value);
    sound = sound && joint;
    e.to = joint.value_or(-1);
    bool any = false;
    for (const auto& [key, unit, k] :
         {std::tuple{"axial", "N/um", 0}, {"radial", "N/um", 1}, {"twisting", "N*m/rad", 2}, {"tilting", "N*m/rad", 3}})
      if (const Entry* x = table.find(key)) {
        any = true;
        const auto stiffness = quantity_above_zero(*x, 1e-12, 1e15, unit, reader);
        sound = sound && stiffness;
        e.stiffness[k] = stiffness.value_or(1);
      }
    if (!any) {
      diagnostics.add(content.place, "expected how stiff the joint is, which is not there",
                      "write axial = \"80 N/um\", radial, tilting or twisting");
      sound = false;
    }
  } else if (given == 1) {
    e.kind = ElementKind::drive;
    const auto actuator = reader.word(drive->value, names_of(t.actuators), "the actuators");
    const Entry* k = table.need("stiffness", "stiffness = \"50 N/um\"");
    sound = sound && actuator && k != nullptr;
    if (actuator && k != nullptr) {
      e.actuator = static_cast<int>(*actuator);
      const bool linear = t.actuators[*actuator].sense() == Sense::linear;
      const auto stiffness = quantity_above_zero(*k, 1e-12, 1e15, linear ? "N/um" : "N*m/rad", reader);
      sound = sound && stiffness;
      e.stiffness[0] = stiffness.value_or(1);
    }
  }
  table.finish();
  if (!sound) return std::nullopt;
  const std::string fault = mechanics::fault_of(e, t);
  if (fault.empty()) return e;
  diagnostics.add(content.place, fault);
  return std::nullopt;
}

void read_rigid(const Entry& e, const std::vector<std::string>& names, ElasticSettings& out, const Reader& reader) {
  std::vector<std::string> known = kinds;
  known.insert(known.end(), names.begin(), names.end());
  for (const Value& item : items_of(e, known.size(), reader)) {
    const auto word = reader.word(item, known, "the elements and their kinds");
    if (!word) continue;
    if (*word < kinds.size())
      out.rigid_kinds.push_back(static_cast<ElementKind>(*word));
    else
      out.rigid.push_back(known[*word]);
  }
}

void read_misfits(const Entry& e, const std::vector<Element>& elements, const Topology& t, ElasticSettings& out, const Reader& reader) {
  const Value* content = table_of(&e, "elasticity.misfit", reader);
  if (content == nullptr) return;
  TableReader table(*content, "[elasticity] misfit", e.place, reader);
  for (const Element& element : elements) {
    if (element.kind == ElementKind::bearing) continue;
    const Entry* own = table.find(element.name);
    if (own == nullptr) continue;
    const bool rotary =
        element.kind == ElementKind::drive && t.actuators[static_cast<std::size_t>(element.actuator)].sense() == Sense::rotary;
    if (const auto x = read_within(*own, -1e3, 1e3, rotary ? "deg" : "mm", "how much longer it is than it should be", reader))
      out.misfits.emplace_back(element.name, *x);
  }
  table.finish();
}

}  // namespace

void read_elasticity(const Entry* elasticity, const Entry* elements, const std::vector<mechanics::DriveTrain>& drives,
                     MechanismPart& mechanism, const Reader& reader) {
  const bool driven = std::ranges::any_of(drives, [](const mechanics::DriveTrain& d) { return d.stiffness > 0; });
  if (!mechanism.topology || (elasticity == nullptr && elements == nullptr && !driven)) return;
  Topology& t = *mechanism.topology;
  ElasticSettings out;
  for (const mechanics::DriveTrain& d : drives)
    out.drives.push_back(d.stiffness > 0 ? d.stiffness : std::numeric_limits<double>::quiet_NaN());
  std::set<std::string> seen;
  for (const Value* content : tables_of(elements, "element", reader)) {
    const auto e = read_element(*content, t, reader);
    if (!e) continue;
    const auto declared = std::ranges::find(t.elements, e->name, &Element::name);
    if (declared != t.elements.end() && declared->kind != e->kind)
      reader.diagnostics().add(
          content->place, fmt::format("{} is declared by the mechanism as another kind of element, whose place this would take", e->name),
          fmt::format("give it another name, or have the other rigid: [elasticity] rigid = [{}]", in_quotes(e->name)));
    else if (seen.insert(e->name).second)
      out.added.push_back(*e);
    else
      reader.diagnostics().add(content->place, fmt::format("two elements are called {}", in_quotes(e->name)),
                               "give each a name of its own");
  }
  if (const Value* content = table_of(elasticity, "elasticity", reader)) {
    TableReader table(*content, "[elasticity]", elasticity->place, reader);
    const std::vector<Element> all = elements_under(out, t);
    if (const Entry* e = table.find("rigid")) read_rigid(*e, names_of(all), out, reader);
    if (const Entry* e = table.find("bending"))
      if (const auto word = reader.word(e->value, bendings, "the ways to bend")) out.bends = static_cast<Bending>(*word);
    if (const Entry* e = table.find("material")) out.material = read_material(*e, "[elasticity] material", reader);
    if (const Entry* e = table.find("platform_compliance")) out.platform = read_compliance(*e, reader);
    if (const Entry* e = table.find("base_compliance")) out.base = read_compliance(*e, reader);
    if (const Entry* e = table.find("warmer"))
      out.warmer = read_within(*e, -1000, 1000, "", "it is in kelvin, without a unit", reader).value_or(0);
    if (const Entry* e = table.find("misfit")) {
      read_misfits(*e, all, t, out, reader);
      const std::vector<Element> left = elements_under(out, t);
      for (const auto& [name, more] : out.misfits)
        if (std::ranges::find(left, name, &Element::name) == left.end())
          reader.diagnostics().add(e->value.place, fmt::format("{} is taken as rigid, and its misfit would not be looked at", name),
                                   "remove it from rigid, or from misfit");
    }
    table.finish();
  }
  t.elements = elements_under(out, t);
  if (mechanism.machine != nullptr) mechanism.machine->give(std::move(out));
}

}  // namespace pmreport::scenario
