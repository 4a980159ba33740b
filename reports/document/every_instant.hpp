// What was proved of a motion for every instant of it, as programs read it; the section of that name shows it to people.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace pmreport::document {

// It lies between the two; not finite: nothing is known on that side.
struct Bracket {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

struct EveryInstant {
  struct Broken {
    Bracket begin, end;  // [s]
    std::string side;    // "above" or "below" its range
    Bracket worst;       // SI
    double at = 0;       // [s]
  };
  struct Claim {
    std::string about;    // "assembly", "stroke", "joint limit", "regularity"
    std::string subject;  // "l3", "A1_deflection"; none of the whole mechanism
    std::string unit;     // of range and worst, SI
    Bracket range;        // not finite: none
    std::string state;    // "holds", "broken", "not decided", "not examined", "not applicable"
    std::string reason;
    std::vector<Broken> broken;
    std::vector<Bracket> undecided;  // [s]
  };
  struct Meeting {
    std::string what;  // "crossing", "touch", "unbounded"
    Bracket time;      // [s]
  };
  struct Extreme {
    std::string column, unit;
    Bracket least, largest;               // SI
    double at_least = 0, at_largest = 0;  // [s]
  };

  std::string sentence;       // all of it in one
  std::string unexamined;     // why nothing was looked at; empty: it was
  double begin = 0, end = 0;  // [s]
  int intervals = 0;
  long evaluations = 0;
  bool exhausted = false;
  double resolution = 0;  // [s]
  std::vector<Claim> claims;
  std::vector<Meeting> meetings;
  std::vector<Extreme> extremes;
};

}  // namespace pmreport::document
