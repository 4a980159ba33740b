#include <reports/document/pdf/pdf_appendix.hpp>
#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_table.hpp>

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
    const int element = c.add("P");
    for (int i = 0; i < lines.count(); ++i) {
      c.flow.put({.height = listing.pitch, .draw = [=, &c](cairo_t* cr) {
                    if (i == 0) number.draw(cr, number_left, 0);
                    const Mark mark(cr, c.structure, element);
                    lines.draw_line(cr, i, number_width, 0);
                  }});
    }
  }
  if (line == 0) put_lines(c, "The scenario is empty.", body);
  if (at < text.size()) {
    c.flow.gap(8);
    put_lines(c, fmt::format("Its first {} lines; the scenario file has the rest.", most_lines), secondary);
  }
}

void put_files(Composer& c) {
  Grid g{
      .caption = "", .number = 0, .headings = {"File", "What it holds", "Size"}, .numeric = {false, false, true}, .rows = {}, .stretch = 1};
  for (std::size_t i = 0; i < c.report.files.size(); ++i) {
    const File& file = c.report.files[i];
    g.rows.push_back({markup_line("data/" + c.names.files[i]), markup_line(file.title), size_of(file.bytes.size())});
  }
  put_grid(c, g);
}

void put_colophon(Composer& c, const Provenance& p, const Attachments& attached, const std::string& destination) {
  constexpr Style small{{.size = 7.6}, 10.6, grey};
  c.flow.gap(30);
  const Lines title(c.cr, coloured("Provenance", grey), {{.size = 8.5, .bold = true}, 12}, text_width);
  c.flow.put({.height = title.height() + 5,
              .draw =
                  [title](cairo_t* cr) {
                    rule(cr, 0, 0, text_width, 0.4, hairline);
                    title.draw(cr, 0, 5);
                  },
              .keep_with_next = true,
              .destination = destination,
              .element = c.add("H2")});
  c.flow.gap(2);
  c.flow.reluctance(split_small);
  put_field(c, "Program", p.version.empty() ? p.program : p.program + " " + p.version, small);
  put_field(c, "Mechanism", p.mechanism, small);
  put_field(c, "Plugin", p.plugin_build, small);
  put_field(c, "Scenario", p.scenario_name, small);
  put_field(c, "SHA-256", p.scenario_sha256, small);
  const auto list = [](const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); };
  std::vector<std::string> names;
  for (const Attachment& a : attached.files) names.push_back(a.name);
  put_field(c, "Attached", list(names), small);
  std::vector<std::string> missing;
  if (!attached.left_out.empty()) missing.push_back(list(attached.left_out) + "; too large, they lie beside the report");
  if (!attached.scenario_left_out.empty()) missing.push_back(attached.scenario_left_out + "; too large, it lies where it was read from");
  put_field(c, "Not attached", fmt::format("{}", fmt::join(missing, ". ")), small);
  c.flow.reluctance(0);
}

}  // namespace pmreport::document::pdf
