// The columns of a run: a number a sample each, NaN where a sample has none.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pmreport::analysis {

class ColumnStore {
 public:
  void add(const std::string& name, std::size_t samples);  // of NaN
  bool has(const std::string& name) const { return columns_.contains(name); }
  const std::vector<double>& operator[](const std::string& name) const { return columns_.at(name); }  // std::out_of_range: there is none
  double* find(const std::string& name);                                // the first sample; nullptr: there is none. Columns do not move
  double largest(const std::vector<std::string>& columns) const;        // magnitude over the samples
  void put(const std::string& name, std::size_t sample, double value);  // no negative zero, nothing infinite; ignored where there is none

 private:
  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace pmreport::analysis
