#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/scenario/motion/motion_part.hpp>
#include <core/scenario/motion/solve.hpp>
#include <core/text/text.hpp>
#include <iterator>

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

// 0, told, when it is no number of samples.
std::size_t read_samples(const Value& v, const Reader& reader) {
  reader.takes(v, Shape::whole(2, max_samples));
  if (v.kind != Value::Kind::integer) {
    if (v.kind != Value::Kind::refused) reader.diagnostics().add(v.place, "expected a whole number of samples, seen " + name_of(v));
    return 0;
  }
  const bool many = v.number > static_cast<double>(max_samples);
  if (v.number >= 2 && !many) return static_cast<std::size_t>(v.number);
  reader.diagnostics().add(
      v.place, fmt::format("expected 2 to {} samples, seen {}{}", max_samples, v.number, many ? "; " + estimate(v.number) : ""));
  return 0;
}

void refuse_expressions(const Value& table, const Movables& movables, const char* instead, Diagnostics& diagnostics) {
  for (const Entry& e : table.entries)
    for (const std::vector<Moved>* list : {&movables.coordinates, &movables.actuators})
      for (const Moved& m : *list)
        if (without_rate(e.key) == m.name)
          diagnostics.add(e.place, fmt::format("{} is given twice: here and by the {}", m.name, instead), "keep one of the two");
}

std::vector<double> uniform(const TimeSpan& span, std::size_t samples) {
  std::vector<double> time(samples);
  const double length = span.end - span.begin;
  for (std::size_t i = 0; i < samples; ++i) time[i] = span.begin + length * static_cast<double>(i) / static_cast<double>(samples - 1);
  time.back() = span.end;
  return time;
}

constexpr const char *of_forces[] = {"start", "start_rate", "forces"}, *of_points[] = {"profile", "waypoint", "file", "unwrap"};

// Keys that are none of a motion that follows from forces; coordinates and actuators are told by read_forces.
void refuse_unknown_of_forces(const Value& content, const Movables& movables, Diagnostics& diagnostics) {
  std::vector<std::string> known{"from", "duration", "samples", "until"};
  known.insert(known.end(), std::begin(of_forces), std::end(of_forces));
  const std::string keys = fmt::format("the keys are {}", listed(known, "and"));
  for (const std::vector<Moved>* list : {&movables.coordinates, &movables.actuators})
    for (const Moved& m : *list) known.push_back(m.name);
  for (const Entry& e : content.entries)
    if (std::find(std::begin(of_points), std::end(of_points), e.key) != std::end(of_points))
      diagnostics.add(e.place, fmt::format("{} is of a prescribed motion, and this one follows from forces", e.key),
                      "remove it, or from = \"forces\"");
    else if (std::find(known.begin(), known.end(), without_rate(e.key)) == known.end() &&
             std::find(known.begin(), known.end(), e.key) == known.end())
      diagnostics.add(e.place, fmt::format("unknown key {} in [motion]{}", in_quotes(e.key), did_you_mean(e.key, known)), keys);
}

// Keys that are none: coordinates that cannot be given are told apart from slips.
void refuse_unknown(const Value& content, const MechanismPart& mechanism, const Movables& movables, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  std::vector<std::string> known{"duration", "samples", "until", "profile", "waypoint", "file", "unwrap", "from"};
  const std::string keys =
      fmt::format("the keys are {}; and the coordinates {}, or the actuators {}, each also by its rate, {}_rate", listed(known, "and"),
                  names_of(movables.coordinates), names_of(movables.actuators), movables.coordinates.front().name);
  for (const char* suffix : {"", "_rate"})
    for (const std::vector<Moved>* list : {&movables.coordinates, &movables.actuators})
      for (const Moved& m : *list) known.push_back(m.name + suffix);
  for (const std::string& key : known) reader.looks_for(content, key);
  for (const Entry& e : content.entries)
    if (std::find(std::begin(of_forces), std::end(of_forces), e.key) != std::end(of_forces))
      diagnostics.add(e.place, fmt::format("{} is of a motion that follows from forces, and this one is prescribed", e.key),
                      "add from = \"forces\", or remove it");
    else if (std::find(known.begin(), known.end(), e.key) == known.end())
      refuse_coordinate(e.place, e.key, mechanism, known, "[motion]", diagnostics, keys);
}

