#include <reports/program/cli/scenario_shape.hpp>

#include <core/mechanics/model/effort.hpp>
#include <core/scenario/loaded.hpp>
#include <core/scenario/read/asked.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace pmreport::program {

using scenario::Asked, scenario::Key, scenario::Shape, scenario::Value;

namespace {

constexpr const char* own_name = "named_by_the_scenario";  // of an element: such names may be anything

// Scenarios that have every key with every kind of value that may stand there. They need not be sound: what the reader asks for is looked
// at, whatever it then thinks of the answers. Those with forces lack a title, so that nothing is integrated.
class Questions {
 public:
  explicit Questions(const pm_mechanism& mechanism, const Topology& topology) : t_(topology) {
    head_ = fmt::format("[mechanism]\nuse = \"{}\"\nparameters = {{}}\n", mechanism.name);
    for (const Coordinate& c : t_.coordinates) moved_.push_back({c.name, c.unit});
    for (const Actuator& a : t_.actuators) moved_.push_back({a.name, a.unit});
  }

  std::vector<std::string> all() const {
    const std::string motion = "\n[motion]\nduration = \"1 s\"\nsamples = 2\nuntil = \"singularity\"\n";
    const std::string points = "profile = \"quintic\"\nunwrap = true\n", forces = "from = \"forces\"\n";
    return {"title = \"\"\nauthor = \"\"\ndescription = \"\"\ndetail = \"\"\n" + head_ + motion + prescribed() + sizes() + elastic() +
                sections(),
            head_ + motion + points + waypoints() + sizes_by_name() + elastic_drives() + sections(),
            head_ + motion + points + "file = \"none.csv\"\n" + sections(),
            head_ + motion + forces + start() + "\n[motion.forces]\nall = \"1 N\"\n" + sections(),
            head_ + motion + forces + "\n[motion.forces]\n" + forces_by_name() + sections()};
  }

 private:
  static std::string one(const std::string& unit) { return fmt::format("\"1 {}\"", unit); }

