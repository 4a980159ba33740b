// Poses looked at closely: matrices, indices, budget, screws, modes, and what beams carry.
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pmreport::section {

using document::Table;
using mechanics::Matrix6d;

namespace {

std::string number(double x, int digits = 4) { return typeset(format_number(x, digits)); }

// One unit an index, over all poses.
Table index_table(const Analysis& a, const std::vector<ElasticView>& views) {
  Table out{
      "Deformation indices: largest and smallest singular value of the blocks of the compliance. Rotation by force is translation by "
      "moment, "
      "transposed, and has the same.",
      {"pose", "where"},
      {false, false},
      {}};
  std::vector<std::vector<double>> values;
  for (const ElasticView& v : views) {
    const auto i = mechanics::deformation_indices(v.tool.compliance);
    values.push_back({i.pF_max, i.pF_min, i.pT_max, i.pT_min, i.PhiT_max, i.PhiT_min});
    out.rows.push_back({v.name, where_words(a.machine(), v.q)});
  }
  const std::array names{"pF max", "pF min", "pT max", "pT min", "ΦT max", "ΦT min"},
      units{"m/N", "m/N", "1/N", "1/N", "rad/N/m", "rad/N/m"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    double largest = 0;
    const std::size_t pair = k / 2 * 2;
    for (const auto& row : values) largest = std::max(largest, row[pair]);
    const DisplayUnit unit = display_unit(units[k], largest);
    out.headings.push_back(fmt::format("{} [{}]", names[k], unit.label));
    out.numeric.push_back(true);
    for (std::size_t p = 0; p < values.size(); ++p) {
      const bool nothing = values[p][k] < 1e-12 * values[p][pair];  // rounding of what symmetry makes zero
      out.rows[p].push_back(nothing ? "0" : number(values[p][k] * unit.per_si));
    }
  }
  return out;
}

Table budget_table(const Analysis& a, const std::vector<ElasticView>& views) {
  const auto& elements = a.machine().topology().elements;
  Table out{
      "Compliance budget: share of every element in the deflection of the tool, under load or by a unit force along the direction in "
      "which it gives most. The first to make stiffer stands first.",
      {"element"},
      {false},
      {}};
  std::vector<std::vector<double>> columns;
  for (const ElasticView& v : views) {
    if (v.loaded && v.tool.deflection.head<3>().norm() > 0) {
      out.headings.push_back(v.name + ", under load [%]");
      columns.push_back(analysis::budget_under_load(a.machine(), v.pose, v.tool));
    }
    Eigen::Vector3d softest;
    columns.push_back(analysis::budget_of_softest(a.machine(), v.pose, v.tool, &softest));
    out.headings.push_back(fmt::format("{}, softest ({}, {}, {}) [%]", v.name, number(softest.x() + 0.0, 2), number(softest.y() + 0.0, 2),
                                       number(softest.z() + 0.0, 2)));
  }
  out.numeric.resize(out.headings.size(), true);
  std::vector<std::size_t> order(elements.size() + 1);
  std::iota(order.begin(), order.end(), 0);
  const auto weight = [&](std::size_t e) {
    double most = 0;
    for (const auto& c : columns)
      if (std::isfinite(c[e])) most = std::max(most, std::abs(c[e]));
    return most;
  };
  std::ranges::stable_sort(order, [&](std::size_t x, std::size_t y) { return weight(x) > weight(y); });
  constexpr double least = 5e-4;
  std::size_t small = 0;
  for (const std::size_t e : order) {
    if (!(weight(e) >= least)) {
      small += e < elements.size();
      continue;
    }
    out.rows.push_back({e < elements.size() ? elements[e].name : "base and platform"});
    for (const auto& c : columns)
      out.rows.back().push_back(std::isfinite(c[e]) ? typeset(fmt::format("{:.1f}", std::abs(c[e]) < 5e-4 ? 0.0 : 100 * c[e])) : "");
  }
  if (small > 0)
    out.caption += fmt::format(" {} with less than 0.05 % everywhere {} left out.", plural(static_cast<int>(small), "element"),
                               small == 1 ? "is" : "are");
  return out;
}

Table mode_table(const Analysis& a, const std::vector<ElasticView>& views) {
  Table out{
      "Natural frequencies [Hz]: of the whole machine, masses at the bodies' centres, limbs as they swing by themselves included; of limbs "
      "that "
      "follow the platform as they do statically (Guyan), which is too high where they do not; of the platform on massless limbs.",
      {"pose", "limbs"},
      {false, false},
      {}};
  std::size_t most = 0;
  const auto add = [&](const ElasticView& v, const char* limbs, const auto& modes) {
    out.rows.push_back({v.name, limbs});
    most = std::max(most, modes.size());
    for (const auto& m : modes) out.rows.back().push_back(number(m.frequency));
  };
  for (const ElasticView& v : views) {
    if (!v.pose.masses.empty()) {
      add(v, "whole machine", mechanics::whole_modes(v.pose, analysis::told_frequencies));
      add(v, "following statically", mechanics::modes(v.pose.compliance, v.pose.inertia, a.length()));
    }
    add(v, "massless", mechanics::modes(v.pose.compliance, v.pose.platform_inertia, a.length()));
  }
  for (std::size_t m = 1; m <= most; ++m) out.headings.push_back(symbol(fmt::format("f{}", m))), out.numeric.push_back(true);
  for (auto& row : out.rows) row.resize(out.headings.size());
  return out;
}

// An axis by where it is nearest to the tool, and its direction.
Table screw_table(const ElasticView& v, const Matrix6d& stiffness) {
  Table out{fmt::format("Eigenscrews of the stiffness at {}: twists whose wrench lies on their own screw (force λω, moment λv), seen from "
                        "the tool. Those "
                        "of the compliance are the same, with 1/λ.",
                        v.name),
            {"λ [N/µrad]", "pitch [mm]", "direction", "nearest point [mm]"},
            {true, true, false, false},
            {}};
  const auto vector = [](const Eigen::Vector3d& x, double scale, int digits) {
    std::vector<std::string> parts;
    for (int k = 0; k < 3; ++k) {
      const double value = x(k) * scale;
      parts.push_back(std::abs(value) < 1e-9 * scale * std::max(1.0, x.norm()) ? "0" : number(value, digits));
    }
    return fmt::format("({})", fmt::join(parts, ", "));
  };
  for (const mechanics::Eigenscrew& s : mechanics::eigenscrews(stiffness))
    out.rows.push_back({number(s.lambda * 1e-6), number(s.pitch * 1e3), vector(s.direction, 1, 3), vector(s.nearest, 1e3, 4)});
  return out;
}

Table beam_table(const Analysis& a, const ElasticView& v) {
  const auto& elements = a.machine().topology().elements;
  const auto forces = mechanics::beam_forces(v.pose, elements.size(), v.pose.forces);
  double force = 0, moment = 0;
  for (const auto& f : forces) force = std::max(force, std::abs(f.axial)), moment = std::max({moment, f.bending, f.torque});
  const DisplayUnit n = display_unit("N", force), nm = display_unit("N*m", moment);
  Table out{fmt::format(
                "What beams carry at {}: axial force (tension positive), largest bending moment, torque; and the load at which they would "
                "buckle, by Euler with length and end conditions as declared, over their compression.",
                v.name),
            {"beam", fmt::format("axial [{}]", n.label), fmt::format("bending [{}]", nm.label), fmt::format("torque [{}]", nm.label),
             "buckles at", "times its compression", "buckling length"},
            {false, true, true, true, true, true, false},
            {}};
  const auto shown = [](double x, double largest, const DisplayUnit& u) {
    return std::abs(x) < 1e-9 * largest ? "0" : number(x * u.per_si);
  };
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (elements[e].kind != ElementKind::beam) continue;
    const double critical = mechanics::buckling_load(elements[e], v.pose.parts.lengths[e]);
    const bool compressed = forces[e].compression > 1e-9 * force;
    const double k = elements[e].buckling_length;
    const std::string ends = k == 0   ? "not slender"
                             : k == 1 ? "1 L, hinged ends"
                             : k == 2 ? "2 L, one end free"
                                      : fmt::format("{} L", number(k, 3));
    out.rows.push_back(
        {elements[e].name, shown(forces[e].axial, force, n), shown(forces[e].bending, std::max(moment, 1e-9 * force * a.length()), nm),
         shown(forces[e].torque, std::max(moment, 1e-9 * force * a.length()), nm), std::isfinite(critical) ? show(critical, "N", 3) : "",
         compressed && std::isfinite(critical) ? number(critical / forces[e].compression, 3) : "", ends});
  }
  return out;
}

Table displacement_table(const std::vector<ElasticView>& views) {
  Table out{"Displacements of the tool: under load, by its parts, and by warming and misfits, which are no part of it.",
            {"pose", "by", "Δx [µm]", "Δy [µm]", "Δz [µm]", "size [µm]", "θx [µrad]", "θy [µrad]", "θz [µrad]"},
            {false, false, true, true, true, true, true, true, true},
            {}};
  for (const ElasticView& v : views)
    for (const auto& [word, d] : {std::pair{"load, weights, inertia", &v.tool.deflection},
                                  {"load", &v.tool.by_load},
                                  {"weights", &v.tool.by_weights},
                                  {"inertia", &v.tool.by_inertia},
                                  {"warming and misfits", &v.tool.by_strain}}) {
      const bool strain = d == &v.tool.by_strain;
      if ((!v.loaded && !strain) || d->isZero(1e-15)) continue;
      // Rounding of one kind of displacement is told by the other.
      const double size = std::max(d->head<3>().norm(), 1e-9 * d->tail<3>().norm()),
                   turn = std::max(d->tail<3>().norm(), 1e-3 * d->head<3>().norm());
      out.rows.push_back({v.name, word});
      for (int k = 0; k < 3; ++k) out.rows.back().push_back(std::abs((*d)(k)) < 1e-9 * size ? "0" : number((*d)(k)*1e6));
      out.rows.back().push_back(number(size * 1e6));
      for (int k = 3; k < 6; ++k) out.rows.back().push_back(std::abs((*d)(k)) < 1e-9 * turn ? "0" : number((*d)(k)*1e6));
    }
  return out;
}

}  // namespace

