#include <core/mechanics/conformance/plausibility.hpp>
#include <reports/section/common/words/remarks.hpp>

#include <utility>

namespace pmreport::section {

std::vector<std::string> remark_sentences(const mechanics::Machine& machine) {
  std::vector<std::string> out;
  for (const mechanics::Remark& r : plausibility(machine)) {
    std::string s = sentence(r);
    for (const auto& [plain, set] : {std::pair{"^2", "²"}, std::pair{"^3", "³"}, std::pair{"kg*m", "kg·m"}, std::pair{" deg", "°"}})
      for (std::size_t at = 0; (at = s.find(plain, at)) != std::string::npos;) s.replace(at, std::string_view(plain).size(), set);
    out.push_back("Odd data: " + s);
  }
  return out;
}

std::vector<std::string> remark_sentences(const Analysis& a) {
  const bool weighs = !a.scenario().load.gravity.isZero();
  return a.has_dynamics() || weighs ? remark_sentences(a.machine()) : std::vector<std::string>{};
}

}  // namespace pmreport::section
