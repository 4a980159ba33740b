#include <reports/document/finding.hpp>
#include <reports/document/pdf/pdf_table.hpp>

#include <fmt/format.h>

namespace pmreport::document::pdf {

namespace {

std::string smaller(const std::string& markup, const Colour& c) { return "<span size=\"88%\">" + coloured(markup, c) + "</span>"; }

}  // namespace

void put_proof(Composer& c, const Proof& p) {
  if (p.lines.empty()) return;
  Grid g{.caption = "Evidence",
         .number = 0,
         .headings = {"Claim", "Value", "Tolerance", "Result"},
         .numeric = {false, true, true, false},
         .rows = {},
         .stretch = 0};
  for (const auto& e : p.lines) {
    std::string claim = markup_line(e.claim);
    if (const std::string how = how_it_is_shown(e); !how.empty()) claim += "\n" + smaller(markup_line(how), grey);
    g.rows.push_back(
        {claim, markup_line(number_shown(e, e.value)), markup_line(number_shown(e, e.tolerance)), verdict_markup(e.verdict())});
  }
  put_grid(c, g);
}

void put_checks(Composer& c, const std::vector<Check>& checks) {
  Grid g{.caption = "",
         .number = 0,
         .headings = {"Check", "Measured", "Limit", "Line", "Result"},
         .numeric = {false, true, true, true, false},
         .rows = {},
         .stretch = 0};
  for (const auto& check : checks) {
    std::string name = markup_line(check.name);
    if (!check.message.empty()) name += "\n" + smaller(markup_line(check.message), check.passed ? grey : bad);
    g.rows.push_back({name, markup_line(check.measured), markup_line(check.limit), check.line > 0 ? fmt::to_string(check.line) : "",
                      verdict_markup(check.passed ? Verdict::passed : Verdict::failed)});
  }
  put_grid(c, g);
  put_lines(c, "Lines are those of the scenario, printed in the appendix.", secondary);
}

}  // namespace pmreport::document::pdf
