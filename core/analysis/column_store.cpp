#include <core/analysis/column_store.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}

void ColumnStore::add(const std::string& name, std::size_t samples) { columns_[name].assign(samples, nan); }

double* ColumnStore::find(const std::string& name) {
  const auto found = columns_.find(name);
  return found != columns_.end() ? found->second.data() : nullptr;
}

double ColumnStore::largest(const std::vector<std::string>& columns) const {
  double out = 0;
  for (const std::string& name : columns)
    for (const double x : columns_.at(name))
      if (std::isfinite(x)) out = std::max(out, std::abs(x));
  return out;
}

void ColumnStore::put(const std::string& name, std::size_t sample, double value) {
  const auto found = columns_.find(name);
  if (found != columns_.end()) found->second[sample] = std::isfinite(value) ? value + 0.0 : nan;
}

}  // namespace pmreport::analysis
