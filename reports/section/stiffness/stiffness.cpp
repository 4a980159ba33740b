// Section `stiffness`: how far the platform gives way, and why.
#include <core/numbers.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/analysis/columns.hpp>
#include <core/linear/eigenvalues.hpp>
#include <core/mechanics/stiffness/whole_system.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pmreport::section {

using document::Paragraph;
using mechanics::Matrix6d, mechanics::Vector6d;

namespace {

constexpr std::size_t pictured = 3;

// Looks at poses, at rest but for those of the motion.
class Viewer {
 public:
  Viewer(const Analysis& a, const StiffnessRequest& request) : a_(a), request_(request), statics_(a.machine()) {}

  ElasticView at_sample(int sample) {
    ElasticView v{"t = " + show_time(a_, sample), a_.trajectory().value.row(sample).transpose(), true, {}, {}, {}};
    const auto dof = static_cast<std::size_t>(a_.machine().dof());
    std::vector<double> jets(3 * dof), loads(6);
    for (std::size_t i = 0; i < dof; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      jets[3 * i] = a_.trajectory().value(sample, at);
      jets[3 * i + 1] = a_.trajectory().rate(sample, at);
      jets[3 * i + 2] = a_.trajectory().acceleration(sample, at);
    }
    const scenario::Load& load = a_.scenario().load;
    for (std::size_t c = 0; c < 3; ++c) {
      loads[c] = load.force[static_cast<std::size_t>(sample)](static_cast<Eigen::Index>(c));
      loads[3 + c] = load.moment[static_cast<std::size_t>(sample)](static_cast<Eigen::Index>(c));
    }
    std::vector<mechanics::ElasticPose> out;
    statics_.solve(1, jets.data(), loads.data(), load.gravity, {true, request_.limb_inertia}, out);
    v.pose = std::move(out.front());
    finish(v);
    return v;
  }
  ElasticView at_rest(const std::string& name, const Eigen::VectorXd& q) {
    ElasticView v{name, q, false, {}, {}, {}};
    v.pose = statics_.at(q, Vector6d::Zero(), Eigen::Vector3d::Zero(), {true, request_.limb_inertia});
    finish(v);
    return v;
  }

