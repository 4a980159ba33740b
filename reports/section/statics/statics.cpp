// Section `statics`.
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/statics/statics.hpp>

#include <fmt/core.h>

namespace pmreport::section {

using document::Paragraph;

namespace {

// "F", "τ" or "F, τ": what the actuators give.
std::string efforts(const Analysis& a) {
  bool linear = false, rotary = false;
  for (const Actuator& x : a.machine().topology().actuators) (x.sense() == Sense::linear ? linear : rotary) = true;
  return linear && rotary ? "F, τ" : linear ? "F" : "τ";
}

}  // namespace

Result statics_section(const Analysis& a) {
  document::Section s{"statics", "statics", "Statics", {}};
  const Eigen::Vector3d& g = a.scenario().load.gravity;
  for (const std::string& line : singularity_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  s.blocks.push_back(Paragraph{
      Paragraph::Tone::plain,
      fmt::format("Actuator forces and constraint wrenches that hold the platform against its load at rest, by virtual work: ({}; Fτ) = "
                  "−G⁻ᵀ(force; moment). A positive force F of an actuator acts to extend it, a positive torque τ to turn it onwards. A "
                  "constraint wrench Fτ is what the limbs exert on the platform.",
                  efforts(a))});
  s.blocks.push_back(Paragraph{Paragraph::Tone::plain,
                               g.isZero() ? "The scenario gives no gravity: all bodies are taken as weightless."
                                          : fmt::format("The weights of all bodies are included, gravity ({}, {}, {}) m/s². With heavy "
                                                        "limbs the constraint wrench is the share of all that the "
                                                        "limbs exert on the platform; it is no longer the force of a single joint.",
                                                        format_number(g.x(), 4), format_number(g.y(), 4), format_number(g.z(), 4))});
  figure::Figure f{"statics", "Actuator forces and constraint wrenches.", "data/statics.csv", figure::Width::full, 2, {}};
  for (const auto& [name, title] : {std::pair<std::string, std::string>{"actuator_force", "actuator"}, {"constraint", "constraint"}})
    for (const std::string unit : {"N", "N*m"}) {
      const std::vector<Trace> curves = group(a, analysis::statics_columns, name, unit);
      const std::string kind = unit == "N" ? "force" : name == "constraint" ? "moment" : "torque";
      add_panel(f, a, title + " " + kind, kind, unit, curves);
    }
  put(s, std::move(f));
  s.blocks.push_back(extremes(a, "Extremes over the motion.", analysis::statics_columns(a.machine().topology())));
  s.blocks.push_back(
      proof(a, {{Measure::statics, "Closed form equals the generic model",
                 "actuator forces by G (and the weights by virtual work) against the equilibrium of every body, relative", 1e-8, ""},
                {Measure::equilibrium, "Every body is in equilibrium",
                 "largest unbalanced force or moment of the generic model, relative to the largest load", 1e-8, ""},
                {Measure::power, "Virtual power balances", "power of actuators, load and weights over the motion, relative to the largest",
                 1e-8, ""}}));
  return {s};
}

}  // namespace pmreport::section
