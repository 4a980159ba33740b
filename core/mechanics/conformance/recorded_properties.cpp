#include <core/mechanics/conformance/recorded_properties.hpp>

#include <core/mechanics/conformance/diagnosis.hpp>
#include <core/program/derivative.hpp>
#include <core/program/evaluate.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmreport::mechanics {

namespace {

constexpr std::size_t differentiated = 20;  // poses: derivatives of what is the same function differ at all of them, if at any

// Scalar `number` of a placement, or of G behind it: "number 12: y of the centre of joint A1".
std::string number_in_words(const Machine& machine, std::size_t number) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const auto told = [&](const std::string& words) { return fmt::format("number {}: {}", number, words); };
  const auto component = [](std::size_t i) { return "xyz"[i % 3]; };
  if (number == 0) return told("reach");
  if (number >= layout.size()) {
    const std::size_t e = number - layout.size();
    return fmt::format("column {} of {}", e % 6 + 1, about_row(machine, static_cast<int>(e / 6)));
  }
  if (number >= layout.derived(0)) return told("derived quantity " + t.derived[number - layout.derived(0)].name);
  if (number >= layout.actuator(0)) return told("actuator " + t.actuators[number - layout.actuator(0)].name);
  for (std::size_t j = t.joints.size(); j-- > 0;)
    if (const std::size_t first = layout.joint(static_cast<int>(j)); number >= first) {
      const std::size_t k = number - first;
      const std::string of = k < 3 ? "the centre" : fmt::format("axis {}", k / 3);
      return told(fmt::format("{} of {} of joint {}", component(k), of, t.joints[j].name));
    }
  for (std::size_t i = t.bodies.size(); i-- > 1;)
    if (const std::size_t first = layout.body(static_cast<int>(i)); number >= first) {
      const std::size_t k = number - first;
      if (k < 3) return told(fmt::format("{} of the origin of body {}", component(k), t.bodies[i].name));
      if (t.bodies[i].slender) return told(fmt::format("{} of the axis of body {}", component(k), t.bodies[i].name));
      return told(fmt::format("row {}, column {} of the rotation of body {}", (k - 3) / 3 + 1, (k - 3) % 3 + 1, t.bodies[i].name));
    }
  return told("");
}

class RecordedComparison {
 public:
  RecordedComparison(const Machine& machine, const program::Program& geometry)
      : machine_(machine), geometry_(geometry), dof_(static_cast<std::size_t>(machine.dof())), n_(machine.layout().size()) {}

  void values(const std::vector<double>& poses, Property& p) { compare(PM_VALUE, geometry_, poses, poses.size() / dof_, p); }
  void rates(const std::vector<double>& poses, Property& p) { compare(PM_JET, program::in_time(geometry_, 2), poses, differentiated, p); }
  void partials(const std::vector<double>& poses, Property& p) {
    std::vector<int> by(dof_);
    std::iota(by.begin(), by.end(), 0);
    compare(PM_PARTIALS, program::partials(geometry_, by), poses, differentiated, p);
  }

 private:
  // The first so many poses, in the order of scalars of which `program` gives the components.
  void compare(pm_order order, const program::Program& program, const std::vector<double>& poses, std::size_t most, Property& p) {
    const std::size_t c = machine_.components(order), given = order == PM_JET ? 3 : 1;
    program::Evaluator<double> evaluator(program);
    std::vector<double> q(dof_ * given), in(dof_ * given), placed((n_ + 36) * c), recorded((n_ + 36) * c);
    for (std::size_t k = 0; k < std::min(most, poses.size() / dof_); ++k) {
      const double* pose = poses.data() + k * dof_;
      for (std::size_t i = 0; i < dof_; ++i)
        for (std::size_t e = 0; e < given; ++e) {
          const double x = e == 0 ? pose[i] : std::cos(static_cast<double>(3 * i + e));  // any rates and accelerations, unlike each other
          q[i * given + e] = in[e * dof_ + i] = x;
        }
      const pm_status status = machine_.place(order, 1, q.data(), placed.data());
      if (status != PM_OK && status != PM_SINGULAR) continue;  // with numbers that are not finite it has numbers
      const bool wrenches = machine_.jacobian(order, 1, placed.data(), placed.data() + n_ * c) == PM_OK;
      evaluator.run(in, recorded);
      const auto where = [&](std::size_t s) {
        return fmt::format("{} at {}", number_in_words(machine_, s),
                           pose_in_words(machine_, Eigen::Map<const Eigen::VectorXd>(pose, machine_.dof())));
      };
      compare(order, placed.data(), recorded, 0, n_, p, where);
      if (wrenches) compare(order, placed.data(), recorded, n_, n_ + 36, p, where);
    }
  }

  // Scalars `begin` to `end`, in terms of the largest number among them. Where neither has one, as of G on a singular surface, there is
  // nothing to compare.
  template <class Where>
  void compare(pm_order order, const double* placed, const std::vector<double>& recorded, std::size_t begin, std::size_t end, Property& p,
               Where&& where) {
    const std::size_t c = machine_.components(order);
    double scale = 1;
    for (std::size_t i = begin * c; i < end * c; ++i)
      if (std::isfinite(placed[i])) scale = std::max(scale, std::abs(placed[i]));
    for (std::size_t s = begin; s < end; ++s)
      for (std::size_t e = order == PM_VALUE ? 0 : 1; e < c; ++e)  // values are compared once
        if (const double x = placed[s * c + e], y = recorded[program_output(order, s, e)]; std::isfinite(x) || std::isfinite(y))
          note(
              p, std::abs(x - y) / scale, [&] { return where(s); },
              [&]() -> std::string {
                return order == PM_VALUE
                           ? "it computes another thing when it is recorded; look for an if on the type of T, or a value that is kept "
                             "from one call to the next"
                           : "its rates are computed in another way than its value; look for an if on the type of T";
              });
  }
  // Component e of scalar s among the outputs of the differentiated program (derivative.hpp).
  std::size_t program_output(pm_order order, std::size_t s, std::size_t e) const {
    const std::size_t all = n_ + 36;
    return e == 0 ? s : order == PM_JET ? e * all + s : all + s * dof_ + e - 1;
  }

  const Machine& machine_;
  const program::Program& geometry_;
  std::size_t dof_, n_;
};

}  // namespace

void look_at_recording(const Machine& machine, const std::vector<double>& poses, PropertyList& p) {
  std::string why;
  const program::Program* geometry = machine.program(&why);
  if (geometry == nullptr) {
    if (machine.records()) note(*p.recorded, std::numeric_limits<double>::infinity(), why);
    for (Property* x : {p.recorded, p.recorded_rates, p.recorded_partials}) x->unexamined = why;
    return;
  }
  RecordedComparison comparison(machine, *geometry);
  comparison.values(poses, *p.recorded);
  comparison.rates(poses, *p.recorded_rates);
  comparison.partials(poses, *p.recorded_partials);
}

}  // namespace pmreport::mechanics
