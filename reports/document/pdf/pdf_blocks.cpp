#include <reports/document/pdf/pdf_blocks.hpp>
#include <reports/document/pdf/pdf_link.hpp>
#include <reports/document/tally.hpp>
#include <reports/figure/draw.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::document::pdf {

void put_lines(Composer& c, const std::string& markup, const Style& style, double indent, const Bar* bar, bool keep_with_next) {
  const Lines lines(c.cr, markup, style, text_width - indent);
  for (int i = 0; i < lines.count(); ++i) {
    Piece piece{.height = style.pitch};
    piece.draw = [lines, i, indent, style, ruled = bar != nullptr, colour = bar ? bar->colour : ink](cairo_t* cr) {
      if (ruled) {
        // Each line draws its part of the bar; they overlap, or viewers show seams.
        set_colour(cr, colour);
        cairo_rectangle(cr, 0, i == 0 ? 1 : -0.4, 2.2, style.pitch - (i == 0 ? 1 : -0.4) - (i + 1 == lines.count() ? 1 : 0));
        cairo_fill(cr);
      }
      lines.draw_line(cr, i, indent, 0);
    };
    const bool orphan = i == 0, before_widow = i + 2 == lines.count(), last = i + 1 == lines.count();
    piece.keep_with_next = last ? keep_with_next : (orphan || before_widow);
    c.flow.put(std::move(piece));
  }
}

void put_paragraph(Composer& c, const Paragraph& p) {
  if (p.text.empty()) return;
  const std::string text = markup(p.text);
  if (p.tone == Paragraph::Tone::plain) {
    put_lines(c, text, body);
  } else {
    const bool warns = p.tone == Paragraph::Tone::warning;
    const Bar bar{warns ? caution : hairline};
    put_lines(c, coloured(warns ? "<b>Warning.</b>" : "<b>Note.</b>", warns ? caution : grey) + " " + text, body, 10, &bar);
  }
  c.flow.gap(7);
}

void put_heading(Composer& c, const std::string& number, const std::string& title, const std::string& destination) {
  constexpr double number_width = 26;  // [pt]
  c.flow.gap(24);
  const std::string text = markup_line(title);
  const Lines lines(c.cr, text.empty() ? " " : text, heading, text_width - number_width);
  Piece piece{.height = lines.height(), .keep_with_next = true, .destination = destination, .role = "H1"};
  piece.draw = [lines, figure = Lines(c.cr, markup_line(number), heading, 0)](cairo_t* cr) {
    figure.draw(cr, 0, 0);
    lines.draw(cr, number_width, 0);
  };
  c.flow.put(std::move(piece));
  c.flow.gap(7);
}

void put_subheading(Composer& c, const std::string& title) {
  c.flow.gap(14);
  const Lines lines(c.cr, markup_line(title), subheading, text_width);
  c.flow.put({.height = lines.height(), .draw = [lines](cairo_t* cr) { lines.draw(cr, 0, 0); }, .keep_with_next = true, .role = "H2"});
  c.flow.gap(4);
}

void put_field(Composer& c, const std::string& label, const std::string& value) {
  if (value.empty()) return;
  constexpr double label_width = 78;  // [pt]
  const Lines name(c.cr, coloured(markup_line(label), grey), body, label_width);
  const Lines lines(c.cr, markup_line(value), body, text_width - label_width);
  c.flow.put({.height = lines.height() + 1, .draw = [name, lines](cairo_t* cr) {
                name.draw(cr, 0, 0);
                lines.draw(cr, label_width, 0);
              }});
}

std::string verdict_markup(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return coloured("pass", good);
    case Verdict::failed:
      return coloured("<b>FAIL</b>", bad);
    case Verdict::error:
      return coloured("<b>ERROR</b>", bad);
    case Verdict::not_decided:
      return coloured(word_of(verdict), caution);
    case Verdict::not_examined:
    case Verdict::not_applicable:
      break;
  }
  return coloured(word_of(verdict), grey);
}

std::string numbered(const char* kind, int number, const std::string& caption_markup) {
  return fmt::format("<b>{} {}.</b> {}", kind, number, caption_markup);
}

namespace {

// Beside a figure of column width there is room for its caption.
void put_column_figure(Composer& c, const figure::Figure& f, const figure::Size& size, const std::string& text) {
  const double left = size.width + 8 * mm;
  const Lines lines(c.cr, text, caption, text_width - left);
  Piece piece{.height = std::max(size.height, lines.height()), .role = "Figure"};
  piece.draw = [&f, lines, left](cairo_t* cr) {
    cairo_save(cr);
    figure::draw(cr, f);
    cairo_restore(cr);
    lines.draw(cr, left, 4);
  };
  c.flow.put(std::move(piece));
}

}  // namespace

void put_figure(Composer& c, const figure::Figure& f) {
  std::string text = numbered("Figure", ++c.figures, markup_line(f.caption));
  const std::string data = data_file(c.report, c.names, f);
  if (!data.empty()) text += " " + coloured(unbroken("Data: " + markup_line(data)), grey);
  c.flow.gap(12);
  const figure::Size size = f.panels.empty() ? figure::Size{0, 0} : figure::size_of(f);
  if (size.width > 0 && size.width < text_width / 2 && size.height < text_height / 2) {
    put_column_figure(c, f, size, text);
  } else {
    const Lines lines(c.cr, text, caption, text_width);
    // A heading and the caption still fit on the page of the largest figure.
    const double room = text_height - lines.height() - 60;
    const double scale = size.width > 0 ? std::min({1.0, room / size.height, text_width / size.width}) : 0;
    if (scale > 0) {
      Piece piece{.height = scale * size.height + 4, .keep_with_next = true, .role = "Figure"};
      piece.draw = [&f, scale, x = (text_width - scale * size.width) / 2](cairo_t* cr) {
        cairo_save(cr);
        cairo_translate(cr, x, 0);
        cairo_scale(cr, scale, scale);
        figure::draw(cr, f);
        cairo_restore(cr);
      };
      c.flow.put(std::move(piece));
    }
    c.flow.put({.height = lines.height(), .draw = [lines](cairo_t* cr) { lines.draw(cr, 0, 0); }, .role = "Caption"});
  }
  c.flow.gap(14);
}

}  // namespace pmreport::document::pdf
