#include <reports/document/pdf/pdf_attachments.hpp>
#include <reports/document/pdf/pdf_style.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document::pdf {

namespace {

constexpr std::size_t most_bytes = 4'000'000;  // before they are packed, which takes a tenth of a second

// The scenario's own name, without a folder.
std::string name_of_scenario(const Report& r) {
  const std::string name = printable_line(r.provenance.scenario_name);
  const std::string last = name.substr(name.find_last_of("/\\") + 1);
  return last.empty() ? "scenario.toml" : last;
}

}  // namespace

Attachments attachments_of(const Report& r, const Names& names) {
  Attachments all;
  std::size_t bytes = 0;
  const auto add = [&](Attachment a) {
    if (bytes + a.bytes.size() > most_bytes) {
      all.left_out.push_back(a.name);
      return;
    }
    bytes += a.bytes.size();
    all.files.push_back(std::move(a));
  };
  if (!r.scenario_text.empty()) add({name_of_scenario(r), "application/toml", "The scenario that this report answers", r.scenario_text});
  add({"results.json", "application/json", "Every check, line of evidence and value of this report", to_json(r)});
  for (std::size_t i = 0; i < r.data.size(); ++i)
    add({names.data[i] + ".csv", "text/csv", printable_line("Data of " + r.data[i].name + ", SI units"), to_csv(r.data[i])});
  return all;
}

}  // namespace pmreport::document::pdf
