// Section `singularity`: how far the motion stays from a loss of control, where it is lost, of which type, and how the platform escapes.
#include <core/numbers.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/singularity/singularity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using mechanics::BodyFreedoms;
using mechanics::Singularity;

namespace {

constexpr std::size_t pictured = 4;  // poses at most
constexpr std::size_t examined = 8;  // crossings at most
const scene::Color escape_color{0.82F, 0.0F, 0.42F, 1.0F};

std::string coordinates_words(const mechanics::Machine& m, const Eigen::VectorXd& q) {
  std::vector<std::string> parts;
  const Eigen::VectorXd home = m.home();
  for (int i = 0; i < q.size(); ++i) {
    const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(i)];
    if (std::abs(q(i) - home(i)) > 1e-12) parts.push_back(fmt::format("{} = {}", symbol(c.name), show(q(i), c.unit, 6)));
  }
  return parts.empty() ? "home" : listed(parts);
}

std::optional<ExaminedPose> examine(const Analysis& a, const std::string& name, const Eigen::VectorXd& q, double length, bool snap) {
  const mechanics::Machine& m = a.machine();
  auto at = mechanics::singularity_at(m, q, a.mobility(), length);
  if (!at) return std::nullopt;
  ExaminedPose p{name, coordinates_words(m, q), std::move(*at), std::nullopt};
  // Six independent wrenches, and yet more freedoms than the limbs should leave: the rows of G are not all that hold the platform.
  p.beyond_g = p.at.type == mechanics::SingularityType::constraint && p.at.ranks.wrenches == 6;
  p.determinant = p.at.conditioning.determinant, p.smallest = p.at.conditioning.smallest, p.condition = p.at.conditioning.condition();
  if (snap && !p.singular() && !a.singular_everywhere()) {
    p.snapped = mechanics::onto_surface(m, q, length);
    if (p.snapped)
      if (auto on = mechanics::singularity_at(m, p.snapped->coordinates, a.mobility(), length)) p.at = std::move(*on);
  }
  return p;
}

document::Table pose_table(const std::vector<ExaminedPose>& poses) {
  document::Table t{"Poses looked at closely. Ranks of the lines of the actuators' forces, and of all wrenches on the platform.",
                    {"pose", "where", "det Ĝ", "σ₆", "condition", "lines", "all", "verdict"},
                    {false, false, true, true, true, true, true, false},
                    {}};
  const bool proved = std::ranges::any_of(poses, [](const ExaminedPose& p) { return p.proved.has_value(); });
  if (proved) t.headings.emplace_back("within [s]"), t.numeric.push_back(true);
  const auto number = [](double x, int digits) { return typeset(format_number(x, digits)); };
  for (const ExaminedPose& p : poses) {
    // What lies at rounding of a double is zero and is told as such.
    const bool zero = p.smallest < 1e-12;
    t.rows.push_back({p.name, p.where, zero ? "0" : number(p.determinant, 3), zero ? "0" : number(p.smallest, 3),
                      zero ? "∞" : number(p.condition, 3), std::to_string(p.at.ranks.lines), std::to_string(p.at.ranks.wrenches),
                      type_name(p.at.type)});
    if (proved) t.rows.back().push_back(p.proved ? bracket_number(*p.proved, 1) : "");
  }
  return t;
}

// A margin of the constraints of all bodies at a sample, of that at home; NaN where there is none, or the mechanism has none of the kind.
double share_of_home(const Analysis& a, BodyFreedoms::Margin which, int sample) {
  if (a.margins().at_sample.empty()) return nan;  // an architecture that is singular everywhere is not followed
  const double home = a.margins().sound[which], here = a.margins().at_sample[static_cast<std::size_t>(sample)][which];
  return std::isfinite(home) && home > 0 ? here / home : nan;
}
std::vector<double> shares_of_home(const Analysis& a, BodyFreedoms::Margin which) {
  std::vector<double> out(static_cast<std::size_t>(a.samples()), nan);
  for (int k = 0; k < a.samples(); ++k) out[static_cast<std::size_t>(k)] = share_of_home(a, which, k);
  return out;
}

