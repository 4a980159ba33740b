// Brackets of shapes with edges and corners, of several orientations, and of what is hardly a shape at all.
#include <catch2/catch.hpp>
#include <tests/scan/closed_sets.hpp>
#include <tests/scan/holds.hpp>

#include <random>
#include <stdexcept>

using namespace pmreport;
using namespace pmreport::scan;
using program::Bounds;

namespace {

ProvedVolume to(double gap, const PoseSet& set, const Scan& scan, std::size_t need = 1) {
  VolumeOptions options;
  options.gap = gap;
  options.need = need;
  options.boxes = 400'000;
  return prove_volume(set, scan, options);
}

// Unit discs about (cos t, sin t): t is the orientation.
PoseSet turned_disc() {
  return recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    const Recorded dx = r.input(0) - cos(r.input(2)), dy = r.input(1) - sin(r.input(2));
    m.push_back(Recorded(1.0) - dx * dx - dy * dy);
  });
}
Scan turned_scan(std::vector<double> angles) {
  Scan scan;
  scan.at = {0, 0, 0};
  scan.points = {{0, -2.1, 2.2, 1}, {1, 2.3, -2.1, 1}};  // one of them reversed
  scan.turned = {2};
  for (const double t : angles) scan.orientations.push_back({t});
  return scan;
}

}  // namespace

TEST_CASE("Corners, a lens, and a cone to its tip are bracketed") {
  for (int d = 1; d <= 4; ++d) {
    CAPTURE(d);
    const PoseSet corner = recorded_set(d, [d](program::Recorder& r, std::vector<Recorded>& m) {
      Recorded left(1.0);
      for (int a = 0; a < d; ++a) m.push_back(r.input(a)), left = left - r.input(a);
      m.push_back(left);
    });
    const double gap = d < 4 ? 1e-3 : 0.05;
    const ProvedVolume proved = to(gap, corner, off_centre(d, 1.2));
    check_holds(proved, 1 / std::tgamma(d + 1));
    CHECK(proved.enough);
  }
  const double apart = 0.7;
  const PoseSet lens = recorded_set(3, [apart](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(1.0) - square_distance(r, {0, 0, 0}));
    m.push_back(Recorded(1.0) - square_distance(r, {apart, 0, 0}));
  });
  const ProvedVolume of_lens = to(3e-3, lens, off_centre(3, 1.1));
  check_holds(of_lens, M_PI * (4 + apart) * (2 - apart) * (2 - apart) / 12);
  CHECK(of_lens.enough);
  const PoseSet cone = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(r.input(2) - Recorded(0.8) * sqrt(r.input(0) * r.input(0) + r.input(1) * r.input(1)));
    m.push_back(Recorded(1.0) - r.input(2));
  });
  const ProvedVolume of_cone = to(3e-3, cone, off_centre(3, 1.4));
  check_holds(of_cone, M_PI / (3 * 0.64));
  CHECK(of_cone.enough);
}

TEST_CASE("A box that random planes cut has the volume that random poses count") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int trial = 0; trial < 8; ++trial) {
    const int d = 2 + trial % 2;
    std::vector<std::vector<double>> planes(3, std::vector<double>(static_cast<std::size_t>(d) + 1));
    for (std::vector<double>& p : planes) {
      for (double& x : p) x = any(random);
      p.back() = 0.4 * std::abs(p.back());
    }
    const PoseSet set = recorded_set(d, [&](program::Recorder& r, std::vector<Recorded>& m) {
      for (const std::vector<double>& p : planes) {
        Recorded g(p.back());
        for (int a = 0; a < d; ++a) g = g + Recorded(p[static_cast<std::size_t>(a)]) * r.input(a);
        m.push_back(g);
      }
    });
    const Scan scan = off_centre(d, 1, 0);
    const ProvedVolume proved = to(2e-3, set, scan);
    constexpr int poses = 20'000;
    int counted = 0;
    for (int k = 0; k < poses; ++k) {
      std::vector<double> x(static_cast<std::size_t>(d));
      for (double& c : x) c = any(random);
      counted += std::ranges::all_of(planes, [&](const std::vector<double>& p) {
        double g = p.back();
        for (std::size_t a = 0; a < x.size(); ++a) g += p[a] * x[a];
        return g >= 0;
      });
    }
    const double share = double(counted) / poses, slack = 5 * std::sqrt(0.25 / poses);
    CAPTURE(trial, planes, share, proved.volume.low, proved.volume.high);
    CHECK(proved.enough);
    CHECK(proved.volume.low / scan.range() - slack <= share);
    CHECK(share <= proved.volume.high / scan.range() + slack);
  }
}

