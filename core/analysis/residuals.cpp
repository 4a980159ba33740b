#include <core/analysis/residuals.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {

// The larger of two, of equal ones the earlier.
void look(Worst& w, double value, int sample) {
  if (w.sample < 0 || value > w.value || (value == w.value && sample < w.sample)) w.value = value, w.sample = sample;
}

}  // namespace

Row::Row() {
  value.fill(std::numeric_limits<double>::quiet_NaN());
  error.fill(0);
}

void set(Row& row, Measure m, double value, double error) {
  row.value[static_cast<std::size_t>(m)] = std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
  row.error[static_cast<std::size_t>(m)] = error;
}

void Residuals::add(int sample, const Row& row) {
  constexpr double telling = 0.01;  // an error from which on two numbers that agree say nothing
  for (std::size_t m = 0; m < all_.size(); ++m) {
    const double value = row.value[m], error = row.error[m];
    All& all = all_[m];
    if (std::isnan(value)) continue;
    if (!(error < telling)) {
      ++all.exact.undecided;
    } else if (error > 0) {
      all.rounded.push_back({sample, value, error});
    } else {
      ++all.exact.compared;
      look(all.exact, value, sample);
    }
  }
}

void Residuals::join(const Residuals& other) {
  for (std::size_t m = 0; m < all_.size(); ++m) {
    All& all = all_[m];
    const All& more = other.all_[m];
    all.exact.undecided += more.exact.undecided;
    all.exact.compared += more.exact.compared;
    if (more.exact.sample >= 0) look(all.exact, more.exact.value, more.exact.sample);
    all.rounded.insert(all.rounded.end(), more.rounded.begin(), more.rounded.end());
  }
}

Worst Residuals::worst(Measure m, double tolerance) const {
  const All& all = all_[static_cast<std::size_t>(m)];
  Worst w = all.exact;
  for (const All::Rounded& r : all.rounded) {
    ++w.compared;
    const bool poorly = r.error > tolerance;
    if (poorly) ++w.poorly_known, w.poorest = std::max(w.poorest, r.error);
    look(w, poorly ? r.value * (tolerance / r.error) : r.value, r.sample);
  }
  return w;
}

void Residuals::put(chunks::Writer& to) const {
  for (const All& all : all_) {
    to.put(all.exact.value), to.put(all.exact.sample), to.put(all.exact.compared), to.put(all.exact.undecided);
    to.put(std::uint64_t{all.rounded.size()});
    for (const All::Rounded& r : all.rounded) to.put(r.sample), to.put(r.value), to.put(r.error);
  }
}

void Residuals::get(chunks::Reader& from) {
  for (All& all : all_) {
    from.get(all.exact.value), from.get(all.exact.sample), from.get(all.exact.compared), from.get(all.exact.undecided);
    std::uint64_t count = 0;
    from.get(count);
    all.rounded.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      All::Rounded r{};
      from.get(r.sample), from.get(r.value), from.get(r.error);
      all.rounded.push_back(r);
    }
  }
}

}  // namespace pmreport::analysis
