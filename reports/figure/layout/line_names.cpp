#include <reports/figure/layout/line_names.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double name_pitch = 2;        // [pt] between the places tried
constexpr double bend = 2.2;            // [pt] a line may stray so far from the middle of a name on it
constexpr double from_end = 3;          // [pt] from a name to the end of its line
constexpr double name_clearance = 1.2;  // [pt] from a name to other ink
constexpr double beside_line = 2.5;     // [pt] from a line to a name that stands beside it
constexpr double cut = 1.6;             // [pt] from a name to its line
constexpr double raster = 1.2;          // [pt] between the points of a box that are looked at
constexpr double long_stroke = 5;       // widths of a name: a further stroke so long bears it too

// A stroke by its length.
class Measured {
 public:
  explicit Measured(const Stroke& stroke) : points_(stroke), until_(stroke.size(), 0) {
    for (std::size_t i = 1; i < stroke.size(); ++i)
      until_[i] = until_[i - 1] + std::hypot(stroke[i].x - stroke[i - 1].x, stroke[i].y - stroke[i - 1].y);
  }
  double length() const { return until_.back(); }
  Point at(double s) const {
    const auto next = std::upper_bound(until_.begin() + 1, until_.end() - 1, s);
    const auto i = static_cast<std::size_t>(next - until_.begin());
    const double span = until_[i] - until_[i - 1], part = span > 0 ? std::clamp((s - until_[i - 1]) / span, 0.0, 1.0) : 0;
    return {points_[i - 1].x + part * (points_[i].x - points_[i - 1].x), points_[i - 1].y + part * (points_[i].y - points_[i - 1].y)};
  }
  Stroke piece(double from, double to) const {
    Stroke out{at(from)};
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (until_[i] > from && until_[i] < to) out.push_back(points_[i]);
    out.push_back(at(to));
    return out;
  }

 private:
  Stroke points_;
  std::vector<double> until_;
};

template <class Visit>  // bool(Point): false ends it
bool all_points(const LineName& name, double margin, Visit&& visit) {
  const double w = name.width / 2 + margin, h = name.height / 2 + margin, c = std::cos(name.angle), s = std::sin(name.angle);
  const int columns = static_cast<int>(2 * w / raster) + 1, rows = static_cast<int>(2 * h / raster) + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double u = -w + 2 * w * i / columns, v = -h + 2 * h * j / rows;
      if (!visit(Point{name.middle.x + c * u - s * v, name.middle.y + s * u + c * v})) return false;
    }
  return true;
}

struct Bearer {
  std::vector<Measured> strokes;  // the longest first
  Extents size{};
  std::string label;
};

struct Place {
  LineName name;
  double from = 0, to = 0;  // of the stroke, cut out; none beside it
};

class Namer {
 public:
  Namer(const std::vector<Bearer>& lines, const Frame& frame, const std::vector<Stroke>& other)
      : lines_(lines), frame_(frame), other_(other) {}

  std::optional<Place> on_stroke(std::size_t line, std::size_t stroke) const {
    const Measured& own = lines_[line].strokes[stroke];
    const double width = lines_[line].size.width;
    const double first = width / 2 + from_end, last = own.length() - first;
    if (last < first) return std::nullopt;
    const Occupancy ink = ink_without(line, stroke);
    std::optional<Place> best;
    double least = std::numeric_limits<double>::infinity();
    for (double s = first; s <= last; s += name_pitch) {
      Place p{named(line), s - width / 2, s + width / 2};
      const Point a = own.at(p.from), b = own.at(p.to);
      if (std::hypot(b.x - a.x, b.y - a.y) < 0.9 * width) continue;
      p.name.angle = std::atan2(b.y - a.y, b.x - a.x);
      if (p.name.angle > std::numbers::pi / 2) p.name.angle -= std::numbers::pi;
      if (p.name.angle <= -std::numbers::pi / 2) p.name.angle += std::numbers::pi;
      const double stray = strays(own, p, a, b);
      p.name.middle = middle(own, p);
      if (stray > bend || !stands_free(p.name, ink) || meets_itself(own, p)) continue;
      const double cost =
          stray / bend + std::abs(p.name.angle) / (std::numbers::pi / 2) + 0.7 * std::abs(s - own.length() / 2) / own.length();
      if (cost < least) least = cost, best = p;
    }
    return best;
  }

