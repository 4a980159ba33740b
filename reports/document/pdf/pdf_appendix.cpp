#include <reports/document/pdf/pdf_appendix.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <reports/document/text.hpp>

namespace pmreport::document::pdf {

void put_listing(Composer& c, const std::string& text) {
  constexpr int most_lines = 1000;
  constexpr std::size_t longest_line = 2000;  // [bytes], before it is cut; layout takes its time with lines of a megabyte
  constexpr double number_width = 26;         // [pt]
  std::size_t at = 0;
  int line = 0;
  while (at < text.size() && line < most_lines) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string source = text.substr(at, end - at);
    if (!source.empty() && source.back() == '\r') source.pop_back();
    const bool cut = source.size() > longest_line;
    if (cut) source.resize(longest_line);
    std::string shown = markup_line(source);
    if (cut) shown += coloured(" … cut", grey);
    at = end + 1;
    ++line;
    const Lines number(c.cr, fmt::to_string(line), {listing.font, listing.pitch, hairline}, 0);
    const double number_left = number_width - 10 - width_of(c.cr, fmt::to_string(line), listing.font);
    const Lines lines(c.cr, shown.empty() ? " " : shown, listing, text_width - number_width);
    for (int i = 0; i < lines.count(); ++i) {
      c.flow.put({.height = listing.pitch,
                  .draw =
                      [=](cairo_t* cr) {
                        if (i == 0) number.draw(cr, number_left, 0);
                        lines.draw_line(cr, i, number_width, 0);
                      },
                  .role = "Code"});
    }
  }
  if (line == 0) put_lines(c, "The scenario is empty.", body);
  if (at < text.size()) {
    c.flow.gap(8);
    put_lines(c, fmt::format("Its first {} lines; the scenario file has the rest.", most_lines), secondary);
  }
}

void put_provenance(Composer& c, const Provenance& p) {
  put_field(c, "Program", p.version.empty() ? p.program : p.program + " " + p.version);
  put_field(c, "Mechanism", p.mechanism);
  put_field(c, "Plugin", p.plugin_build);
  put_field(c, "Scenario", p.scenario_name);
  put_field(c, "SHA-256", p.scenario_sha256);
}

void put_files(Composer& c) {
  for (std::size_t i = 0; i < c.report.files.size(); ++i) {
    const File& file = c.report.files[i];
    put_field(c, i == 0 ? "Files" : " ", fmt::format("data/{}: {}, {}", c.names.files[i], file.title, size_of(file.bytes.size())));
  }
}

}  // namespace pmreport::document::pdf
