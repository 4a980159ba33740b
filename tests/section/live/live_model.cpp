// The machine as the page moves it has the numbers of the report.
#include <core/analysis/columns.hpp>
#include <nlohmann/json.hpp>
#include <reports/scene/gltf/machine_model.hpp>
#include <reports/section/front/live_geometry.hpp>
#include <reports/section/front/live_model.hpp>
#include <tests/recorded_program/in_node.hpp>
#include <tests/section/gantry.hpp>
#include <tests/section/live/house.hpp>
#include <tests/section/whole_report.hpp>

using namespace pmreport;
using namespace pmreport::section;
using Catch::Contains;
using nlohmann::json;

namespace {

const std::string loaded_and_heavy = R"([load]
force = ["10 N", "-20 N", "-50 N"]
moment = ["1 N*m", "2 N*m", "-3 N*m"]
gravity = ["0.5 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[[section]]
kind = "displacement"
[[section]]
kind = "velocity"
[[section]]
kind = "statics"
)";

template <class Derived>
json list(const Eigen::MatrixBase<Derived>& x) {
  json out = json::array();
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    for (Eigen::Index j = 0; j < x.cols(); ++j) out.push_back(x(i, j));
  return out;
}

// What the report has at sample k.
json numbers_of(const Analysis& a, int k) {
  const Topology& t = a.machine().topology();
  const auto at = [&](const ColumnId& column) { return a.column(column)[static_cast<std::size_t>(k)]; };
  json out{{"x", list(a.trajectory().value.row(k))},
           {"determinant", at(column_of(OfMachine::determinant))},
           {"condition", at(column_of(OfMachine::condition))}};
  for (const Actuator& x : t.actuators) {
    out["actuators"].push_back(at(column_of(x)));
    out["forces"].push_back(at(column_of(x, OfActuator::static_force)));
  }
  out["derived"] = json::array();
  for (const Derived& x : t.derived) out["derived"].push_back(at(column_of(x)));
  out["motions"] = json::object();
  for (const Joint& j : t.joints)
    for (std::size_t i = 0; i < j.limits.size(); ++i)
      if (const ColumnId column = analysis::joint_column(j, i); a.has(column))
        out["motions"][column.name()] = {{"value", at(column)}, {"low", j.limits[i].min}, {"high", j.limits[i].max}};
  const mechanics::Pose pose = a.pose(k);
  for (std::size_t b = 0; b < t.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    out["bodies"].push_back({{"slender", t.bodies[b].slender},
                             {"origin", list(a.machine().origin(pose, body))},
                             {"rotation", list(a.machine().rotation(pose, body))}});
  }
  return out;
}

// The nodes of the model file, at home and on a way from there.
json nodes_of(const Analysis& a) {
  std::vector<scene::Moment> moments{{0, a.machine().home_pose()}};
  for (int k = 0; k < a.samples(); ++k) moments.push_back({k + 1.0, a.pose(k)});
  json out = json::array();
  for (const scene::ModelNode& n : scene::model_of(a.machine(), moments).nodes)
    out.push_back({{"origin", list(n.translation)}, {"rotation", list(n.rotation.toRotationMatrix())}});
  return out;
}

}  // namespace

TEST_CASE("a live machine has the report's actuators, joint motions, margins, condition, determinant and forces, and finds its way back") {
  if (!in_node::here()) return;
  int live = 0;
  const in_node::Folder folder;
  json all = json::array();
  for (const std::string& name : house::names()) {
    const house::Run run(name, loaded_and_heavy);
    const std::string model = live_model(run.analysis);
    if (model.empty()) continue;
    ++live;
    CAPTURE(name, model.size());
    CHECK(model.size() < 60000);
    folder.write(name + ".js", model);
    json samples = json::array();
    for (int k = 0; k < run.analysis.samples(); ++k) samples.push_back(numbers_of(run.analysis, k));
    all.push_back(
        {{"name", name}, {"samples", samples}, {"nodes", nodes_of(run.analysis)}, {"platform", run.loaded.machine->topology().platform}});
  }
  CHECK(live >= 9);
  folder.write("expected.json", all.dump());
  CHECK(std::system(("node " SOURCE "/tests/section/live/live_machine.js '" + folder.file("") + "'").c_str()) == 0);
}

