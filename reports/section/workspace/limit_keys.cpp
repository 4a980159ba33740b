// [[section.limit]]: what a pose must keep besides strokes and joints.
#include <reports/section/workspace/keys.hpp>

#include <core/mechanics/machine/limb_line.hpp>
#include <core/scenario/section/keys.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

namespace pmreport::section {

using scenario::Entry;
using scenario::Reading;
using scenario::Shape;
using scenario::Value;
namespace keys = scenario::keys;

namespace {

constexpr std::size_t most_limbs = 100;
constexpr const char* forms =
    "write angle = [1, 2] and against = \"base z\", or value = \"hinge_c1\", or distance = [1, 2, 3], or index = \"pressure\"";
const std::vector<std::string> indices{"pressure", "condition", "compliance", "transmission"};
const std::vector<std::string> forces{"any", "horizontal"};
const std::vector<std::string> directions{"base x",     "base y",     "base z",     "-base x",     "-base y",     "-base z",
                                          "platform x", "platform y", "platform z", "-platform x", "-platform y", "-platform z"};

std::vector<int> read_limbs(const Entry& entry, const Reading& r) {
  std::vector<int> out;
  const int limbs = r.mechanism.topology ? mechanics::limbs_of(*r.mechanism.topology) : static_cast<int>(most_limbs);
  for (const Value& item : items_of(entry, most_limbs, r.reader))
    if (const auto n = r.reader.integer(item, 1, limbs)) add_once(out, static_cast<int>(*n), item, r.reader);
  return out;
}

std::optional<mechanics::Direction> read_direction(const Value& v, const Reading& r) {
  mechanics::Direction out;
  if (v.kind != Value::Kind::table) {
    const auto word = r.reader.word(v, directions, "the directions");
    if (!word) return std::nullopt;
    const std::string& text = directions[*word];
    const bool opposite = text[0] == '-';
    if (text.find("platform") != std::string::npos && r.mechanism.topology) out.body = r.mechanism.topology->platform;
    out.axis = (opposite ? -1.0 : 1.0) * Eigen::Vector3d::Unit(text.back() - 'x');
    return out;
  }
  scenario::TableReader table(v, "against", v.place, r.reader);
  const Entry *body = table.find("body"), *axis = table.need("axis", "axis = [0, 0, 1], in the axes of the body");
  table.finish();
  if (body != nullptr && r.mechanism.topology) {
    std::vector<std::string> names;
    for (const Body& b : r.mechanism.topology->bodies) names.push_back(b.name);
    const auto word = r.reader.word(body->value, names, "the bodies");
    if (!word) return std::nullopt;
    out.body = static_cast<int>(*word);
  }
  const auto* numbers = axis != nullptr ? r.reader.list(axis->value, 3, "three numbers") : nullptr;
  if (numbers == nullptr) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    const auto x = r.reader.quantity((*numbers)[static_cast<std::size_t>(k)], {});
    if (!x) return std::nullopt;
    out.axis(k) = *x;
  }
  if (!(out.axis.norm() > 0)) {
    r.reader.diagnostics().add(axis->value.place, "expected a direction, seen three zeros");
    return std::nullopt;
  }
  return out;
}

// The dimension of what is limited; nothing, told, where it cannot be known.
std::optional<Dimension> dimension_of(const mechanics::AskedLimit& asked, const Reading& r) {
  if (std::holds_alternative<mechanics::AskedDistance>(asked.what)) return Dimension{1, 0, 0, 0};
  if (std::holds_alternative<mechanics::AskedCondition>(asked.what) || std::holds_alternative<mechanics::AskedTransmission>(asked.what))
    return Dimension{};
  if (std::holds_alternative<mechanics::AskedCompliance>(asked.what)) return parse_unit("m/N")->dimension;
  if (const auto* value = std::get_if<mechanics::AskedValue>(&asked.what); value != nullptr && r.mechanism.machine != nullptr)
    return parse_unit(mechanics::unit_of_value(*r.mechanism.machine, value->name))->dimension;
  return parse_unit("rad")->dimension;
}

std::optional<mechanics::AskedLimit> read_limit(const Value& content, const Reading& r) {
  const scenario::Reader& reader = r.reader;
  scenario::TableReader table(content, "[[section.limit]]", content.place, reader);
  const Entry *name = table.find("name"), *angle = table.find("angle"), *against = table.find("against"), *value = table.find("value"),
              *distance = table.find("distance"), *to = table.find("to"), *surfaces = table.find("surfaces"), *index = table.find("index"),
              *stiffness = table.find("drive_stiffness"), *force = table.find("force"), *every = table.find("every_orientation"),
              *min = table.find("min"), *max = table.find("max");
  table.finish();
  mechanics::AskedLimit out;
  if (name != nullptr) out.name = reader.text(name->value).value_or("");
  int given = 0;
  for (const Entry* e : {angle, value, distance, index}) given += e != nullptr ? 1 : 0;
  if (given != 1) {
    reader.diagnostics().add(content.place, fmt::format("expected one of angle, value, distance and index, seen {}", given), forms);
    return std::nullopt;
  }
  for (const auto& [key, needs, needed] : {std::tuple{against, angle, "angle"},
                                           {to, distance, "distance"},
                                           {surfaces, distance, "distance"},
                                           {every, index, "index"},
                                           {stiffness, index, "index"},
                                           {force, index, "index"}})
    if (key != nullptr && needs == nullptr)
      reader.diagnostics().add(key->place, fmt::format("{} belongs to a limit with {}", key->key, needed), "remove it");
  if (angle != nullptr) {
    mechanics::AskedAngle a{read_limbs(*angle, r), {}};
    if (against == nullptr) {
      reader.diagnostics().add(angle->place, "expected a direction that the angles are counted from, and there is none",
                               "write against = \"base z\", or against = { body = \"platform\", axis = [0, 0, 1] }");
      return std::nullopt;
    }
    const auto direction = read_direction(against->value, r);
    if (!direction || a.limbs.empty()) return std::nullopt;
    a.against = *direction;
    out.what = a;
  } else if (value != nullptr) {
    const auto text = reader.text(value->value);
    if (!text) return std::nullopt;
    out.what = mechanics::AskedValue{*text};
  } else if (distance != nullptr) {
    mechanics::AskedDistance d{read_limbs(*distance, r), {}, false};
    if (to != nullptr) d.with = read_limbs(*to, r);
    if (surfaces != nullptr) d.surfaces = reader.boolean(surfaces->value).value_or(false);
    if (d.limbs.empty()) return std::nullopt;
    out.what = d;
  } else {
    const auto word = reader.word(index->value, indices, "the indices");
    if (!word) return std::nullopt;
    if (*word == 0) out.what = mechanics::AskedPressure{};
    if (*word == 1) out.what = mechanics::AskedCondition{};
    if (*word == 3) out.what = mechanics::AskedTransmission{};
    if (*word == 2) {
      const auto k = stiffness != nullptr ? reader.quantity(stiffness->value, parse_unit("N/m")->dimension) : std::nullopt;
      if (!k || !(*k > 0)) {
        reader.diagnostics().add((stiffness != nullptr ? stiffness : index)->place, "expected the stiffness of the drives, above 0 N/m",
                                 "write drive_stiffness = \"1e4 N/m\"");
        return std::nullopt;
      }
      const auto direction =
          force != nullptr ? reader.word(force->value, forces, "the directions of the force") : std::optional<std::size_t>(0);
      if (!direction) return std::nullopt;
      out.what = mechanics::AskedCompliance{*k, *direction == 1};
    }
    if (every != nullptr) out.every = reader.boolean(every->value).value_or(false);
  }
  if (r.mechanism.machine != nullptr)
    if (const auto why = mechanics::refusal(*r.mechanism.machine, out)) {
      const Entry* at = angle != nullptr ? angle : value != nullptr ? value : distance != nullptr ? distance : index;
      reader.diagnostics().add(at->value.place, *why);
      return std::nullopt;
    }
  if (min == nullptr && max == nullptr) {
    reader.diagnostics().add(content.place, "expected a least value, a most, or both, and there is neither",
                             "write min = ... or max = ...");
    return std::nullopt;
  }
  const auto dimension = dimension_of(out, r);
  for (const auto& [entry, end] : {std::pair{min, &out.min}, {max, &out.max}})
    if (entry != nullptr) {
      const auto x = reader.quantity(entry->value, dimension.value_or(Dimension{}));
      if (!x) return std::nullopt;
      *end = *x;
    }
  if (!(out.min <= out.max)) {
    reader.diagnostics().add(min->value.place, "expected a least value below the most, seen one above it: no pose could keep both",
                             "exchange min and max");
    return std::nullopt;
  }
  // Angles of lines, pressure angles and distances have ends of their own; a limit beyond them no pose could keep.
  const double pi = std::numbers::pi;
  const double most = std::holds_alternative<mechanics::AskedAngle>(out.what)      ? pi
                      : std::holds_alternative<mechanics::AskedPressure>(out.what) ? pi / 2
                                                                                   : std::numeric_limits<double>::infinity();
  const bool is_length = std::holds_alternative<mechanics::AskedDistance>(out.what);
  if (std::holds_alternative<mechanics::AskedTransmission>(out.what) && (out.max < 0 || out.min > 1)) {
    reader.diagnostics().add((out.max < 0 ? max : min)->value.place,
                             "expected an index from 0 to 1, seen one beyond: no pose could keep it");
    return std::nullopt;
  }
  if ((std::isfinite(most) || is_length) && (out.max < 0 || out.min > most)) {
    reader.diagnostics().add(
        (out.max < 0 ? max : min)->value.place,
        is_length ? "expected a distance of 0 or more, seen one below: no pose could keep it"
                  : fmt::format("expected an angle from 0 to {:.0f} deg, seen one beyond: no pose could keep it", most * 180 / pi));
    return std::nullopt;
  }
  return out;
}

}  // namespace

