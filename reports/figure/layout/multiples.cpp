#include <algorithm>
#include <cmath>

#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/range.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double between_multiples = 7;          // [pt] from a frame to the numbers of the next
constexpr double between_rows_of_multiples = 6;  // [pt]
constexpr double after_name = 4;                 // [pt] from the name of a row to the numbers of its first panel
constexpr double frame_height_few = 58;          // [pt] of up to four rows
constexpr double frame_height_many = 48;
constexpr std::size_t few = 4;

// Of all panels of a column: as if they were one.
Interval shared_range(const Figure& figure, std::size_t column) {
  Panel all;
  const std::size_t columns = figure.multiples->columns.size();
  for (std::size_t i = column; i < figure.panels.size(); i += columns) {
    const Panel& p = figure.panels[i];
    all.series.insert(all.series.end(), p.series.begin(), p.series.end());
    all.lines.insert(all.lines.end(), p.lines.begin(), p.lines.end());
  }
  return y_range(all);
}

double width_of(cairo_t* cr, const std::string& text, double size, bool bold) {
  return Text(cr, bold ? "<b>" + escape_markup(text) + "</b>" : escape_markup(text), {.size = size}, 0, true).extents().width;
}

}  // namespace

Layout lay_out_multiples(cairo_t* cr, const Figure& figure, double width) {
  const Multiples& names = *figure.multiples;
  const std::size_t columns = names.columns.size(), rows = names.rows.size();
  const double frame_height = rows <= few ? frame_height_few : frame_height_many;
  double name_width = 0;
  for (const std::string& name : names.rows) name_width = std::max(name_width, width_of(cr, name, title_size, true));

  // Numbers of a column take the room that its scale needs; frames share what is left.
  Layout layout;
  std::vector<double> numbers(columns, 0);
  std::vector<Interval> ranges;
  for (std::size_t c = 0; c < columns; ++c) ranges.push_back(shared_range(figure, c));
  // The numbers that stand along a frame follow its width, and its width follows what they leave: until frames as wide as these fit.
  double frame_width = 60;
  for (int round = 0; round < 6; ++round) {
    layout.panels.clear();
    double overhang = 0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      const std::size_t c = i % columns;
      layout.panels.push_back(lay_out_panel(cr, figure.panels[i], frame_width, frame_height, frame_width, ranges[c]));
      const PanelLayout& panel = layout.panels.back();
      for (const Tick& tick : panel.y.major)
        numbers[c] = std::max(numbers[c], tick_length + tick_gap + width_of(cr, tick.label, tick_size, false));
      for (const Tick& tick : panel.x.major)
        overhang =
            std::max(overhang, panel.x.position(tick.value) * frame_width + width_of(cr, tick.label, tick_size, false) / 2 - frame_width);
    }
    double taken = 2 * edge + name_width + after_name + overhang + between_multiples * static_cast<double>(columns - 1);
    for (const double n : numbers) taken += n;
    const double fits = std::max(20.0, std::floor((width - taken) / static_cast<double>(columns)));
    if (fits == frame_width || (round > 1 && fits > frame_width)) break;
    frame_width = fits;
  }

  const double tick_height = Text(cr, "0", {.size = tick_size}).extents().height;
  double heading = 0;
  for (std::size_t c = 0; c < columns && c < layout.panels.size(); ++c) {
    PanelLayout& top = layout.panels[c];
    const Panel& panel = figure.panels[c];
    top.heading = escape_markup(axis_title({names.columns[c], panel.y.unit}, top.y));
    heading = std::max(heading, Text(cr, top.heading, {.size = title_size}, top.frame.width, true).extents().height + heading_gap);
  }
  double y = edge + heading;
  for (std::size_t r = 0; r < rows; ++r) {
    double x = edge + name_width + after_name;
    for (std::size_t c = 0; c < columns; ++c) {
      PanelLayout& panel = layout.panels[r * columns + c];
      x += numbers[c];
      panel.frame.x = x, panel.frame.y = y;
      panel.y_titled = false;
      panel.x_titled = panel.x_numbered = r + 1 == rows;
      panel.x_title_y = panel.frame.height + tick_length + tick_gap + tick_height + title_gap;
      if (c == 0) {
        panel.row_name = names.rows[r];
        panel.row_name_x = edge - x;
        const std::vector<Series>& series = figure.panels[r * columns].series;
        panel.row_style = series.empty() ? 0 : style_of(series.front(), 0);
      }
      x += panel.frame.width + between_multiples;
    }
    y += frame_height + between_rows_of_multiples;
  }
  const double title_height = Text(cr, "t", {.size = label_size}).extents().height;
  y += tick_length + tick_gap + tick_height + title_gap + title_height - between_rows_of_multiples;
  layout.size = {width, std::ceil(y + edge)};
  return layout;
}

}  // namespace pmreport::figure
