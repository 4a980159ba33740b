#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <tests/given/stage.hpp>
#include <tests/section/gantry.hpp>
#include <tests/section/whole_report.hpp>

#include <stdexcept>

namespace whole_report {

document::Report report_of(const std::string& text, const scenario::MechanismSource& source) {
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", source, section::kinds());
  return section::make_report(loaded, "1.2.3", "a build for the tests", {});
}

document::Report of_gantry(const std::string& more) {
  return report_of(
      "title = \"Gantry\"\n[mechanism]\nuse = \"gantry\"\n[motion]\nduration = \"2 s\"\nsamples = 21\nx = \"50 mm * sin(2*pi*t/2 s)\"\n" +
          more,
      gantry::source());
}

document::Report of_stage(const std::string& parameters, const std::string& motion, const std::string& more) {
  return report_of("title = \"Stage\"\n[mechanism]\nuse = \"stage\"\nparameters = { arm = \"200 mm\"" + parameters +
                       " }\n[motion]\nduration = \"2 s\"\nsamples = 21\n" + motion + more,
                   stage::source());
}

std::string asking_for(const std::vector<std::string>& kinds) {
  std::string out;
  for (const std::string& kind : kinds) out += "[[section]]\nkind = \"" + kind + "\"\n";
  return out;
}

std::vector<std::string> ids(const document::Report& r) {
  std::vector<std::string> out;
  for (const document::Section& s : r.sections) out.push_back(s.id);
  return out;
}

const document::Section& section_of(const document::Report& r, const std::string& id) {
  for (const document::Section& s : r.sections)
    if (s.id == id) return s;
  throw std::out_of_range("no section " + id);
}

const std::vector<double>& column_of(const document::Report& r, const std::string& data, const std::string& heading) {
  for (const document::Data& d : r.data)
    if (d.name == data)
      for (std::size_t i = 0; i < d.headings.size(); ++i)
        if (d.headings[i] == heading) return d.columns[i];
  throw std::out_of_range("no column " + heading + " of " + data);
}

namespace {

const figure::Figure& figure_of(const document::Section& s) {
  for (const document::Block& b : s.blocks)
    if (const auto* f = std::get_if<figure::Figure>(&b)) return *f;
  throw std::out_of_range("no figure in " + s.id);
}

}  // namespace

std::vector<std::string> panels_of(const document::Section& s) {
  std::vector<std::string> out;
  for (const figure::Panel& p : figure_of(s).panels) out.push_back(p.title);
  return out;
}

const figure::Panel& panel_of(const document::Section& s, const std::string& title) {
  for (const figure::Panel& p : figure_of(s).panels)
    if (p.title == title) return p;
  throw std::out_of_range("no panel " + title + " in " + s.id);
}

const figure::Series& series_of(const document::Section& s, const std::string& panel, const std::string& label) {
  for (const figure::Series& curve : panel_of(s, panel).series)
    if (curve.label == label) return curve;
  throw std::out_of_range("no curve " + label + " in the panel " + panel);
}

}  // namespace whole_report
