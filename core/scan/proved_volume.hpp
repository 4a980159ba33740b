// A bracket of the volume of a set of poses, proved.
#pragma once

#include <core/chunks/sharing.hpp>
#include <core/program/intervals/bounds.hpp>
#include <core/scan/pose_set.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pmreport::scan {

struct VolumeOptions {
  double gap = 1e-3;                                         // (high - low) / middle at which it is enough
  double seconds = std::numeric_limits<double>::infinity();  // and when to give up
  std::size_t boxes = 50'000'000;                            // and with how many
  std::size_t need = 1;                                      // orientations of the scan that must be accepted at a point
};

struct ProvedVolume {
  program::Bounds volume;                  // the true one lies between, rounding included; in the product of the scanned units
  std::vector<program::Bounds> low, high;  // of each axis: brackets of the ends of the set; not bounded where it may be empty
  bool empty = false;                      // proved: no pose of the range belongs to the set
  bool enough = false;                     // the gap that was asked for is reached
  std::string why;                         // it is not
  std::uint64_t boxes = 0;                 // looked at
  double undecided = 0;                    // volume of boxes that were left whole, neither in nor out, for margins without bounds
};
// Bytes do not depend on the number of threads, nor on who shares the work, unless the time ends it. Those who wait for each other
// (chunks::Dealer) share it, and go through all of the proof; one who shares nothing keeps nothing. `work`: its name, and the meaning of
// what decides the volume besides the set, the scan and the options, as those by which guides are chosen; the rest is left out. Throws what
// chunks::run throws; what is not provable: std::invalid_argument.
ProvedVolume prove_volume(const PoseSet& set, const Scan& scan, const VolumeOptions& options, const Watch& watch = {},
                          const chunks::Work& work = {}, const chunks::Sharing& sharing = {});

}  // namespace pmreport::scan
