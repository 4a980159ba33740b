#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/scenario/parts.hpp>
#include <core/scenario/text.hpp>

namespace pmreport::scenario {
namespace {

// The order of what a sample costs, to tell what a number of samples means. Bytes: a placement of five limbs is 154 scalars, each with
// rate and acceleration. Time: placing, and solving the equations of eleven bodies.
constexpr double bytes_per_sample = 154 * 3 * sizeof(double), seconds_per_sample = 50e-6;

std::string estimate(double samples) {
  const double gigabytes = samples * bytes_per_sample / 1e9, hours = samples * seconds_per_sample / 3600;
  return fmt::format("{} samples would take about {} GB of memory and {} h", format_number(samples, 3), format_number(gigabytes, 2),
                     format_number(hours, 2));
}

std::optional<std::size_t> read_samples(const Value& v, const Reader& reader) {
  if (v.kind != Value::Kind::integer) {
    if (v.kind != Value::Kind::refused) reader.diagnostics().add(v.place, "expected a whole number of samples, seen " + name_of(v));
    return std::nullopt;
  }
  const bool many = v.number > static_cast<double>(max_samples);
  if (v.number >= 2 && !many) return static_cast<std::size_t>(v.number);
  reader.diagnostics().add(
      v.place, fmt::format("expected 2 to {} samples, seen {}{}", max_samples, v.number, many ? "; " + estimate(v.number) : ""));
  return std::nullopt;
}

Curve at_home(const Coordinate& c) {
  const double home = c.home;
  const DisplayUnit unit = display_unit(c.unit, home);
  return {c.name,
          {},
          [home](double) { return Jet<double>(home); },
          fmt::format("{} = {}{}{} (home)", c.name, format_number(home * unit.per_si, 6), unit.label == "°" ? "" : " ", unit.label)};
}

// One expression for each coordinate; one without stays at home.
std::vector<Curve> read_expressions(TableReader& table, const Topology& topology) {
  std::vector<Curve> out;
  for (const Coordinate& c : topology.coordinates) {
    const Entry* e = table.find(c.name);
    if (e == nullptr) {
      out.push_back(at_home(c));
      continue;
    }
    auto written = table.read().expression(e->value, parse_unit(c.unit)->dimension, Time::allowed);
    if (!written) continue;
    const std::string description = fmt::format("{} = {}", c.name, printable(written->text));
    out.push_back(
        {c.name, written->place, [expression = std::move(written->expression)](double t) { return expression.at(t); }, description});
  }
  return out;
}

void refuse_expressions(const Value& table, const Topology& topology, const char* instead, Diagnostics& diagnostics) {
  for (const Entry& e : table.entries)
    for (const Coordinate& c : topology.coordinates)
      if (e.key == c.name)
        diagnostics.add(e.place, fmt::format("{} is given twice: here and by the {}", c.name, instead), "keep one of the two");
}

std::vector<double> uniform(const Interval& interval, std::size_t samples) {
  std::vector<double> time(samples);
  const double span = interval.end - interval.begin;
  for (std::size_t i = 0; i < samples; ++i) time[i] = interval.begin + span * static_cast<double>(i) / static_cast<double>(samples - 1);
  time.back() = interval.end;
  return time;
}

Motion sampled(const std::vector<Curve>& curves, std::vector<double> time, Diagnostics& diagnostics) {
  Motion out;
  const auto rows = static_cast<Eigen::Index>(time.size()), columns = static_cast<Eigen::Index>(curves.size());
  for (Eigen::MatrixXd* m : {&out.value, &out.rate, &out.acceleration}) m->resize(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const Curve& curve = curves[static_cast<std::size_t>(j)];
    out.description += (j > 0 ? "\n" : "") + curve.description;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double t = time[static_cast<std::size_t>(i)];
      const Jet<double> x = curve.at(t);
      if (!finite(x, t, curve.place, curve.name, diagnostics)) break;
      out.value(i, j) = x.value, out.rate(i, j) = x.rate, out.acceleration(i, j) = x.acceleration;
    }
  }
  out.asked = time.back();
  out.time = std::move(time);
  out.at = [curves](double t, double* value, double* rate, double* acceleration) {
    for (const Curve& curve : curves) {
      const Jet<double> x = curve.at(t);
      *value++ = x.value, *rate++ = x.rate, *acceleration++ = x.acceleration;
    }
    return true;
  };
  return out;
}

// Keys that are none: coordinates that cannot be given are told apart from slips.
void refuse_unknown(const Value& content, const MechanismPart& mechanism, Diagnostics& diagnostics) {
  std::vector<std::string> known{"duration", "samples", "profile", "waypoint", "file"};
  for (const Coordinate& c : mechanism.topology->coordinates) known.push_back(c.name);
  for (const Entry& e : content.entries)
    if (std::find(known.begin(), known.end(), e.key) == known.end())
      refuse_coordinate(e.place, e.key, mechanism, known, "[motion]", diagnostics);
}

std::optional<double> read_duration(const Entry* entry, const Reader& reader) {
  if (entry == nullptr) return std::nullopt;
  const auto duration = reader.quantity(entry->value, {0, 0, 1, 0});
  if (!duration || *duration > 0) return duration;
  reader.diagnostics().add(entry->value.place, fmt::format("expected a duration above 0 s, seen {} s", format_number(*duration, 6)));
  return std::nullopt;
}

}  // namespace