  std::string prescribed() const {
    std::string out;
    for (const auto& [name, unit] : moved_) out += fmt::format("{0} = {1}\n{0}_rate = {2}\n", name, one(unit), one(unit + "/s"));
    return out;
  }
  std::string waypoints() const {
    std::string out;
    for (const int time : {0, 1}) {
      out += fmt::format("\n[[motion.waypoint]]\ntime = \"{} s\"\n", time);
      for (const Coordinate& c : t_.coordinates) out += fmt::format("{} = {}\n", c.name, one(c.unit));
    }
    return out;
  }
  std::string start() const {
    std::string values, rates;
    for (const Coordinate& c : t_.coordinates) {
      values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", c.name, one(c.unit));
      rates += fmt::format("{}{} = {}", rates.empty() ? "" : ", ", c.name, one(c.unit + "/s"));
    }
    return fmt::format("start = {{ {} }}\nstart_rate = {{ {} }}\n", values, rates);
  }
  std::string forces_by_name() const {
    std::string out;
    for (const Actuator& a : t_.actuators) out += fmt::format("{} = {}\n", a.name, one(mechanics::unit_of_effort(a.sense())));
    return out;
  }
  std::string sizes() const {
    constexpr const char* drive =
        "efficiency = 1\nconvention = \"power\"\nlead = \"1 mm\"\nratio = 1\ninertia = \"1 kg*m^2\"\nstiffness = \"1 N/um\"\n";
    std::string out =
        "\n[load]\nforce = [\"1 N\", \"1 N\", \"1 N\"]\nmoment = [\"1 N*m\", \"1 N*m\", \"1 N*m\"]\n"
        "gravity = [\"1 m/s^2\", \"1 m/s^2\", \"1 m/s^2\"]\n";
    out += fmt::format("\n[drive]\n{}", drive);
    for (const Actuator& a : t_.actuators) out += fmt::format("\n[drive.{}]\n{}", a.name, drive);
    return out +
           "\n[limits]\nactuator_force = \"1 N\"\nactuator_speed = \"1 m/s\"\nactuator_power = \"1 W\"\njoint_force = \"1 N\"\n"
           "joint_moment = \"1 N*m\"\n";
  }
  std::string sizes_by_name() const {
    std::string out = "\n[limits]\n", actuators, joints;
    for (const Actuator& a : t_.actuators) actuators += fmt::format("{}{} = 1", actuators.empty() ? "" : ", ", a.name);
    for (const Joint& j : t_.joints) joints += fmt::format("{}{} = 1", joints.empty() ? "" : ", ", j.name);
    for (const char* key : {"actuator_force", "actuator_speed", "actuator_power"}) out += fmt::format("{} = {{ {} }}\n", key, actuators);
    for (const char* key : {"joint_force", "joint_moment"}) out += fmt::format("{} = {{ {} }}\n", key, joints);
    return out + "\n[elasticity]\nmaterial = { modulus = \"1 GPa\", shear_modulus = \"1 GPa\", expansion = 0 }\n";
  }
  // Drives apart: one that is added takes the place of the mechanism's own.
  std::string elastic_drives() const {
    std::string out;
    for (const Actuator& a : t_.actuators) out += new_element() + "drive = \"" + a.name + "\"\nstiffness = \"1 N/um\"\n";
    return out;
  }
  static std::string new_element() { return fmt::format("\n[[element]]\nname = \"{}\"\n", own_name); }
  std::string elastic() const {
    const std::string joint = t_.joints.front().name, zeros = "[0, 0, 0, 0, 0, 0]",
                      matrix = fmt::format("[{0}, {0}, {0}, {0}, {0}, {0}]", zeros);
    std::string misfits = fmt::format("{} = \"0 mm\"", own_name);
    for (const Element& e : t_.elements)
      if (e.kind != ElementKind::bearing) misfits += fmt::format(", {} = \"0 mm\"", e.name);
    std::string out = fmt::format(
        "\n[elasticity]\nrigid = [\"none\"]\nbending = \"none\"\nmaterial = \"steel\"\nplatform_compliance = {0}\nbase_compliance = {0}\n"
        "warmer = 0\nmisfit = {{ {1} }}\n",
        matrix, misfits);
    const std::string round = "diameter = \"2 mm\"\nbore = \"1 mm\"\n", flat = "width = \"1 mm\"\nheight = \"1 mm\"\n";
    const std::string made_of = "material = { modulus = \"1 GPa\", shear_modulus = \"1 GPa\", expansion = 0 }\n";
    const std::string element = new_element(), ends = fmt::format("[\"{0}\", \"{0}\"]\n", joint);
    out += element + "beam = " + ends + round + "material = \"steel\"\nbuckling_length = 1\nbending = \"none\"\n";
    out += element + "rail = " + ends + flat + made_of + "offset = \"1 mm\"\n";
    out +=
        element + "joint = \"" + joint + "\"\naxial = \"1 N/um\"\nradial = \"1 N/um\"\ntwisting = \"1 N*m/rad\"\ntilting = \"1 N*m/rad\"\n";
    return out;
  }
  // Numbers of several dimensions are checked, so that no bound seems to be of one dimension.
  std::string sections() const {
    std::string out = "\n[[section]]\nkind = \"displacement\"\n";
    const std::string bounds = "below = 1\nabove = 1\nequals = 1\nwithin = 1\n";
    for (const std::string& name : {t_.coordinates.front().name, t_.coordinates.front().name + "_rate", std::string("condition")})
      out += fmt::format("\n[[check]]\nthat = \"max({})\"\n{}", name, bounds);
    return out + "\n[[section]]\nkind = \"velocity\"\n";
  }

