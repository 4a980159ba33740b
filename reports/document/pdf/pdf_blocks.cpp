#include <reports/document/html/figure_words.hpp>
#include <reports/document/pdf/pdf_blocks.hpp>
#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/tally.hpp>
#include <reports/figure/draw.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pmreport::document::pdf {

void put_lines(Composer& c, int element, const std::string& markup, const Style& style, const Setting& setting) {
  const Lines lines(c.cr, markup, style, text_width - setting.indent);
  for (int i = 0; i < lines.count(); ++i) {
    Piece piece{.height = style.pitch, .reluctance = split_paragraph, .element = element};
    piece.draw = [lines, i, indent = setting.indent, style, ruled = setting.bar != nullptr,
                  colour = setting.bar ? setting.bar->colour : ink](cairo_t* cr) {
      if (ruled) {
        // Each line draws its part of the bar; they overlap, or viewers show seams.
        set_colour(cr, colour);
        cairo_rectangle(cr, 0, i == 0 ? 1 : -0.4, 2.2, style.pitch - (i == 0 ? 1 : -0.4) - (i + 1 == lines.count() ? 1 : 0));
        cairo_fill(cr);
      }
      lines.draw_line(cr, i, indent, 0);
    };
    const bool orphan = i == 0, before_widow = i + 2 == lines.count(), last = i + 1 == lines.count();
    piece.keep_with_next = last ? setting.keep_with_next : (orphan || before_widow);
    if (last) piece.reluctance = 0;
    c.flow.put(std::move(piece));
  }
}

void put_lines(Composer& c, const std::string& markup, const Style& style, const Setting& setting) {
  put_lines(c, c.add("P"), markup, style, setting);
}

void put_paragraph(Composer& c, const Paragraph& p) {
  if (p.text.empty()) return;
  const std::string text = markup(p.text);
  if (p.tone == Paragraph::Tone::plain) {
    put_lines(c, text, body);
  } else {
    const bool warns = p.tone == Paragraph::Tone::warning;
    const Bar bar{warns ? caution : hairline};
    put_lines(c, coloured(warns ? "<b>Warning.</b>" : "<b>Note.</b>", warns ? caution : grey) + " " + text, body,
              {.indent = 10, .bar = &bar});
  }
  c.flow.gap(7);
}

void put_heading(Composer& c, const std::string& number, const std::string& title, const std::string& destination) {
  const double number_width = number.empty() ? 0 : 26;  // [pt]
  c.flow.gap(24);
  const std::string text = markup_line(title);
  const Lines lines(c.cr, text.empty() ? " " : text, heading, text_width - number_width);
  Piece piece{.height = lines.height(), .keep_with_next = true, .destination = destination, .element = c.add("H2")};
  piece.draw = [number_width, lines, figure = Lines(c.cr, markup_line(number), heading, 0)](cairo_t* cr) {
    figure.draw(cr, 0, 0);
    lines.draw(cr, number_width, 0);
  };
  c.flow.put(std::move(piece));
  c.flow.gap(7);
}

void put_subheading(Composer& c, const std::string& title, const char* role) {
  c.flow.gap(14);
  const Lines lines(c.cr, markup_line(title), subheading, text_width);
  c.flow.put(
      {.height = lines.height(), .draw = [lines](cairo_t* cr) { lines.draw(cr, 0, 0); }, .keep_with_next = true, .element = c.add(role)});
  c.flow.gap(4);
}