  // Level, and nearer to its own line than to any other.
  std::optional<Place> beside_stroke(std::size_t line, std::size_t stroke) const {
    const Measured& own = lines_[line].strokes[stroke];
    const Occupancy others = ink_without(line, lines_[line].strokes.size()), all = ink_without(lines_.size(), 0);
    for (double s = own.length() / 2, step = 0; s >= 0 && s <= own.length();
         step = step <= 0 ? -step + name_pitch : -step, s = own.length() / 2 + step) {
      const Point at = own.at(s);
      for (const auto& [right, down] : {std::pair{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}) {
        Place p{named(line)};
        p.name.middle = {at.x + right * (p.name.width / 2 + beside_line), at.y + down * (p.name.height / 2 + beside_line)};
        if (stands_free(p.name, all) && all_points(p.name, 2 * beside_line, [&](Point q) { return others.free({q.x, q.y, 0, 0}); }))
          return p;
      }
    }
    return std::nullopt;
  }

  void put(const LineName& name) { names_.push_back(name); }
  const std::vector<LineName>& names() const { return names_; }

 private:
  const std::vector<Bearer>& lines_;
  Frame frame_;
  const std::vector<Stroke>& other_;
  std::vector<LineName> names_;

  LineName named(std::size_t line) const { return {lines_[line].label, {}, 0, lines_[line].size.width, lines_[line].size.height}; }

  // Of everything but one stroke, or but a whole line where `stroke` counts its strokes.
  Occupancy ink_without(std::size_t line, std::size_t stroke) const {
    Occupancy ink(frame_.width, frame_.height);
    const auto draw = [&](const Stroke& s) {
      for (std::size_t i = 0; i + 1 < s.size(); ++i) ink.mark(s[i], s[i + 1]);
    };
    for (const Stroke& s : other_) draw(s);
    for (std::size_t k = 0; k < lines_.size(); ++k)
      for (std::size_t i = 0; i < lines_[k].strokes.size(); ++i) {
        if (k == line && (i == stroke || stroke == lines_[k].strokes.size())) continue;
        const Measured& m = lines_[k].strokes[i];
        draw(m.piece(0, m.length()));
        for (const Point end : {m.at(0), m.at(m.length())}) ink.mark(Box{end.x, end.y, 0, 0}.grown(1));
      }
    ink.seal();
    return ink;
  }

  bool stands_free(const LineName& name, const Occupancy& ink) const {
    return all_points(name, name_clearance, [&](Point p) {
      if (p.x < 0 || p.y < 0 || p.x > frame_.width || p.y > frame_.height || !ink.free({p.x, p.y, 0, 0})) return false;
      return std::none_of(names_.begin(), names_.end(), [&](const LineName& other) { return other.covers(p, name_clearance); });
    });
  }

  // How far the piece under the name is from its chord.
  static double strays(const Measured& own, const Place& p, Point a, Point b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double low = 0, high = 0;
    for (double s = p.from; s <= p.to; s += name_pitch) {
      const Point q = own.at(s);
      const double off = ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x)) / length;
      low = std::min(low, off), high = std::max(high, off);
    }
    return (high - low) / 2;
  }

  static Point middle(const Measured& own, const Place& p) {
    Point sum{0, 0};
    constexpr int parts = 8;
    for (int k = 0; k <= parts; ++k) {
      const Point q = own.at(p.from + (p.to - p.from) * k / parts);
      sum.x += q.x / (parts + 1), sum.y += q.y / (parts + 1);
    }
    return sum;
  }

  static bool meets_itself(const Measured& own, const Place& p) {
    for (double s = 0; s <= own.length(); s += raster)
      if ((s < p.from - from_end || s > p.to + from_end) && p.name.covers(own.at(s), name_clearance)) return true;
    return false;
  }
};

}  // namespace

bool LineName::covers(Point p, double margin) const {
  const double c = std::cos(angle), s = std::sin(angle), x = p.x - middle.x, y = p.y - middle.y;
  return std::abs(c * x + s * y) <= width / 2 + margin && std::abs(-s * x + c * y) <= height / 2 + margin;
}

