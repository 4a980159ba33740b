#include <reports/document/pdf/pdf_appendix.hpp>
#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_compose.hpp>

#include <algorithm>

namespace pmreport::document::pdf {

std::vector<Entry> Plan::all() const {
  std::vector<Entry> result = sections;
  if (checks) result.push_back(*checks);
  result.push_back(scenario);
  if (files) result.push_back(*files);
  result.push_back(provenance);
  return result;
}

Plan plan_of(const Composer& c) {
  const Report& r = c.report;
  const Numbering& n = c.numbering;
  Plan plan;
  for (std::size_t i = 0; i < r.sections.size(); ++i) {
    const Section& s = r.sections[i];
    plan.sections.push_back({n.sections[i], s.title.empty() ? s.kind : s.title, c.names.sections[i]});
  }
  if (!n.checks.empty()) plan.checks = {n.checks, "Checks", "checks"};
  plan.scenario = {n.scenario, "Scenario", "scenario"};
  if (!n.files.empty()) plan.files = {n.files, "Files", "files"};
  plan.provenance = {"", "Provenance", "provenance"};
  return plan;
}

std::string title_of(const Entry& e) { return printable_line(e.number.empty() ? e.title : e.number + "  " + e.title); }

namespace {

struct PutBlock {
  Composer& c;
  int number;
  void operator()(const Paragraph& p) const { put_paragraph(c, p); }
  void operator()(const Table& t) const { put_table(c, t, number); }
  void operator()(const figure::Figure& f) const { put_figure(c, f, number); }
  void operator()(const Gallery& g) const { put_gallery(c, g, number); }
  void operator()(const Proof& p) const { put_proof(c, p); }
};

Flow::Kind kind_of(const Block& block) {
  if (std::holds_alternative<Paragraph>(block)) return Flow::Kind::text;
  if (std::holds_alternative<Proof>(block)) return Flow::Kind::evidence;
  return std::holds_alternative<Table>(block) ? Flow::Kind::table : Flow::Kind::picture;
}

void begin(Composer& c, const Entry& e) {
  c.flow.section(title_of(e));
  c.part = c.structure.add("Sect", -1);
  put_heading(c, e.number, e.title, e.destination);
}

// Paragraphs before a section's first figure or table are its introduction: they stay together, and with it.
void put_blocks(Composer& c, const Section& s, const std::vector<int>& numbers) {
  const auto is_paragraph = [](const Block& b) { return std::holds_alternative<Paragraph>(b); };
  const auto first = std::ranges::find_if_not(s.blocks, is_paragraph);
  if (first != s.blocks.end()) c.flow.reluctance(parted);
  for (auto block = s.blocks.begin(); block != s.blocks.end(); ++block) {
    if (block == first) c.flow.reluctance(0);
    c.flow.block(kind_of(*block));
    std::visit(PutBlock{c, numbers[static_cast<std::size_t>(block - s.blocks.begin())]}, *block);
  }
  if (s.blocks.empty()) put_lines(c, "This section is empty.", secondary);
}

}  // namespace

void compose(Composer& c, const Plan& plan, const Attachments& attached) {
  const Report& r = c.report;
  c.part = c.structure.add("Sect", -1);
  put_title(c, plan.sections, plan.checks.value_or(Entry{}));
  put_contents(c, plan.all());
  for (std::size_t i = 0; i < r.sections.size(); ++i) {
    begin(c, plan.sections[i]);
    put_blocks(c, r.sections[i], c.numbering.blocks[i]);
  }
  if (plan.checks) {
    begin(c, *plan.checks);
    put_checks(c, r.checks);
  }
  begin(c, plan.scenario);
  put_listing(c, r.scenario_text);
  if (plan.files) {
    begin(c, *plan.files);
    put_files(c);
  }
  c.flow.section(plan.provenance.title);
  c.part = c.structure.add("Sect", -1);
  put_colophon(c, r.provenance, attached, plan.provenance.destination);
}

}  // namespace pmreport::document::pdf
