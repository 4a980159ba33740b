#include <reports/document/levels.hpp>

#include <algorithm>
#include <utility>

namespace pmreport::document {

namespace {

constexpr std::size_t long_table = 14;  // rows; with more a table is long
constexpr std::size_t shown = 5;        // rows of a ranked one
constexpr const char* appendix = "Long tables";

// The caption's first sentence.
std::string name_of(const Table& t) {
  const std::size_t stop = t.caption.find(". ");
  std::string out = t.caption.substr(0, stop);
  if (out.ends_with('.')) out.pop_back();
  return out;
}

// "Parameters: 31 rows, in section "Long tables"."
std::string pointer_to(const Table& t) {
  return name_of(t) + ": " + std::to_string(t.rows.size()) + " rows, in section \"" + appendix + "\".";
}

void move_long_tables(Report& r) {
  Section tables{"long-tables", "long-tables", appendix, {}};
  for (Section& s : r.sections)
    for (Block& block : s.blocks) {
      auto* table = std::get_if<Table>(&block);
      if (table == nullptr || table->rows.size() <= long_table) continue;
      Table whole = *table;
      whole.caption = s.title + ": " + whole.caption;
      if (table->ranked) {
        table->rows.resize(shown);
        table->caption += " The first " + std::to_string(shown) + " of " + std::to_string(whole.rows.size()) + "; all are in section \"" +
                          appendix + "\".";
      } else {
        block = Paragraph{Paragraph::Tone::note, pointer_to(*table)};
      }
      tables.blocks.emplace_back(std::move(whole));
    }
  if (!tables.blocks.empty()) r.sections.push_back(std::move(tables));
}

void shorten(Section& s) {
  bool pictured = false;
  std::vector<Block> kept;
  for (Block& block : s.blocks) {
    const auto* paragraph = std::get_if<Paragraph>(&block);
    const bool picture = std::holds_alternative<figure::Figure>(block) || std::holds_alternative<Gallery>(block);
    if ((paragraph != nullptr && paragraph->tone == Paragraph::Tone::warning) || std::holds_alternative<Proof>(block) ||
        (picture && !std::exchange(pictured, pictured || picture)))
      kept.push_back(std::move(block));
  }
  s.blocks = std::move(kept);
}

}  // namespace

Report arranged(Report r, Detail detail) {
  if (detail == Detail::engineering) move_long_tables(r);
  if (detail != Detail::brief) return r;
  for (Section& s : r.sections) shorten(s);
  std::erase_if(r.sections, [](const Section& s) { return s.blocks.empty(); });
  const auto gone = [&](const std::string& id) { return std::ranges::find(r.sections, id, &Section::id) == r.sections.end(); };
  for (KeyNumber& k : r.key_numbers)
    if (gone(k.section)) k.section.clear();
  for (Finding& f : r.findings)
    if (gone(f.section)) f.section.clear();
  return r;
}

}  // namespace pmreport::document
