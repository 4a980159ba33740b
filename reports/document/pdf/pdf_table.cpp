#include <reports/document/pdf/pdf_breaks.hpp>
#include <reports/document/pdf/pdf_table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>

namespace pmreport::document::pdf {

namespace {

constexpr double largest_type = 8.5, smallest_type = 6.5;  // [pt]
constexpr double readable_column = 110;                    // text is not wrapped narrower while smaller type can help [pt]
constexpr double above = 1.9, below = 1.9;                 // of a row's text [pt]
constexpr int most_lines = 14;                             // of a cell; what is more ends in an ellipsis
constexpr std::size_t most_rows = 60, most_columns = 24;

struct Cell {
  std::shared_ptr<figure::Text> text;
  figure::Extents extents{};
};
using Row = std::vector<Cell>;

struct Layout {
  double size = 0;               // of type [pt]
  std::vector<double> x, width;  // of columns [pt]
  double total = 0;              // width of the table [pt]
};

Cell set_cell(cairo_t* cr, const std::string& markup, double size, bool bold, double width, bool right) {
  Cell cell;
  const figure::Font font{.size = size, .bold = bold};
  cell.text = std::make_shared<figure::Text>(cr, markup, font, 0, true);
  cell.extents = cell.text->extents();
  // Rounding to Pango's units must not wrap what fits exactly.
  if (width > 0 && cell.extents.width > width + 0.01) {
    PangoLayout* const layout = cell.text->layout();
    pango_layout_set_width(layout, static_cast<int>(std::ceil(width * PANGO_SCALE)));
    break_words(layout);
    pango_layout_set_ellipsize(layout, PANGO_ELLIPSIZE_END);
    pango_layout_set_height(layout, -most_lines);
    if (right) pango_layout_set_alignment(layout, PANGO_ALIGN_RIGHT);
    cell.extents = cell.text->extents();
    cell.extents.width = width;
  }
  return cell;
}

// Width of the longest word: what remains when lines break wherever they may.
double longest_word(cairo_t* cr, const std::string& markup, double size, bool bold) {
  const figure::Text text(cr, markup, {.size = size, .bold = bold}, 1, true);
  pango_layout_set_wrap(text.layout(), PANGO_WRAP_WORD);
  return text.extents().width;
}

Layout lay_out(cairo_t* cr, const Grid& g) {
  const std::size_t n = g.headings.size();
  std::vector<double> natural(n), tight(n);
  for (std::size_t j = 0; j < n; ++j) {
    double cells = 0, words = 0;
    for (const auto& row : g.rows) {
      cells = std::max(cells, width_of(cr, row[j], {.size = largest_type}));
      if (!g.numeric[j]) words = std::max(words, longest_word(cr, row[j], largest_type, false));
    }
    natural[j] = std::max(cells, width_of(cr, g.headings[j], {.size = largest_type, .bold = true}));
    const double heading = longest_word(cr, g.headings[j], largest_type, true);
    tight[j] = std::max(heading, g.numeric[j] ? cells : std::max(words, std::min(cells, readable_column)));
  }
  const double gap = std::min(14.0, 0.25 * text_width / static_cast<double>(n));
  const double available = text_width - gap * static_cast<double>(n - 1);
  Fit fit = fit_columns(natural, tight, available, largest_type, smallest_type);
  if (g.stretch >= 0) {
    const double used = std::accumulate(fit.width.begin(), fit.width.end(), 0.0);
    fit.width[static_cast<std::size_t>(g.stretch)] += std::max(0.0, available - used);
  }
  Layout layout{.size = fit.size, .x = {}, .width = fit.width};
  double x = 0;
  for (const double w : fit.width) {
    layout.x.push_back(x);
    x += w + gap;
  }
  layout.total = x - gap;
  return layout;
}

Row set_row(cairo_t* cr, const Grid& g, const Layout& layout, const std::vector<std::string>& cells, bool bold) {
  Row row;
  for (std::size_t j = 0; j < cells.size(); ++j) row.push_back(set_cell(cr, cells[j], layout.size, bold, layout.width[j], g.numeric[j]));
  return row;
}

double height_of(const Row& row) {
  double height = 0;
  for (const auto& cell : row) height = std::max(height, cell.extents.height);
  return height + above + below;
}

// Cells are content of `elements`, one each; of none where the row repeats another.
void draw_row(cairo_t* cr, Structure& structure, const Row& row, const std::vector<int>& elements, const Layout& layout,
              const std::vector<bool>& numeric, double y, bool at_bottom) {
  const double height = height_of(row);
  for (std::size_t j = 0; j < row.size(); ++j) {
    const double x = layout.x[j] + (numeric[j] ? layout.width[j] - row[j].extents.width : 0);
    const double top = y + (at_bottom ? height - below - row[j].extents.height : above);
    std::optional<Mark> mark;
    if (!elements.empty()) mark.emplace(cr, structure, elements[j]);
    set_colour(cr, ink);
    row[j].text->show(x, top);
  }
}

// A row of the structure: headings of columns, or a heading and its values.
std::vector<int> add_row(Structure& structure, int parent, std::size_t cells, bool headings) {
  const int row = structure.add("TR", parent);
  std::vector<int> elements;
  for (std::size_t j = 0; j < cells; ++j) {
    const bool heads = headings || j == 0;
    elements.push_back(structure.add(heads ? "TH" : "TD", row, {}, headings ? Scope::column : heads ? Scope::row : Scope::none));
  }
  return elements;
}

void put_rows(Composer& c, const Grid& g, const std::string& name, int table) {
  const auto layout = std::make_shared<const Layout>(lay_out(c.cr, g));
  const auto heading = std::make_shared<const Row>(set_row(c.cr, g, *layout, g.headings, true));
  const auto draw_heading = [&c, layout, heading, numeric = g.numeric](cairo_t* cr, double y, const std::vector<int>& elements) {
    rule(cr, 0, y, layout->total, 0.9, ink);
    draw_row(cr, c.structure, *heading, elements, *layout, numeric, y + 1, true);
    rule(cr, 0, y + height_of(*heading) + 1.5, layout->total, 0.5, ink);
  };
  const double heading_height = height_of(*heading) + 3;

  const Lines again(c.cr, coloured(name.empty() ? "continued" : name + ", continued", grey), caption, 0);
  Continuation over;
  over.foot.draw = [layout](cairo_t* cr) { rule(cr, 0, 1.5, layout->total, 0.5, ink); };
  over.head.height = again.height() + 3 + heading_height;
  over.head.draw = [again, draw_heading](cairo_t* cr) {
    again.draw(cr, 0, 0);
    draw_heading(cr, again.height() + 3, {});
  };
  Piece top{.height = heading_height, .keep_with_next = true};
  const std::vector<int> headings = add_row(c.structure, c.structure.add("THead", table), g.headings.size(), true);
  top.draw = [draw_heading, headings](cairo_t* cr) { draw_heading(cr, 0, headings); };
  top.begins = std::make_shared<const Continuation>(std::move(over));
  c.flow.put(std::move(top));

  const std::size_t n = g.rows.size();
  std::vector<std::shared_ptr<const Row>> rows;
  double total = heading_height;
  for (const auto& cells : g.rows) {
    rows.push_back(std::make_shared<const Row>(set_row(c.cr, g, *layout, cells, false)));
    total += height_of(*rows.back());
  }
  constexpr std::size_t small_table = 12;
  const double reluctance = n > small_table ? split_large : total <= most_white * text_height ? split_small : split_low;
  const int all = c.structure.add("TBody", table);
  for (std::size_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    Piece piece{.height = height_of(*rows[i]) + (last ? 3 : 0), .reluctance = last ? 0 : reluctance};
    piece.draw = [&c, row = rows[i], elements = add_row(c.structure, all, g.headings.size(), false), layout, numeric = g.numeric,
                  last](cairo_t* cr) {
      draw_row(cr, c.structure, *row, elements, *layout, numeric, 0, false);
      if (last) rule(cr, 0, height_of(*row) + 1.5, layout->total, 0.9, ink);
    };
    piece.keep_with_next = !last && (i == 0 || i + 2 == n);
    piece.ends = last;
    c.flow.put(std::move(piece));
  }
}

}  // namespace

Fit fit_columns(const std::vector<double>& natural, const std::vector<double>& tight, double available, double size, double smallest) {
  const double all_natural = std::accumulate(natural.begin(), natural.end(), 0.0);
  const double all_tight = std::accumulate(tight.begin(), tight.end(), 0.0);
  for (double s = size; s >= smallest; s -= 0.5) {
    const double k = s / size;
    Fit fit{s, natural};
    if (k * all_natural <= available) {
      for (double& w : fit.width) w *= k;
      return fit;
    }
    if (k * all_tight <= available) {
      // The width beyond need goes to those who want it, in proportion.
      const double share = (available - k * all_tight) / (k * (all_natural - all_tight));
      for (std::size_t j = 0; j < natural.size(); ++j) fit.width[j] = k * (tight[j] + share * (natural[j] - tight[j]));
      return fit;
    }
  }
  // Words must break: columns narrower than an equal share keep their width, the others divide the rest among them.
  const double k = smallest / size;
  Fit fit{smallest, tight};
  std::vector<std::size_t> order(tight.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return tight[a] < tight[b]; });
  double left = available;
  for (std::size_t i = 0; i < order.size(); ++i) {
    fit.width[order[i]] = std::min(k * tight[order[i]], left / static_cast<double>(order.size() - i));
    left -= fit.width[order[i]];
  }
  return fit;
}

