#include <core/analysis/design/local_search.hpp>

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace pmreport::analysis {

namespace {

// The searches want numbers everywhere. A variant that could not be made gets the worst cost that any had so far, and breaks every
// constraint by its scale: it is left behind, and the planes through it do not grow without bound. Costs are told over the first that was
// known, for both methods weigh them against constraints.
class Merit {
 public:
  Merit(const DesignGoal& goal, const LocalSearch& search, Trials& trials, std::string by)
      : goal_(goal), constraints_(trials.problem().constraints), most_(search.most), trials_(trials), by_(std::move(by)) {
    constraints_.insert(constraints_.end(), search.also.begin(), search.also.end());
  }

  std::size_t constraints() const { return constraints_.size(); }

  // False: no more trials.
  bool go_to(const double* unit, unsigned n) {
    const std::vector<double> here(unit, unit + n);
    if (here == at_) return true;
    // Of a trial that is known already nothing is spent, and so a search that goes in circles would never end.
    if (++asked_ > 20 * most_ + 100) return false;
    const std::size_t before = trials_.all().size();
    if (spent_ >= most_) return false;
    const Trial* t = trials_.at(trials_.values_of(here), by_);
    if (t == nullptr) return false;
    spent_ += trials_.all().size() - before;
    at_ = here;
    judge(t->judged);
    return true;
  }

  double cost() const { return cost_; }
  double broken(std::size_t constraint) const { return broken_[constraint]; }
  double with_penalty() const {
    double sum = 0;
    for (const double x : broken_) sum += std::max(0.0, x);
    return sum > 0 ? worst_ + sum : cost_;
  }

 private:
  void judge(const Judged& j) {
    const DesignProblem& p = trials_.problem();
    if (!p.usable(j)) {
      cost_ = worst_;
      broken_.assign(constraints_.size(), 1.0);
      if (broken_.empty()) cost_ = worst_ + 1;
      return;
    }
    const double cost = p.cost(goal_, j);
    if (scale_ == 0 && cost != 0) scale_ = std::abs(cost);
    cost_ = scale_ != 0 ? cost / scale_ : cost;
    worst_ = any_ ? std::max(worst_, cost_) : cost_;
    any_ = true;
    broken_.clear();
    for (const DesignConstraint& c : constraints_) broken_.push_back(-c.slack(j) / c.scale());
  }

  const DesignGoal& goal_;
  std::vector<DesignConstraint> constraints_;
  std::size_t most_, spent_ = 0, asked_ = 0;
  Trials& trials_;
  std::string by_;
  std::vector<double> at_, broken_;
  double cost_ = 0, scale_ = 0, worst_ = 1;
  bool any_ = false;
};

struct Run {
  Merit merit;
  nlopt_opt library = nullptr;
  std::exception_ptr thrown = {};  // no exception may pass through the library

  template <class Number>
  double number_at(unsigned n, const double* x, Number number) {
    try {
      if (!thrown && merit.go_to(x, n)) return number();
    } catch (...) {
      thrown = std::current_exception();
    }
    nlopt_force_stop(library);
    return HUGE_VAL;
  }
};

struct ConstraintOf {
  Run* run;
  std::size_t index;
};

double cost_at(unsigned n, const double* x, double*, void* data) {
  auto& run = *static_cast<Run*>(data);
  return run.number_at(n, x, [&] { return run.merit.cost(); });
}

double penalised_at(unsigned n, const double* x, double*, void* data) {
  auto& run = *static_cast<Run*>(data);
  return run.number_at(n, x, [&] { return run.merit.with_penalty(); });
}

double broken_at(unsigned n, const double* x, double*, void* data) {
  const auto& c = *static_cast<const ConstraintOf*>(data);
  return c.run->number_at(n, x, [&] { return c.run->merit.broken(c.index); });
}

}  // namespace

const char* name_of(LocalMethod method) { return method == LocalMethod::linear_models ? "COBYLA" : "Nelder and Mead's simplex"; }

void search_from(const std::vector<double>& start, const DesignGoal& goal, const LocalSearch& search, Trials& trials,
                 const std::string& by) {
  if (search.most == 0) return;
  const bool planes = search.method == LocalMethod::linear_models;
  Run run{Merit(goal, search, trials, by)};
  std::vector<ConstraintOf> constraints;
  for (std::size_t i = 0; i < run.merit.constraints(); ++i) constraints.push_back({&run, i});
  const auto n = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> library(nlopt_create(planes ? NLOPT_LN_COBYLA : NLOPT_LN_NELDERMEAD, n),
                                                                       &nlopt_destroy);
  if (!library) throw std::bad_alloc();
  run.library = library.get();
  nlopt_set_lower_bounds1(library.get(), 0.0);
  nlopt_set_upper_bounds1(library.get(), 1.0);
  nlopt_set_min_objective(library.get(), planes ? cost_at : penalised_at, &run);
  if (planes)
    for (ConstraintOf& c : constraints) nlopt_add_inequality_constraint(library.get(), broken_at, &c, 0.0);
  nlopt_set_initial_step1(library.get(), search.step);
  nlopt_set_xtol_abs1(library.get(), search.accuracy);
  std::vector<double> x = start;
  double least = 0;
  nlopt_optimize(library.get(), x.data(), &least);
  if (run.thrown) std::rethrow_exception(run.thrown);
}

}  // namespace pmreport::analysis