 private:
  void finish(ElasticView& v) {
    if (!v.pose.known) return;
    v.placement = a_.machine().pose({v.q.data(), static_cast<std::size_t>(v.q.size())}).numbers;
    v.tool = analysis::at_tool(a_.machine(), v.pose, v.placement.data(), request_);
  }
  const Analysis& a_;
  const StiffnessRequest& request_;
  mechanics::Elastostatics statics_;
};

// The sample of the largest number of a column; -1: none.
int sample_of_largest(const Analysis& a, const ColumnId& id) {
  int out = -1;
  if (!a.has(id)) return out;
  const auto& x = a.column(id);
  for (int k = 0; k < a.samples(); ++k)
    if (const double y = x[static_cast<std::size_t>(k)]; std::isfinite(y) && (out < 0 || y > x[static_cast<std::size_t>(out)])) out = k;
  return out;
}
double extreme(const Analysis& a, const ColumnId& id, bool largest) {
  double out = nan;
  if (!a.has(id)) return out;
  for (const double x : a.column(id))
    if (std::isfinite(x)) out = largest ? std::fmax(out, x) : std::fmin(out, x);
  return out;
}

std::string definition(const Analysis& a, const StiffnessRequest& request) {
  std::string out =
      "A unit force or moment on the platform is carried by the joints; what passes through them loads the elements. Their complementary "
      "energy, "
      "made least over the self-stresses, gives the compliance C = QᵀcQ, Q the forces in all elements, c their compliances (Castigliano, "
      "Menabrea). Displacements are small, elements unloaded, no geometric stiffness; beams follow Euler and Bernoulli, actuators are "
      "locked. ";
  out += request.tool.isZero(0) ? "Told is the platform's reference point"
                                : fmt::format("Told is the tool, ({}, {}, {}) from the reference point in the platform's axes",
                                              show(request.tool.x(), "m"), show(request.tool.y(), "m"), show(request.tool.z(), "m"));
  out += fmt::format(", in {} axes.", request.platform_axes ? "platform" : "base");
  const auto warms = [](const Element& e) { return e.kind == ElementKind::beam || e.kind == ElementKind::rail; };
  if (const double warmer = a.machine().elasticity().warmer; warmer != 0)
    out += std::ranges::any_of(a.machine().topology().elements, warms)
               ? fmt::format(" Beams and rails are {} K warmer than when they were measured.", typeset(format_number(warmer, 4)))
               : " No beam or rail gives way, and what is rigid is not warmed.";
  return out;
}

// What bending is worth: pF_max here, by that of the same beams bent by no force across them. NaN: no beam bends.
double bending_factor(const Analysis& a, const StiffnessRequest& request, const ElasticView& home) {
  const auto& elements = a.machine().topology().elements;
  if (!home.pose.known ||
      std::ranges::none_of(elements, [](const Element& e) { return e.kind == ElementKind::beam && e.bends == Bending::full; }))
    return nan;
  const auto plain = a.machine().with(a.machine().values());
  mechanics::ElasticSettings settings = a.machine().elasticity();
  settings.bends.reset();
  for (Element e : elements) {
    if (e.kind == ElementKind::beam && e.bends == Bending::full) e.bends = Bending::couples;
    std::erase_if(settings.added, [&](const Element& other) { return other.name == e.name; });
    settings.added.push_back(std::move(e));
  }
  plain->give(settings);
  mechanics::Elastostatics statics(*plain);
  const auto pose = statics.at(home.q, Vector6d::Zero(), Eigen::Vector3d::Zero(), {false, false});
  if (!pose.known) return nan;
  const auto tool = analysis::at_tool(*plain, pose, home.placement.data(), request);
  const double without = mechanics::deformation_indices(tool.compliance).pF_max;
  return without > 0 ? mechanics::deformation_indices(home.tool.compliance).pF_max / without : nan;
}

// The beam that comes nearest to buckling along the motion, and when; empty: none is compressed.
std::string buckling_words(const Analysis& a) {
  const Element* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  int sample = 0;
  for (const Element& e : a.machine().topology().elements) {
    if (e.kind != ElementKind::beam || !a.has(column_of(e, analysis::OfElement::buckling))) continue;
    const auto& x = a.column(column_of(e, analysis::OfElement::buckling));
    for (int k = 0; k < a.samples(); ++k)
      if (x[static_cast<std::size_t>(k)] < least) least = x[static_cast<std::size_t>(k)], nearest = &e, sample = k;
  }
  if (nearest == nullptr) return "";
  return fmt::format("Nearest to buckling comes {}: at t = {} it could carry {} times its compression.", nearest->name,
                     show_time(a, sample), typeset(format_number(least, 3)));
}

// Upper triangle of the compliance at every sample: displacements x y z and rotations by forces and moments.
document::Data compliance_data(const Analysis& a) {
  constexpr std::array names{"x", "y", "z", "rx", "ry", "rz"};
  document::Data out{"compliance", {"t [s]"}, {a.time()}};
  for (int r = 0; r < 6; ++r)
    for (int c = r; c < 6; ++c) {
      const char* unit = c < 3 ? "m/N" : r < 3 ? "1/N" : "rad/N/m";
      out.headings.push_back(fmt::format("C_{}_{} [{}]", names[static_cast<std::size_t>(r)], names[static_cast<std::size_t>(c)], unit));
      std::vector<double>& column = out.columns.emplace_back();
      for (const Matrix6d& m : a.compliances()) column.push_back(m(r, c));
    }
  return out;
}

document::Evidence no_negative_energy(const std::vector<ElasticView>& views, double length) {
  double worst = 0;
  const Vector6d s = (Vector6d() << 1, 1, 1, Eigen::Vector3d::Constant(1 / length)).finished();
  for (const ElasticView& v : views) {
    const auto values = linear::symmetric_eigen(Matrix6d(s.asDiagonal() * v.pose.compliance * s.asDiagonal())).values;
    if (values(5) == 0) continue;  // nothing gives way
    const double share = -values(0) / values(5);
    if (!(share <= worst)) worst = share;
  }
  return {"No load meets a negative compliance",
          fmt::format("least eigenvalue of the compliance, moments per length, relative to the largest, at {}; negative ones count",
                      plural(static_cast<int>(views.size()), "pose")),
          worst, 1e-13, ""};
}

// Why the one system over all bodies was asked nothing.
std::string why_not_whole(const Analysis& a) {
  const mechanics::ElasticSettings& e = a.machine().elasticity();
  return e.base.isZero(0) && e.platform.isZero(0) ? "no pose that was looked at has a compliance"
                                                  : "base or platform give way, which that system does not have";
}

document::Evidence by_whole_system(const Analysis& a, const std::vector<ElasticView>& views) {
  double worst = 0;
  int looked = 0;
  const Vector6d s = (Vector6d() << 1, 1, 1, Eigen::Vector3d::Constant(1 / a.length())).finished();
  if (a.machine().elasticity().base.isZero(0) && a.machine().elasticity().platform.isZero(0))
    for (const ElasticView& v : views) {
      const mechanics::State state = state_at_rest(a.machine(), v.q);
      if (state.status != PM_OK) continue;
      const Eigen::MatrixXd all = mechanics::WholeSystem(mechanics::SpringPlan(a.machine()), state).under_unit_wrenches();
      const Matrix6d whole = s.asDiagonal() * all.middleRows<6>(6 * a.machine().topology().platform - 6) * s.asDiagonal();
      const Matrix6d mine = s.asDiagonal() * v.pose.compliance * s.asDiagonal();
      if (mine.isZero(0)) continue;  // of nothing that gives way nothing is compared
      const double share = (whole - mine).cwiseAbs().maxCoeff() / mine.cwiseAbs().maxCoeff();
      if (!(share <= worst)) worst = share;
      ++looked;
    }
  const char *claim = "The force method equals one system over all bodies",
             *how =
                 "compliance of the platform by the reactions of joints and their self-stresses against the "
                 "displacements of all bodies, joints and springs at once, relative to the largest number";
  if (looked == 0) return document::Evidence::not_examined(claim, how, why_not_whole(a));
  return {claim, fmt::format("{}, at {}", how, plural(looked, "pose")), worst, 1e-8, ""};
}

}  // namespace

