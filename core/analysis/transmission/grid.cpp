#include <core/analysis/transmission/grid.hpp>

#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/program/batch.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

constexpr std::size_t chunk = 256;  // poses: sums are made within chunks and then over them, so that no digit depends on the threads

Eigen::VectorXd pose_of(const GridRequest& request, const Eigen::VectorXd& home, std::size_t number) {
  Eigen::VectorXd q = home;
  for (std::size_t a = request.ranges.size(); a-- > 0;) {
    const ScanRange& r = request.ranges[a];
    const std::size_t k = number % r.count;
    number /= r.count;
    q(r.coordinate) = r.count > 1 ? r.from + (r.to - r.from) * static_cast<double>(k) / static_cast<double>(r.count - 1) : r.from;
  }
  return q;
}

struct Sum {
  double sum = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  std::size_t least_pose = 0, most_pose = 0, counted = 0, good = 0;

  void add(double x, std::size_t pose) {
    if (std::isnan(x)) return;
    ++counted, sum += x, good += x >= good_transmission ? 1 : 0;
    if (x < least) least = x, least_pose = pose;
    if (x > most) most = x, most_pose = pose;
  }
  void add(const Sum& s) {
    counted += s.counted, good += s.good, sum += s.sum;
    if (s.least < least) least = s.least, least_pose = s.least_pose;
    if (s.most > most) most = s.most, most_pose = s.most_pose;
  }
};

struct Sums {
  std::size_t accepted = 0;
  std::vector<Sum> indices;
};

}  // namespace

std::optional<TransmissionGrid> transmission_grid(const mechanics::Transmission& t, const GridRequest& request, std::string* why) {
  const mechanics::Machine& machine = t.machine();
  const auto margins = mechanics::pose_margins(machine, {request.strokes, request.joints, {}}, why);
  if (!margins) return std::nullopt;
  const Eigen::VectorXd home = machine.home();
  const auto dof = static_cast<std::size_t>(machine.dof());
  const std::size_t numbers = why_without(t).size(), outputs = margins->program.outputs().size();
  TransmissionGrid out;
  out.left_out = margins->left_out;
  out.poses = 1;
  for (const ScanRange& r : request.ranges) out.poses *= r.count;

  std::vector<Sums> sums((out.poses + chunk - 1) / chunk);
  tbb::parallel_for(std::size_t{0}, sums.size(), [&](std::size_t c) {
    const std::size_t first = c * chunk, count = std::min(chunk, out.poses - first);
    std::vector<double> in(dof * count), margin(outputs * count), at(numbers);
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::VectorXd q = pose_of(request, home, first + k);
      for (std::size_t i = 0; i < dof; ++i) in[i * count + k] = q(static_cast<Eigen::Index>(i));
    }
    program::Batch(margins->program).run(count, in.data(), margin.data());
    mechanics::Transmission::Work work;
    sums[c].indices.resize(numbers);
    for (std::size_t k = 0; k < count; ++k) {
      bool kept = true;
      for (std::size_t o = 0; o < outputs; ++o) kept = kept && margin[o * count + k] >= 0;
      if (!kept) continue;
      ++sums[c].accepted;
      const Eigen::VectorXd q = pose_of(request, home, first + k);
      transmission_numbers(t, {q.data(), dof}, work, at);
      for (std::size_t i = 0; i < numbers; ++i) sums[c].indices[i].add(at[i], first + k);
    }
  });

  std::vector<Sum> total(numbers);
  for (const Sums& s : sums) {
    out.accepted += s.accepted;
    for (std::size_t i = 0; i < numbers; ++i) total[i].add(s.indices[i]);
  }
  for (const Sum& s : total) {
    IndexOverGrid& index = out.indices.emplace_back();
    index.counted = s.counted, index.good = s.good;
    if (s.counted == 0) continue;
    index.mean = s.sum / static_cast<double>(s.counted), index.least = s.least, index.most = s.most;
    index.least_at = pose_of(request, home, s.least_pose), index.most_at = pose_of(request, home, s.most_pose);
  }
  return out;
}

}  // namespace pmreport::analysis