// The first law that the user wrote.
Place place_of(const Laws& laws, Place otherwise) {
  for (const Law& law : laws.laws)
    if (law.place.line > 0) return law.place;
  return otherwise;
}

std::optional<double> read_duration(const Entry* entry, const Reader& reader) {
  if (entry == nullptr) return std::nullopt;
  const auto duration = reader.quantity(entry->value, {0, 0, 1, 0});
  if (!duration || *duration > 0) return duration;
  reader.diagnostics().add(entry->value.place, fmt::format("expected a duration above 0 s, seen {} s", format_number(*duration, 6)));
  return std::nullopt;
}

// Rising times that another law has too.
void join(std::vector<double>& times, const std::vector<double>& more) {
  std::vector<double> both;
  std::set_union(times.begin(), times.end(), more.begin(), more.end(), std::back_inserter(both));
  times = std::move(both);
}

MotionRequest request_of(const Laws& laws) {
  MotionRequest out;
  out.by = laws.by_actuators ? MotionRequest::By::actuators : MotionRequest::By::coordinates;
  for (const Law& law : laws.laws) out.description += (out.description.empty() ? "" : "\n") + law.description;
  out.prescribed = [laws = laws.laws](double t, double* value, double* rate, double* acceleration) {
    for (const Law& law : laws) {
      const Jet<double> x = law.at(t);
      *value++ = x.value, *rate++ = x.rate, *acceleration++ = x.acceleration;
    }
    return true;
  };
  out.over = [laws = laws.laws](program::Bounds time, mechanics::Bounded* bounded) {
    bool known = false;
    for (const Law& law : laws) {
      const Jet<program::Bounds> x = law.over(time);
      known = known || x.value.bounded();
      *bounded++ = {x.value, x.rate, x.acceleration};
    }
    return known;
  };
  for (const Law& law : laws.laws) join(out.steps, law.steps);
  return out;
}

// Knots and breaks of all laws.
void take_breaks(const Laws& laws, mechanics::Trajectory& out) {
  for (const Law& law : laws.laws) {
    std::vector<double> knots;
    for (const Switch& s : law.switches) knots.push_back(s.time());
    join(out.knots, knots);
    out.breaks.insert(out.breaks.end(), law.breaks.begin(), law.breaks.end());
  }
  std::stable_sort(out.breaks.begin(), out.breaks.end(),
                   [](const mechanics::Break& x, const mechanics::Break& y) { return x.time < y.time; });
}

void take(MotionRequest request, mechanics::Trajectory solved, MotionPart& part) {
  part.request = std::move(request);
  part.trajectory = std::move(solved);
  part.span->end = part.trajectory.time.back();
}

MotionPart read_motion_from_forces(const Value& content, Place place, const MechanismPart& mechanism, const Load& load,
                                   const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  TableReader table(content, "[motion]", place, reader);
  MotionPart part;
  const Entry *samples_entry = table.need("samples", "samples = 501"), *duration_entry = table.need("duration", "duration = \"2 s\"");
  const std::size_t samples = samples_entry != nullptr ? read_samples(samples_entry->value, reader) : 0;
  const auto duration = read_duration(duration_entry, reader);
  if (duration) part.span = {0, *duration};
  if (!mechanism.topology) return part;
  const Movables movables(mechanism);
  refuse_unknown_of_forces(content, movables, diagnostics);
  const auto forces = read_forces(content, place, mechanism, movables, reader);
  // An integration takes its time, and a load that is wrong would lead it elsewhere: it begins when all is sound that it stands on.
  if (!forces || !duration || samples == 0 || mechanism.machine == nullptr || !diagnostics.empty()) return part;
  MotionRequest request;
  request.by = MotionRequest::By::forces;
  request.forces = all_of(*forces);
  request.end = part.span->end;
  request.until_singularity = forces->until_singularity;
  request.description = forces->description;
  auto solved = forced(*forces, request, load, uniform(*part.span, samples), *mechanism.machine, diagnostics);
  if (solved) take(std::move(request), std::move(*solved), part);
  return part;
}

}  // namespace

