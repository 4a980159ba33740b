#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_front.hpp>
#include <reports/document/tally.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

namespace pmreport::document::pdf {

namespace {

const Style secondary_ink{secondary.font, secondary.pitch};

Colour colour_of(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::fault:
      return bad;
    case Finding::Kind::disagreement:
      return caution;
    case Finding::Kind::surprise:
      return accent;
    case Finding::Kind::result:
      break;
  }
  return hairline;
}

Colour colour_of(Verdict v) {
  switch (v) {
    case Verdict::passed:
      return good;
    case Verdict::failed:
    case Verdict::error:
      return bad;
    case Verdict::not_decided:
      return caution;
    case Verdict::not_examined:
    case Verdict::not_applicable:
      break;
  }
  return grey;
}

// The verdict in words, and below it checks and evidence by what became of them: what stands beside the picture, or alone.
struct VerdictBox {
  struct Line {
    Lines text;
    std::optional<Colour> square;
  };
  Colour colour;
  Lines word;
  std::vector<Line> lines;
  double height() const {
    double h = word.height() + 4;
    for (const Line& l : lines) h += l.text.height();
    return h;
  }
  void draw(cairo_t* cr, Structure& structure, int element, double x, double y, double tall) const {
    set_colour(cr, colour);
    cairo_rectangle(cr, x, y, 4, tall);
    cairo_fill(cr);
    const Mark mark(cr, structure, element);
    word.draw(cr, x + 14, y);
    y += word.height() + 4;
    for (const Line& l : lines) {
      if (l.square) {
        set_colour(cr, *l.square);
        cairo_rectangle(cr, x + 14, y + 0.5 * body.pitch - 3, 6, 6);
        cairo_fill(cr);
      }
      l.text.draw(cr, x + (l.square ? 26 : 14), y);
      y += l.text.height();
    }
  }
};

VerdictBox verdict_box(Composer& c, double width) {
  const Tally asked = tally_checks(c.report), shown = tally_evidence(c.report);
  const bool claims = asked.total() + shown.total() > 0;
  const Colour colour = !claims ? grey : c.report.passed() ? good : bad;
  const Style large{{.size = 16, .bold = true}, 24};
  VerdictBox box{colour,
                 Lines(c.cr,
                       coloured(!claims             ? "NOTHING TO CHECK"
                                : c.report.passed() ? "PASSED"
                                                    : "FAILED",
                                colour),
                       large, 0),
                 {}};
  const auto add = [&](const Tally& t, const char* one, const char* many) {
    box.lines.push_back(
        {Lines(c.cr, t.total() == 0 ? fmt::format("no {}", many) : fmt::format("<b>{} {}</b>", t.total(), t.total() == 1 ? one : many),
               body, width - 14),
         {}});
    for (std::size_t i = 0; i < verdicts; ++i) {
      const auto v = static_cast<Verdict>(i);
      if (t[v] > 0) box.lines.push_back({Lines(c.cr, fmt::format("{} {}", t[v], word_of(v)), body, width - 26), colour_of(v)});
    }
  };
  add(asked, "check", "checks");
  add(shown, "line of evidence", "lines of evidence");
  for (const Finding& f : c.report.findings)
    if (f.kind == Finding::Kind::disagreement)
      box.lines.push_back({Lines(c.cr, coloured(markup_line(f.text), caution), body, width - 14), {}});
  return box;
}

// Beside the machine how it ended.
void put_verdict(Composer& c) {
  c.flow.gap(12);
  if (!c.report.cover) {
    const VerdictBox box = verdict_box(c, text_width);
    c.flow.put({.height = box.height(),
                .draw = [&c, box, words = c.add("P")](cairo_t* cr) { box.draw(cr, c.structure, words, 0, 0, box.height()); }});
    return;
  }
  constexpr double picture_width = 98 * mm, between = 8 * mm, most = 74 * mm;
  const Box picture = picture_box(*c.report.cover, picture_width, most);
  const VerdictBox box = verdict_box(c, text_width - picture.width - between);
  const double height = std::max(picture.height, box.height());
  const std::string shown = c.report.cover->caption.empty() ? "The machine" : printable_line(c.report.cover->caption);
  c.flow.put(
      {.height = height, .draw = [=, &c, figure = c.add("Figure", shown), words = c.add("P"), cover = &*c.report.cover](cairo_t* cr) {
         {
           const Mark mark = Mark::figure(cr, c.structure, figure, picture);
           draw_picture(cr, *cover, picture);
         }
         box.draw(cr, c.structure, words, picture.width + between, 0, height);
       }});
}

const Entry* entry_of(const Composer& c, const std::vector<Entry>& sections, const std::string& id) {
  for (std::size_t i = 0; i < sections.size(); ++i)
    if (c.report.sections[i].id == id) return &sections[i];
  return nullptr;
}

// Lines that lead to where more is told, when that is known.
void draw_linked(Composer& c, cairo_t* cr, const Lines& lines, int element, const std::string& destination, const Box& box) {
  if (destination.empty()) {
    const Mark mark(cr, c.structure, element);
    return lines.draw(cr, box.x, box.y);
  }
  c.flow.require(destination);
  const Mark mark = Mark::link(cr, c.structure, element, destination, box);
  lines.draw(cr, box.x, box.y);
}

// Element of lines that may be a link, in `parent`.
int add_linked(Composer& c, int parent, const Entry* to) {
  return to == nullptr ? c.structure.add("P", parent) : c.structure.add("Link", parent, printable_line(to->number + " " + to->title));
}

// What fails, by name, each a link to where it is told.
void put_failures(Composer& c, const std::vector<Entry>& sections, const Entry& checks) {
  const std::vector<Failure> all = failures_of(c.report);
  if (all.empty()) return;
  put_subheading(c, "Failures", "H2");
  constexpr double found_at = 118 * mm, limit_at = 146 * mm;
  const int table = c.add("Table");
  for (const Failure& f : all) {
    const Entry* entry = f.section.empty() ? &checks : entry_of(c, sections, f.section);
    const std::string text = coloured("<b>" + markup_line(f.name) + "</b>", bad) + (f.message.empty() ? "" : "\n" + markup_line(f.message));
    const Lines what(c.cr, text, body, found_at - 20), found(c.cr, markup_line(f.worst), body, limit_at - found_at - 6),
        limit(c.cr, markup_line(f.limit), body, text_width - limit_at);
    const double height = std::max({what.height(), found.height(), limit.height()}) + 5;
    const int row = c.structure.add("TR", table), head = c.structure.add("TH", row, {}, Scope::row);
    const int name = add_linked(c, head, entry), first = c.structure.add("TD", row), second = c.structure.add("TD", row);
    c.flow.put({.height = height,
                .reluctance = &f == &all.back() ? 0 : split_small,
                .draw = [=, &c, destination = entry != nullptr ? entry->destination : std::string()](cairo_t* cr) {
                  set_colour(cr, bad);
                  cairo_rectangle(cr, 0, 0, 3, height - 4);
                  cairo_fill(cr);
                  draw_linked(c, cr, what, name, destination, {14, 0, found_at - 20, height - 4});
                  {
                    const Mark mark(cr, c.structure, first);
                    found.draw(cr, found_at, 0);
                  }
                  const Mark mark(cr, c.structure, second);
                  limit.draw(cr, limit_at, 0);
                }});
  }
}

// A bar as long as the share of the limit that is used, the limit at a tick.
void draw_bar(cairo_t* cr, double x, double y, double width, double height, double used) {
  constexpr double longest = 1.25;
  set_colour(cr, {0.91, 0.92, 0.94});
  cairo_rectangle(cr, x, y, width / longest, height);
  cairo_fill(cr);
  set_colour(cr, used > 1 ? bad : used >= 0.8 ? caution : good);
  cairo_rectangle(cr, x, y, width * std::min(used, longest) / longest, height);
  cairo_fill(cr);
  set_colour(cr, ink);
  cairo_rectangle(cr, x + width / longest - 0.4, y - 2, 0.8, height + 4);
  cairo_fill(cr);
}

// Name, number, how much of the limit it takes, the limit, where; one row each.
void put_key_numbers(Composer& c, const std::vector<Entry>& sections) {
  if (c.report.key_numbers.empty()) return;
  put_subheading(c, "Key numbers", "H2");
  constexpr double value_at = 55 * mm, bar_at = 90 * mm, bar_width = 27 * mm, limit_at = 120 * mm;
  const Style strong{{.size = body.font.size, .bold = true}, body.pitch};
  const int table = c.add("Table");
  for (const KeyNumber& k : c.report.key_numbers) {
    const Entry* entry = entry_of(c, sections, k.section);
    const Lines what(c.cr, markup_line(k.what), body, value_at - 8),
        value(c.cr, markup_line(k.value), strong, (k.limited() ? bar_at : limit_at) - value_at - 6);  // a bar stands where it is limited
    const std::string percent = k.limited() ? coloured(fmt::format("{:.0f} %", 100 * k.used), k.broken() ? bad : grey) + "  " : "";
    const std::string limit = percent + markup_line(k.limit), where = markup_line(k.where);
    const Lines beside(c.cr, limit + (limit.empty() || where.empty() ? "" : "\n") + coloured(where, grey), secondary_ink,
                       text_width - limit_at);
    const double height = std::max({what.height(), value.height(), beside.height()}) + 5;
    const int row = c.structure.add("TR", table), head = c.structure.add("TH", row, {}, Scope::row);
    const int name = add_linked(c, head, entry), first = c.structure.add("TD", row), second = c.structure.add("TD", row);
    c.flow.put({.height = height,
                .reluctance = &k == &c.report.key_numbers.back() ? 0 : split_small,
                .draw = [=, &c, used = k.used, limited = k.limited(),
                         destination = entry != nullptr ? entry->destination : std::string()](cairo_t* cr) {
                  draw_linked(c, cr, what, name, destination, {0, 0, text_width, height});
                  {
                    const Mark mark(cr, c.structure, first);
                    value.draw(cr, value_at, 0);
                  }
                  if (limited) draw_bar(cr, bar_at, 4, bar_width, 6, used);
                  {
                    const Mark mark(cr, c.structure, second);
                    beside.draw(cr, limit_at, 0);
                  }
                  rule(cr, 0, height - 2.5, text_width, 0.3, hairline);
                }});
  }
}

void put_finding(Composer& c, const std::vector<Entry>& sections, const Finding& f, int list) {
  const Entry* entry = entry_of(c, sections, f.section);
  std::string text = markup_line(f.text);
  if (f.kind == Finding::Kind::fault) text = "<b>" + text + "</b>";
  if (entry != nullptr) text += "  " + coloured("Section\u00A0" + markup_line(entry->number), accent);
  const Lines lines(c.cr, text, body, text_width - 14);
  const int element = add_linked(c, c.structure.add("LBody", c.structure.add("LI", list)), entry);
  c.flow.put(
      {.height = lines.height() + 4,
       .draw = [=, &c, colour = colour_of(f.kind), destination = entry != nullptr ? entry->destination : std::string()](cairo_t* cr) {
         set_colour(cr, colour);
         cairo_rectangle(cr, 0, 1, 3, lines.height() - 1);
         cairo_fill(cr);
         draw_linked(c, cr, lines, element, destination, {14, 0, text_width - 14, lines.height()});
       }});
}

// What was not looked at, or not decided, by name; and what nobody asked for.
void put_not_examined(Composer& c) {
  const std::vector<std::string> told = unexamined(c.report);
  if (told.empty()) return;
  put_subheading(c, "Not examined", "H2");
  for (const std::string& s : told) put_lines(c, markup_line(s), secondary);
}

constexpr Style contents_style{body.font, 16};

// Number, title, leaders and page of an entry, one link `width` wide.
std::function<void(cairo_t*)> contents_line(Composer& c, const Entry& e, int table, double width) {
  constexpr double number_width = 24, page_width = 22;  // [pt]
  auto text = std::make_shared<figure::Text>(c.cr, markup_line(e.title), contents_style.font, 0, true);
  pango_layout_set_width(text->layout(), static_cast<int>((width - number_width - page_width - 20) * PANGO_SCALE));
  pango_layout_set_ellipsize(text->layout(), PANGO_ELLIPSIZE_END);
  const Lines number(c.cr, markup_line(e.number), contents_style, 0);
  const int item = c.structure.add("TOCI", table);
  const int element = c.structure.add("Link", c.structure.add("Reference", item), printable_line(e.number + " " + e.title));
  return [=, &c, destination = e.destination](cairo_t* cr) {
    const std::string page_number = fmt::to_string(c.flow.page_of(destination));
    const auto extents = text->extents();
    const double baseline = contents_style.pitch / 2 + 0.346 * contents_style.font.size;
    {
      const Mark mark = Mark::link(cr, c.structure, element, destination, {0, 0, width, contents_style.pitch});
      number.draw(cr, 0, 0);
      set_colour(cr, ink);
      text->show(number_width, baseline - extents.baseline);
      Lines(cr, page_number, contents_style, 0).draw(cr, width - width_of(cr, page_number, contents_style.font), 0);
    }
    // Leaders are a dashed line of round dots: full stops would be read aloud and copied. They stand on one raster down the page.
    constexpr double pitch = 4.2;
    const double from = std::ceil((number_width + extents.width + 6) / pitch) * pitch, to = width - page_width;
    if (from >= to) return;
    const double dots[] = {0, pitch};
    cairo_save(cr);
    set_colour(cr, grey);
    cairo_set_line_width(cr, 0.8);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cr, dots, 2, 0);
    cairo_move_to(cr, from, baseline - 0.5);
    cairo_line_to(cr, to, baseline - 0.5);
    cairo_stroke(cr);
    cairo_restore(cr);
  };
}

}  // namespace

