// What the sections of a report, and its gates, ask of a run: what nobody shows is not computed.
#pragma once

namespace pmreport::scenario {
struct Scenario;
}

namespace pmreport::analysis {

// Poses, twists, how well G is conditioned and what breaks a stroke or a joint's limit are always computed: the gates judge them, and
// singularities with them, but for a single instant.
struct Asked {
  bool displacement_evidence = false;  // joints close, and forward displacement returns the pose
  bool velocity_evidence = false;      // twists and rates by several ways, and against differences in extended precision
  bool acceleration_evidence = false;  // twist rates likewise
  bool statics = false;                // forces at rest, and their evidence
  bool forces = false;                 // forces in motion, powers and energies
  bool force_evidence = false;         // that they balance every body, one way and another
  bool power_evidence = false;         // that power becomes energy
  bool drives = false;                 // what drives and motors must give; within forces in motion
  bool reactions = false;              // the wrench in every joint; within forces in motion
  bool transmission = false;           // how well actuators move the platform
  double transmission_length = 0;      // that makes moments comparable with forces in it [m]; 0: the characteristic length
  bool stiffness = false;              // deflection, indices of the compliance, frequencies
  bool singularities = true;           // where the motion meets one, or comes near it
};

// By the kinds of the scenario's sections and its limits.
Asked asked_by(const scenario::Scenario& scenario);

}  // namespace pmreport::analysis
