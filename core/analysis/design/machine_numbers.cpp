#include <core/analysis/design/machine_numbers.hpp>

#include <core/mechanics/singularity/singularity.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pmreport::analysis {

namespace {

using What = MachineNumber::What;

Bracketed bracketed(const program::Bounds& b) { return Bracketed::between(b.low, b.high); }

std::uint64_t points_with(const scan::GridCounts& g, std::uint64_t need) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(g.accepted_at, [&](std::uint32_t n) { return static_cast<std::uint64_t>(n) >= need; }));
}

// Accepted points of a grid with a neighbour that is refused, or none: where the border of the set passes. A pose is a cell, and of those
// at the border another grid may have all or nothing.
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

// By the method that the section names first; a proof that was not made has the next one in its place.
class Answers {
 public:
  explicit Answers(const Workspace& w) : w_(w) {
    for (const ScanMethod m : w.request.methods) {
      const bool there = m == ScanMethod::proof ? w.proof.has_value() : m == ScanMethod::grid ? w.grid.has_value() : w.estimate.has_value();
      if (!there) continue;
      method_ = m, any_ = true;
      break;
    }
  }

  bool any() const { return any_; }

  Bracketed volume() const {
    if (method_ == ScanMethod::proof) return bracketed(w_.proof->volume);
    if (method_ == ScanMethod::grid)
      return Bracketed::counted(static_cast<double>(accepted()) * w_.scan.cell(), static_cast<double>(rim_of(w_, need())) * w_.scan.cell());
    const scan::Estimate& e = *w_.estimate;
    return {e.share * w_.scan.range(), e.low * w_.scan.range(), e.high * w_.scan.range()};
  }

  // Of an axis; NaN where the set is empty, or random poses looked at it.
  Bracketed end(std::size_t axis, bool high) const {
    if (method_ == ScanMethod::proof) {
      const std::vector<program::Bounds>& ends = high ? w_.proof->high : w_.proof->low;
      if (axis >= ends.size() || !std::isfinite(ends[axis].low) || !std::isfinite(ends[axis].high)) return {};
      return bracketed(ends[axis]);
    }
    if (method_ != ScanMethod::grid) return {};
    const std::vector<double>& ends = high ? w_.grid->high : w_.grid->low;
    return axis < ends.size() ? Bracketed::counted(ends[axis], std::abs(w_.scan.points[axis].step())) : Bracketed{};
  }

  bool empty() const {
    return method_ == ScanMethod::proof ? w_.proof->empty : method_ == ScanMethod::grid ? accepted() == 0 : w_.estimate->share == 0;
  }
  bool ended_early() const { return method_ == ScanMethod::proof && !w_.proof->enough && !w_.proof->empty; }

  // Names of the scanned coordinates whose range ends where the set may go on.
  std::vector<std::string> cut_off(const Topology& t) const {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < w_.scan.points.size(); ++i) {
      const scan::Axis& a = w_.scan.points[i];
      const Bracketed low = end(i, false), high = end(i, true);
      const double from = std::min(a.from, a.to), to = std::max(a.from, a.to);
      if (low.known() && high.known() && (low.low <= from || high.high >= to))
        out.push_back(t.coordinates[static_cast<std::size_t>(a.input)].name);
    }
    return out;
  }

 private:
  std::uint64_t need() const { return w_.request.at_least.empty() ? 1 : w_.request.at_least.front(); }
  std::uint64_t accepted() const { return points_with(*w_.grid, need()); }

  const Workspace& w_;
  ScanMethod method_ = ScanMethod::proof;
  bool any_ = false;
};

// What the request holds at home of the machine that it was written for stays at home of this one.
WorkspaceRequest moved_home(WorkspaceRequest r, const Eigen::VectorXd& from, const mechanics::Machine& machine) {
  const Eigen::VectorXd home = machine.home();
  if (r.at.size() != home.size() || from.size() != home.size()) return r;
  for (Eigen::Index i = 0; i < home.size(); ++i)
    if (r.at(i) == from(i)) r.at(i) = home(i);
  return r;
}

std::optional<mechanics::Conditioning> at_home(const mechanics::Machine& m, double length) {
  const mechanics::Jacobian g = m.jacobian(m.home_pose());
  return g.known() ? std::optional(mechanics::conditioning(m, g.matrix, length)) : std::nullopt;
}

}  // namespace

Judged judge(const mechanics::Machine& machine, const MachineStudy& study, const Progress& progress) {
  Judged out;
  const Progress quiet{[](const std::string&) {}, progress.stop_if_asked};
  std::map<std::size_t, Workspace> done;
  for (const MachineNumber& n : study.numbers) {
    if (!n.of_workspace() || done.contains(n.workspace)) continue;
    WorkspaceRequest request = moved_home(study.requests[n.workspace], study.home, machine);
    // The volume alone is asked for; what ends by the clock would differ from run to run.
    request.safe = request.reasons = request.one_sheet = false;
    request.seconds = std::numeric_limits<double>::infinity();
    try {
      done.emplace(n.workspace, workspace(machine, request, quiet));
    } catch (const NoProgram& e) {
      return {{}, e.what()};
    } catch (const ScanTooLarge& e) {
      return {{}, e.what()};
    }
  }
  const std::optional<mechanics::Conditioning> home = at_home(machine, study.length);
  for (const MachineNumber& n : study.numbers) {
    if (n.what == What::condition || n.what == What::smallest_singular_value) {
      out.numbers.push_back(!home ? Bracketed{} : Bracketed::plain(n.what == What::condition ? home->condition() : home->smallest));
      continue;
    }
    const Answers a(done.at(n.workspace));
    if (!a.any()) return {{}, done.at(n.workspace).not_proved};
    out.numbers.push_back(n.what == What::volume ? a.volume() : a.end(n.axis, n.what == What::high));
  }
  const auto note = [&](std::string s) {
    if (std::ranges::find(out.notes, s) == out.notes.end()) out.notes.push_back(std::move(s));
  };
  for (const auto& [index, w] : done) {
    const Answers a(w);
    if (a.empty()) note(w.home_refused_by.empty() ? "empty" : fmt::format("empty; home is refused by {}", w.home_refused_by));
    if (const std::vector<std::string> cut = a.cut_off(machine.topology()); !cut.empty())
      note(fmt::format("may go on beyond the range of {}", listed(cut, "and"))), out.cut_off = true;
    if (a.ended_early()) note(fmt::format("the proof ended early: {}", w.proof->why));
  }
  return out;
}

MachineStudy finer(MachineStudy study) {
  for (WorkspaceRequest& r : study.requests) {
    r.gap /= 10;
    for (ScanRange& range : r.scan)
      if (range.count > 1) range.count = 2 * range.count - 1;
    r.poses *= 4;
    ++r.seed;
  }
  return study;
}

Judge judge_of_parameters(const mechanics::Machine& machine, std::vector<std::size_t> parameters, MachineStudy study,
                          const Progress& progress) {
  return [&machine, &progress, parameters = std::move(parameters), study = std::move(study)](const std::vector<double>& values) -> Judged {
    mechanics::ParameterValues all = machine.values();
    for (std::size_t i = 0; i < parameters.size(); ++i) all[parameters[i]] = {values[i]};
    try {
      return judge(*machine.with(std::move(all)), study, progress);
    } catch (const mechanics::MechanismError& e) {
      if (e.status != PM_BAD_ARGUMENT) throw;
      return {{}, e.what()};
    }
  };
}

}  // namespace pmreport::analysis
