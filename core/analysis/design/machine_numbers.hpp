// Numbers by which studies compare machines: of their workspaces, and of their home.
#pragma once

#include <core/analysis/design/problem.hpp>
#include <core/analysis/workspace/workspace.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <string>
#include <vector>

namespace pmreport::analysis {

struct MachineNumber {
  enum class What {
    volume,  // of a workspace
    low,     // least and largest value of a scanned coordinate in it
    high,
    condition,               // of G at home, moments over a length
    smallest_singular_value  // likewise
  };
  What what = What::volume;
  std::string name;           // "workspace.volume"
  std::size_t workspace = 0;  // which of the requests
  std::size_t axis = 0;       // which of its scanned coordinates

  bool of_workspace() const { return what != What::condition && what != What::smallest_singular_value; }
};

struct MachineStudy {
  std::vector<MachineNumber> numbers;
  std::vector<WorkspaceRequest> requests;  // only those that numbers name are carried out
  double length = 1;                       // [m]; of all machines the same, or their numbers could not be compared
};

// The volume with the bracket of a proof or the 95 % interval of random poses; a grid's as it was counted, with its resolution. Notes tell
// a set that goes up to the end of a scanned range, and so may go on beyond it, and a proof that ended early. A machine that cannot be
// judged gives a reason, not numbers. Throws what progress.stop_if_asked throws, and a mechanics::MechanismError where the plugin is at
// fault.
Judged judge(const mechanics::Machine& machine, const MachineStudy& study, const Progress& progress);

// The same study by tenth the gap of proofs, half the step of grids, and four times the random poses, others than before.
MachineStudy finer(MachineStudy study);

// Machines with other values of some parameters, each a single number. Both must outlive it.
Judge judge_of_parameters(const mechanics::Machine& machine, std::vector<std::size_t> parameters, MachineStudy study,
                          const Progress& progress);

}  // namespace pmreport::analysis
