// Compliances of the mechanisms against reference cases: springs and positions in 60 digits, with the platform displaced by Newton.
#include <core/mechanics/stiffness/answers.hpp>
#include <pmreport/elastic.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/Geometry>
#include <memory>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::check_equal, test::json, test::matrix, test::number, test::vector;

namespace {

std::unique_ptr<Machine> elastic_machine_of(const json& c) {
  const pm_mechanism& table = test::plugin(c["mechanism"].get<std::string>());
  std::map<std::string, std::vector<double>> changes;
  for (const auto& [name, value] : c["parameters"].items()) {
    if (value.is_string())
      changes[name] = {test::choice(table, name, value.get<std::string>())};
    else if (value.is_array())
      changes[name] = value.get<std::vector<double>>();
    else
      changes[name] = {value.get<double>()};
  }
  return std::make_unique<Machine>(table, test::values_with(table, changes));
}

VectorXd coordinates_of(const Machine& m, const json& pose) {
  VectorXd q(m.dof());
  for (int i = 0; i < m.dof(); ++i) q(i) = pose.at(m.topology().coordinates[static_cast<std::size_t>(i)].name).get<double>();
  return q;
}

struct Prepared {
  std::unique_ptr<Machine> machine;
  VectorXd q;
};

// Elements of the reference, in the words of a scenario.
Prepared prepared(const json& c) {
  Prepared out{elastic_machine_of(c), {}};
  out.q = coordinates_of(*out.machine, c["pose"]);
  const Topology& t = out.machine->topology();
  const std::string name = c["mechanism"].get<std::string>();
  const json& elements = c["elements"];
  ElasticSettings settings;
  for (const Element& e : t.elements) settings.rigid.push_back(e.name);
  const Pose pose = out.machine->pose({out.q.data(), static_cast<std::size_t>(out.q.size())});
  if (name == "gough" || name == "stewart" || name == "parallel-cross" || name == "4sps-spr") {
    for (std::size_t i = 0; i < t.actuators.size(); ++i)
      settings.added.push_back(spring_drive("k" + std::to_string(i + 1), static_cast<int>(i), elements[i]["stiffness"].get<double>()));
    // The force along the axis of the hinge is what the hinge passes along its own axis.
    if (name == "4sps-spr" && !elements[5]["rigid"].get<bool>())
      settings.added.push_back(
          bearing("along_n6", test::joint_named(*out.machine, "B5"), elements[5]["stiffness"].get<double>(), Element::rigid));
  } else if (name == "5pus-upu") {
    for (int i = 0; i < 5; ++i) {
      const json& e = elements[static_cast<std::size_t>(i)];
      const std::string n = std::to_string(i + 1);
      const int u = test::joint_named(*out.machine, "U" + n), s = test::joint_named(*out.machine, "S" + n);
      const double length = (out.machine->centre(pose, s) - out.machine->centre(pose, u)).norm();
      Material made_of = steel;
      CrossSection section = solid(0.01);
      section.area = e["rod_stiffness"].get<double>() * length / made_of.modulus;
      settings.added.push_back(beam("rod_" + n, u, s, made_of, section));
      settings.added.push_back(spring_drive("k" + n, i, e["drive_stiffness"].get<double>()));
    }
    // The program's constraint row has a couple of size |a4 x a2| at U6', where a4 x a2 is not the joint's own axis but across it.
    const int u = test::joint_named(*out.machine, "U6p");
    const double size = out.machine->axis(pose, u, 1).cross(out.machine->axis(pose, u, 0)).norm();
    settings.added.push_back(bearing("couple", u, Element::rigid, Element::rigid, elements[5]["stiffness"].get<double>() * size * size));
  } else {
    const json& s = elements["limb_section"];
    std::map<std::string, std::vector<double>> changes;
    const double diameter = 2 * std::sqrt(s["S"].get<double>() / std::numbers::pi);
    ParameterValues values = out.machine->values();
    const auto set = [&](const char* parameter, double value) {
      const auto& all = out.machine->info().parameters;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == parameter) values[i] = {value};
    };
    set("young_modulus", s["E"].get<double>());
    set("shear_modulus", s["G"].get<double>());
    for (const char* d : {"limb_diameter", "rail_x_diameter", "rail_y_diameter"}) set(d, diameter);
    set("limb_bending", elements["limb_bending"].get<bool>() ? 0 : 1);
    out.machine = out.machine->with(values);
    return out;
  }
  out.machine->give(settings);
  return out;
}

}  // namespace

