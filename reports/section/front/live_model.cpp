#include <reports/section/front/live_model.hpp>

#include <core/analysis/columns.hpp>
#include <core/analysis/proof/recording_check.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/print_javascript.hpp>
#include <core/text/units.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/front/live_geometry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace pmreport::section {

namespace {

// A string of JavaScript in which nothing can end the element around it, nor the line that it stands in.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
    if (c == '<' || c == '>' || c == '&')
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  return out;
}

std::string written(double x) { return std::isinf(x) ? (x < 0 ? "-Infinity" : "Infinity") : fmt::format("{}", x + 0.0); }

template <class List, class Write>
std::string list(const List& all, Write&& write) {
  std::string out;
  for (const auto& x : all) out.append(out.empty() ? "" : ",").append(write(x));
  return "[" + out + "]";
}
std::string numbers(const Eigen::Vector3d& v) { return list(v, written); }

// What all numbers of the model have: a name, that name as a symbol, and the unit in which values up to `largest` are shown.
std::string called(const std::string& name, const std::string& title, const std::string& unit, double largest) {
  const DisplayUnit shown = display_unit(unit, largest);
  return fmt::format("name:{},symbol:{},title:{},unit:{},factor:{}", quoted(name), quoted(symbol(name)), quoted(title), quoted(shown.label),
                     written(shown.per_si));
}

double largest_of(const Range& r) { return std::max(std::abs(r.min), std::abs(r.max)); }

// Where a limit of a joint has no end, none is met.
Range bounds_of(const Joint& joint, std::size_t limit) {
  const Range& range = joint.limits[limit];
  return {mechanics::binds(joint, range, false) ? range.min : -INFINITY, mechanics::binds(joint, range, true) ? range.max : INFINITY};
}

// Wider, to ends that read well: whole steps of a twentieth of the decade of its width, "-1050 mm".
Range with_round_ends(const Range& r, const std::string& unit) {
  if (!(r.max > r.min)) return r;
  const double per_si = display_unit(unit, largest_of(r)).per_si;
  const double step = std::pow(10, std::floor(std::log10((r.max - r.min) * per_si))) / 20, slack = 1e-9;
  return {std::floor(r.min * per_si / step + slack) * step / per_si, std::ceil(r.max * per_si / step - slack) * step / per_si};
}

// How far the reader may move each coordinate: as far as strokes and joints let it go alone, from home, and a fifth beyond, so that its
// limits can be met; in any case where the mechanism is said to be sane, and where the motion goes.
class Room {
 public:
  Room(const Analysis& a, const LiveGeometry& geometry)
      : analysis_(a), machine_(a.machine()), geometry_(geometry), evaluator_(geometry.program), y_(geometry.program.outputs().size()) {}

  Range of(int coordinate) {
    const Coordinate& c = machine_.topology().coordinates[static_cast<std::size_t>(coordinate)];
    const double size = std::max(c.box.max - c.home, c.home - c.box.min);
    Range out{std::min(c.box.min, c.home), std::max(c.box.max, c.home)};
    for (const double way : {-1.0, 1.0}) {
      const double beyond = c.home + 1.2 * way * free_way(coordinate, way * size / steps_of_box);
      out = {std::min(out.min, beyond), std::max(out.max, beyond)};
    }
    for (int k = 0; k < analysis_.samples(); ++k)
      if (const double x = analysis_.trajectory().value(k, coordinate); std::isfinite(x))
        out = {std::min(out.min, x), std::max(out.max, x)};
    out = with_round_ends(out, c.unit);
    if (c.sense() == Sense::rotary) {
      const double turn = std::numbers::pi;
      out = {std::min(c.home, std::max(out.min, -turn)), std::max(c.home, std::min(out.max, turn))};
    }
    return out;
  }

 private:
  static constexpr int steps_of_box = 16, most_steps = 8 * steps_of_box;

  double free_way(int coordinate, double step) {
    const Eigen::VectorXd home = machine_.home();
    std::vector<double> x(home.begin(), home.end());
    int steps = 0;
    while (steps < most_steps) {
      x[static_cast<std::size_t>(coordinate)] = home(coordinate) + step * (steps + 1);
      if (!free(x)) break;
      ++steps;
    }
    return std::abs(step) * steps;
  }

  bool free(const std::vector<double>& x) {
    const Topology& t = machine_.topology();
    const auto within = [&](std::size_t at, const Range& r) { return y_[at] >= r.min && y_[at] <= r.max; };
    evaluator_.run(x, y_);
    bool keeps = y_[0] >= 0;
    for (std::size_t i = 0; i < t.actuators.size(); ++i) keeps = keeps && within(geometry_.actuators + i, t.actuators[i].stroke);
    for (const LiveGeometry::Motion& m : geometry_.motions)
      keeps = keeps && within(m.at, bounds_of(t.joints[static_cast<std::size_t>(m.joint)], static_cast<std::size_t>(m.limit)));
    return keeps;
  }

  const Analysis& analysis_;
  const mechanics::Machine& machine_;
  const LiveGeometry& geometry_;
  program::Evaluator<double> evaluator_;
  std::vector<double> y_;
};

std::string coordinates(const Analysis& a, const LiveGeometry& g) {
  Room room(a, g);
  int i = 0;
  return list(a.machine().topology().coordinates, [&](const Coordinate& c) {
    const Range range = room.of(i++);
    return fmt::format("{{{},rotary:{},home:{},min:{},max:{}}}\n", called(c.name, c.title, c.unit, largest_of(range)),
                       c.sense() == Sense::rotary, written(c.home), written(range.min), written(range.max));
  });
}

