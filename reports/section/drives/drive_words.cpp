// What the section `drives` says of its drives: what they are, and how losses are counted.
#include <reports/section/common/words/words.hpp>
#include <reports/section/drives/drives.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

namespace {

std::string percent(double x) { return std::isfinite(x) ? format_number(100 * x, 3) + " %" : "–"; }

// Actuators alike in some way share a row of words: "l₁ to l₅", "l₁, l₃".
std::string actuators_listed(const Analysis& a, const std::vector<std::size_t>& indices) {
  if (indices.size() == actuators(a).size()) return "every actuator";
  std::string out;
  for (const std::size_t i : indices) out += (out.empty() ? "" : ", ") + symbol(actuators(a)[i].name);
  return out;
}

std::string train_words(const DriveTrain& d, const std::string& unit) {
  std::string out = fmt::format("efficiency {}", format_number(d.efficiency, 4));
  if (d.ratio > 0) {
    out += sense_of(unit) == Sense::linear ? fmt::format(", screw of lead {}", show(2 * std::numbers::pi / d.ratio, "m"))
                                           : fmt::format(", gear ratio {}", format_number(d.ratio, 5));
    if (d.inertia > 0) out += fmt::format(", rotor and screw {} kg·m²", typeset(format_number(d.inertia, 4)));
  }
  return out;
}

}  // namespace

std::vector<Paragraph> drive_words(const Analysis& a) {
  std::vector<Paragraph> out;
  const auto tell = [&](Paragraph::Tone tone, std::string text) { out.push_back({tone, std::move(text)}); };
  std::vector<std::pair<DriveTrain, std::vector<std::size_t>>> kinds;
  for (std::size_t i = 0; i < actuators(a).size(); ++i) {
    const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == train(a, i); });
    same != kinds.end() ? same->second.push_back(i) : void(kinds.push_back({train(a, i), {i}}));
  }
  std::string list;
  for (const auto& [drive, of] : kinds)
    list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", actuators_listed(a, of), train_words(drive, actuators(a)[of.front()].unit));
  list.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(list.front())));
  tell(Paragraph::Tone::plain, list + ".");

  const bool losses = std::any_of(kinds.begin(), kinds.end(), [](const auto& k) { return k.first.efficiency < 1; });
  if (losses) {
    const bool divides = kinds.front().first.convention == EfficiencyConvention::always_divides;
    std::string most;
    double share = 0;
    for (const Actuator& x : actuators(a))
      if (const double s = driven_back(a, x); s > share) share = s, most = symbol(x.name);
    tell(Paragraph::Tone::plain,
         divides
             ? "By the convention of the scenario the efficiency always divides: drive force = actuator force / efficiency, also where the "
               "actuator is driven back."
             : "Losses take from the power that flows, whichever way it flows: an actuator that drives its load needs drive force = "
               "actuator force / efficiency; where the load drives it back, friction helps to hold it, and drive force = actuator force × "
               "efficiency.");
    if (share > 0) {
      const std::string when = fmt::format("{} is driven back in {} of the samples, the most of all", most, percent(share));
      if (divides)
        tell(Paragraph::Tone::warning,
             fmt::format("{}: there this convention asks for more force than is needed, and shows more power coming back than the actuator "
                         "takes from its load.",
                         when));
      else
        tell(Paragraph::Tone::note,
             fmt::format("{}: there a formula that always divides by the efficiency has the losses on the wrong side, and shows more power "
                         "coming back than the actuator takes from its load.",
                         when));
    }
  }
  if (any_motor(a))
    tell(Paragraph::Tone::plain,
         "Motor torque = drive force / ratio + rotor inertia × motor acceleration, the ratio being motor angle per actuator displacement, "
         "2π / "
         "lead of a screw. Rotor and screw stand behind the losses: their inertia is the motor's own affair.");
  return out;
}

}  // namespace pmreport::section
