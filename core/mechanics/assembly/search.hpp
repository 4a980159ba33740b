// The search of assembly modes: walks under way, what they bring home, and which walks come next.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>
#include <core/mechanics/assembly/continuum.hpp>
#include <core/mechanics/assembly/curve.hpp>

#include <deque>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

class AssemblySearch {
 public:
  // `machines`: one for each word of the working mode. What is found is entered into `out`, whose modes hold no more than their word,
  // coordinates, pose, kind of root and the starts that reached them, its continua their poses.
  AssemblySearch(std::span<const std::unique_ptr<Machine>> machines, const Eigen::VectorXd& actuators, const AssemblyOptions& options,
                 AssemblyModes& out);

  void run(const Eigen::VectorXd& reference);
  // Goes on from a pose in a word of the working mode, and from what comes of it.
  void go_on(std::size_t word, const Eigen::VectorXd& coordinates);
  void finish() { out_.continua = continua_.take(); }
  const AssemblyTarget& target() const { return target_; }

  // Whether two poses have platform and bodies in the same places. Coordinates are not compared: an orientation has several names in
  // angles. `tolerance` [m], and of rotations' elements.
  static bool same_bodies(const Machine& m, const Pose& a, const Pose& b, double tolerance);
  static constexpr double same_placement =
      1e-6;  // of the mechanism's size: what two finds of one mode may differ by: far more than rounding, far less than modes do

 private:
  static constexpr std::size_t no_mode = std::numeric_limits<std::size_t>::max();

  struct Line {  // a curve to be followed from a mode, or from the edge of another word's reach
    SolutionCurve curve;
    std::size_t mode = no_mode;
    bool back = false;  // the second half of a curve whose first half did not close
  };
  struct Task {  // a walk under way
    std::unique_ptr<Halt> halt;
    std::optional<Walk<Arrival>> start;
    std::optional<Walk<SolutionCurveEnd>> trace;
    Line line;
    int number = 0;  // of a start
  };

  void work();
  void releases();
  bool begin_next();
  void begin_start(std::size_t word, const SmallVector& u);
  void begin_trace(const Line& line);
  void finish(Task& task);
  void cross_the_edge(const SolutionCurve& curve, const SolutionCurveEnd& end);
  void more_candidates();
  struct Entry {                           // where a site belongs
    std::size_t mode = no_mode;            // the isolated mode
    bool solution = false, fresh = false;  // it has the actuator values; nothing like it was known
  };
  Entry enter(const Site& site, int start);
  std::size_t known_mode(const Machine& m, const Pose& pose, double near) const;
  Entry enter_continuum(const Site& site, int start);
  bool full();
  bool enough();

  const AssemblyOptions& options_;
  AssemblyModes& out_;
  std::span<const std::unique_ptr<Machine>> machines_;
  std::vector<std::vector<std::size_t>> neighbours_;  // words that differ in one choice
  AssemblyTarget target_;
  AssemblyPlacer placer_;
  ContinuumSearch continua_;
  std::vector<Release> releases_;
  SmallVector home_;
  std::mt19937_64 random_;

  std::vector<Task> tasks_;
  std::deque<std::pair<std::size_t, SmallVector>> candidates_;  // starts to come: word and pose
  std::deque<Line> lines_;                                      // curves to come
  std::vector<std::pair<const Release*, SmallVector>> edges_;   // where curves went out of reach
  std::vector<std::vector<bool>> released_;                     // of each mode, actuators whose curve has been followed through it
  int quiet_ = 0;                                               // arrivals since the last new mode
};

}  // namespace pmreport::mechanics