  const Topology& t_;
  std::string head_;
  std::vector<std::pair<std::string, std::string>> moved_;  // name, SI unit
};

const Shape anything = Shape::either({});
bool is_anything(const Shape& s) { return s.kind == Shape::Kind::either && s.of.empty(); }

Shape seen(const Value& value, const Asked& asked) {
  const auto taken = asked.taken.find(&value);
  if (value.kind == Value::Kind::table && asked.keys.contains(&value)) {
    std::vector<Key> keys;
    for (const Asked::Name& name : asked.keys.at(&value)) {
      Key key{name.key, anything, "", "", name.needed ? name.key : ""};
      const auto entry = std::ranges::find(value.entries, name.key, &scenario::Entry::key);
      if (entry != value.entries.end()) key.shape = seen(entry->value, asked);
      keys.push_back(std::move(key));
    }
    return Shape::table(std::move(keys));
  }
  if (value.kind == Value::Kind::array && !value.items.empty()) {
    Shape item = anything;
    for (const Value& v : value.items) item = merged(item, seen(v, asked));
    if (item.kind == Shape::Kind::table) return Shape::tables(std::move(item.keys));
    const bool counted = taken != asked.taken.end();
    Shape list = Shape::list(0, std::numeric_limits<std::size_t>::max(), std::move(item));
    if (counted) list.least = taken->second.least, list.most = taken->second.most;
    return list;
  }
  return taken != asked.taken.end() ? taken->second : anything;
}

// Keys of both; needed is what both need.
std::vector<Key> merged_keys(const std::vector<Key>& a, const std::vector<Key>& b) {
  std::vector<Key> out;
  for (Key key : a) {
    const auto other = std::ranges::find(b, key.name, &Key::name);
    if (other != b.end()) key.shape = merged(key.shape, other->shape);
    if (other == b.end() || !other->required()) key.example.clear();
    out.push_back(std::move(key));
  }
  for (Key key : b) {
    if (std::ranges::find(a, key.name, &Key::name) != a.end()) continue;
    key.example.clear();
    out.push_back(std::move(key));
  }
  return out;
}

// Of the same kind.
Shape merged_alike(Shape a, const Shape& b) {
  if (a.dimension != b.dimension) a.dimension.reset();
  for (const std::string& word : b.words)
    if (std::ranges::find(a.words, word) == a.words.end()) a.words.push_back(word);
  a.keys = merged_keys(a.keys, b.keys);
  if (a.named.empty()) a.named = b.named;
  a.least = std::min(a.least, b.least), a.most = std::max(a.most, b.most);
  for (std::size_t i = 0; i < a.of.size() && i < b.of.size(); ++i) a.of[i] = merged(a.of[i], b.of[i]);
  return a;
}

// Whether all of a group are there; of no group none is.
template <class Has>
bool has_all(const std::vector<std::string>& group, Has has) {
  return !group.empty() && std::ranges::all_of(group, has);
}

std::vector<std::vector<std::string>> groups_of_names(const Topology& t) {
  std::vector<std::vector<std::string>> out(6);
  for (const Coordinate& c : t.coordinates) out[0].push_back(c.name), out[1].push_back(c.name + "_rate");
  for (const Actuator& a : t.actuators) out[2].push_back(a.name), out[3].push_back(a.name + "_rate");
  for (const Joint& j : t.joints) out[4].push_back(j.name);
  for (const Element& e : t.elements)
    if (e.kind != ElementKind::bearing) out[5].push_back(e.name);
  return out;
}

void take_out(Shape& shape, const std::vector<std::vector<std::string>>& groups, const char* whose) {
  for (const std::vector<std::string>& group : groups) {
    if (has_all(group, [&](const std::string& name) { return std::ranges::find(shape.keys, name, &Key::name) != shape.keys.end(); })) {
      std::erase_if(shape.keys, [&](const Key& key) { return std::ranges::find(group, key.name) != group.end(); });
      shape.named = whose;
    }
    if (has_all(group, [&](const std::string& name) { return std::ranges::find(shape.words, name) != shape.words.end(); }))
      shape = Shape::text();
  }
  for (Key& key : shape.keys) take_out(key.shape, groups, whose);
  for (Shape& s : shape.of) take_out(s, groups, whose);
}

}  // namespace

Shape merged(const Shape& a, const Shape& b) {
  if (is_anything(a)) return b;
  if (is_anything(b)) return a;
  if (b.kind == Shape::Kind::either) {
    Shape out = a;
    for (const Shape& s : b.of) out = merged(out, s);
    return out;
  }
  if (a.kind == Shape::Kind::either) {
    Shape out = a;
    for (Shape& s : out.of)
      if (s.kind == b.kind) {
        s = merged_alike(s, b);
        return out;
      }
    out.of.push_back(b);
    return out;
  }
  return a.kind == b.kind ? merged_alike(a, b) : Shape::either({a, b});
}

Shape shape_of_scenario(const pm_mechanism& mechanism, const Topology& topology) {
  const std::filesystem::path file = "questions.toml";
  const scenario::MechanismSource source{[&](const std::string&) { return &mechanism; }, {mechanism.name}};
  Shape out = anything;
  for (const std::string& text : Questions(mechanism, topology).all()) {
    Asked asked;
    try {
      scenario::load_text(text, {file, source, section::kinds(), false, &asked});
    } catch (const scenario::ScenarioError&) {  // what it asked for is noted
    }
    out = merged(out, seen(*asked.document, asked));
  }
  take_out(out, {{own_name}}, "names of the scenario");
  return out;
}

Shape without_names(Shape shape, const Topology& topology) {
  take_out(shape, groups_of_names(topology), "names of the mechanism");
  return shape;
}

}  // namespace pmreport::program
