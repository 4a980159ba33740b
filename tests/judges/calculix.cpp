// Elasticity of every mechanism before CalculiX, which knows its beams, its joints and where they are at a pose.
#include <core/host/plugin_file.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/stiffness/answers.hpp>
#include <pmreport/elastic.hpp>
#include <tests/judges/calculix_model.hpp>

#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <filesystem>
#include <functional>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;
using judges::CalculixDeck;
using judges::CalculixModel;

namespace {

// CalculiX prints seven digits: 5e-7 of a displacement, and of what is made of several, or stands across the largest, some more. Seen:
// 6e-7 of a compliance, 2.5e-6 with a bearing in every joint of 2q-spr.
constexpr double printed = 5e-6;

constexpr const char* all_mechanisms[] = {"gough",    "stewart", "parallel-cross", "4sps-spr", "p2prpu-prps",
                                          "5pus-upu", "2q-spr",  "delta",          "par4"};
constexpr std::span<const char* const> of_legs_and_rods(all_mechanisms, 7);  // none of whose beams ends between two joints
// Shares of half the box of each coordinate, from home.
constexpr double displaced[][6] = {{0.3, -0.4, 0.2, 0.35, -0.25, 0.3}, {-0.5, 0.2, 0.25, -0.3, 0.4, -0.35}};

struct Judged {
  Machine& machine;
  VectorXd coordinates;