figure::Figure motion_figure(const Analysis& a, const AlongMotion& along) {
  figure::Figure f{"singularity",
                   "Along the motion: determinant, smallest singular value and condition number of Ĝ; last pivot of the constraints of all "
                   "bodies, of that at home.",
                   "data/singularity.csv",
                   figure::Width::full,
                   2,
                   {}};
  const std::pair<const char*, const std::vector<double>*> curves[] = {
      {"det Ĝ", &along.determinant}, {"smallest singular value", &along.smallest}, {"condition number", &along.condition}};
  for (const auto& [title, values] : curves) {
    figure::Panel p = panel(a, title, title, "", {});
    p.y.label = values == &along.determinant ? "det Ĝ" : values == &along.smallest ? "σ₆" : "σ₁/σ₆";
    p.series.push_back({"", a.time(), *values, -1});
    f.panels.push_back(std::move(p));
  }
  figure::Panel p = panel(a, "constraints of all bodies", "constraints of all bodies", "", {});
  p.y.label = "of home";
  for (const auto& [name, which] : {std::pair{"actuators locked", BodyFreedoms::locked}, std::pair{"actuators free", BodyFreedoms::free},
                                    std::pair{"limbs, platform locked", BodyFreedoms::limb}})
    if (std::vector<double> shares = shares_of_home(a, which); std::ranges::any_of(shares, [](double x) { return std::isfinite(x); }))
      p.series.push_back({name, a.time(), std::move(shares), static_cast<int>(p.series.size())});
  if (!p.series.empty()) f.panels.push_back(std::move(p));
  return f;
}

// Least of a margin over the motion, relative to that at home, and where. Nothing where it has none.
struct Least {
  double share = 0;
  int sample = 0;
};
std::optional<Least> least(const Analysis& a, BodyFreedoms::Margin which) {
  std::optional<Least> out;
  for (int k = 0; k < a.samples(); ++k) {
    const double share = share_of_home(a, which, k);
    if (std::isfinite(share) && (!out || share < out->share)) out = {share, k};
  }
  return out;
}

// What one body's G does not tell announces itself in the constraints of all bodies.
std::string margin_words(const Analysis& a) {
  const auto locked = least(a, BodyFreedoms::locked), free = least(a, BodyFreedoms::free), limb = least(a, BodyFreedoms::limb);
  std::vector<std::string> parts;
  const auto tell = [&](const std::optional<Least>& l, const char* what) {
    if (l) parts.push_back(fmt::format("{}, {} at t = {}", what, typeset(format_number(l->share, 3)), show_time(a, l->sample)));
  };
  tell(locked, "with all actuators locked (zero: bodies move all the same)");
  tell(free, "with all actuators free (zero: a constraint singularity)");
  tell(limb, "of the limbs with the platform locked (zero: type 1)");
  if (parts.empty()) return "";
  return fmt::format(
      "G knows one body of the platform. The constraints of all bodies are followed as well, at every sample and to the least value "
      "between "
      "samples where they dip; the last pivot of their rows, of that at home, is least: {}.",
      fmt::join(parts, "; "));
}

std::string lines_words(const mechanics::Machine& m, const Singularity& s) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < s.ranks.pitch.size(); ++i) {
    const double h = s.ranks.pitch[i];
    const std::string name = symbol(m.topology().actuators[i].name);
    if (h != 0) others.push_back(std::isinf(h) ? name + " (a couple)" : fmt::format("{} (pitch {})", name, show(h, "m", 3)));
  }
  if (others.empty()) return "Each actuator acts on the platform by a force along a line.";
  return fmt::format("Not every actuator acts along a line: {}. The rank of their wrenches is not one of lines.", listed(others));
}

document::Proof proof_of(const std::vector<ExaminedPose>& poses, double length) {
  int ranks = 0, singular = 0, compared = 0;
  double angle = 0;
  for (const ExaminedPose& p : poses) {
    if (p.beyond_g) continue;  // it is told that G, which knows one body, does not know it
    ++compared;
    const Singularity& s = p.at;
    ranks = std::max(ranks, std::abs(6 - s.ranks.wrenches - s.freedoms.platform));
    if (s.freedoms.platform == 0 || s.ranks.wrenches == 6) continue;
    ++singular;
    // Twists weigh their lower half by the length, wrenches by its inverse.
    angle = std::max(angle, outside({s.freedoms.escapes.origin, s.conditioning.escape}, s.freedoms.escapes, 1 / length));
  }
  document::Proof proof;
  proof.lines.push_back(
      {"Closed form and generic model agree on what is lost",
       fmt::format("6 less the rank of G against the freedoms of the platform that the constraints of all bodies leave with the "
                   "actuators locked, at {}, largest difference",
                   plural(compared, "pose")),
       double(ranks), 0, ""});
  // A singular pose is known to the last digits of its coordinate; the smallest singular value there is 1e-15, the next one 1e-3 or more.
  if (singular > 0)
    proof.lines.push_back({"They agree on how the platform escapes",
                           fmt::format("singular vector of Ĝ against the twists that the generic model allows, sine of the angle, at {}",
                                       plural(singular, "singular pose")),
                           angle, 1e-6, ""});
  return proof;
}

