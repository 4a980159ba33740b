// Brackets of volumes against closed forms.
#include <catch2/catch.hpp>
#include <tests/scan/closed_sets.hpp>
#include <tests/scan/holds.hpp>

#include <tbb/global_control.h>
#include <random>

using namespace pmreport;
using namespace pmreport::scan;

namespace {

void check_reaches(const ProvedVolume& proved, double gap) {
  CHECK(proved.enough);
  CHECK(proved.why.empty());
  CHECK(proved.volume.high - proved.volume.low <= gap * proved.volume.middle());
}

PoseSet ball(int axes, double radius) {
  return recorded_set(axes, [&](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(radius * radius) - square_distance(r, std::vector<double>(static_cast<std::size_t>(axes), 0.0)));
  });
}

}  // namespace

TEST_CASE("The bracket of a ball holds its volume in one to six dimensions, and is as narrow as asked") {
  const double gaps[] = {1e-9, 1e-5, 4e-3, 0.06, 0.4, 1.2};
  for (int d = 1; d <= 6; ++d) {
    CAPTURE(d);
    VolumeOptions options;
    options.gap = gaps[d - 1];
    const ProvedVolume proved = prove_volume(ball(d, 0.75), off_centre(d, 1), options);
    check_holds(proved, unit_ball(d) * std::pow(0.75, d));
    check_reaches(proved, options.gap);
    CHECK(proved.undecided == 0);
    CHECK_FALSE(proved.empty);
    for (std::size_t a = 0; a < static_cast<std::size_t>(d); ++a) {
      CHECK(proved.low[a].has(-0.75));
      CHECK(proved.high[a].has(0.75));
      CHECK(proved.low[a].width() < 0.4);
      CHECK(proved.high[a].width() < 0.4);
    }
  }
}

TEST_CASE("Four times the boxes of a shell leave a quarter of the gap or less") {
  const double inner = 0.5, outer = 1.0, truth = 4.0 / 3 * M_PI * (outer * outer * outer - inner * inner * inner);
  const PoseSet shell = recorded_set(3, [&](program::Recorder& r, std::vector<Recorded>& m) {
    const Recorded square = square_distance(r, {0, 0, 0});
    m.push_back(square - Recorded(inner * inner));
    m.push_back(Recorded(outer * outer) - square);
  });
  std::uint64_t boxes = 0;
  for (const double gap : {3.2e-2, 8e-3, 2e-3}) {
    CAPTURE(gap, boxes);
    VolumeOptions options;
    options.gap = gap;
    const ProvedVolume proved = prove_volume(shell, off_centre(3, 1.05), options);
    check_holds(proved, truth);
    check_reaches(proved, gap);
    // The layer in doubt is as thick as the square of the boxes, of which there are as many as the inverse square: 4, and room for steps.
    if (boxes > 0) CHECK(proved.boxes < 7 * boxes);
    boxes = proved.boxes;
  }
}

TEST_CASE("A set that is empty, or all there is, is known to be after a look or few") {
  const PoseSet none = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(-0.01) - square_distance(r, {0.1, 0.2, 0.3}));
  });
  const ProvedVolume empty = prove_volume(none, off_centre(3, 1), {});
  CHECK(empty.empty);
  CHECK(empty.enough);
  CHECK(empty.volume == program::Bounds::exactly(0));
  CHECK_FALSE(empty.low[0].bounded());
  const Scan scan = off_centre(3, 1);
  const ProvedVolume all = prove_volume(ball(3, 4), scan, {});
  CHECK(all.boxes == 1);
  check_holds(all, scan.range());
  CHECK(all.volume.width() < 1e-14 * scan.range());
  CHECK(all.low[1].has(scan.points[1].from));
}

TEST_CASE("Two threads give the digits of one") {
  VolumeOptions options;
  options.gap = 2e-3;
  std::vector<ProvedVolume> of;
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    of.push_back(prove_volume(ball(3, 0.8), off_centre(3, 1), options));
  }
  CHECK(of[0].volume == of[1].volume);
  CHECK(of[0].boxes == of[1].boxes);
  CHECK(of[0].low == of[1].low);
  CHECK(of[0].high == of[1].high);
}
