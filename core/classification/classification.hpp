// The class of parallel-cross mechanisms: Glazunov et al. 2008, Development of manipulators with a parallel-cross structure.
//
// k chains join base and platform, n_p of them in parallel and n_c across, each between two of the parallel ones. Chain i has p_i pairs of
// one freedom and imposes D_i = 6 - p_i constraints (1), which leaves m = 6 - sum D_i freedoms (2). A scheme is written by its p_i,
// parallel chains first: 5556-66.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace pmreport::classification {

struct Scheme {
  std::string parallel, cross;                                                     // the digits p_i, rising within each
  int chains() const { return static_cast<int>(parallel.size() + cross.size()); }  // k
  int freedoms() const;                                                            // m, by (2)
  std::string name() const { return parallel + "-" + cross; }
  bool operator==(const Scheme&) const = default;
};

// Whether the paper's rule admits a scheme: 3 <= k <= 6, 1 <= m <= 6, 1 <= p_i <= 6;
//   n_p >= n_c >= 1 and n_c <= n_p (n_p - 1) / 2: at most one cross chain for each two parallel ones;
//   every chain imposes constraints or contains a drive, and there are m drives: at most m chains have D_i = 0.
// The paper also asks for seven pairs or more in every closed loop, else the loop is a truss. Whatever the rule admits has them.
bool admitted(const Scheme& scheme);

// All that the rule admits: by k from 6 down, m from 6 down, n_c, then name.
std::vector<Scheme> admitted_schemes();

// The base schemes of Table 1 as corrected, in the same order. Those with six chains are Table 2.
const std::vector<Scheme>& base_schemes();
bool is_base(const Scheme& scheme);

// One row of a table, as the paper sets them: schemes by m = 6 .. 1 in columns; empty where the column has ended.
struct SchemeRow {
  std::string head;  // k, or n_p-n_c; empty in the rows after the first of its kind
  std::array<std::string, 6> cells;
};
// Table 1 by k; a scheme that the rule admits beyond it stands after the others and bears a star.
std::vector<SchemeRow> table_of_base_schemes();
// Table 2: six chains, by n_p-n_c.
std::vector<SchemeRow> table_of_six_chains();
// Numbers of schemes by k = 6 .. 3 and m = 6 .. 1: of Table 1, and of the rule.
struct SchemeCount {
  int chains = 0;
  std::array<int, 6> base{}, by_rule{};
};
std::vector<SchemeCount> scheme_counts();

// Where the printed tables err.
struct Correction {
  int table = 1, chains = 6, freedoms = 6;
  std::string printed, corrected, why;  // `printed` empty: the entry is missing
};
const std::vector<Correction>& corrections();

}  // namespace pmreport::classification
