// The columns of a run: a number a sample each, NaN where a sample has none.
#pragma once

#include <core/analysis/column_names.hpp>

#include <map>
#include <vector>

namespace pmreport::analysis {

class ColumnStore {
 public:
  void add(const ColumnId& id, std::size_t samples);  // of NaN
  bool has(const ColumnId& id) const { return columns_.contains(id); }
  const std::vector<double>& operator[](const ColumnId& id) const { return columns_.at(id); }  // std::out_of_range: there is none
  double* find(const ColumnId& id);                                // the first sample; nullptr: there is none. Columns do not move
  double largest(const std::vector<ColumnId>& columns) const;      // magnitude over the samples
  void put(const ColumnId& id, std::size_t sample, double value);  // no negative zero, nothing infinite; ignored where there is none

 private:
  std::map<ColumnId, std::vector<double>> columns_;
};

}  // namespace pmreport::analysis