void put_field(Composer& c, const std::string& label, const std::string& value, const Style& style) {
  if (value.empty()) return;
  constexpr double label_width = 78;  // [pt]
  const Lines name(c.cr, coloured(markup_line(label), grey), style, label_width);
  const Lines lines(c.cr, markup_line(value), style, text_width - label_width);
  c.flow.put({.height = lines.height() + 1,
              .draw =
                  [name, lines](cairo_t* cr) {
                    name.draw(cr, 0, 0);
                    lines.draw(cr, label_width, 0);
                  },
              .element = c.add("P")});
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

// The caption, and at the right of its last line, or below it, the link to the data behind the figure.
class FigureCaption {
 public:
  FigureCaption(Composer& c, const std::string& text, const std::string& data, double width)
      : lines_(c.cr, text, caption, width), data_(data), element_(c.add("Caption")) {
    if (data.empty()) return;
    link_ = c.structure.add("Link", element_, "The data of this figure: " + data);
    word_.emplace(c.cr, coloured("Data: ", grey) + coloured(markup_line(data), accent), caption, 0);
    x_ = std::max(0.0, width - word_->width(0));
    y_ = lines_.width(lines_.count() - 1) + 12 <= x_ ? lines_.height() - caption.pitch : lines_.height();
  }
  double height() const { return word_ ? y_ + caption.pitch : lines_.height(); }
  void draw(cairo_t* cr, Structure& structure, double x, double y) const {
    {
      const Mark mark(cr, structure, element_);
      lines_.draw(cr, x, y);
    }
    if (!word_) return;
    const Mark mark = Mark::link_to_file(cr, structure, link_, data_, {x + x_, y + y_, word_->width(0), caption.pitch});
    word_->draw(cr, x + x_, y + y_);
  }

 private:
  Lines lines_;
  std::string data_;
  int element_, link_ = -1;
  std::optional<Lines> word_;
  double x_ = 0, y_ = 0;  // of the link [pt]
};

// What a reader by ear is told instead of a plot.
std::string in_words(const figure::Figure& f) {
  std::string all = name_of(f) + ".";
  for (const PanelWords& panel : words_of(f)) {
    all += " " + panel.heading + ".";
    for (const std::string& line : panel.lines) all += " " + line + ".";
  }
  return printable_line(all);
}

// Beside a figure of column width there is room for its caption.
void put_column_figure(Composer& c, const figure::Figure& f, int element, const figure::Size& size, const std::string& text,
                       const std::string& data) {
  const double left = size.width + 8 * mm;
  const FigureCaption words(c, text, data, text_width - left);
  Piece piece{.height = std::max(size.height, words.height() + 4)};
  piece.draw = [&c, &f, words, left, element, size](cairo_t* cr) {
    {
      const Mark mark = Mark::figure(cr, c.structure, element, {0, 0, size.width, size.height});
      cairo_save(cr);
      figure::draw(cr, f);
      cairo_restore(cr);
    }
    words.draw(cr, c.structure, left, 4);
  };
  c.flow.put(std::move(piece));
}

}  // namespace

void put_figure(Composer& c, const figure::Figure& f, int number) {
  const std::string text = numbered("Figure", number, markup_line(f.caption)), data = data_file(c.report, c.names, f);
  c.flow.gap(12);
  const figure::Size size = f.panels.empty() ? figure::Size{0, 0} : figure::size_of(f);
  const int element = size.width > 0 ? c.add("Figure", in_words(f)) : -1;
  if (size.width > 0 && size.width < text_width / 2 && size.height < text_height / 2) {
    put_column_figure(c, f, element, size, text, data);
  } else {
    const FigureCaption words(c, text, data, text_width);
    // A heading and the caption still fit on the page of the largest figure.
    const double room = text_height - words.height() - 60;
    const double scale = size.width > 0 ? std::min({1.0, room / size.height, text_width / size.width}) : 0;
    if (scale > 0) {
      Piece piece{.height = scale * size.height + 4, .keep_with_next = true};
      piece.draw_scaled = [&c, &f, element, scale, size](cairo_t* cr, double shrunk) {
        cairo_save(cr);
        cairo_translate(cr, (text_width - shrunk * scale * size.width) / 2, 0);
        const Mark mark = Mark::figure(cr, c.structure, element, {0, 0, shrunk * scale * size.width, shrunk * scale * size.height});
        cairo_scale(cr, shrunk * scale, shrunk * scale);
        figure::draw(cr, f);
        cairo_restore(cr);
      };
      c.flow.put(std::move(piece));
    }
    c.flow.put({.height = words.height(), .draw = [&c, words](cairo_t* cr) { words.draw(cr, c.structure, 0, 0); }});
  }
  c.flow.gap(14);
}

}  // namespace pmreport::document::pdf
