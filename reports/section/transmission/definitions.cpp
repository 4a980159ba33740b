// What the indices are, by whom, where they are taken on this mechanism, and what they do not say.
#include <reports/section/common/words/words.hpp>
#include <reports/section/transmission/transmission.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using document::Paragraph;
using mechanics::Transmission;

namespace {

document::Table sources(const Transmission& t) {
  document::Table out{
      "Indices of transmission. f, g: direction of a force; v: velocity of the point that it acts at, while one actuator moves and all "
      "others "
      "are held, by a column of the inverse of G; c: a couple; ω: angular velocity. Each is 1 at best and 0 where nothing passes on.",
      {"index", "definition", "source"},
      {false, false, false},
      {{"pressure angle", "cos = |f·v| / |v|, f along the slide and v of its far end from its near end; of any other drive f = g",
        "Glazunov et al. 2008; its cosine is the generalized transmission index of Chen and Angeles 2007"},
       {"output transmission", "|g·v| / (|g| |v|), g the force of the actuator's row of G: their power over the largest that it could be",
        "Takeda and Funabashi 1995; Wang, Wu, Liu 2010"},
       {"input transmission", "|g·s| / |g|, s the way in which the drive moves its next joint", "Wang, Wu, Liu 2010"},
       {"local transmission", "the least of all output and input transmissions; 0.7 and more is called good", "Wang, Wu, Liu 2010"},
       {"constraint transmission", "|c·ω| / (|c| |ω|) of a couple that constrains, by its own column of the inverse; of a force as output",
        "Liu, Chen, Xie 2014"},
       {"local conditioning", "least over largest singular value of Ĝ", "Gosselin and Angeles 1991"},
       {"manipulability", "1 / |det Ĝ|", "Yoshikawa 1985"}}};
  if (t.paths().constraints.empty()) std::erase_if(out.rows, [](const auto& row) { return row.front() == "constraint transmission"; });
  return out;
}

// Actuators with the same reason share a row.
document::Table places(const Transmission& t) {
  const Topology& topology = t.machine().topology();
  const auto joint = [&](int j) { return topology.joints[static_cast<std::size_t>(j)].name; };
  document::Table table{
      "Where the indices are taken.", {"force", "pressure angle", "output and input transmission"}, {false, false, false}, {}};
  for (std::size_t i = 0; i < t.paths().drives.size(); ++i) {
    const mechanics::DrivePath& d = t.paths().drives[i];
    const std::string pressure = !d.no_pressure.empty() ? "none: " + d.no_pressure
                                 : d.telescope
                                     ? fmt::format("{} from {}, along the slide", joint(d.telescope->far), joint(d.telescope->near))
                                     : words_of(topology, d.entry);
    const std::string output = !d.no_output.empty() ? "none: " + d.no_output : words_of(topology, d.output);
    table.rows.push_back({symbol(topology.actuators[i].name), pressure, output});
  }
  for (std::size_t i = 0; i < t.paths().constraints.size(); ++i) {
    const mechanics::ConstraintPath& c = t.paths().constraints[i];
    table.rows.push_back({topology.constraints[i].name, "",
                          !c.none.empty() ? "none: " + c.none
                          : c.couple      ? "a couple, anywhere on the platform"
                                          : words_of(topology, c.point)});
  }
  return table;
}

std::string conditioning_words(const Transmission& t) {
  if (t.paths().translates)
    return "The platform only translates: its conditioning is that of the three rows of the actuators and the three columns of velocities, "
           "and no "
           "length enters the ratio.";
  return fmt::format(
      "Ĝ is G with moments and angular velocities counted by the length L = {}, as in the section singularity: its conditioning "
      "depends on that length, and the other indices do not.",
      show(t.length(), "m"));
}

// Of mechanisms with fewer than six degrees of freedom.
std::string limits_of_meaning(const Transmission& t) {
  const auto constraints = static_cast<int>(t.paths().constraints.size());
  if (constraints == 0) return "";
  return fmt::format(
      "What these indices do not say of a mechanism with {} degrees of freedom (Brinker, Corves, Takeda 2017, 2018): they weigh one "
      "actuator "
      "at a time and know nothing of the {} that hold{} the platform, so that input and output can be good next to a constraint "
      "singularity, "
      "which the constraint transmission and the section singularity tell. The force of an actuator on the platform is known but for "
      "multiples "
      "of the constraints; here it is the row of G as the mechanism gives it, and another choice would give other numbers by the same "
      "definitions. An index is a ratio at one point: it says how much of a force drives the motion, not how large errors, deflections or "
      "torques are.",
      6 - constraints, plural(constraints, "constraint"), constraints == 1 ? "s" : "");
}

}  // namespace

std::vector<document::Block> transmission_definitions(const Analysis& a) {
  const Transmission& t = *a.transmission();
  std::vector<document::Block> out{sources(t), places(t), Paragraph{Paragraph::Tone::plain, conditioning_words(t)}};
  if (std::string words = limits_of_meaning(t); !words.empty()) out.push_back(Paragraph{Paragraph::Tone::note, std::move(words)});
  return out;
}

}  // namespace pmreport::section
