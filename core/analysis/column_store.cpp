#include <core/analysis/column_store.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace pmreport::analysis {

void ColumnStore::add(const ColumnId& id, std::size_t samples) { columns_[id].assign(samples, nan); }

std::vector<double> ColumnStore::release(const ColumnId& id) {
  std::vector<double> out = std::move(columns_.at(id));
  columns_.erase(id);
  return out;
}

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

void ColumnStore::put(chunks::Writer& to) const {
  for (const auto& [id, column] : columns_) to.put_all(column);
}

void ColumnStore::get(chunks::Reader& from, std::size_t first, std::size_t samples) {
  for (auto& [id, column] : columns_) from.get_all(std::span(column).subspan(first, samples));
}

}  // namespace pmreport::analysis