bool finite(const Jet<double>& x, double t, Place place, const std::string& what, Diagnostics& diagnostics) {
  const char* missing = !std::isfinite(x.value)          ? "value"
                        : !std::isfinite(x.rate)         ? "rate"
                        : !std::isfinite(x.acceleration) ? "acceleration"
                                                         : nullptr;
  if (missing == nullptr) return true;
  diagnostics.add(place, fmt::format("{} has no finite {} at t = {} s", what, missing, format_number(t, 6)));
  return false;
}

void refuse_coordinate(Place place, const std::string& name, const MechanismPart& mechanism, std::vector<std::string> known,
                       const std::string& where, Diagnostics& diagnostics) {
  for (const Derived& d : mechanism.topology->derived) {
    if (!d.dependent || d.name != name) continue;
    std::string hint = "leave it out";
    for (const auto& p : mechanism.info.parameters)
      if (p.kind == PM_CHOICE && std::find(p.choices.begin(), p.choices.end(), name) != p.choices.end()) {
        std::vector<std::string> others = p.choices;
        std::erase(others, name);
        hint += fmt::format(", or let another coordinate follow: {} = {} in [mechanism.parameters]", p.name, listed(others, "or", true));
      }
    diagnostics.add(place,
                    fmt::format("{} is a dependent coordinate of {}: it follows from the others and cannot be given", name, mechanism.name),
                    hint);
    return;
  }
  diagnostics.add(place, fmt::format("unknown key {} in {}{}", in_quotes(name), where, did_you_mean(name, known)),
                  fmt::format("the keys are {}", listed(known, "and")));
}

MotionPart read_motion(const Entry* entry, const MechanismPart& mechanism, const std::filesystem::path& scenario, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  MotionPart part;
  if (entry == nullptr) {
    diagnostics.add(Place{}, "expected the table [motion], which is not there", "write [motion], duration = \"10 s\" and samples = 501");
    return part;
  }
  const Value* content = table_of(entry, "motion", reader);
  if (content == nullptr) return part;
  TableReader table(*content, "[motion]", entry->place, reader);
  const Entry *file = table.find("file"), *waypoints = table.find("waypoint"), *profile = table.find("profile"),
              *duration_entry = table.find("duration");
  const Entry* samples_entry = file != nullptr ? table.find("samples") : table.need("samples", "samples = 501");
  const auto samples = samples_entry != nullptr ? read_samples(samples_entry->value, reader) : std::nullopt;
  const auto duration = read_duration(duration_entry, reader);
  const bool by_points = file != nullptr || waypoints != nullptr;

  bool quintic = false;
  if (profile != nullptr) {
    const auto choice = reader.word(profile->value, {"quintic", "cubic-spline"}, "the profiles");
    quintic = choice == std::size_t{0};
    if (choice && !by_points)
      diagnostics.add(profile->place, "a profile leads through points, and there are none",
                      "add [[motion.waypoint]] tables, or file = \"NAME.csv\"");
  } else if (waypoints != nullptr && file == nullptr) {
    table.need("profile", "profile = \"quintic\" (at rest at every waypoint) or \"cubic-spline\" (at rest at the ends)");
  }
  if (file != nullptr && waypoints != nullptr)
    diagnostics.add(file->place, "the motion is given twice: by a file and by waypoints", "keep one of the two");
  if (file != nullptr && duration_entry != nullptr)
    diagnostics.add(duration_entry->place, "the times in the file say how long the motion lasts", "remove duration");
  if (!by_points) table.need("duration", "duration = \"10 s\"");

  if (!mechanism.topology) {
    if (!by_points && duration) part.interval = {0, *duration};
    return part;
  }
  const Topology& topology = *mechanism.topology;
  refuse_unknown(*content, mechanism, diagnostics);
  std::vector<Curve> curves;
  std::vector<double> own_times;
  if (by_points) {
    refuse_expressions(*content, topology, file != nullptr ? "file" : "waypoints", diagnostics);
    auto knots = file != nullptr ? read_motion_file(*file, quintic, topology, scenario, reader)
                                 : read_waypoints(*waypoints, quintic, topology, reader);
    if (knots) {
      curves = std::move(knots->curves);
      own_times = std::move(knots->times);
      part.interval = {own_times.front(), own_times.back()};
      if (duration && file == nullptr && *duration > own_times.back())
        diagnostics.add(duration_entry->value.place, fmt::format("expected at most the time of the last waypoint, {} s, seen {} s",
                                                                 format_number(own_times.back(), 6), format_number(*duration, 6)));
      else if (duration && file == nullptr)
        part.interval->end = *duration;
    }
  } else {
    curves = read_expressions(table, topology);
    if (duration) part.interval = {0, *duration};
  }
  if (!part.interval || curves.size() != topology.coordinates.size()) return part;
  if (samples)
    part.motion = sampled(curves, uniform(*part.interval, *samples), diagnostics);
  else if (samples_entry == nullptr && file != nullptr)
    part.motion = sampled(curves, std::move(own_times), diagnostics);
  return part;
}

}  // namespace pmreport::scenario
