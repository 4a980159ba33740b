// Section `transmission`: how well the actuators move the platform, by the indices that the literature has.
#pragma once

#include <core/analysis/transmission/grid.hpp>
#include <core/analysis/transmission/request.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/pose_map.hpp>
#include <reports/section/kind.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::section {

struct TransmissionOptions : analysis::TransmissionRequest {
  std::optional<MapRequest> map;
  bool limits_given = false;
  // Columns, and quantities with the kind's name before them, of which this mechanism never has a number, and why.
  std::map<std::string, std::string> empty;
};

Result transmission_section(const Context& c, const TransmissionOptions& r);

// -- its parts ------------------------------------------------------------------------------------------------------------------------

std::vector<document::Block> transmission_definitions(
    const Analysis& a);                                 // what the indices are, where they are taken, what they leave out
figure::Figure transmission_figure(const Analysis& a);  // along the motion
document::Table transmission_worst(const Analysis& a);  // of the motion, an actuator a row
document::Proof transmission_proof(const Analysis& a, const TransmissionOptions& r);

// The smallest number of columns over the motion, and where; NaN where none has one. `largest`: the largest.
struct WorstSample {
  double value = 0;
  int sample = -1;
  std::string column;
};
WorstSample extreme_of(const Analysis& a, const std::vector<Trace>& columns, bool largest = false);

struct PosesOfTransmission {
  document::Table table;
  document::Data data;
  std::vector<std::string> refused;  // a sentence each
  std::vector<document::Value> values;
};
PosesOfTransmission transmission_poses(const Analysis& a, const std::vector<Eigen::VectorXd>& poses);

struct MapOfTransmission {
  DrawnMap drawn;
  std::string told;  // how much of it transmits well
  std::vector<document::Value> values;
};
MapOfTransmission transmission_map(const Analysis& a, const MapRequest& request);

struct GridOfTransmission {
  std::optional<document::Table> table;
  std::string told;
  std::vector<document::Value> values;
};
GridOfTransmission transmission_over_grid(const Analysis& a, const analysis::GridRequest& request);

}  // namespace pmreport::section