void put_grid(Composer& c, const Grid& g) {
  c.flow.gap(12);
  if (g.number == 0 && !g.caption.empty()) put_subheading(c, g.caption);
  const bool empty = g.rows.empty() || g.headings.empty();
  const int table = empty ? -1 : c.add("Table");
  std::string name;
  if (g.number > 0) {
    name = fmt::format("Table {}", g.number);
    const int element = empty ? c.add("P") : c.structure.add("Caption", table);
    put_lines(c, element, numbered("Table", g.number, markup_line(g.caption)), caption, {.keep_with_next = true});
    c.flow.gap(4);
  }
  if (empty) {
    put_lines(c, "No rows.", secondary);
  } else {
    put_rows(c, g, name, table);
  }
  c.flow.gap(12);
}

void put_table(Composer& c, const Table& t, int number) {
  std::size_t columns = t.headings.size();
  for (const auto& row : t.rows) columns = std::max(columns, row.size());
  const std::size_t shown_columns = std::min(columns, most_columns), shown_rows = std::min(t.rows.size(), most_rows);
  const auto markup_of = [&](const std::vector<std::string>& cells) {
    std::vector<std::string> result(shown_columns);
    for (std::size_t j = 0; j < std::min(cells.size(), shown_columns); ++j) result[j] = markup_line(cells[j]);
    return result;
  };
  Grid g{.caption = t.caption, .number = number, .headings = markup_of(t.headings), .numeric = t.numeric, .rows = {}};
  g.numeric.resize(shown_columns, false);
  for (std::size_t i = 0; i < shown_rows; ++i) g.rows.push_back(markup_of(t.rows[i]));
  put_grid(c, g);
  const auto tell = [&](const char* what, std::size_t shown, std::size_t all) {
    if (shown < all) put_lines(c, fmt::format("{} 1 to {} of {} are shown; report.html has all of them.", what, shown, all), secondary);
  };
  tell("Rows", shown_rows, t.rows.size());
  tell("Columns", shown_columns, columns);
  c.flow.gap(12);
}

}  // namespace pmreport::document::pdf
