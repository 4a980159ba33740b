#include <catch2/catch.hpp>
#include <reports/section/snapshots/snapshots.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;

TEST_CASE("a whole scenario is read") {
  const Loaded loaded = load_text(R"toml(title = "A stage – Prüfung 机构"
author = "N. N."
description = "Two freedoms."

[mechanism]
use = "stage"
parameters = { arm = "25 cm", ratio = 2.5, grid = ["1 mm", "2 mm", "3 mm"] }

[motion]
duration = "10 s"
samples = 5
x = "20 mm * t/10 s"

[load]
force = ["0 N", "10 N", "-1 N/s * t"]
moment = ["0 N*m", "10 N*mm", "0 N*m"]
gravity = ["0 m/s^2", "9.81 m/s^2", "0 m/s^2"]

[[section]]
kind = "mechanism"
title = "Its parts"

[[section]]
kind = "snapshots"
times = ["0 s", "2.5 s"]
views = ["front", { azimuth = "30 deg", elevation = "20 deg" }]
size = [800, 600]
ground = "transparent"
labels = false

[[section]]
kind = "displacement"

[[section]]
kind = "statics"

[[check]]
that = "max(abs(q_force))"
below = "0.4 kN"
above = "0 N"

[[check]]
that = "at( x , 2.5 s )"
below = "10 mm"
)toml",
                                  "a.toml", stage::source(), section::kinds());
  const Scenario& s = loaded.scenario;
  CHECK(s.title == "A stage – Prüfung 机构");
  CHECK(s.author == "N. N.");
  CHECK(s.description == "Two freedoms.");
  CHECK(s.mechanism == "stage");
  CHECK(s.parameters.at(0).at(0) == Approx(0.25));
  CHECK(s.parameters.at(4).at(0) == 2.5);
  CHECK(s.parameters.at(5) == std::vector{0.001, 0.002, 0.003});
  CHECK(s.parameters_set == std::vector<std::size_t>{0, 4, 5});
  REQUIRE(loaded.machine);
  CHECK(loaded.machine->values() == s.parameters);

  CHECK(loaded.trajectory.time == std::vector<double>{0, 2.5, 5, 7.5, 10});
  CHECK(loaded.trajectory.value(4, 0) == Approx(0.02));
  CHECK(loaded.trajectory.rate(2, 0) == Approx(0.002));
  CHECK(loaded.trajectory.value(4, 1) == 0);
  CHECK(s.motion->description == "x = 20 mm * t/10 s\nphi = 0° (home)");

  REQUIRE(s.load.force.size() == 5);
  CHECK(s.load.force[4] == Eigen::Vector3d(0, 10, -10));
  CHECK(s.load.moment[1].y() == Approx(0.01));
  CHECK(s.load.gravity == Eigen::Vector3d(0, 9.81, 0));
  CHECK(s.load.description ==
        "force = (0 N, 10 N, -1 N/s * t)\nmoment = (0 N*m, 10 N*mm, 0 N*m)\ngravity = (0 m/s^2, 9.81 m/s^2, 0 m/s^2)");

  REQUIRE(s.sections.size() == 4);
  CHECK(s.sections[0].kind->name == "mechanism");
  CHECK(s.sections[0].title == "Its parts");
  CHECK(s.sections[0].line == 19);
  const auto& snapshots = options_of<section::SnapshotsOptions>(s.sections[1]);
  CHECK(snapshots.times == std::vector<double>{0, 2.5});
  REQUIRE(snapshots.views.size() == 2);
  CHECK(snapshots.views[0].name == "front");
  CHECK(snapshots.views[1].name == "azimuth 30°, elevation 20°");
  CHECK(snapshots.views[1].azimuth == Approx(0.5235987755982988));
  CHECK(snapshots.width == 800);
  CHECK(snapshots.height == 600);
  CHECK(snapshots.transparent);
  CHECK_FALSE(snapshots.labels);
  CHECK(snapshots.path);

  REQUIRE(s.checks.size() == 2);
  CHECK(s.checks[0].reduction == "max");
  CHECK(s.checks[0].absolute);
  CHECK(s.checks[0].columns == std::vector<std::string>{"q_force"});
  CHECK(s.checks[0].unit == "N");
  CHECK(s.checks[0].below == 400.0);
  CHECK(s.checks[0].above == 0.0);
  CHECK(s.checks[1].reduction == "at");
  CHECK_FALSE(s.checks[1].absolute);
  CHECK(s.checks[1].time == 2.5);
  CHECK(s.checks[1].below == 0.01);
  CHECK_FALSE(s.checks[1].above);
}

TEST_CASE("load and snapshots have sane defaults") {
  const Loaded loaded = load_text(with("kind = \"displacement\"", "kind = \"snapshots\""), "a.toml", stage::source(), section::kinds());
  const Scenario& s = loaded.scenario;
  CHECK(s.load.gravity == Eigen::Vector3d(0, 0, 0));
  CHECK(s.load.description == "no gravity: the bodies are weightless");
  CHECK(s.load.force.size() == loaded.trajectory.time.size());
  REQUIRE(s.sections.size() == 1);
  const auto& snapshots = options_of<section::SnapshotsOptions>(s.sections[0]);
  CHECK(snapshots.times == std::vector<double>{0});
  REQUIRE(snapshots.views.size() == 1);
  CHECK(snapshots.views[0].name == "auto");
  CHECK_FALSE(snapshots.overlay);
  CHECK(s.checks.empty());
}
