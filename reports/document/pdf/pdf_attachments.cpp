#include <reports/document/pdf/pdf_attachments.hpp>
#include <reports/document/pdf/pdf_style.hpp>
#include <reports/document/write.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::document::pdf {

namespace {

constexpr std::size_t most_bytes = 4'000'000;  // before they are packed, which takes a tenth of a second

// The scenario's own name, without a folder.
std::string name_of_scenario(const Report& r) {
  const std::string name = printable_line(r.provenance.scenario_name);
  const std::string last = name.substr(name.find_last_of("/\\") + 1);
  return last.empty() ? "scenario.toml" : last;
}

// What its CSV takes at least: a digit for each number, and a comma or an end of line behind each cell. Hundreds of megabytes
// need not be written to learn that they are too many.
std::size_t least_bytes(const Data& d) {
  std::size_t out = 0;
  for (const auto& column : d.words) out += column.size();
  for (const auto& column : d.columns)
    out += column.size() + static_cast<std::size_t>(std::ranges::count_if(column, [](double x) { return std::isfinite(x); }));
  return out;
}

}  // namespace

Attachments attachments_of(const Report& r, const Names& names) {
  Attachments all;
  std::size_t bytes = 0;
  const auto fits = [&](std::size_t more) { return bytes + more <= most_bytes; };
  // False where it is too large.
  const auto add = [&](Attachment a) {
    if (!fits(a.bytes.size())) return false;
    bytes += a.bytes.size();
    all.files.push_back(std::move(a));
    return true;
  };
  const std::string scenario = name_of_scenario(r);
  if (!r.scenario_text.empty() && !add({scenario, "application/toml", "The scenario that this report answers", r.scenario_text}))
    all.scenario_left_out = scenario;
  if (!add({"results.json", "application/json", "Every check, line of evidence and value of this report", to_json(r)}))
    all.left_out.emplace_back("results.json");
  for (std::size_t i = 0; i < r.data.size(); ++i) {
    const std::string name = names.data[i] + ".csv";
    if (!fits(least_bytes(r.data[i])) ||
        !add({name, "text/csv", printable_line("Data of " + r.data[i].name + ", SI units"), to_csv(r.data[i])}))
      all.left_out.push_back("data/" + name);
  }
  return all;
}

}  // namespace pmreport::document::pdf
