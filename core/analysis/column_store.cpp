#include <core/analysis/column_store.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}

void ColumnStore::add(const ColumnId& id, std::size_t samples) { columns_[id].assign(samples, nan); }

double* ColumnStore::find(const ColumnId& id) {
  const auto found = columns_.find(id);
  return found != columns_.end() ? found->second.data() : nullptr;
}

double ColumnStore::largest(const std::vector<ColumnId>& columns) const {
  double out = 0;
  for (const ColumnId& id : columns)
    for (const double x : columns_.at(id))
      if (std::isfinite(x)) out = std::max(out, std::abs(x));
  return out;
}

void ColumnStore::put(const ColumnId& id, std::size_t sample, double value) {
  const auto found = columns_.find(id);
  if (found != columns_.end()) found->second[sample] = std::isfinite(value) ? value + 0.0 : nan;
}

}  // namespace pmreport::analysis