MotionPart read_motion(const Entry* entry, bool needed, const MechanismPart& mechanism, const Load& load,
                       const std::filesystem::path& scenario, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  MotionPart part;
  if (entry == nullptr && !needed) {
    part.span = TimeSpan{0, -1};
    return part;
  }
  if (entry == nullptr) {
    diagnostics.add(Place{}, "expected the table [motion], which is not there", "write [motion], duration = \"10 s\" and samples = 501");
    return part;
  }
  const Value* content = table_of(entry, "motion", reader);
  if (content == nullptr) return part;
  TableReader table(*content, "[motion]", entry->place, reader);
  if (const Entry* from = table.find("from")) {
    reader.word(from->value, {"forces"}, "what a motion may follow from");
    return read_motion_from_forces(*content, entry->place, mechanism, load, reader);
  }
  const Entry *file = table.find("file"), *waypoints = table.find("waypoint"), *profile = table.find("profile"),
              *duration_entry = table.find("duration"), *until = table.find("until"), *unwrap = table.find("unwrap");
  const Entry* samples_entry = file != nullptr ? table.find("samples") : table.need("samples", "samples = 501");
  const std::size_t samples = samples_entry != nullptr ? read_samples(samples_entry->value, reader) : 0;
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
  if (unwrap != nullptr && !by_points)
    diagnostics.add(unwrap->place, "the angles of points are unwrapped, and there are no points", "remove unwrap");
  if (file != nullptr && waypoints != nullptr)
    diagnostics.add(file->place, "the motion is given twice: by a file and by waypoints", "keep one of the two");
  if (file != nullptr && duration_entry != nullptr)
    diagnostics.add(duration_entry->place, "the times in the file say how long the motion lasts", "remove duration");
  if (!by_points) table.need("duration", "duration = \"10 s\"");
  if (until != nullptr) reader.word(until->value, {"singularity"}, "what a motion may last until");

  if (!mechanism.topology) {
    if (!by_points && duration) part.span = {0, *duration};
    return part;
  }
  const Movables movables(mechanism);
  refuse_unknown(*content, mechanism, movables, reader);
  std::optional<Laws> laws;
  std::vector<double> time;
  if (by_points) {
    refuse_expressions(*content, movables, file != nullptr ? "file" : "waypoints", diagnostics);
    laws = file != nullptr ? read_motion_file(*file, {quintic, unwrap}, movables, scenario, reader)
                           : read_waypoints(*waypoints, {quintic, unwrap}, movables, reader);
    if (!laws) return part;
    part.span = {laws->times.front(), laws->times.back()};
    if (duration && file == nullptr && *duration > part.span->end)
      diagnostics.add(duration_entry->value.place, fmt::format("expected at most the time of the last waypoint, {} s, seen {} s",
                                                               format_number(part.span->end, 6), format_number(*duration, 6)));
    else if (duration && file == nullptr)
      part.span->end = *duration;
    if (samples_entry == nullptr && file != nullptr) time = laws->times;
    if (samples > 0) time = uniform(*part.span, samples);
  } else {
    if (duration) part.span = {0, *duration};
    if (duration && samples > 0) time = uniform(*part.span, samples);
    laws = read_expressions(*content, movables, duration, reader);
  }
  if (!laws || time.empty()) return part;
  MotionRequest request = request_of(*laws);
  request.end = time.back();
  request.until_singularity = until != nullptr;
  auto solved = sampled(*laws, request, std::move(time), diagnostics);
  if (!solved || mechanism.machine == nullptr) return part;
  if (laws->by_actuators)
    solved = followed(request, *solved, *mechanism.machine, place_of(*laws, entry->place), diagnostics);
  else if (until != nullptr)
    solved = end_at_singularity(std::move(*solved), *mechanism.machine, until->place, diagnostics);
  if (!solved) return part;
  if (!laws->by_actuators) solved->over = request.over;
  take_breaks(*laws, *solved);
  mechanics::cut_off(*solved, solved->time.size());
  take(std::move(request), std::move(*solved), part);
  return part;
}

}  // namespace pmreport::scenario