TEST_CASE("the report brings what moves the machine where it has pictures of it") {
  CHECK_THAT(whole_report::of_gantry("[[section]]\nkind = \"mechanism\"\n").live, Contains("geometry:(x,y)=>{"));
  CHECK(whole_report::of_gantry("[[section]]\nkind = \"displacement\"\n").live.empty());
}

TEST_CASE("a load that changes along the motion is told as that of its first instant") {
  const std::string still =
      live_model(gantry::Run("[load]\nforce = [\"0 N\", \"7 N\", \"0 N\"]\n[[section]]\nkind = \"statics\"\n").analysis);
  CHECK_THAT(still, Contains("load:{force:[0,7,0],moment:[0,0,0],varies:false}"));
  const std::string moving =
      live_model(gantry::Run("[load]\nforce = [\"0 N\", \"7 N + 1 N * t/1 s\", \"0 N\"]\n[[section]]\nkind = \"statics\"\n").analysis);
  CHECK_THAT(moving, Contains("load:{force:[0,7,0],moment:[0,0,0],varies:true}"));
}

TEST_CASE("a coordinate may be moved as far as its limits let it go alone, to ends that read well") {
  // The stroke of the gantry ends at one metre either way, and a fifth beyond is a round number.
  const std::string model = live_model(gantry::Run("[[section]]\nkind = \"displacement\"\n").analysis);
  CHECK_THAT(model, Contains("title:\"place on the rails\",unit:\"mm\",factor:1000,rotary:false,home:0,min:-1.2,max:1.2}"));
}

namespace {

// A plugin that records another geometry than it computes.
class Bent : public gantry::Gantry {
 public:
  static constexpr const char* name = "bent";
  explicit Bent(const Parameters& p) : Gantry(p) {}
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    Coordinates<T> there = q;
    if constexpr (std::is_same_v<T, Recorded>) there[0] = 1.01 * there[0];
    Gantry::place(there, at);
  }
};

std::string live_of(const scenario::MechanismSource& source) {
  const std::string text = "title = \"a\"\n[mechanism]\nuse = \"" + source.names.front() +
                           "\"\n[motion]\nduration = \"2 s\"\nsamples = 3\nx = \"0 mm\"\n[[section]]\nkind = \"displacement\"\n";
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", source, section::kinds());
  return live_model(Analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}));
}

}  // namespace

TEST_CASE("a mechanism that records nothing, or another geometry than its own, is not moved in the page") {
  CHECK_FALSE(live_of(gantry::source()).empty());
  CHECK(live_of(test::only<Bent>()).empty());
  static pm_mechanism silent = gantry::table();
  silent.record = nullptr;
  CHECK(live_of({[](const std::string&) { return &silent; }, {"gantry"}}).empty());
}

namespace {

class Evil : public gantry::Gantry {
 public:
  static constexpr const char *name = "evil", *title = "</script><script>alert(1)</script> \u2028 & \"quoted\" \\ `${1}`";
  explicit Evil(const Parameters& p) : Gantry(p) {}
};

}  // namespace

TEST_CASE("what a mechanism calls itself cannot end the script that it stands in") {
  const std::string model = live_of(test::only<Evil>());
  CHECK_THAT(model, !Contains("</") && !Contains("<!") && !Contains("\u2028"));
  CHECK_THAT(model, Contains("\\u003c/script\\u003e"));
  if (!in_node::here()) return;
  const in_node::Folder folder;
  folder.write("model.js", "process.exit((" + model +
                               ").name.startsWith('</script><script>alert(1)</script> \\u2028 & \"quoted\" \\\\ `${1}`') ? 0 : 1)");
  CHECK(std::system(("node '" + folder.file("model.js") + "'").c_str()) == 0);
}