TEST_CASE("Of two orientations one or both, of three two: brackets hold the discs' union, lens and what is counted") {
  const double apart = std::sqrt(2.0), lens = 2 * std::acos(apart / 2) - apart / 2 * std::sqrt(4 - apart * apart);
  const Scan two = turned_scan({0, M_PI / 2});
  for (const std::size_t need : {1, 2}) {
    const ProvedVolume proved = to(1e-3, turned_disc(), two, need);
    check_holds(proved, need == 1 ? 2 * M_PI - lens : lens);
    CHECK(proved.enough);
  }
  CHECK(to(1e-3, turned_disc(), two, 3).empty);

  const std::vector<double> angles{0.1, 1.3, 2.9};
  const ProvedVolume proved = to(2e-3, turned_disc(), turned_scan(angles), 2);
  CHECK(proved.enough);
  // Middles of 400 x 400 cells; those that the boundary may cross are told apart.
  double least = 0, most = 0;
  constexpr int cells = 400;
  const double step = 4.4 / cells, reach = step / std::sqrt(2.0) * 1.01;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      int sure = 0, maybe = 0;
      for (const double t : angles) {
        const double r = std::hypot(-2.2 + (i + 0.5) * step - std::cos(t), -2.2 + (j + 0.5) * step - std::sin(t));
        sure += r + reach <= 1, maybe += r - reach <= 1;
      }
      least += sure >= 2 ? step * step : 0, most += maybe >= 2 ? step * step : 0;
    }
  CHECK(proved.volume.low <= most);
  CHECK(least <= proved.volume.high);
}

TEST_CASE("Axes without a range are numbers, and what has no volume comes to an end") {
  const PoseSet ball = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(1.0) - square_distance(r, {0, 0, 0}));
  });
  Scan slice = off_centre(3, 1.1);
  slice.points[1].from = slice.points[1].to = 0.6;
  const ProvedVolume disc = to(1e-3, ball, slice);
  check_holds(disc, M_PI * 0.64);
  CHECK(disc.enough);
  CHECK(disc.low[1] == Bounds::exactly(0.6));

  Scan point = slice;
  for (Axis& axis : point.points) axis.from = axis.to = 0.1;
  CHECK(to(1e-3, ball, point).volume == Bounds::exactly(1));
  for (Axis& axis : point.points) axis.from = axis.to = 2;
  CHECK(to(1e-3, ball, point).empty);

  const PoseSet surface = recorded_set(2, [](program::Recorder& r, std::vector<Recorded>& m) {
    const Recorded off = r.input(0) - Recorded(0.3);
    m.push_back(-(off * off));
  });
  const ProvedVolume line = to(1e-3, surface, off_centre(1, 1));
  CHECK_FALSE(line.enough);
  CHECK_FALSE(line.empty);
  CHECK(line.volume.low == 0);
  CHECK(line.volume.high < 1e-12);
  CHECK(line.why.find("as narrow as numbers are") != std::string::npos);
  CHECK_FALSE(line.low[0].bounded());
  const ProvedVolume plane = to(1e-3, surface, off_centre(2, 1));
  CHECK_FALSE(plane.enough);
  CHECK(plane.why.find("after 4") == 0);
  CHECK(plane.volume.high < 1e-3);
}

TEST_CASE("A proof that must end early says so, and its bracket still holds: margins of no program are refused") {
  const PoseSet ball = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(1.0) - square_distance(r, {0, 0, 0}));
  });
  VolumeOptions options;
  options.gap = 1e-9;
  options.boxes = 5000;
  const ProvedVolume few = prove_volume(ball, off_centre(3, 1.1), options);
  CHECK_FALSE(few.enough);
  CHECK(few.why.find("after ") == 0);
  check_holds(few, 4 * M_PI / 3);
  options.seconds = 0;
  const ProvedVolume none = prove_volume(ball, off_centre(3, 1.1), options);
  CHECK(none.why.find("after 0 s") == 0);
  check_holds(none, 4 * M_PI / 3);

  // 1 / x has no bounds about zero, where it is no number.
  const PoseSet pole =
      recorded_set(1, [](program::Recorder& r, std::vector<Recorded>& m) { m.push_back(Recorded(1.0) / r.input(0) - Recorded(0.5)); });
  options = {};
  options.boxes = 20;
  const ProvedVolume near_pole = prove_volume(pole, off_centre(1, 3), options);
  CHECK(near_pole.undecided > 0);
  check_holds(near_pole, 2);

  PoseSet late = ball;
  late.late = {1, [](std::size_t, const double*, double*) {}};
  CHECK_THROWS_AS(prove_volume(late, off_centre(3, 1), {}), std::invalid_argument);
}
