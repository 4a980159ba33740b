#include <reports/section/memory_need.hpp>

#include <core/analysis/asked.hpp>
#include <core/analysis/columns.hpp>
#include <core/analysis/samples/motion_blocks.hpp>
#include <core/mechanics/stiffness/answers.hpp>
#include <core/text/units.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <set>

namespace pmreport::section {

namespace {

// Bytes of a sample, beside its columns: the coordinates with rates and accelerations, as they are solved and as they are kept; the load;
// what is known of a sample besides numbers; what proofs and figures make of it on the way.
constexpr double of_coordinate = 2 * 3 * sizeof(double), of_sample = 700;
// Of a column in each: a number in the run, which the data file takes over; and where it is shown a share of what is drawn of it.
constexpr double computed = sizeof(double), shown = 2;
// Of a column that is shown, its curve as it is drawn: to so many samples it has as many points, and no more of more.
constexpr double as_drawn = 210e3, drawn_samples = 4000;
// Of a column in each sample of a block that is being computed, one a thread: as computed, as a chunk, and as it is read.
constexpr double in_block = 3 * sizeof(double);
constexpr double of_program = 118e6;   // libraries, fonts, the machine, a page
constexpr double of_pictures = 100e6;  // the renderer, whose code is compiled as it runs, and the pictures that nobody asked for

std::size_t columns_of(analysis::ColumnList* list, const Topology& t) { return list(t).size(); }

MemoryNeed::Part of_motion(const scenario::Loaded& loaded) {
  const scenario::Scenario& s = loaded.scenario;
  const Topology& t = loaded.machine->topology();
  const analysis::Asked asked = analysis::asked_by(s);
  std::size_t in_run = 0, in_report = 0;
  for (analysis::ColumnList* list :
       {analysis::displacement_columns, analysis::velocity_columns, analysis::acceleration_columns, analysis::statics_columns})
    in_run += columns_of(list, t);
  const std::pair<bool, analysis::ColumnList*> more[] = {{asked.transmission, analysis::transmission_columns},
                                                         {asked.forces, analysis::dynamics_columns},
                                                         {asked.forces && asked.drives, analysis::drive_columns},
                                                         {asked.forces && asked.reactions, analysis::reaction_columns},
                                                         {asked.stiffness, analysis::stiffness_columns}};
  for (const auto& [is_asked, list] : more)
    if (is_asked) in_run += columns_of(list, t);
  std::set<const scenario::SectionKind*> seen;
  for (const scenario::Section& section : s.sections)
    if (section.kind->columns != nullptr && seen.insert(section.kind).second) in_report += section.kind->columns(t).size();
  const double compliance = asked.stiffness ? sizeof(mechanics::Matrix6d) : 0;
  const auto count = [](std::size_t n) { return static_cast<double>(n); };
  const double bytes =
      of_sample + compliance + of_coordinate * count(t.coordinates.size()) + computed * count(in_run) + shown * count(in_report);
  const int samples = loaded.trajectory.samples();
  const double drawn = as_drawn * count(in_report) * std::min(1.0, samples / drawn_samples);
  const double blocks = in_block * count(in_run) * count(std::min(static_cast<std::size_t>(samples), analysis::MotionBlocks::size)) *
                        tbb::this_task_arena::max_concurrency();
  return {bytes * samples + drawn + blocks, fmt::format("{} samples of {} columns, of which {} are shown", samples, in_run, in_report),
          seen.size() > 1 ? "fewer samples, or fewer sections" : "fewer samples"};
}

}  // namespace

double MemoryNeed::bytes() const {
  double sum = 0;
  for (const Part& p : parts) sum += p.bytes;
  return sum;
}

MemoryNeed memory_need(const scenario::Loaded& loaded) {
  const scenario::Scenario& s = loaded.scenario;
  MemoryNeed out{{{of_program + (s.needs().pictures ? of_pictures : 0), "the program", ""}}};
  if (loaded.trajectory.samples() > 0) out.parts.push_back(of_motion(loaded));
  std::set<const scenario::SectionKind*> seen;
  for (const scenario::Section& section : s.sections)
    if (const SectionKind& kind = kind_of(section); kind.memory != nullptr)
      out.parts.push_back(kind.memory(loaded, section, seen.insert(&kind).second));
  std::ranges::stable_sort(out.parts, std::ranges::greater(), &MemoryNeed::Part::bytes);
  return out;
}

std::string memory_words(double bytes) {
  for (const auto& [unit, size] : {std::pair{"TB", 1e12}, {"GB", 1e9}, {"MB", 1e6}})
    if (bytes >= size) return format_number(bytes / size, 2) + " " + unit;
  return format_number(bytes / 1e3, 2) + " kB";
}

}  // namespace pmreport::section
