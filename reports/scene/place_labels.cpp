#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <reports/figure/text.hpp>
#include <reports/scene/labels.hpp>
#include <reports/scene/occupied.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;

// All lengths below are in units of the font size.
constexpr double gaps[] = {0.20, 0.55, 1.0, 1.6, 2.4, 3.4, 4.8};  // between a point and its label
constexpr int places_around = 24;
constexpr double spacing = 0.18;       // between two labels, and between a label and a joint
constexpr double between_words = 0.8;  // beside one another, of labels of several words, which would be read as one
constexpr double needs_leader = 1.3;   // a label farther than this gets a line
constexpr int sweeps = 12;
constexpr double forbidden = 1000;  // cost of a collision

struct Box {
  double left, top, right, bottom;
  Vector2d middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

struct Anchor {
  std::size_t index;
  Vector2d at, outward;
  double width, height;  // of the label
  double clear;          // radius of the joint that is labelled
  bool optional, words;  // of several words
};

struct Candidate {
  Box box;
  double gap;  // from the joint's circle, in font sizes
  Vector2d direction;
};

Box box_around(const Vector2d& middle, double width, double height) {
  return {middle.x() - width / 2, middle.y() - height / 2, middle.x() + width / 2, middle.y() + height / 2};
}
bool overlap(const Box& a, const Box& b, double beside, double above) {
  return a.left < b.right + beside && b.left < a.right + beside && a.top < b.bottom + above && b.top < a.bottom + above;
}
Vector2d nearest(const Box& b, const Vector2d& p) { return {std::clamp(p.x(), b.left, b.right), std::clamp(p.y(), b.top, b.bottom)}; }
bool overlap(const Box& b, const Disc& d, double apart) { return (nearest(b, d.centre) - d.centre).norm() < d.radius + apart; }

class Placer {
 public:
  Placer(const Scene& scene, const View& view, int width, int height, double printed)
      : scene_(scene),
        size_(label_size(width, printed)),
        picture_{0.2 * size_, 0.2 * size_, width - 0.2 * size_, height - 0.2 * size_},
        occupied_(scene, view, width, height) {
    measure(view, width, height);
  }

  // Each label in turn takes the best of its candidates, given where the others stand, until none wants to move. One that still collides
  // goes to the nearest free place of the picture; where there is none, it is left out. Then those that are optional, where room is left.
  std::vector<LabelSpot> place() {
    chosen_.assign(anchors_.size(), std::nullopt);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      bool moved = false;
      for (std::size_t i = 0; i < anchors_.size(); ++i) moved = (!anchors_[i].optional && settle(i)) || moved;
      if (!moved) break;
    }
    for (std::size_t i = 0; i < anchors_.size(); ++i)
      if (chosen_[i] && cost(i, *chosen_[i]) >= forbidden) chosen_[i] = nearest_free(i);
    for (std::size_t i = 0; i < anchors_.size(); ++i)
      if (anchors_[i].optional && settle(i) && !is_close(i)) chosen_[i] = std::nullopt;
    std::vector<LabelSpot> spots;
    for (std::size_t i = 0; i < anchors_.size(); ++i)
      if (chosen_[i]) spots.push_back(spot(i, *chosen_[i]));
    return spots;
  }

 private:
  // A label that needs no line to tell what it is of, nor stands closer to what another one is of.
  bool is_close(std::size_t i) const {
    return chosen_[i]->gap <= needs_leader && cost(i, *chosen_[i]) < forbidden && mistaken(i, *chosen_[i]) == 0;
  }

  void measure(const View& view, int width, int height) {
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t* cr = cairo_create(surface);
    Vector2d middle(0, 0);
    for (std::size_t i = 0; i < scene_.labels.size(); ++i) {
      const Label& label = scene_.labels[i];
      const Vector2d at = view.see(label.at).head<2>();
      const bool inside = at.x() >= 0 && at.x() <= width && at.y() >= 0 && at.y() <= height;
      if (!inside || label.text.empty()) continue;
      const figure::Text text(cr, label_markup(label.text, size_), {size_}, 0, true);
      PangoRectangle ink;
      pango_layout_get_extents(text.layout(), &ink, nullptr);
      double clear = label.clear * view.scale();
      for (const Disc& d : occupied_.joints())
        if ((d.centre - at).norm() < 0.5) clear = std::max(clear, d.radius);
      const bool words = label.text.find(' ') != std::string::npos;
      anchors_.push_back({i,
                          at,
                          {0, 0},
                          ink.width / double(PANGO_SCALE) + 2 * halo * size_,
                          ink.height / double(PANGO_SCALE) + 2 * halo * size_,
                          clear,
                          label.optional,
                          words});
    }
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    int counted = 0;
    for (const Anchor& a : anchors_)
      if (!a.optional) middle += a.at, ++counted;
    if (counted > 0) middle /= counted;
    for (Anchor& a : anchors_) {
      const Vector2d away = a.at - middle;
      a.outward = away.norm() > 1 ? Vector2d(away.normalized()) : Vector2d(0, -1);
    }
  }

  std::vector<Candidate> candidates(const Anchor& a) const {
    std::vector<Candidate> all;
    if (a.clear == 0) all.push_back({box_around(a.at, a.width, a.height), 0, a.outward});
    for (const double gap : gaps)
      for (int k = 0; k < places_around; ++k) {
        const double angle = 2 * std::numbers::pi * k / places_around;
        const Vector2d d(std::cos(angle), std::sin(angle));
        // The box touches the circle of radius clear + gap around the point, from outside, in direction d.
        const double reach = std::min(a.width / 2 / std::max(std::abs(d.x()), 1e-9), a.height / 2 / std::max(std::abs(d.y()), 1e-9));
        all.push_back({box_around(a.at + (a.clear + gap * size_ + reach) * d, a.width, a.height), gap, d});
      }
    return all;
  }