std::vector<mechanics::AskedLimit> read_asked_limits(const Entry& entry, const Reading& r) {
  std::vector<mechanics::AskedLimit> out;
  for (const Value* content : tables_of(&entry, "section.limit", r.reader))
    if (auto limit = read_limit(*content, r)) out.push_back(std::move(*limit));
  return out;
}

Shape limit_shape() {
  const Shape limbs = Shape::list(1, most_limbs, Shape::whole(1, most_limbs));
  const Shape end = Shape::quantity(std::nullopt);
  return Shape::tables(
      {keys::within("name", Shape::text(), "for tables and figures"),
       keys::within("angle", limbs, "numbers of limbs, whose lines are held against a direction"),
       keys::within("against",
                    Shape::either({Shape::word(directions),
                                   Shape::table({keys::within("body", Shape::text(), "in whose axes", "the base"),
                                                 keys::within("axis", Shape::list(3, 3, Shape::quantity(Dimension{})), "")})}),
                    "that direction"),
       keys::within("value", Shape::text(),
                    "an actuator, a joint's motion, a derived quantity or a reading, or all of a group: `\"actuator\"`, "
                    "`\"joint_angle\"`, `\"derived\"`, `\"reading\"`"),
       keys::within("distance", limbs, "limbs, as segments, from each other, but those that share a joint"),
       keys::within("to", limbs, "from these instead"), keys::within("surfaces", Shape::boolean(), "less their radii", "`false`"),
       keys::within(
           "index", Shape::word(indices),
           "of every actuator its pressure angle, the condition number of G, the largest displacement by a force of 1 N with drives "
           "that yield, or the local transmission index"),
       keys::within("drive_stiffness", Shape::quantity(parse_unit("N/m")->dimension), "of every drive, for the compliance"),
       keys::within("force", Shape::word(forces), "which force", "any"),
       keys::within("every_orientation", Shape::boolean(),
                    "whether a point counts only where an index keeps its limit at all orientations that keep the other limits", "`false`"),
       keys::within("min", end, ""), keys::within("max", end, "")});
}

}  // namespace pmreport::section
