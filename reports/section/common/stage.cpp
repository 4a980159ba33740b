#include <reports/section/common/stage.hpp>
#include <reports/section/common/times_on_path.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>
#include <reports/scene/diagram/diagram.hpp>
#include <reports/scene/labels.hpp>
#include <reports/scene/showing/choose_view.hpp>
#include <reports/scene/vector/drawing.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

constexpr int framed_poses = 64;     // enough to bound a smooth motion; every pose would cost more than the picture
constexpr float ghost_base = 0.22F;  // opacity

// How many times along the path have no label, for want of room.
std::string left_out_words(const scene::Scene& scene, const scene::Camera& camera, const scene::Quality& quality) {
  auto left = std::ranges::count_if(scene.labels, &scene::Label::optional);
  for (const scene::LabelSpot& spot : scene::find_spots(scene, camera, quality)) left -= scene.labels[spot.index].optional ? 1 : 0;
  return left == 0   ? ""
         : left == 1 ? ", but for 1 dot that has no room for it"
                     : fmt::format(", but for {} dots that have no room for them", left);
}

}  // namespace

Stage::Stage(const Analysis& a, scene::Studio& studio) : analysis_(a), studio_(studio) {
  scene::include(bounds_, a.machine(), a.machine().home_pose());
  const int n = std::min(framed_poses, a.samples());
  for (int i = 0; i < n; ++i) {
    const int k = n > 1 ? i * (a.samples() - 1) / (n - 1) : 0;
    if (a.outcome(k) == Outcome::unreachable) continue;
    const mechanics::Pose pose = a.pose(k);
    scene::include(bounds_, a.machine(), pose);
    path_.push_back(a.machine().origin(pose, a.machine().topology().platform));
    if (i == n / 4 || i == (3 * n) / 4) looked_at_.push_back(pose);
  }
  looked_at_.push_back(a.machine().home_pose());
  for (const Eigen::Vector3d& f : a.scenario().load.force) most_force_ = std::max(most_force_, f.norm());
  for (const Eigen::Vector3d& m : a.scenario().load.moment) most_moment_ = std::max(most_moment_, m.norm());
}

const View& Stage::chosen() const {
  if (!chosen_) {
    const scene::Direction d = scene::choose_direction(analysis_.machine(), looked_at_, bounds_), usual = scene::isometric();
    const bool same = d.azimuth == usual.azimuth && d.elevation == usual.elevation;
    chosen_ = same ? View{"isometric", d.azimuth, d.elevation} : view_at(d.azimuth, d.elevation);
  }
  return *chosen_;
}

View Stage::resolved(const View& view) const { return view.name == "auto" ? chosen() : view; }

// A view along an axis shows a mechanism as drawings do; who looks at it for the first time wants one from aside.
View Stage::main_view() const {
  for (const scenario::Section& s : analysis_.scenario().sections)
    if (const auto* look = dynamic_cast<const Look*>(s.options.get()))
      for (const View& v : look->views)
        if (v.name != "front" && v.name != "side" && v.name != "top") return resolved(v);
  return chosen();
}

bool Stage::base_in_front(const View& view) const {
  const auto [known, fresh] = base_in_front_.try_emplace({view.azimuth, view.elevation}, false);
  if (fresh) known->second = scene::base_is_in_front(analysis_.machine(), looked_at_, bounds_, {view.azimuth, view.elevation});
  return known->second;
}

scene::Extras Stage::extras_of(const Look& look) const {
  scene::Extras extras;
  extras.labels = look.labels;
  extras.frames = look.frames;
  return extras;
}

// What every picture has: the symbols of the actuators, and a base that is seen through where it hides much of the rest.
void Stage::complete(scene::Extras& extras, const View& view) const {
  extras.drives = symbols();
  if (base_in_front(view)) extras.base_opacity = ghost_base;
}

std::vector<std::string> Stage::symbols() const {
  std::vector<std::string> out;
  for (const Actuator& a : analysis_.machine().topology().actuators) out.push_back(symbol(a.name));
  return out;
}

std::string Stage::load_scale() const {
  const double longest = scene::longest_force * scene::overall_size(analysis_.machine());
  std::string text;
  if (most_force_ > 0)
    text = fmt::format("Forces are drawn to one scale: {} is an arrow as long as {} of the machine.", show(most_force_, "N", 3),
                       show(longest, "m", 2));
  if (most_moment_ > 0)
    text += fmt::format("{}The ring of a moment is largest for {}.", text.empty() ? "" : " ", show(most_moment_, "N*m", 3));
  return text;
}

document::Picture Stage::Ordered::wait() {
  scene::Prints made = prints.get();
  picture.png = std::move(made.png), picture.pdf = std::move(made.pdf), picture.svg = std::move(made.svg);
  return std::move(picture);
}

Stage::Ordered Stage::picture(int sample, const View& view, const Look& look, const std::string& id) const {
  const View from = resolved(view);
  scene::Extras extras = extras_of(look);
  if (look.path) extras.path = path_;
  if (look.load) {
    extras.force = analysis_.scenario().load.force[static_cast<std::size_t>(sample)];
    extras.moment = analysis_.scenario().load.moment[static_cast<std::size_t>(sample)];
    extras.full_force = most_force_, extras.full_moment = most_moment_;
    extras.force_label = "F = " + show(extras.force.norm(), "N", 3);
    extras.moment_label = "M = " + show(extras.moment.norm(), "N*m", 3);
  }
  return picture(analysis_.machine(), analysis_.pose(sample), extras, bounds_, from, id,
                 fmt::format("t = {}, {}", show_time(analysis_, sample), words(from)),
                 {look.width, look.height, look.transparent, 2, look.printed});
}

