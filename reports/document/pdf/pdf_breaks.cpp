#include <reports/document/pdf/pdf_breaks.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace pmreport::document::pdf {

namespace {

constexpr double rounding = 0.01;  // of sums: it must not push a line that fits exactly to the next page [pt]
constexpr double a_page = 20;      // a sheet more
constexpr double white = 60;       // times the square of a sheet's white share
constexpr double shrunk = 120;     // times the share by which figures are smaller
constexpr double moved = 15;       // a block behind those that follow it
constexpr double stretched = 40;   // times the share by which gaps are wider

// What is still to be placed: what moved, items [moved, moved_end), then all from `next`.
struct Rest {
  std::size_t moved, moved_end, next;
  auto operator<=>(const Rest&) const = default;
};

struct Choice {
  double cost = std::numeric_limits<double>::infinity();
  Sheet sheet{};
  Rest then{};
};

class Breaker {
 public:
  Breaker(const std::vector<Item>& items, double height) : items_(items), height_(height) {}

  std::vector<Sheet> sheets() {
    std::vector<Sheet> all;
    Rest rest{0, 0, 0};
    // Sheets are chosen from the last to the first without recursion through the pages of a long listing.
    std::vector<Rest> wanted{rest};
    while (!wanted.empty()) {
      const Rest at = wanted.back();
      if (known_.contains(at)) {
        wanted.pop_back();
        continue;
      }
      missing_.clear();
      Choice best = choose(at);
      if (missing_.empty()) {
        known_.emplace(at, std::move(best));
        wanted.pop_back();
      } else {
        wanted.insert(wanted.end(), missing_.begin(), missing_.end());
      }
    }
    while (!done(rest)) {
      const Choice& c = known_.at(rest);
      all.push_back(c.sheet);
      rest = c.then;
    }
    for (Sheet& s : all) settle(s);
    return all;
  }
  std::size_t weighed() const { return weighed_; }

 private:
  struct Draft {
    std::vector<std::size_t> order;
    double fixed = 0, flexible = 0;  // heights, gaps included [pt]
    double gaps = 0;                 // [pt]
  };

  bool done(const Rest& r) const { return r.moved == r.moved_end && r.next == items_.size(); }

  // White between two items that stand one above the other, whatever stood between them first.
  double gap(std::size_t above, std::size_t below) const {
    const double own = items_[below].gap;
    return below == above + 1 || above + 1 == items_.size() ? own : std::max(own, items_[above + 1].gap);
  }

  void add(Draft& d, std::size_t i) const {
    const double white = d.order.empty() ? 0 : gap(d.order.back(), i);
    d.fixed += d.order.empty() ? items_[i].head : white;
    d.gaps += white;
    (items_[i].scales ? d.flexible : d.fixed) += items_[i].height;
    d.order.push_back(i);
  }

  bool fits(const Draft& d) const { return d.fixed + least_scale * d.flexible <= height_ + rounding; }

  bool begins_block(std::size_t i) const { return i == items_.size() || i == 0 || items_[i].block != items_[i - 1].block; }

  // The end of the blocks from i on that may move.
  std::size_t end_of_moving(std::size_t i) const {
    const int section = items_[i].section;
    while (i < items_.size() && items_[i].may_move && items_[i].section == section) ++i;
    return i;
  }

  double scale_of(const Draft& d) const { return d.flexible > 0 ? std::clamp((height_ - d.fixed) / d.flexible, least_scale, 1.0) : 1; }

  void consider(Choice& best, const Draft& d, const Rest& then, double extra) {
    ++weighed_;
    const double scale = scale_of(d);
    double cost = extra + a_page + shrunk * (1 - scale), used = d.fixed + scale * d.flexible, stretch = 0;
    if (!done(then)) {
      // Where a page would be mostly white, its gaps take some of that.
      if (const double lacks = (1 - most_white) * height_ - used; lacks > 0 && d.gaps > 0) {
        stretch = std::min(most_stretch, (lacks + rounding) / d.gaps);
        used += stretch * d.gaps;
        cost += stretched * stretch;
      }
      const double foot = std::max(0.0, 1 - used / height_);
      cost += items_[d.order.back()].reluctance + white * foot * foot;
      if (foot > most_white) cost += mostly_white * (1 + 3 * (foot - most_white));
      if (cost >= best.cost) return;
      const auto found = known_.find(then);
      if (found == known_.end()) {
        missing_.push_back(then);
        return;
      }
      cost += found->second.cost;
    }
    if (cost >= best.cost) return;
    best.cost = cost;
    best.sheet = {.items = d.order, .y = {}, .scale = scale, .stretch = stretch, .used = used};
    best.then = then;
  }

  Choice choose(const Rest& at) {
    Choice best;
    Draft d;
    for (std::size_t i = at.moved; i < at.moved_end; ++i) {
      if (!d.order.empty()) consider(best, d, {i, at.moved_end, at.next}, 0);
      const bool first = d.order.empty();
      Draft longer = d;
      add(longer, i);
      if (!fits(longer) && !first) return best;
      d = std::move(longer);
    }
    follow(best, std::move(d), at.next);
    return best;
  }

  // The sheet goes on with what comes next, or with what follows the blocks that may move there.
  void follow(Choice& best, Draft d, std::size_t i) {
    for (;; ++i) {
      if (!d.order.empty()) consider(best, d, {0, 0, i}, 0);
      if (i == items_.size()) return;
      if (items_[i].may_move && begins_block(i)) follow_without(best, d, i);
      const bool first = d.order.empty();
      add(d, i);
      if (!fits(d) && !first) return;
    }
  }

  void follow_without(Choice& best, Draft d, std::size_t moving) {
    const std::size_t end = end_of_moving(moving);
    // Where it parts an introduction from its figure, something else must stand in for that.
    const double parts = moving > 0 && items_[moving - 1].reluctance >= parted ? items_[moving - 1].reluctance : 0;
    bool stands_in = false;
    for (std::size_t i = end; i < items_.size() && items_[i].section == items_[moving].section && !items_[i].may_move; ++i) {
      add(d, i);
      if (!fits(d)) return;
      stands_in = stands_in || items_[i].stands_in;
      if (begins_block(i + 1)) consider(best, d, {moving, end, i + 1}, moved + (stands_in ? 0 : parts));
    }
  }

  void settle(Sheet& s) const {
    double y = items_[s.items.front()].head;
    for (std::size_t k = 0; k < s.items.size(); ++k) {
      const std::size_t i = s.items[k];
      if (k > 0) y += (1 + s.stretch) * gap(s.items[k - 1], i);
      s.y.push_back(y);
      y += items_[i].height * (items_[i].scales ? s.scale : 1);
    }
  }

  const std::vector<Item>& items_;
  const double height_;
  std::map<Rest, Choice> known_;
  std::vector<Rest> missing_;
  std::size_t weighed_ = 0;
};

}  // namespace

std::vector<Sheet> break_pages(const std::vector<Item>& items, double height, std::size_t* weighed) {
  Breaker breaker(items, height);
  std::vector<Sheet> out = breaker.sheets();
  if (weighed != nullptr) *weighed = breaker.weighed();
  return out;
}

}  // namespace pmreport::document::pdf
