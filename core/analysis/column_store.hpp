// The columns of a run, or of a block of its samples: a number a sample each, NaN where a sample has none.
#pragma once

#include <core/analysis/column_names.hpp>
#include <core/chunks/bytes.hpp>

#include <map>
#include <vector>

namespace pmreport::analysis {

class ColumnStore {
 public:
  void add(const ColumnId& id, std::size_t samples);  // of NaN
  std::size_t count() const { return columns_.size(); }
  bool has(const ColumnId& id) const { return columns_.contains(id); }
  const std::vector<double>& operator[](const ColumnId& id) const { return columns_.at(id); }  // std::out_of_range: there is none
  std::vector<double> release(const ColumnId& id);                                             // likewise; it has the column no more
  double* find(const ColumnId& id);                                // the first sample; nullptr: there is none. Columns do not move
  double largest(const std::vector<ColumnId>& columns) const;      // magnitude over the samples
  void put(const ColumnId& id, std::size_t sample, double value);  // no negative zero, nothing infinite; ignored where there is none

  // All samples of all columns; and so many of them from `first` on, of a store that has the same columns.
  void put(chunks::Writer& to) const;
  void get(chunks::Reader& from, std::size_t first, std::size_t samples);

 private:
  std::map<ColumnId, std::vector<double>> columns_;
};

}  // namespace pmreport::analysis