  std::span<const double> span() const { return {coordinates.data(), static_cast<std::size_t>(coordinates.size())}; }
  ElasticPose ours(const Vector6d& load = Vector6d::Zero(), const Vector3d& gravity = Vector3d::Zero()) const {
    Elastostatics statics(machine);
    ElasticPose out = statics.at(coordinates, load, gravity, {true, true});
    REQUIRE(out.known);
    return out;
  }
  double length() const { return characteristic_length(machine); }
};

// Calls f for each of the mechanisms, default parameters, at displaced poses, in a section of its own.
template <class F>
void each(std::span<const char* const> names, std::size_t poses, F&& f) {
  for (const char* name : names) DYNAMIC_SECTION(name) {
      const host::PluginFile file = host::load_plugin(std::filesystem::path(PLUGINS) / (std::string(name) + ".so"));
      const pm_mechanism& table = *file.mechanisms.at(0);
      Machine machine(table, default_values(describe(table)));
      for (std::size_t k = 0; k < poses; ++k) {
        CAPTURE(name, k);
        VectorXd q = machine.home();
        for (Index i = 0; i < q.size(); ++i) {
          const Range& box = machine.topology().coordinates[static_cast<std::size_t>(i)].box;
          q(i) += displaced[k][i] * 0.5 * (box.max - box.min);
        }
        f(Judged{machine, q});
      }
    }
}

// Largest difference of two forms that are not negative, entry (i, j) by what it can be at most, sqrt(A_ii A_jj).
double difference(const Matrix6d& a, const Matrix6d& b) {
  const Vector6d scale = a.diagonal().cwiseSqrt().cwiseInverse();
  return (scale.asDiagonal() * (b - a) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

// x . B x by x . A x: least and largest. A positive.
struct Ratios {
  double least, largest;
};
Ratios ratios(const Matrix6d& b, const Matrix6d& a) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> parts(b, a, Eigen::EigenvaluesOnly);
  return {parts.eigenvalues()(0), parts.eigenvalues()(5)};
}

int joint_named(const Machine& machine, const std::string& name) {
  const auto& joints = machine.topology().joints;
  return static_cast<int>(std::ranges::find(joints, name, &Joint::name) - joints.begin());
}

}  // namespace

TEST_CASE("a cantilever in CalculiX gives way as Euler and Bernoulli have it, across both of its directions, and twists") {
  const double length = 0.8, bends_x = 1000, bends_y = 3000, axial = 2e7;
  const Vector3d foot(0.1, 0.2, 0.3), n = Vector3d(1, 2, -0.5).normalized(), x = n.unitOrthogonal(), y = n.cross(x);
  for (const double torsion : {2500.0, 700.0}) {  // Poisson's ratio -0.2; and 1.9, which no material has, but a rectangle may seem to
    CalculixDeck deck;
    const int root = deck.add_node(foot);
    int end = root;
    for (int i = 1; i <= 4; ++i) {
      const int next = deck.add_node(foot + n * (0.25 * i * length));
      deck.add_bar(end, next, {axial, torsion, bends_x, bends_y, x});
      end = next;
    }
    for (int k = 0; k < 6; ++k) deck.relate({{root, k, 1}});
    Matrix6d axes = Matrix6d::Zero();
    axes.topLeftCorner<3, 3>() << x, y, n;
    axes.bottomRightCorner<3, 3>() = axes.topLeftCorner<3, 3>();
    std::vector<CalculixDeck::Loads> loads;
    for (int k = 0; k < 6; ++k) loads.push_back({{end, axes.col(k)}});
    const std::vector<judges::Displacements> found = deck.solve(loads, {end});
    Matrix6d expected = Matrix6d::Zero(), seen;
    expected.diagonal() << std::pow(length, 3) / 3 / bends_y, std::pow(length, 3) / 3 / bends_x, length / axial, length / bends_x,
        length / bends_y, length / torsion;
    expected(0, 4) = expected(4, 0) = length * length / 2 / bends_y;
    expected(1, 3) = expected(3, 1) = -length * length / 2 / bends_x;
    for (int k = 0; k < 6; ++k) seen.col(k) = axes.transpose() * found[static_cast<std::size_t>(k)];
    CAPTURE(torsion, seen, expected);
    CHECK(difference(expected, seen) <= printed);
  }
}

TEST_CASE("CalculiX's compliance of every mechanism is that of the force method") {
  each(all_mechanisms, 2, [](const Judged& judged) {
    const Matrix6d ours = judged.ours().compliance, judge = CalculixModel(judged.machine, judged.span()).compliance();
    CAPTURE(ours, judge);
    CHECK(difference(ours, judge) <= printed);
  });
}

TEST_CASE("the compliance in CalculiX does not depend on how finely its beams are divided") {
  constexpr const char* some[] = {"2q-spr", "p2prpu-prps"};
  each(some, 1, [](const Judged& judged) {
    const CalculixModel coarse(judged.machine, judged.span(), CalculixModel::Mass::of_bodies, 1),
        fine(judged.machine, judged.span(), CalculixModel::Mass::of_bodies, 16);
    CHECK(difference(fine.compliance(), coarse.compliance()) <= printed);
  });
}

TEST_CASE("beams that couples alone bend, or nothing does, have CalculiX's compliance") {
  constexpr const char* some[] = {"p2prpu-prps", "stewart", "2q-spr", "5pus-upu"};
  each(some, 1, [](const Judged& judged) {
    const Matrix6d bent = judged.ours().compliance;
    for (const Bending bends : {Bending::couples, Bending::none}) {
      CAPTURE(static_cast<int>(bends));
      ElasticSettings settings;
      settings.bends = bends;
      judged.machine.give(settings);
      const CalculixModel model(judged.machine, judged.span(), CalculixModel::Mass::of_bodies, 1);
      const Matrix6d ours = judged.ours().compliance, judge = model.compliance();
      CAPTURE(ours, judge);
      CHECK(difference(bent, ours) > 1e-3);
      CHECK(difference(ours, judge) <= printed);
    }
  });
}

TEST_CASE("bearings, rails, flat bars and drives in series give way in CalculiX as they do in the force method") {
  const auto check = [](const char* name, const std::function<void(const Machine&, ElasticSettings&)>& give) {
    const char* const names[] = {name};
    each(names, 2, [&](const Judged& judged) {
      judged.machine.give({});
      const Matrix6d before = judged.ours().compliance;
      ElasticSettings settings;
      give(judged.machine, settings);
      judged.machine.give(settings);
      const Matrix6d ours = judged.ours().compliance, judge = CalculixModel(judged.machine, judged.span()).compliance();
      CAPTURE(ours, judge);
      CHECK(difference(ours, before) > 1e-3);  // they do matter
      CHECK(difference(ours, judge) <= printed);
    });
  };
  check("gough", [](const Machine& m, ElasticSettings& s) {
    for (int j = 0; j < static_cast<int>(m.topology().joints.size()); ++j)
      s.added.push_back(bearing("at" + std::to_string(j), j, 80e6, 30e6 + 1e6 * j, 2e4, 3e4));
  });
  check("2q-spr", [](const Machine& m, ElasticSettings& s) {  // where bearings share self-stresses with the beams
    for (int j = 0; j < static_cast<int>(m.topology().joints.size()); ++j)
      s.added.push_back(bearing("at" + std::to_string(j), j, 80e6, 30e6 + 1e6 * j, 2e4, 3e4));
    for (const char* flat : {"lower11", "lower22", "upper12", "rod11"})
      for (const Element& e : m.topology().elements)
        if (e.name == flat) {
          s.added.push_back(e);
          s.added.back().section = rectangle(0.012, 0.045);
        }
  });
  check("p2prpu-prps", [](const Machine& m, ElasticSettings& s) {
    for (const char* flat : {"limb1", "limb2", "limb3"})
      for (const Element& e : m.topology().elements)
        if (e.name == flat) {
          s.added.push_back(e);
          s.added.back().section = rectangle(0.02, 0.06);
        }
    s.added.push_back(rail("own", joint_named(m, "PX"), joint_named(m, "PX"), steel, solid(0.02), 0.3));  // of the drive itself
    for (int i = 0; i < 5; ++i) s.drives.push_back(20e6 + 5e6 * i);
    s.added.push_back(bearing("foot", joint_named(m, "R21"), 50e6, 40e6, 1e5));
  });
  check("parallel-cross", [](const Machine& m, ElasticSettings& s) {
    for (const Element& e : m.topology().elements)
      if (e.name.starts_with("leg")) {
        s.added.push_back(e);
        s.added.back().section = rectangle(0.02, 0.06);
      }
  });
}

TEST_CASE("beams, drives and rails carry in CalculiX what they carry in the force method, redundant constraints or not") {
  each(all_mechanisms, 2, [](const Judged& judged) {
    std::vector<Vector6d> loads;
    for (int k = 0; k < 6; ++k) loads.push_back(Vector6d::Unit(k) * (k < 3 ? 100 : 10));
    loads.push_back((Vector6d() << 30, -20, 50, 3, -2, 4).finished());
    const std::vector<Element>& elements = judged.machine.topology().elements;
    const std::vector<CalculixModel::Answer> judge = CalculixModel(judged.machine, judged.span()).under(loads);
    for (std::size_t k = 0; k < loads.size(); ++k) {
      const ElasticPose ours = judged.ours(loads[k]);
      std::vector<BeamForces> carried = beam_forces(ours, elements.size(), ours.forces);
      for (std::size_t i = 0; i < ours.parts.springs.size(); ++i)
        if (const Spring& s = ours.parts.springs[i]; s.kind == Spring::Kind::drive || s.kind == Spring::Kind::rail)
          carried[static_cast<std::size_t>(s.element)].axial = -ours.forces(static_cast<Index>(i));
      double force = 0, moment = loads[k].tail<3>().norm();
      for (const BeamForces& c : carried) force = std::max(force, std::abs(c.axial)), moment = std::max({moment, c.bending, c.torque});
      moment = std::max(moment, 1e-3 * force * judged.length());  // of a machine of which nothing is bent
      for (std::size_t i = 0; i < elements.size(); ++i) {
        CAPTURE(k, elements[i].name);
        // Of opposite ends the larger is told, with its sign: two that are as large may differ in it.
        CHECK(std::abs(std::abs(judge[k].carried[i].axial) - std::abs(carried[i].axial)) <= printed * force);
        CHECK(std::abs(judge[k].carried[i].bending - carried[i].bending) <= printed * moment);
        CHECK(std::abs(judge[k].carried[i].torque - carried[i].torque) <= printed * moment);
        if (elements[i].kind != ElementKind::beam) CHECK(std::abs(judge[k].carried[i].axial - carried[i].axial) <= printed * force);
      }
    }
  });
}

TEST_CASE("elasticity settles the two self-stresses of P(2PRPU)/PRPS and the six of 2Q-SPR") {
  constexpr const char* redundant[] = {"p2prpu-prps", "2q-spr"};
  each(redundant, 1, [](const Judged& judged) {
    const ElasticPose ours = judged.ours();
    CHECK(ours.open == 0);
    CHECK(ours.settled == (judged.machine.info().name == "2q-spr" ? 6 : 2));
  });
}

TEST_CASE("kinetic energy in static shapes, and the sag under weight, are CalculiX's") {
  each(all_mechanisms, 2, [](const Judged& judged) {
    const Vector3d gravity(1, -2, -9.5);
    const ElasticPose ours = judged.ours(Vector6d::Zero(), gravity);
    const CalculixModel judge(judged.machine, judged.span());
    CHECK(difference(ours.inertia, judge.inertia()) <= printed);
    const Vector6d sag = judge.sag(gravity);
    CAPTURE(sag.transpose(), ours.by_weights.transpose());
    CHECK((sag - ours.by_weights).head<3>().norm() <= printed * sag.head<3>().norm());
    CHECK((sag - ours.by_weights).tail<3>().norm() <= printed * sag.tail<3>().norm());
  });
}

// How far the reduction to the platform can be off. With the platform held the limbs vibrate at w_k, the lowest w_1, and take part in the
// motion of the platform by p_k; shaken at w the platform feels, exactly,
//     M(w) = M + sum of p_k p_k^T w^2 / (w_k^2 - w^2),   sum of p_k p_k^T = M_limbs,   M = M_platform + M_limbs as of (5) in
//     elastostatics.hpp
// so that below w_1  M <= M(w) <= M (1 + s w^2 / (w_1^2 - w^2)), s the largest share of limbs in the energy of any motion. By Courant and
// Fischer the reduced frequency w_r of every mode w < w_1 then has
//     w <= w_r <= w sqrt(1 + s w^2 / (w_1^2 - w^2))
// which is next to nothing where limbs are stiff, and much where their own bending is almost as slow as the platform.
TEST_CASE("frequencies of the platform are never below CalculiX's, and above them by no more than limbs explain that vibrate themselves") {
  each(of_legs_and_rods, 1, [](const Judged& judged) {
    const ElasticPose ours = judged.ours();
    const std::vector<Mode> reduced = modes(ours.compliance, ours.inertia, judged.length());
    const CalculixModel judge(judged.machine, judged.span());
    const auto whole = judge.modes();
    const double slowest = judge.modes(CalculixModel::Platform::held).front().frequency;
    const double share = ratios(ours.inertia - ours.platform_inertia, ours.inertia).largest;
    CAPTURE(slowest, share);
    int judged_modes = 0;
    for (std::size_t i = 0; i < reduced.size() && whole[i].frequency < slowest; ++i, ++judged_modes) {
      const double f = whole[i].frequency, square = f * f;
      const double most = std::sqrt(1 + share * square / (slowest * slowest - square));
      CAPTURE(i, f, reduced[i].frequency, most);
      CHECK(reduced[i].frequency >= f * (1 - printed));
      CHECK(reduced[i].frequency <= f * most * (1 + printed));
    }
    CHECK(judged_modes >= 3);
  });
}

TEST_CASE("the first twelve frequencies of every machine, its limbs' own among them, are CalculiX's") {
  each(all_mechanisms, 1, [](const Judged& judged) {
    const std::vector<WholeMode> ours = whole_modes(judged.ours(), 12);
    const auto whole = CalculixModel(judged.machine, judged.span()).modes();
    REQUIRE(ours.size() == 12);
    REQUIRE(whole.size() >= 12);
    for (std::size_t i = 0; i < 12; ++i) {
      CAPTURE(i, ours[i].frequency, whole[i].frequency);
      CHECK(ours[i].frequency == Approx(whole[i].frequency).epsilon(printed));
    }
  });
}

// The bound above, with the energy of rods in the place of that of the bodies, of which it is between `least` and `largest`. The first
// frequency of gough, whose legs bend as slowly, is 13 per cent above that with rods, and 19 above that with bodies; of 5pus-upu 1.2 and
// 2.9; of p2prpu-prps 0.3 and 0.2; of 2q-spr 0.1 and 0.1.
TEST_CASE("bodies with their mass along the beams vibrate in CalculiX within the same bounds") {
  constexpr const char* some[] = {"gough", "p2prpu-prps", "5pus-upu", "2q-spr"};
  each(some, 1, [](const Judged& judged) {
    const ElasticPose ours = judged.ours();
    const std::vector<Mode> reduced = modes(ours.compliance, ours.inertia, judged.length());
    const CalculixModel judge(judged.machine, judged.span(), CalculixModel::Mass::along_beams, 4);
    const Matrix6d inertia = judge.inertia();
    const Ratios more = ratios(inertia, ours.inertia);
    const double share = ratios(inertia - ours.platform_inertia, inertia).largest;
    const auto whole = judge.modes();
    const double slowest = judge.modes(CalculixModel::Platform::held).front().frequency;
    CAPTURE(slowest, share, more.least, more.largest);
    // A rod bends with its beam, a body does not: up to 8 per cent more energy in static shapes, with the limbs of p2prpu-prps.
    CHECK(more.least > 0.95);
    CHECK(more.largest < 1.1);
    for (std::size_t i = 0; i < reduced.size() && whole[i].frequency < slowest; ++i) {
      const double f = whole[i].frequency, square = f * f;
      const double most = std::sqrt(more.largest * (1 + share * square / (slowest * slowest - square)));
      INFO(judged.machine.info().name << ", mode " << i + 1 << ": " << reduced[i].frequency << " Hz, with rods " << f << " Hz");
      CAPTURE(most);
      CHECK(reduced[i].frequency >= f * std::sqrt(more.least) * (1 - printed));
      CHECK(reduced[i].frequency <= f * most * (1 + printed));
    }
  });
}
