// Every mechanism there is, with the choices that change its bodies or joints, and random motions of it.
#pragma once

#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <tests/plugins/plugin.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <memory>
#include <random>

namespace pmreport::test {

struct Named {
  std::string name;
  std::unique_ptr<mechanics::Machine> machine;
};

inline std::vector<Named> every_mechanism() {
  std::vector<Named> out;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PLUGINS))
    if (entry.path().extension() == ".so") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  REQUIRE(names.size() >= 8);
  const auto add = [&](const std::string& name, const std::string& label, const std::map<std::string, std::vector<double>>& changes) {
    out.push_back({label, std::make_unique<mechanics::Machine>(plugin(name), values_with(plugin(name), changes))});
  };
  for (const std::string& name : names) add(name, name, {});
  add("parallel-cross", "parallel-cross, outer", {{"variant", {choice(plugin("parallel-cross"), "variant", "outer")}}});
  add("5pus-upu", "5pus-upu, ideal", {{"constraint", {choice(plugin("5pus-upu"), "constraint", "ideal")}}});
  return out;
}

// Sizes of coordinates: the characteristic length, or a radian.
inline Eigen::VectorXd sizes(const mechanics::Machine& machine) {
  Eigen::VectorXd out(machine.dof());
  for (int i = 0; i < machine.dof(); ++i)
    out(i) =
        mechanics::size_of(machine.topology().coordinates[static_cast<std::size_t>(i)].sense(), mechanics::characteristic_length(machine));
  return out;
}

struct RandomMotion {
  Eigen::VectorXd q, rate, acceleration;
  mechanics::State state(const mechanics::Machine& machine) const {
    mechanics::State s;
    mechanics::evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
    return s;
  }
};

// A pose in the box of the coordinates that is in reach and away from singular ones, with rates of about a size, or a radian, a second.
inline RandomMotion random_motion(const mechanics::Machine& machine, std::mt19937_64& random) {
  std::uniform_real_distribution<double> symmetric(-1, 1);
  const Eigen::VectorXd size = sizes(machine);
  RandomMotion m{Eigen::VectorXd(machine.dof()), Eigen::VectorXd(machine.dof()), Eigen::VectorXd(machine.dof())};
  for (int tries = 0; tries < 1000; ++tries) {
    for (int i = 0; i < machine.dof(); ++i) {
      const Range& box = machine.topology().coordinates[static_cast<std::size_t>(i)].box;
      m.q(i) = 0.5 * (box.min + box.max) + 0.5 * (box.max - box.min) * symmetric(random);
      m.rate(i) = size(i) * symmetric(random);
      m.acceleration(i) = 3 * size(i) * symmetric(random);
    }
    const mechanics::State s = m.state(machine);
    constexpr double regular = 1e3;  // a condition number that leaves twelve digits
    if (s.status == PM_OK && mechanics::closed_form(machine, s, mechanics::characteristic_length(machine)).condition < regular) return m;
  }
  throw std::runtime_error("no regular pose found");
}

inline Eigen::Matrix<double, 6, 1> random_load(double length, std::mt19937_64& random) {
  std::uniform_real_distribution<double> symmetric(-1, 1);
  Eigen::Matrix<double, 6, 1> w;
  for (int i = 0; i < 6; ++i) w(i) = 100 * symmetric(random) * (i < 3 ? 1 : length);
  return w;
}
inline Eigen::Vector3d random_gravity(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return 9.81 * Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace pmreport::test