// The pose with its escape, framed so that the whole axis shows.
Stage::Ordered portrait(const mechanics::Machine& m, const ExaminedPose& p, double length, const Stage& stage, std::size_t number) {
  const mechanics::Pose pose = m.pose({p.at.coordinates.data(), static_cast<std::size_t>(p.at.coordinates.size())});
  const mechanics::Screw e = escape_screw(m.topology(), p, length);
  scene::Extras extras;
  extras.frames = false;
  extras.screws.push_back({e.point, e.direction, e.pitch, "$", escape_color});
  scene::Bounds bounds;
  scene::include(bounds, m, m.home_pose());
  scene::include(bounds, m, pose);
  scene::include(bounds, m, pose, extras.screws[0]);
  const std::string caption = p.at.freedoms.platform > 0 ? p.name + ": with the actuators locked the platform escapes by the twist $."
                                                         : p.name + ": the twist $ that the actuators hold least.";
  return stage.picture(m, pose, extras, bounds, {"auto", 0, 0}, fmt::format("singularity-{}", number), caption, {800, 600, false, 2});
}

}  // namespace

Result singularity_section(const Analysis& a, const SingularityOptions& r, const Stage& stage, const Progress& progress) {
  const mechanics::Machine& m = a.machine();
  const double length = r.length.value_or(a.length());
  const AlongMotion along = along_motion(a, length);
  Result out;
  document::Section& s = out.section = {"singularity", "singularity", "Singularity", {}};
  const auto tell = [&](const std::string& text, Paragraph::Tone tone = Paragraph::Tone::plain) {
    if (!text.empty()) s.blocks.push_back(Paragraph{tone, text});
  };

  // The poses: where the motion is worst, where it crosses, and those given. Not every one of these can be assembled.
  std::vector<ExaminedPose> poses;
  std::optional<ExaminedPose> worst;
  const auto& crossings = a.crossings();
  std::vector<std::string> met;  // what is told of each crossing
  for (std::size_t i = 0; i < std::min(examined, crossings.size()); ++i) {
    const Crossing& c = crossings[i];
    const std::string when = fmt::format("t = {} s", format_number(c.time, 7));
    auto p = examine(a, when, c.coordinates, length, false);
    std::string told = sentence(a, c);
    if (p) p->proved = c.proved;
    if (p) p->beyond_g = p->beyond_g || (c.what != Crossing::What::surface && c.what != Crossing::What::pole);
    if (p && p->singular() && !p->beyond_g) told += " It is of " + type_words(p->at.type) + ".";
    met.push_back(std::move(told));
    if (p) poses.push_back(std::move(*p));
  }
  if (!poses.empty()) {
    worst = poses.front();
  } else if (along.worst >= 0) {
    worst = examine(a, "t = " + show_time(a, along.worst), a.trajectory().value.row(along.worst).transpose(), length, false);
    if (worst) poses.push_back(*worst);
  }
  std::vector<const ExaminedPose*> given(r.poses.size(), nullptr);
  poses.reserve(poses.size() + r.poses.size());
  std::vector<std::string> refused;
  for (std::size_t i = 0; i < r.poses.size(); ++i) {
    if (auto p = examine(a, fmt::format("pose {}", i + 1), r.poses[i], length, true)) {
      poses.push_back(std::move(*p));
      given[i] = &poses.back();
    } else {
      refused.push_back(fmt::format("Pose {}, {}, cannot be assembled.", i + 1, coordinates_words(m, r.poses[i])));
    }
  }
  progress.stop_if_asked();

  std::vector<Stage::Ordered> ordered;
  for (const ExaminedPose& p : poses)
    if (ordered.size() < pictured && ((worst && p.name == worst->name) || p.singular()))
      ordered.push_back(portrait(m, p, length, stage, ordered.size() + 1));

  if (!a.trajectory().ending.empty()) tell(fmt::format("The motion {}.", a.trajectory().ending), Paragraph::Tone::warning);
  if (a.singular_everywhere()) tell(singularity_sentences(a).front(), Paragraph::Tone::warning);
  for (const std::string& text : met) tell(text, Paragraph::Tone::warning);
  if (crossings.size() > examined)
    tell(fmt::format("{} more crossings are not looked at.", crossings.size() - examined), Paragraph::Tone::warning);
  for (const std::string& text : refused) tell(text, Paragraph::Tone::warning);
  tell(fmt::format(
      "Ĝ is the overall Jacobian made dimensionless by the length L = {}{}: it maps (v; Lω) to the rates of the linear actuators, L "
      "times those of rotary ones, and L times the rows of constraint couples. σ₁ to σ₆ are its singular values; σ₆ is zero on a "
      "singular surface, and its singular vector is the twist that the actuators hold least.",
      show(length, "m"), r.length ? "" : ", the mean distance of the platform's joints from its reference point"));
  for (const std::string& text : nearness_sentences(a)) tell(text, Paragraph::Tone::warning);
  if (crossings.empty() && along.worst >= 0 && !a.singular_everywhere() && a.trajectory().ending.empty())
    tell(fmt::format("The motion stays on one side of every singular surface: det Ĝ keeps its sign, and σ₆ is {} or more, least at t = {}.",
                     typeset(format_number(along.smallest[static_cast<std::size_t>(along.worst)], 3)), show_time(a, along.worst)));
  const bool moves = a.samples() > 0;
  if (moves) s.blocks.push_back(motion_figure(a, along));
  tell(margin_words(a));
  if (!poses.empty()) {
    tell(lines_words(m, poses.front().at));
    s.blocks.push_back(pose_table(poses));
    for (const ExaminedPose& p : poses) {
      if (p.snapped) {
        const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(p.snapped->coordinate)];
        tell(fmt::format(
            "{} is given by rounded numbers: {} = {} lies on a singular surface, {} away. Ranks and verdict are those of that pose.",
            p.name, symbol(c.name), show(p.snapped->coordinates(p.snapped->coordinate), c.unit, 9),
            show(std::abs(p.snapped->moved), c.unit, 2)));
      }
      if (p.singular() || (worst && p.name == worst->name)) tell(escape_words(a, p, length));
      if (p.beyond_g)
        tell(fmt::format("{}: G, which knows one body of the platform, keeps its rank there; the constraints of all bodies do not.",
                         p.name));
    }
  }
  if (r.map && a.singular_everywhere()) tell("A map has nothing to show: every pose of it is singular.");
  if (r.map && !a.singular_everywhere()) {
    SingularityMap map = singularity_map(a, *r.map, length);
    tell(fmt::format("Of {} poses of the map {} can be assembled; det G is negative at {} of them{}.", map.all, map.reachable, map.negative,
                     map.singular > 0 ? fmt::format(", and zero, to rounding, at {}", map.singular) : ""));
    s.blocks.push_back(map.figure);
    out.data.push_back(std::move(map.data));
  }
  document::Gallery gallery{{}, ""};
  for (Stage::Ordered& o : ordered) {
    progress.stop_if_asked();
    gallery.pictures.push_back(o.wait());
  }
  if (!gallery.pictures.empty()) s.blocks.push_back(gallery);
  if (std::ranges::any_of(poses, [](const ExaminedPose& p) { return !p.beyond_g; })) s.blocks.push_back(proof_of(poses, length));

  const auto value = [&](const std::string& name, double x) { out.values.push_back({"singularity", name, "", x}); };
  double smallest = along.worst >= 0 ? along.smallest[static_cast<std::size_t>(along.worst)] : nan, condition = nan;
  for (const double c : along.condition)
    if (std::isfinite(c) && !(c <= condition)) condition = c;
  if (worst) smallest = std::min(smallest, worst->smallest), condition = std::max(condition, worst->condition);
  if (moves) {
    value("crossings", double(crossings.size()));
    value("smallest_singular_value", smallest);
    value("largest_condition", condition);
    value("line_rank", worst ? worst->at.ranks.lines : nan);
    value("wrench_rank", worst ? worst->at.ranks.wrenches : nan);
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    value(fmt::format("line_rank_{}", i + 1), given[i] != nullptr ? given[i]->at.ranks.lines : nan);
    value(fmt::format("wrench_rank_{}", i + 1), given[i] != nullptr ? given[i]->at.ranks.wrenches : nan);
  }
  if (moves)
    out.data.insert(out.data.begin(),
                    {"singularity",
                     {"t [s]", "determinant", "smallest_singular_value", "condition", "margin_locked", "margin_free", "margin_limbs"},
                     {a.time(), along.determinant, along.smallest, along.condition, shares_of_home(a, BodyFreedoms::locked),
                      shares_of_home(a, BodyFreedoms::free), shares_of_home(a, BodyFreedoms::limb)}});
  return out;
}

}  // namespace pmreport::section
