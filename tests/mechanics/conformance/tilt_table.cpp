#include <tests/mechanics/conformance/tilt_table.hpp>

namespace pmreport::test {

const pm_mechanism& table_of(Mistake m) {
  return m == Mistake::one_coordinate ? contract::mechanism<Table<1>> : contract::mechanism<Table<2>>;
}

Machine machine_of(Mistake m) { return Machine(table_of(m), default_values(describe(table_of(m)))); }

std::map<std::string, std::string> failures(Mistake m) {
  const With mistake(m);
  std::map<std::string, std::string> out;
  for (const Property& p : check_properties(machine_of(m), {50, 1}))
    if (p.verdict() == Verdict::failed) out[p.claim] = p.where;
  return out;
}

std::string failure(Mistake m, const std::string& claim) {
  const auto all = failures(m);
  const auto found = all.find(claim);
  return found == all.end() ? "it passed" : found->second;
}

std::string refusal(Mistake m) {
  const With mistake(m);
  try {
    const Machine machine = machine_of(m);
  } catch (const MechanismError& e) {
    CHECK(e.status == PM_FAILED);
    return e.what();
  }
  return "it was taken";
}

}  // namespace pmreport::test