std::string actuators(const Topology& t) {
  return list(t.actuators, [](const Actuator& x) {
    const DisplayUnit effort = display_unit(mechanics::unit_of_effort(x.sense()), 1);
    return fmt::format("{{{},rotary:{},min:{},max:{},effort:{{name:{},unit:{},factor:{}}}}}\n",
                       called(x.name, x.title, x.unit, largest_of(x.stroke)), x.sense() == Sense::rotary, written(x.stroke.min),
                       written(x.stroke.max), quoted(mechanics::word_of_effort(x.sense())), quoted(effort.label), written(effort.per_si));
  });
}

std::string derived(const Topology& t) {
  return list(t.derived, [](const Derived& d) { return fmt::format("{{{}}}", called(d.name, d.title, d.unit, 1)); });
}

std::string bodies(const Topology& t, const LiveGeometry& g) {
  std::size_t b = 0;
  return list(t.bodies, [&](const Body& body) {
    const std::size_t at = g.bodies[b];
    std::string more;
    for (const LiveGeometry::Guide& guide : g.guides)
      if (static_cast<std::size_t>(guide.body) == b) more = fmt::format(",guide:{}", guide.at);
    ++b;
    return fmt::format("{{name:{},at:{}{}{}}}", quoted(body.name), at, body.slender ? ",slender:true" : "", more);
  });
}

std::string motions(const Topology& t, const LiveGeometry& g) {
  const std::vector<Column> columns = analysis::displacement_columns(t);
  return list(g.motions, [&](const LiveGeometry::Motion& m) {
    const Joint& joint = t.joints[static_cast<std::size_t>(m.joint)];
    const std::string name = analysis::joint_column(joint, static_cast<std::size_t>(m.limit)).name();
    const auto column = std::ranges::find(columns, name, &Column::name);
    const Range range = bounds_of(joint, static_cast<std::size_t>(m.limit));
    return fmt::format("{{{},at:{},low:{},high:{}}}\n",
                       called(name, column != columns.end() ? column->title : name, mechanics::motion_unit(joint), 1), m.at,
                       written(range.min), written(range.max));
  });
}

// The rows of G whose magnitude is a couple, or belongs to a rotary actuator.
std::string rotary_rows(const Topology& t) {
  std::vector<bool> rows;
  for (const Actuator& x : t.actuators) rows.push_back(x.sense() == Sense::rotary);
  for (const Constraint& x : t.constraints) rows.push_back(x.sense() == Sense::rotary);
  return list(rows, [](bool rotary) { return rotary ? "true" : "false"; });
}

// That of the first sample; a load that changes is told as such.
std::string load(const scenario::Load& l) {
  const auto first = [](const std::vector<Eigen::Vector3d>& all) { return all.empty() ? Eigen::Vector3d::Zero().eval() : all.front(); };
  const auto changes = [](const std::vector<Eigen::Vector3d>& all) {
    return std::ranges::any_of(all, [&](const Eigen::Vector3d& x) { return x != all.front(); });
  };
  return fmt::format("{{force:{},moment:{},varies:{}}}", numbers(first(l.force)), numbers(first(l.moment)),
                     changes(l.force) || changes(l.moment));
}

// What was recorded is what the plugin computes, at home and where its coordinates lead one by one, and along the motion.
bool is_recorded_well(const Analysis& a) {
  const mechanics::Machine& machine = a.machine();
  const std::vector<Coordinate>& coordinates = machine.topology().coordinates;
  const Eigen::Index dof = machine.dof();
  mechanics::Trajectory about_home;
  about_home.value = machine.home().transpose().replicate(1 + 2 * dof, 1);
  for (Eigen::Index i = 0; i < dof; ++i) {
    const Coordinate& c = coordinates[static_cast<std::size_t>(i)];
    about_home.value(1 + 2 * i, i) = (c.home + c.box.min) / 2;
    about_home.value(2 + 2 * i, i) = (c.home + c.box.max) / 2;
  }
  about_home.time.resize(static_cast<std::size_t>(1 + 2 * dof));
  for (const mechanics::Trajectory* t : {static_cast<const mechanics::Trajectory*>(&about_home), &a.trajectory()})
    if (analysis::recording_deviation(machine, *t) > analysis::recording_rounding) return false;
  return true;
}

}  // namespace

std::string live_model(const Analysis& a) {
  const mechanics::Machine& machine = a.machine();
  const std::optional<LiveGeometry> g = live_geometry(machine);
  if (!g || !is_recorded_well(a)) return "";
  const Topology& t = machine.topology();
  std::string out = "{\n";
  const auto field = [&](const char* name, const std::string& value) { out.append(name).append(":").append(value).append(",\n"); };
  field("name", quoted(machine.info().title));
  field("length", written(a.length()));
  field("coordinates", coordinates(a, *g));
  field("actuators", actuators(t));
  field("derived", derived(t));
  field("bodies", bodies(t, *g));
  field("platform", std::to_string(t.platform));
  field("motions", motions(t, *g));
  field("rotaryRows", rotary_rows(t));
  field("gravity", numbers(a.scenario().load.gravity));
  field("load", load(a.scenario().load));
  field("at", fmt::format("{{actuators:{},derived:{},jacobian:{},rates:{},twist:{},masses:{},all:{}}}", g->actuators, g->derived,
                          g->jacobian, g->rates, g->twist, g->masses, g->program.outputs().size()));
  field("geometry", program::print_javascript(g->program));
  return out + "}";
}

}  // namespace pmreport::section