  // How many other labels' points stand closer: a reader would take it for theirs. What is optional disturbs no other.
  int mistaken(std::size_t i, const Candidate& c) const {
    const double mine = (nearest(c.box, anchors_[i].at) - anchors_[i].at).norm() - anchors_[i].clear;
    int count = 0;
    for (std::size_t k = 0; k < anchors_.size(); ++k)
      if (k != i && (anchors_[i].optional || !anchors_[k].optional) &&
          (nearest(c.box, anchors_[k].at) - anchors_[k].at).norm() - anchors_[k].clear < mine)
        ++count;
    return count;
  }

  double cost(std::size_t i, const Candidate& c) const {
    const Anchor& a = anchors_[i];
    double sum = 0;
    const Box& p = picture_;
    if (c.box.left < p.left || c.box.top < p.top || c.box.right > p.right || c.box.bottom > p.bottom) sum += 2 * forbidden;
    for (const Disc& d : occupied_.joints())
      if (overlap(c.box, d, spacing * size_ * 0.5)) sum += forbidden;
    for (std::size_t k = 0; k < anchors_.size(); ++k) {
      if (k == i) continue;
      const double beside = a.words && anchors_[k].words ? between_words : spacing;
      if (chosen_[k] && overlap(c.box, chosen_[k]->box, beside * size_, spacing * size_)) sum += forbidden;
    }
    sum += 1.2 * mistaken(i, c);
    sum += 7 * occupied_.share(c.box.left, c.box.top, a.width, a.height);
    sum += 0.7 * c.gap + 0.5 * (1 - c.direction.dot(a.outward));
    if (c.gap > needs_leader) {
      sum += 0.8;
      const Vector2d middle = (nearest(c.box, a.at) + a.at) / 2;
      for (std::size_t k = 0; k < anchors_.size(); ++k)
        if (k != i && chosen_[k] && overlap(chosen_[k]->box, Disc{middle, 0}, spacing * size_)) sum += 2;
    }
    return sum;
  }

  bool settle(std::size_t i) {
    const double now = chosen_[i] ? cost(i, *chosen_[i]) : HUGE_VAL;
    double least = now - 1e-9;
    std::optional<Candidate> best;
    for (const Candidate& c : candidates(anchors_[i]))
      if (const double x = cost(i, c); x < least) least = x, best = c;
    if (best) chosen_[i] = best;
    return best.has_value();
  }

  std::optional<Candidate> nearest_free(std::size_t i) const {
    const Anchor& a = anchors_[i];
    std::optional<Candidate> best;
    double least = HUGE_VAL;
    const double step = 0.5 * size_;
    for (double y = picture_.top + a.height / 2; y <= picture_.bottom - a.height / 2; y += step)
      for (double x = picture_.left + a.width / 2; x <= picture_.right - a.width / 2; x += step) {
        const Vector2d away = Vector2d(x, y) - a.at;
        const double distance = away.norm();
        if (distance >= least || distance == 0) continue;
        const Candidate c{box_around({x, y}, a.width, a.height), distance / size_, away / distance};
        if (cost(i, c) < forbidden) least = distance, best = c;
      }
    return best;
  }

  LabelSpot spot(std::size_t i, const Candidate& c) const {
    const Anchor& a = anchors_[i];
    const Vector2d near = nearest(c.box, a.at), away = near - a.at;
    LabelSpot s{a.index, {scene_.labels[a.index].text, c.box.left, c.box.top, a.width, a.height}, false, a.at, near};
    s.leader = away.norm() - a.clear > needs_leader * size_;
    if (s.leader) s.from += (a.clear + 0.1 * size_) * away.normalized();
    return s;
  }

  const Scene& scene_;
  double size_;
  Box picture_;
  Occupied occupied_;
  std::vector<Anchor> anchors_;
  std::vector<std::optional<Candidate>> chosen_;
};

}  // namespace

double label_size(int width, double printed) {
  constexpr double points = 7, millimetres_per_point = 25.4 / 72;
  return points * millimetres_per_point * width / printed;
}

// A letter p behind the digits stands for a prime: names of the program have none.
std::string label_markup(const std::string& text, double size) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool primed = text.size() > 2 && text.back() == 'p' && digit(text[text.size() - 2]);
  const std::string name = primed ? text.substr(0, text.size() - 1) : text;
  std::size_t end = name.size();
  while (end > 0 && digit(name[end - 1])) --end;
  if (end == 0 || end == name.size()) return figure::escape_markup(text);
  return fmt::format("{}{}<span size=\"72%\" rise=\"{}\">{}</span>", figure::escape_markup(name.substr(0, end)), primed ? "′" : "",
                     -std::lround(0.18 * size * PANGO_SCALE), name.substr(end));
}

std::vector<LabelSpot> find_spots(const Scene& scene, const Camera& camera, const Quality& q) {
  return Placer(scene, View(camera, q.width, q.height), q.width, q.height, q.printed).place();
}

std::vector<PlacedLabel> place_labels(const Scene& scene, const Camera& camera, const Quality& quality) {
  std::vector<PlacedLabel> boxes;
  for (LabelSpot& s : find_spots(scene, camera, quality)) boxes.push_back(std::move(s.box));
  return boxes;
}

}  // namespace pmreport::scene
