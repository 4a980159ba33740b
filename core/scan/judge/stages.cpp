#include <core/scan/judge/stages.hpp>

#include <algorithm>

namespace pmreport::scan {

namespace {

// Which steps each output needs, and what steps cost, in additions.
class Needs {
 public:
  Needs(const program::Program& program, std::size_t outputs) : steps_(program.steps()) {
    for (std::size_t o = 0; o < outputs; ++o) {
      std::vector<bool> of(steps_.size());
      of[static_cast<std::size_t>(program.outputs()[o])] = true;
      for (std::size_t i = steps_.size(); i-- > 0;) {
        if (!of[i]) continue;
        const program::Step& s = steps_[i];
        const int operands[] = {s.a, s.b, s.c};
        for (int k = 0; k < program::operands_of(s.operation); ++k) of[static_cast<std::size_t>(operands[k])] = true;
      }
      needs_.push_back(std::move(of));
    }
  }

  // Of an output where `have` is computed anyhow.
  double cost(int output, const std::vector<bool>& have) const {
    const std::vector<bool>& of = needs_[static_cast<std::size_t>(output)];
    double sum = to_look;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (of[i] && !have[i]) sum += of_step(steps_[i].operation);
    return sum;
  }
  void add(int output, std::vector<bool>& have) const {
    const std::vector<bool>& of = needs_[static_cast<std::size_t>(output)];
    for (std::size_t i = 0; i < of.size(); ++i) have[i] = have[i] || of[i];
  }
  std::vector<bool> nothing() const { return std::vector<bool>(steps_.size()); }

  static constexpr double to_look = 1.5;  // at a margin, and to keep what it says

 private:
  static double of_step(program::Operation o) {
    using enum program::Operation;
    switch (o) {
      case constant:
      case input:
        return 0;
      case divide:
      case sqrt:
        return 5;
      case sin:
      case cos:
      case tan:
      case asin:
      case acos:
      case atan2:
      case hypot:
        return 40;
      default:
        return 1;
    }
  }

  std::span<const program::Step> steps_;
  std::vector<std::vector<bool>> needs_;
};

}  // namespace

std::vector<std::vector<int>> stages_by_yield(const program::Program& program, std::size_t margins, std::span<const double> rounding,
                                              std::span<const double> seen) {
  constexpr double beside = 6;     // additions: what costs no more beside what is computed anyhow joins the stage
  constexpr double rarely = 0.02;  // share of refused poses below which parting does not pay
  constexpr double unseen = 1e-3;  // share that even a margin has that refused none
  constexpr double overhead = 4;   // of a stage, in additions: the poses that are left move together
  const Needs needs(program, margins);
  const std::size_t poses = seen.size() / margins;
  std::vector<bool> left(poses, true);
  const auto refuses = [&](int m, std::size_t k) {
    const double x = seen[static_cast<std::size_t>(m) * poses + k];
    return !(x >= -rounding[static_cast<std::size_t>(m)]);
  };
  const auto yield = [&](int m) {
    std::size_t refused = 0, all = 0;
    for (std::size_t k = 0; k < poses; ++k)
      if (left[k]) ++all, refused += refuses(m, k);
    return all == 0 ? 0.0 : static_cast<double>(refused) / static_cast<double>(all);
  };

  std::vector<int> open;
  for (std::size_t m = 0; m < margins; ++m) open.push_back(static_cast<int>(m));
  std::vector<std::vector<int>> out;
  while (!open.empty()) {
    const std::vector<bool> nothing = needs.nothing();
    double best_rate = -1, best_yield = 0;
    int best = open.front();
    for (const int m : open) {
      const double share = yield(m), rate = (share + unseen) / (overhead + needs.cost(m, nothing));
      if (rate > best_rate) best_rate = rate, best_yield = share, best = m;
    }
    std::vector<int> group{best};
    std::vector<bool> have = nothing;
    needs.add(best, have);
    for (const int m : open) {
      if (m == best || (best_yield >= rarely && needs.cost(m, have) > beside)) continue;
      group.push_back(m);
      needs.add(m, have);
    }
    std::sort(group.begin(), group.end());
    for (const int m : group) {
      std::erase(open, m);
      for (std::size_t k = 0; k < poses; ++k) left[k] = left[k] && !refuses(m, k);
    }
    out.push_back(std::move(group));
  }
  return out;
}

std::vector<std::vector<int>> stages_in_order(const program::Program& program, std::size_t margins) {
  constexpr double own = 0.7;    // share of a margin's operations that is not computed anyhow, above which it may part
  constexpr double enough = 60;  // additions of a stage that others may part from
  const Needs needs(program, margins);
  std::vector<std::vector<int>> out{{0}};
  std::vector<bool> have = needs.nothing();
  double cost = 0;
  for (std::size_t o = 1; o < margins; ++o) {
    const int m = static_cast<int>(o);
    const double whole = needs.cost(m, needs.nothing()), more = needs.cost(m, have);
    if (o == 1 || (cost > enough && more > own * whole)) {
      out.emplace_back();
      have = needs.nothing();
      cost = 0;
    }
    cost += needs.cost(m, have);
    needs.add(m, have);
    out.back().push_back(m);
  }
  return out;
}

}  // namespace pmreport::scan