TEST_CASE("compliances of the mechanisms equal those of springs in 60 digits") {
  for (const json& c : test::reference("stiffness.json")["cases"]) {
    const std::string id = c["id"].get<std::string>();
    CAPTURE(id);
    const Prepared p = prepared(c);
    const json& expected = c["expected"];
    const Vector6d load = vector(c["load"]["wrench_at_reference_point"]);
    Elastostatics statics(*p.machine);
    const ElasticPose at = statics.at(p.q, load, Vector3d::Zero(), {true, false});
    REQUIRE(at.known);
    CHECK(at.open == 0);
    const MatrixXd compliance = matrix(expected["compliance"]);
    for (const auto& [what, r, k] : {std::tuple{"pF", 0, 0}, {"pT", 0, 3}, {"PhiF", 3, 0}, {"PhiT", 3, 3}})
      check_equal(what, MatrixXd(at.compliance.block<3, 3>(r, k)).reshaped(), MatrixXd(compliance.block<3, 3>(r, k)).reshaped(),
                  std::sqrt(compliance.block<3, 3>(r, r).norm() * compliance.block<3, 3>(k, k).norm()));
    check_equal("translation", at.deflection.head<3>(), vector(expected["deflection"]).head(3));
    check_equal("rotation", at.deflection.tail<3>(), vector(expected["deflection"]).tail(3));

    const DeformationIndices i = deformation_indices(at.compliance);
    const json& s = expected["block_singular_values"];
    for (const auto& [name, value, scale] : {std::tuple{"pF_max", i.pF_max, 0.0},
                                             {"pF_min", i.pF_min, 0.0},
                                             {"pT_max", i.pT_max, 0.0},
                                             {"pT_min", i.pT_min, i.pT_max},
                                             {"PhiT_max", i.PhiT_max, 0.0},
                                             {"PhiT_min", i.PhiT_min, i.PhiT_max}})
      check_equal(name, value, number(s[name]), scale);

    const double length = characteristic_length(*p.machine);
    const auto stiffness = stiffness_of(at.compliance, length);
    CHECK(rank_of(at.compliance, length) == expected["rank_of_compliance"].get<int>());
    CHECK(stiffness.has_value() == !expected["stiffness"].is_null());
    if (stiffness) {
      const MatrixXd k = matrix(expected["stiffness"]);
      check_equal("stiffness", stiffness->reshaped(), k.reshaped());
    }
    if (c.contains("tool") && !c["tool"].is_null()) {
      const json& tool = c["tool"];
      const Pose pose = p.machine->pose({p.q.data(), static_cast<std::size_t>(p.q.size())});
      const Vector3d r = p.machine->rotation(pose, p.machine->topology().platform) * test::vector3(tool["point_in_platform_axes"]);
      const Matrix6d t = to_tool(r, Eigen::Matrix3d::Identity());
      const Vector6d w = (Vector6d() << test::vector3(tool["force"]), test::vector3(tool["moment"])).finished();
      const Vector6d d = t.transpose() * at.compliance * t * w;
      check_equal("at the tool", d.head<3>(), vector(expected["tool_deflection"]));
      check_equal("rotation at the tool", d.tail<3>(), vector(expected["tool_rotation"]));
    }
    if (expected.contains("natural_frequencies_hz")) {
      const auto all = modes(at.compliance, at.platform_inertia, length);
      const VectorXd f = vector(expected["natural_frequencies_hz"]);
      REQUIRE(all.size() == 6);
      for (std::size_t m = 0; m < 6; ++m) check_equal("frequency", all[m].frequency, f(static_cast<Eigen::Index>(m)));
    }
    if (expected.contains("eigenscrews")) {
      const auto screws = eigenscrews(*stiffness);
      const double largest = std::abs(screws[5].lambda);
      for (std::size_t m = 0; m < 6; ++m) {
        const json& e = expected["eigenscrews"][m];
        check_equal("eigenvalue", screws[m].lambda, e["eigenvalue"].get<double>(), largest);
        check_equal("pitch", screws[m].pitch, e["pitch"].get<double>());
      }
    }
  }
}