void put_title(Composer& c, const std::vector<Entry>& sections, const Entry& checks) {
  const Report& r = c.report;
  put_lines(c, c.add("H1"), r.title.empty() ? "Untitled report" : markup_line(r.title), title, {.keep_with_next = true});
  c.flow.gap(2);
  if (!r.author.empty()) put_lines(c, markup_line(r.author), subheading, {.keep_with_next = true});
  c.flow.gap(5);
  c.flow.put({.height = 2, .draw = [](cairo_t* cr) { rule(cr, 0, 1, text_width, 1.2, ink); }, .keep_with_next = true});
  c.flow.gap(6);
  c.flow.put({});
  put_field(c, "Mechanism", r.mechanism_title);
  put_field(c, "Source", r.source);
  put_field(c, "Scenario", r.provenance.scenario_name);
  if (!r.description.empty()) {
    c.flow.gap(6);
    put_lines(c, markup(r.description), body);
  }
  put_verdict(c);
  put_failures(c, sections, checks);
  put_key_numbers(c, sections);
  const auto told = [&](const Finding& f) { return told_by_a_failure(r, f); };
  if (!std::ranges::all_of(r.findings, told)) {
    put_subheading(c, "Findings", "H2");
    const int list = c.add("L");
    for (const Finding& f : r.findings)
      if (!told(f)) put_finding(c, sections, f, list);
  }
  put_not_examined(c);
  if (!r.summary.empty()) put_subheading(c, "What was asked", "H2");
  for (const Paragraph& p : r.summary) put_paragraph(c, p);
  if (r.assumptions.empty()) return;
  put_subheading(c, "Assumptions", "H2");
  const int list = c.add("L");
  for (std::size_t i = 0; i < r.assumptions.size(); ++i)
    put_lines(c, c.structure.add("LBody", c.structure.add("LI", list)),
              fmt::format("{}  {}", coloured(fmt::format("A{}", i + 1), grey), markup_line(r.assumptions[i])), body);
}

void put_contents(Composer& c, const std::vector<Entry>& entries) {
  put_subheading(c, "Contents", "H2");
  const int table = c.add("TOC");
  constexpr std::size_t most_in_one_column = 8;
  const std::size_t columns = entries.size() > most_in_one_column ? 2 : 1, rows = (entries.size() + columns - 1) / columns;
  constexpr double between = 10 * mm;
  const double width = columns == 1 ? text_width : (text_width - between) / 2;
  std::vector<std::function<void(cairo_t*)>> lines;
  for (const Entry& e : entries) lines.push_back(contents_line(c, e, table, width));
  for (std::size_t row = 0; row < rows; ++row) {
    Piece piece{.height = contents_style.pitch, .reluctance = row + 1 < rows ? split_small : 0, .keep_with_next = row == 0 && rows > 1};
    piece.draw = [first = lines[row], second = columns == 2 && rows + row < lines.size() ? lines[rows + row] : nullptr,
                  width](cairo_t* cr) {
      first(cr);
      if (!second) return;
      cairo_save(cr);
      cairo_translate(cr, width + between, 0);
      second(cr);
      cairo_restore(cr);
    };
    c.flow.put(std::move(piece));
  }
}

}  // namespace pmreport::document::pdf