NamedLines lay_out_named(cairo_t* cr, const std::vector<NamedLine>& lines, const Frame& frame, const std::vector<Stroke>& other) {
  std::vector<Bearer> measured;
  for (const NamedLine& line : lines) {
    Bearer m{{}, Text(cr, line.label, {.size = name_size}).extents(), line.label};
    for (const Stroke& stroke : trace(line.x, line.y, frame).strokes) m.strokes.emplace_back(stroke);
    std::stable_sort(m.strokes.begin(), m.strokes.end(), [](const Measured& a, const Measured& b) { return a.length() > b.length(); });
    measured.push_back(std::move(m));
  }
  // Short lines have the fewest places for their names.
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto longest = [&](std::size_t k) { return measured[k].strokes.empty() ? 0 : measured[k].strokes.front().length(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return longest(a) < longest(b); });

  NamedLines out;
  out.lines.resize(lines.size());
  Namer namer(measured, frame, other);
  int dashed = 0;
  for (const std::size_t k : order) {
    const Bearer& line = measured[k];
    bool named = line.label.empty() || line.strokes.empty();
    std::vector<std::optional<Place>> places(line.strokes.size());
    for (std::size_t i = 0; i < line.strokes.size() && !line.label.empty(); ++i)
      if (!named || line.strokes[i].length() > long_stroke * line.size.width)
        if (places[i] = namer.on_stroke(k, i); places[i]) namer.put(places[i]->name), named = true;
    for (std::size_t i = 0; i < line.strokes.size() && !named; ++i)
      if (const auto place = namer.beside_stroke(k, i)) namer.put(place->name), named = true;
    if (!named) out.lines[k].dash = ++dashed;
    for (std::size_t i = 0; i < line.strokes.size(); ++i) {
      const Measured& m = line.strokes[i];
      if (!places[i]) {
        out.lines[k].strokes.push_back(m.piece(0, m.length()));
        continue;
      }
      out.lines[k].strokes.push_back(m.piece(0, std::max(places[i]->from - cut, 0.0)));
      out.lines[k].strokes.push_back(m.piece(std::min(places[i]->to + cut, m.length()), m.length()));
    }
  }
  out.names = namer.names();
  return out;
}

void mark(Occupancy& ink, const NamedLines& named) {
  for (const NamedStrokes& line : named.lines)
    for (const Stroke& s : line.strokes)
      for (std::size_t i = 0; i + 1 < s.size(); ++i) ink.mark(s[i], s[i + 1]);
  for (const LineName& name : named.names)
    all_points(name, 0, [&](Point p) {
      ink.mark(p, p);
      return true;
    });
}

std::vector<double> named_dash(int dash) { return dash == 0 ? std::vector<double>{} : line_style(dash).dash; }

void draw_named(cairo_t* cr, const NamedLines& named) {
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  const auto draw = [&](const NamedStrokes& line) {
    for (const Stroke& stroke : line.strokes) {
      cairo_new_sub_path(cr);
      for (const Point p : stroke) cairo_line_to(cr, p.x, p.y);
    }
    cairo_stroke(cr);
  };
  cairo_set_line_width(cr, named_width + 1.6);
  cairo_set_source_rgba(cr, 1, 1, 1, 0.8);
  for (const NamedStrokes& line : named.lines) draw(line);
  cairo_set_line_width(cr, named_width);
  set_colour(cr, ink);
  for (const NamedStrokes& line : named.lines) {
    const std::vector<double> dash = named_dash(line.dash);
    cairo_set_dash(cr, dash.data(), static_cast<int>(dash.size()), 0);
    draw(line);
  }
  cairo_set_dash(cr, nullptr, 0, 0);
}

void draw_names(cairo_t* cr, const NamedLines& named) {
  for (const LineName& name : named.names) {
    const Text text(cr, name.text, {.size = name_size});
    cairo_save(cr);
    cairo_translate(cr, name.middle.x, name.middle.y);
    cairo_rotate(cr, name.angle);
    cairo_move_to(cr, -name.width / 2, -name.height / 2);
    pango_cairo_layout_path(cr, text.layout());
    cairo_set_source_rgba(cr, 1, 1, 1, 0.9);
    cairo_set_line_width(cr, 2.2);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cr);
    set_colour(cr, ink);
    text.show(-name.width / 2, -name.height / 2);
    cairo_restore(cr);
  }
}

}  // namespace pmreport::figure