std::string where_words(const mechanics::Machine& m, const Eigen::VectorXd& q) {
  std::vector<std::string> parts;
  for (int i = 0; i < q.size(); ++i) {
    const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(i)];
    if (std::abs(q(i) - c.home) > 1e-12) parts.push_back(fmt::format("{} = {}", symbol(c.name), show(q(i), c.unit, 5)));
  }
  return parts.empty() ? "home" : listed(parts, "and");
}

Result stiffness_section(const Analysis& a, const StiffnessRequest& request, const Stage& stage, const Progress& progress) {
  const mechanics::Machine& m = a.machine();
  Result out{{"stiffness", "stiffness", "Stiffness", {}}, {}, {}, {}};
  document::Section& s = out.section;
  const auto tell = [&](const std::string& text, Paragraph::Tone tone = Paragraph::Tone::plain) {
    if (!text.empty()) s.blocks.emplace_back(Paragraph{tone, text});
  };
  const auto value = [&](const std::string& name, const std::string& unit, double x) {
    out.values.push_back({"stiffness", name, unit, x});
  };
  const bool gives = analysis::gives_way(m);
  if (!gives) {
    tell("Nothing gives way: the mechanism declares no elastic element, or all are taken as rigid. Its compliance is zero.",
         Paragraph::Tone::warning);
    out.findings.push_back(
        {document::Finding::Kind::surprise,
         "No elastic element: stiffness was not examined. Add [[element]], beam = [\"A1\", \"B1\"], diameter and material."});
    s.blocks.emplace_back(
        document::Proof{{document::Evidence::not_examined("Elasticity", "force method on the joint reactions", "no element gives way")}});
    for (const auto& [name, unit] : {std::pair{"rank", ""},
                                     {"home_pF_max", "m/N"},
                                     {"home_pF_min", "m/N"},
                                     {"home_pT_max", "1/N"},
                                     {"home_pT_min", "1/N"},
                                     {"home_PhiT_max", "rad/N/m"},
                                     {"home_PhiT_min", "rad/N/m"}})
      value(name, unit, 0);
    return out;
  }
  tell(definition(a, request));

  Viewer viewer(a, request);
  const ElasticView home = viewer.at_rest("home", m.home());
  if (!home.pose.known) tell("At home the actuators do not hold the platform, which no stiffness replaces.", Paragraph::Tone::warning);
  std::vector<ElasticView> views;
  const auto look = [&](ElasticView v, const std::string& name) {
    const bool placed = m.pose({v.q.data(), static_cast<std::size_t>(v.q.size())}).status == PM_OK;
    if (v.pose.known)
      views.push_back(std::move(v));
    else
      tell(fmt::format("{}, {}: {}; nothing is told of it.", name, where_words(m, v.q),
                       placed ? "the actuators do not hold the platform there" : "the mechanism cannot be assembled there"),
           Paragraph::Tone::warning);
  };
  std::vector<int> samples;
  for (const double t : request.times) {
    samples.push_back(a.sample_at(t));
    if (const double there = a.time()[static_cast<std::size_t>(samples.back())]; std::abs(there - t) > 1e-9)
      tell(fmt::format("t = {} is no sample; the nearest, t = {}, is told in its place.", show(t, "s"), show_time(a, samples.back())),
           Paragraph::Tone::note);
  }
  if (samples.empty() && a.samples() > 0)
    if (const int worst = sample_of_largest(a, column_of(analysis::OfStiffness::deflection_size)); worst >= 0) samples.push_back(worst);
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (std::ranges::find(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(i), samples[i]) ==
        samples.begin() + static_cast<std::ptrdiff_t>(i))
      look(viewer.at_sample(samples[i]), "t = " + show_time(a, samples[i]));
  for (std::size_t i = 0; i < request.poses.size(); ++i) {
    const std::string name = fmt::format("pose {}", i + 1);
    look(viewer.at_rest(name, request.poses[i]), name);
  }
  if (views.empty() && request.poses.empty() && home.pose.known) views.push_back(home);
  progress.stop_if_asked();

  std::vector<Stage::Ordered> ordered;
  for (const ElasticView& v : views)
    if (ordered.size() < pictured && m.elasticity().base.isZero(0) && m.elasticity().platform.isZero(0) &&
        !analysis::frequencies(v.pose, request.limb_inertia, a.length()).empty())
      ordered.push_back(mode_picture(a, request, v, stage, ordered.size() + 1));

  s.blocks.emplace_back(element_table(a, home));
  if (const auto rigid = rigid_limbs(a); !rigid.empty())
    tell(fmt::format("{} {} no element: what {} to the platform is taken as rigid.", listed(rigid, "and"),
                     rigid.size() == 1 ? "has" : "have", rigid.size() == 1 ? "it passes" : "they pass"),
         Paragraph::Tone::note);
  if (home.pose.known && home.pose.settled > 0)
    tell(fmt::format("The elements settle {} that rigid bodies leave open: joint reactions are unique by elasticity{}.",
                     plural(home.pose.settled, "self-stress", "self-stresses"),
                     home.pose.open > 0
                         ? fmt::format(" but for {} that no element gives energy", plural(home.pose.open, "self-stress", "self-stresses"))
                         : ""));
  else if (home.pose.known && home.pose.open > 0)
    tell(fmt::format("{} that rigid bodies leave open {} no element to give {} energy: nothing settles how large {}.",
                     plural(home.pose.open, "self-stress", "self-stresses"), home.pose.open == 1 ? "meets" : "meet",
                     home.pose.open == 1 ? "it" : "them", home.pose.open == 1 ? "it is" : "they are"),
         Paragraph::Tone::note);

  const double factor = bending_factor(a, request, home);
  if (std::isfinite(factor) && factor > 1.05) {
    const std::string sentence =
        fmt::format("With the bending of beams by forces pF_max at home is {}, {} times that of the same beams without it.",
                    show(mechanics::deformation_indices(home.tool.compliance).pF_max, "m/N", 3), typeset(format_number(factor, 5)));
    tell(sentence);
    if (factor > 10) out.findings.push_back({document::Finding::Kind::surprise, sentence});
  }
  if (a.samples() > 0) {
    for (figure::Figure& f : motion_figures(a)) s.blocks.emplace_back(std::move(f));
    if (document::Table t = motion_extremes(a); !t.rows.empty()) s.blocks.emplace_back(std::move(t));
    tell(buckling_words(a));
    if (const double most = extreme(a, column_of(analysis::OfStiffness::deflection_size), true); most > 0.01 * a.length())
      tell(fmt::format(
               "The deflection comes to {}, which is not small beside the platform's {}: what is told holds for small displacements alone.",
               show(most, "m", 3), show(a.length(), "m", 3)),
           Paragraph::Tone::warning);
    int lost = 0;
    for (int k = 0; k < a.samples(); ++k)
      lost += a.outcome(k) == analysis::Outcome::good && !std::isfinite(a.compliances()[static_cast<std::size_t>(k)](0, 0));
    if (lost > 0)
      tell(fmt::format("At {} of {} samples the actuators do not hold the platform: they give way without end there, and are in no number "
                       "of this section.",
                       lost, a.samples()),
           Paragraph::Tone::warning);
  }
  for (document::Block& b : pose_blocks(a, request, views)) s.blocks.emplace_back(std::move(b));
  if (request.map) {
    int singular = 0;
    DrawnMap map = stiffness_map(a, request, out.values, singular);
    if (singular > 0)
      tell(fmt::format(
               "At {} of the map the actuators do not hold the platform, which gives way without end there: the largest and the least over "
               "the map are not known.",
               plural(singular, "pose")),
           Paragraph::Tone::warning);
    s.blocks.emplace_back(std::move(map.figure));
    out.data.push_back(std::move(map.data));
    progress.stop_if_asked();
  }
  document::Gallery gallery{{}, ""};
  for (Stage::Ordered& o : ordered) gallery.pictures.push_back(o.wait());
  if (!gallery.pictures.empty()) s.blocks.emplace_back(std::move(gallery));

  if (!a.compliances().empty()) out.data.insert(out.data.begin(), compliance_data(a));
  document::Proof p;
  if (a.samples() > 0)
    p = proof(a, {{analysis::Measure::elastic_work, "The work of all loads becomes energy of the elements",
                   "loads, weights and inertia of all bodies times their displacements, by one system over all of them, against the sum of "
                   "c q² over all elements by the force method, relative",
                   1e-8, "", why_not_whole(a)},
                  {analysis::Measure::elastic_judge, "Along the motion the force method equals one system over all bodies",
                   "compliance of the platform by joint reactions and self-stresses against the displacements of all bodies, joints and "
                   "springs at once, "
                   "relative to the largest number",
                   1e-8, "", why_not_whole(a)}});
  if (a.samples() > 0 && std::ranges::any_of(m.topology().elements, [](const Element& e) { return e.kind == ElementKind::drive; }))
    for (document::Evidence& line : proof(a, {{analysis::Measure::elastic_drives, "The drives' part follows from the overall Jacobian",
                                               "sum of q qᵀ/k over the drives, q by the joint reactions, against G⁻¹ diag(1/k) G⁻ᵀ of the "
                                               "plugin, relative to the largest number",
                                               1e-8, "", "at no sample has G a value"}})
                                        .lines)
      p.lines.push_back(std::move(line));
  if (a.samples() == 0) p.lines.push_back(by_whole_system(a, views));
  if (!views.empty()) p.lines.push_back(no_negative_energy(views, a.length()));
  s.blocks.emplace_back(std::move(p));

  if (a.samples() > 0) {
    value("largest_deflection", "m", extreme(a, column_of(analysis::OfStiffness::deflection_size), true));
    value("lowest_frequency", "Hz", extreme(a, analysis::frequency_column(1), false));
    double buckling = nan;
    for (const Element& e : m.topology().elements)
      if (e.kind == ElementKind::beam) buckling = std::fmin(buckling, extreme(a, column_of(e, analysis::OfElement::buckling), false));
    value("least_buckling", "", buckling);
    if (std::isfinite(buckling) && buckling < 1)
      out.findings.push_back(
          {document::Finding::Kind::fault, fmt::format("A beam buckles: its compression is {} times what it can carry by Euler.",
                                                       typeset(format_number(1 / buckling, 3)))});
  }
  const bool known = home.pose.known;
  value("rank", "", known ? mechanics::rank_of(home.pose.compliance, a.length()) : nan);
  value("open_self_stresses", "", known ? home.pose.open : nan);
  value("bending_factor", "", factor);
  const auto i = known ? mechanics::deformation_indices(home.tool.compliance) : mechanics::DeformationIndices{nan, nan, nan, nan, nan, nan};
  value("home_pF_max", "m/N", i.pF_max), value("home_pF_min", "m/N", i.pF_min);
  value("home_pT_max", "1/N", i.pT_max), value("home_pT_min", "1/N", i.pT_min);
  value("home_PhiT_max", "rad/N/m", i.PhiT_max), value("home_PhiT_min", "rad/N/m", i.PhiT_min);
  const std::vector<double> modes = known ? analysis::frequencies(home.pose, request.limb_inertia, a.length()) : std::vector<double>{};
  value("home_frequency", "Hz", modes.empty() ? nan : modes.front());
  return out;
}

}  // namespace pmreport::section
