#include <core/mechanics/conformance/plausibility.hpp>
#include <core/text/text.hpp>
#include <reports/program/remarks.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>

namespace pmreport::program {

void print_remarks(const mechanics::Machine& machine) {
  const std::vector<mechanics::Remark> remarks = plausibility(machine);
  put("\n{}\n", remarks.empty() ? "data: nothing looks odd" : "data that look odd, and may be meant:");
  for (const mechanics::Remark& r : remarks) put("  {}\n    seen: {}\n    usually {}\n    {}\n", listed(r.of), r.seen, r.usual, r.reason);
}

}  // namespace pmreport::program
