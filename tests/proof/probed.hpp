// The probe, its motions, and what is asked of their proofs.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <tests/proof/pieces.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pmreport::test {

// The probe of probe.hpp with some of its parameters, choices by their number.
std::unique_ptr<mechanics::Machine> probe(const std::map<std::string, double>& parameters = {});

struct Probed {
  std::unique_ptr<mechanics::Machine> machine;
  analysis::MotionProof proof;
  std::string found;  // by the attack

  const analysis::Claim& claim(analysis::Claim::About about, int index = 0) const;
  const analysis::Claim& stroke(int actuator) const { return claim(analysis::Claim::About::stroke, actuator); }
  const analysis::Claim& assembled() const { return claim(analysis::Claim::About::assembled); }
  const analysis::Claim& regular() const { return claim(analysis::Claim::About::regular); }
  const analysis::Claim& turn() const { return claim(analysis::Claim::About::joint_limit, 1); }
  const analysis::Extreme& extreme(const std::string& column) const { return *proof.extreme(analysis::ColumnId::named(column)); }
};
// Slide and turn, proved and attacked.
Probed probed(const std::map<std::string, double>& parameters, const Pieces& x, const Pieces& phi, double begin, double end,
              const analysis::ProofOptions& options = {});

}  // namespace pmreport::test