Table matrix_table(const Matrix6d& m, bool stiffness, const std::string& caption) {
  // Blocks in one unit each: forces by translations, forces by rotations, moments by rotations; likewise of a compliance.
  const std::array<const char*, 6> of_stiffness{"Fx", "Fy", "Fz", "Mx", "My", "Mz"}, of_compliance{"x", "y", "z", "θx", "θy", "θz"};
  const auto& rows = stiffness ? of_stiffness : of_compliance;
  const auto& columns = stiffness ? of_compliance : of_stiffness;
  Table out{caption, {stiffness ? "by a unit" : "under a unit"}, {false}, {}};
  for (const char* c : columns) out.headings.emplace_back(c), out.numeric.push_back(true);
  for (int r = 0; r < 6; ++r) {
    out.rows.push_back({rows[static_cast<std::size_t>(r)]});
    for (int c = 0; c < 6; ++c) {
      const double scale = std::sqrt(m(r, r) * m(c, c));
      const double per_si = stiffness ? 1e-6 : 1e6;
      out.rows.back().push_back(std::abs(m(r, c)) < 1e-9 * scale ? "0" : number(m(r, c) * per_si));
    }
  }
  return out;
}

std::vector<document::Block> pose_blocks(const Analysis& a, const StiffnessRequest& request, const std::vector<ElasticView>& views) {
  std::vector<document::Block> out;
  if (views.empty()) return out;
  out.emplace_back(index_table(a, views));
  if (Table t = displacement_table(views); !t.rows.empty()) out.emplace_back(std::move(t));
  out.emplace_back(budget_table(a, views));
  out.emplace_back(mode_table(a, views));
  const char* axes = request.platform_axes ? "platform axes" : "base axes";
  for (const ElasticView& v : views) {
    out.emplace_back(matrix_table(
        v.tool.compliance, false,
        fmt::format("Compliance at {}, {}: translations [µm] and rotations [µrad] by a unit force [N] and moment [N·m].", v.name, axes)));
    const auto stiffness = mechanics::stiffness_of(v.tool.compliance, a.length());
    if (!stiffness) {
      out.emplace_back(document::Paragraph{
          document::Paragraph::Tone::note,
          fmt::format(
              "At {} the platform gives way in {} of 6 directions. In the others it is held rigidly, and there is no stiffness matrix.",
              v.name, mechanics::rank_of(v.tool.compliance, a.length()))});
      continue;
    }
    out.emplace_back(matrix_table(
        *stiffness, true,
        fmt::format("Stiffness at {}, {}: forces [N] and moments [N·m] by a translation of 1 µm and a rotation of 1 µrad.", v.name, axes)));
    out.emplace_back(screw_table(v, *stiffness));
  }
  for (const ElasticView& v : views)
    if (!v.pose.forces.isZero(0) &&
        std::ranges::any_of(a.machine().topology().elements, [](const Element& e) { return e.kind == ElementKind::beam; }))
      out.emplace_back(beam_table(a, v));
  return out;
}

}  // namespace pmreport::section
