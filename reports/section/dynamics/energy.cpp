#include <reports/section/dynamics/energy.hpp>

#include <core/text/text.hpp>
#include <reports/section/common/words/motion_words.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

// Relative. An integration that is worse than this tells nothing of masses and forces that are a thousandth off.
constexpr double telling = 1e-4;
// Of all that flows: what nobody reads as the regained work.
constexpr double legible = 1e-3;

constexpr const char* work_becomes_energy = "Work becomes energy";

Paragraph note(const std::string& text) { return {Paragraph::Tone::note, text}; }

std::string share(double x) { return typeset(format_number(x, 2)); }

}  // namespace

EnergyEvidence energy_evidence(const Analysis& a, const std::optional<analysis::MotionWork>& work) {
  EnergyEvidence out;
  const auto not_examined = [&](const char* claim, const std::string& why) {
    out.lines.push_back(document::Evidence::not_examined(claim, "", why));
  };
  if (a.worst(Measure::power_balance).compared == 0)
    not_examined("Power becomes energy", "around no sample is the energy smooth enough along the motion to be differenced");
  if (!work) {
    not_examined(work_becomes_energy, "the motion meets a singular surface, or no stretch of it has forces");
    return out;
  }
  const double scale = work->flow > 0 ? work->flow : 1, open = work->uncertainty / scale;
  if (work->regenerated_uncertainty > legible * scale)
    out.notes.push_back(
        note(fmt::format("The regained work is good to {} alone: the powers change their signs more often than is looked at.",
                         show(work->regenerated_uncertainty, "J", 2))));
  if (a.scenario().motion->by_forces()) return out;
  if (!work->whole) {
    not_examined(work_becomes_energy, "not all of the motion has forces");
    return out;
  }
  if (count_jumps(a) > 0) {
    not_examined(work_becomes_energy, "values or rates of the motion jump: what that takes or gives no power tells");
    return out;
  }
  const double lost = std::abs(work->work() + work->load - work->stored) / scale, kept = std::abs(work->work() + work->load) / scale;
  if (!(open <= telling)) {
    not_examined(work_becomes_energy,
                 fmt::format("they differ by {} of all that flowed, and the work is known to {} of it alone", share(lost), share(open)));
    return out;
  }
  out.lines.push_back(
      {work_becomes_energy,
       "work of actuators and load, added up between the samples too, against kinetic and potential energy at the end less those at the "
       "start; relative to all that flowed. The tolerance is what integration and rounding leave open",
       lost, open, ""});
  // The energies at both ends differ by what the two poses do.
  if (work->closed)
    out.lines.push_back({"A closed path keeps no energy",
                         "the motion ends in its first pose with its first rates: work of actuators and load over it, relative to all that "
                         "flowed. The tolerance is what integration, rounding and the two poses leave open",
                         kept, open + std::abs(work->stored) / scale, ""});
  return out;
}

}  // namespace pmreport::section