// Of the platform, but for rounding.
bool Stage::at_one_place(int a, int b) const {
  const mechanics::Machine& m = analysis_.machine();
  const mechanics::Pose one = analysis_.pose(a), other = analysis_.pose(b);
  const int platform = m.topology().platform;
  constexpr double rounding = 1e-9;  // of the machine's size, and of a radian
  return (m.origin(one, platform) - m.origin(other, platform)).norm() <= rounding * scene::overall_size(m) &&
         (m.rotation(one, platform) - m.rotation(other, platform)).norm() <= rounding;
}

Stage::Ordered Stage::overlay(const std::vector<int>& samples, const View& view, const Look& look, const std::string& id) const {
  const View from = resolved(view);
  scene::Extras extras = extras_of(look);
  extras.path = path_;
  complete(extras, from);
  int last = analysis_.samples() - 1;
  while (last > samples.back() && analysis_.outcome(last) == Outcome::unreachable) --last;
  const bool alike = last != samples.back(), returns = alike && at_one_place(samples.front(), last);
  scene::Overlay overlay{{}, alike, times_on_path(analysis_, samples)};
  std::vector<std::string> times;
  for (const int k : samples) {
    overlay.poses.push_back(analysis_.pose(k));
    times.push_back(show_time(analysis_, k));
  }
  const scene::Camera camera = scene::frame(bounds_, from.azimuth, from.elevation, static_cast<double>(look.width) / look.height);
  const scene::Quality quality{look.width, look.height, look.transparent, 2, page_width};
  scene::Scene scene = scene::build(analysis_.machine(), overlay, extras);
  const std::string caption = fmt::format("The motion, {}: poses at t = {}, the first{} solid{}.", words(from), listed(times),
                                          returns ? ", to which it returns,"
                                          : alike ? ", near which it ends,"
                                                  : " and the last",
                                          overlay.marks.empty() || !look.labels
                                              ? ""
                                              : "; the path of the platform with times along it" + left_out_words(scene, camera, quality));
  return {{id, caption, "", look.width, look.height}, studio_.take(std::move(scene), camera, quality, id, caption)};
}

Stage::Ordered Stage::picture_at_home(const View& view, const Look& look, const std::string& id) const {
  const View from = resolved(view);
  const mechanics::Machine& machine = analysis_.machine();
  return picture(machine, machine.home_pose(), extras_of(look), bounds_, from, id, fmt::format("At home, {}", words(from)),
                 {look.width, look.height, look.transparent, 2, look.printed});
}

Stage::Ordered Stage::forces(int sample, std::vector<scene::JointForce> forces, double full, const std::string& id,
                             const std::string& caption) const {
  const View view = main_view();
  Look look;
  look.frames = false;
  scene::Extras extras = extras_of(look);
  extras.joint_names = false;  // the arrows have them
  extras.force = analysis_.scenario().load.force[static_cast<std::size_t>(sample)];
  extras.force_label = "load " + show(extras.force.norm(), "N", 3);
  extras.full_force = full;
  extras.joint_forces = std::move(forces);
  return picture(analysis_.machine(), analysis_.pose(sample), extras, bounds_, view, id, caption, {1600, 1200, false, 2, page_width});
}

Stage::Ordered Stage::portrait(const std::string& id) const {
  const scene::Quality quality{1200, 900, false, 2, page_width};
  const mechanics::Machine& machine = analysis_.machine();
  const View view = main_view();
  scene::Bounds home;
  scene::include(home, machine, machine.home_pose());
  return picture(machine, machine.home_pose(), extras_of({}), home, view, id,
                 fmt::format("The mechanism at home, {}: joints, frames and actuators, each in the colour of its curves.", words(view)),
                 quality);
}

document::Picture Stage::diagram(const std::string& id) const {
  const scene::Quality quality{1600, 1200, false, 2, page_width};
  const View view = main_view();
  const scene::Diagram diagram = scene::diagram(analysis_.machine(), symbols(), view.azimuth, view.elevation, quality);
  const auto drawing = std::make_shared<scene::Drawing>(scene::draw(diagram.scene, diagram.camera, quality, scene::Manner::plain));
  const std::string caption = fmt::format("Kinematic diagram, {}: {}.", words(view), scene::legend(analysis_.machine()));
  return {id,
          caption,
          to_png(*drawing),
          quality.width,
          quality.height,
          to_pdf(*drawing),
          to_svg(*drawing, id, caption),
          [drawing](cairo_t* cr, double width) { scene::paint(cr, *drawing, width); }};
}

Stage::Ordered Stage::cover() const {
  const scene::Quality quality{880, 720, false, 2};
  const View view = main_view();
  scene::Extras extras = extras_of({});
  extras.labels = extras.frames = false;
  extras.path = path_;
  const bool moves =
      std::ranges::any_of(path_, [&](const Eigen::Vector3d& p) { return (p - path_.front()).norm() > 1e-9 * analysis_.length(); });
  return picture(analysis_.machine(), analysis_.machine().home_pose(), extras, bounds_, view, "cover",
                 moves ? "At home, with the path of the platform" : "At home", quality);
}

Stage::Ordered Stage::picture(const mechanics::Machine& machine, const mechanics::Pose& pose, scene::Extras extras,
                              const scene::Bounds& bounds, const View& asked, const std::string& id, const std::string& caption,
                              const scene::Quality& quality) const {
  const View view = resolved(asked);
  complete(extras, view);
  const scene::Camera camera = scene::frame(bounds, view.azimuth, view.elevation, static_cast<double>(quality.width) / quality.height);
  return {{id, caption, "", quality.width, quality.height},
          studio_.take(scene::build(machine, pose, extras), camera, quality, id, caption)};
}

}  // namespace pmreport::section
