// Section `velocity`.
#include <reports/section/common/kinematic_plots.hpp>
#include <reports/section/common/words/noise.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/velocity/velocity.hpp>

#include <fmt/core.h>

#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using document::Section;

namespace {

// The matrices that the source states, at the first sample that has a pose. Numbers of a column act on one rate and are of one sort: what
// is rounding beside the largest of them is zero.
void add_matrices(Section& s, const Analysis& a) {
  const Topology& t = a.machine().topology();
  if (t.matrices.empty()) return;
  int sample = 0;
  while (sample < a.samples() && a.outcome(sample) != Outcome::good) ++sample;
  if (sample == a.samples()) return;
  const Eigen::VectorXd q = a.trajectory().value.row(sample);
  const std::vector<Eigen::MatrixXd> all = a.machine().matrices({q.data(), static_cast<std::size_t>(q.size())}, a.pose(sample));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SourceMatrix& m = t.matrices[i];
    std::vector<std::string> of;
    if (m.acts_on == Rates::coordinates)
      for (const Coordinate& c : t.coordinates) of.push_back(symbol(c.name));
    else if (m.acts_on == Rates::actuators)
      for (const Actuator& x : t.actuators) of.push_back(symbol(x.name));
    else
      of = {"vx", "vy", "vz", "ωx", "ωy", "ωz"};
    document::Table table{fmt::format("Matrix {}, {}, at t = {}; SI units.", m.name, m.title, show_time(a, sample)),
                          of,
                          std::vector<bool>(of.size(), true),
                          {}};
    for (Eigen::Index r = 0; r < all[i].rows(); ++r) {
      std::vector<std::string> row;
      for (Eigen::Index c = 0; c < all[i].cols(); ++c) {
        const bool nothing = std::abs(all[i](r, c)) < noise_of(all[i].col(c).cwiseAbs().maxCoeff());
        row.push_back(nothing ? "0" : typeset(format_number(all[i](r, c), 5)));
      }
      table.rows.push_back(std::move(row));
    }
    s.blocks.push_back(std::move(table));
  }
}

}  // namespace

Result velocity_section(const Analysis& a) {
  Section s{"velocity", "velocity", "Velocity", {}};
  for (const std::string& line : singularity_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  s.blocks.push_back(Paragraph{
      Paragraph::Tone::plain,
      fmt::format(
          "Rates are exact derivatives of the geometry. G is the overall Jacobian, G·(v; ω) = (actuator rates; 0), for the twist of the "
          "platform's reference point in base axes; its condition number takes moments per characteristic length {}.",
          show(a.length(), "m"))});
  figure::Figure f{"velocity",
                   "Rates of the actuators, twist of the platform, and condition of the overall Jacobian.",
                   "data/velocity.csv",
                   figure::Width::full,
                   2,
                   {}};
  add_actuators(f, a, analysis::velocity_columns, OfMotion::rate, "actuator rate", "/s");
  add_panel(f, a, "velocity of the platform", "velocity", "m/s", group(a, analysis::velocity_columns, "velocity"));
  add_panel(f, a, "angular velocity of the platform", "angular velocity", "rad/s",
            group(a, analysis::velocity_columns, "angular_velocity"));
  add_panel(f, a, "condition number of G", "condition number", "", {{column_of(OfMachine::condition), ""}});
  put(s, std::move(f));
  s.blocks.push_back(
      extremes(a, "Extremes over the motion.",
               columns_in(a, analysis::velocity_columns, {"actuator_rate", "velocity", "angular_velocity", "det_G", "condition"})));
  add_matrices(s, a);
  std::vector<Claim> claims{
      {Measure::velocity, "Relative velocities are those the joints allow",
       "twists of all bodies in the constraints of the generic model, relative to the largest twist", 1e-9, ""},
      {Measure::jacobian, "Closed form equals the geometry", "G times twist against actuator rates by differentiation, relative", 1e-9, ""},
      {Measure::forward_velocity, "Forward velocity returns the twist", "twist solved from the actuator rates, relative", 1e-7, ""},
      {Measure::difference_rate, "Derivatives are exact",
       "rates of every body and joint against eighth-order differences in extended precision, relative", 1e-11, ""}};
  if (!a.machine().topology().matrices.empty())
    claims.push_back(
        {Measure::source, "The source's matrices hold", "its relations with the rates by differentiation, relative", 1e-9, ""});
  s.blocks.push_back(proof(a, claims));
  return {s};
}

}  // namespace pmreport::section
