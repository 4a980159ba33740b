#include <core/analysis/workspace/answers.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

std::uint64_t points_with(const std::vector<std::uint32_t>& accepted_at, std::uint64_t need) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(accepted_at, [&](std::uint32_t n) { return static_cast<std::uint64_t>(n) >= need; }));
}

std::uint64_t rim_of(const Workspace& w, std::uint64_t need) {
  const std::vector<std::uint32_t>& at = w.grid->accepted_at;
  const auto in = [&](std::size_t k) { return static_cast<std::uint64_t>(at[k]) >= need; };
  std::uint64_t out = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (!in(k)) continue;
    std::size_t stride = 1;
    bool rim = false;
    for (std::size_t a = w.scan.points.size(); a-- > 0 && !rim;) {
      const std::size_t count = w.scan.points[a].count, here = k / stride % count;
      rim = here == 0 || here + 1 == count || !in(k - stride) || !in(k + stride);
      stride *= count;
    }
    out += rim ? 1 : 0;
  }
  return out;
}

std::optional<double> end_of_points(const Workspace& w, std::uint64_t need, std::size_t axis, bool high) {
  const scan::Axis& a = w.scan.points[axis];
  std::size_t inside = 1;
  for (std::size_t k = axis + 1; k < w.scan.points.size(); ++k) inside *= w.scan.points[k].count;
  std::optional<double> out;
  for (std::size_t k = 0; k < w.grid->accepted_at.size(); ++k) {
    if (static_cast<std::uint64_t>(w.grid->accepted_at[k]) < need) continue;
    const double x = a.value(k / inside % a.count);
    if (!out || (high ? x > *out : x < *out)) out = x;
  }
  return out;
}

WorkspaceAnswers::WorkspaceAnswers(const Workspace& w) : w_(w) {
  for (const ScanMethod m : w.request.methods) {
    const bool there = m == ScanMethod::proof ? w.proof.has_value() : m == ScanMethod::grid ? w.grid.has_value() : w.estimate.has_value();
    if (!there) continue;
    method_ = m;
    break;
  }
}

Bracketed WorkspaceAnswers::volume() const {
  if (!method_) return {};
  if (*method_ == ScanMethod::proof) return Bracketed::between(w_.proof->volume.low, w_.proof->volume.high);
  const double cell = w_.scan.cell(), range = w_.scan.range();
  if (*method_ == ScanMethod::grid)
    return Bracketed::counted(static_cast<double>(accepted()) * cell, static_cast<double>(rim_of(w_, need())) * cell);
  return {w_.estimate->share * range, w_.estimate->low * range, w_.estimate->high * range};
}

Bracketed WorkspaceAnswers::end(std::size_t axis, bool high) const {
  if (method_ == ScanMethod::proof) {
    const std::vector<program::Bounds>& ends = high ? w_.proof->high : w_.proof->low;
    if (axis >= ends.size() || !ends[axis].bounded()) return {};
    return {high ? ends[axis].low : ends[axis].high, ends[axis].low, ends[axis].high};
  }
  if (method_ != ScanMethod::grid) return {};
  const std::optional<double> out = end_of_points(w_, need(), axis, high);
  return out ? Bracketed::counted(*out, std::abs(w_.scan.points[axis].step())) : Bracketed{};
}

bool WorkspaceAnswers::empty() const {
  return method_ == ScanMethod::proof ? w_.proof->empty : method_ == ScanMethod::grid ? accepted() == 0 : w_.estimate->share == 0;
}

bool WorkspaceAnswers::ended_early() const { return method_ == ScanMethod::proof && !w_.proof->enough && !w_.proof->empty; }

std::vector<std::string> WorkspaceAnswers::cut_off(const Topology& topology) const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < w_.scan.points.size(); ++i) {
    const scan::Axis& a = w_.scan.points[i];
    const Bracketed low = end(i, false), high = end(i, true);
    const double from = std::min(a.from, a.to), to = std::max(a.from, a.to);
    if (low.known() && high.known() && (low.low <= from || high.high >= to))
      out.push_back(topology.coordinates[static_cast<std::size_t>(a.input)].name);
  }
  return out;
}

}  // namespace pmreport::analysis
