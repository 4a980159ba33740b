#include <tests/proof/attack.hpp>
#include <tests/proof/probe.hpp>
#include <tests/proof/probed.hpp>

#include <algorithm>
#include <stdexcept>

namespace pmreport::test {

using namespace analysis;

std::unique_ptr<mechanics::Machine> probe(const std::map<std::string, double>& parameters) {
  const pm_mechanism& table = contract::mechanism<Probe>;
  const mechanics::MechanismInfo info = mechanics::describe(table);
  mechanics::ParameterValues values = mechanics::default_values(info);
  for (std::size_t k = 0; k < info.parameters.size(); ++k)
    if (const auto given = parameters.find(info.parameters[k].name); given != parameters.end()) values[k] = {given->second};
  return std::make_unique<mechanics::Machine>(table, values);
}

const Claim& Probed::claim(Claim::About about, int index) const {
  for (const Claim& c : proof.claims)
    if (c.about == about && c.index == index) return c;
  throw std::out_of_range("there is no such claim");
}

Probed probed(const std::map<std::string, double>& parameters, const Pieces& x, const Pieces& phi, double begin, double end,
              const ProofOptions& options) {
  Probed out{probe(parameters), {}, ""};
  out.proof = prove_motion(*out.machine, pieces_motion({x, phi}, begin, end), {}, options);
  out.found = joined(contradictions(*out.machine, out.proof, law_of({x, phi}), {.random = 300, .dense = 3000}));
  return out;
}

}  // namespace pmreport::test
