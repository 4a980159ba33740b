#include <reports/compare/comparison.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace pmreport::compare {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Rows by their key, each with one place a report, in the order of sections and of names in them.
template <class Row, class Key>
class Rows {
 public:
  // The row of the n-th thing of this key that report `r` has.
  Row& of(std::size_t r, const std::string& section, const Key& key) {
    const int turn = turns_[{r, key}]++;
    const auto [found, fresh] = indices_.try_emplace({key, turn}, rows_.size());
    if (fresh) {
      const auto [order, first] = sections_.try_emplace(section, sections_.size());
      rows_.emplace_back(order->second, Row{});
    }
    return rows_[found->second].second;
  }
  std::vector<Row> take() {
    std::ranges::stable_sort(rows_, {}, [](const auto& r) { return r.first; });
    std::vector<Row> out;
    for (auto& [order, row] : rows_) out.push_back(std::move(row));
    return out;
  }

 private:
  std::map<std::pair<std::size_t, Key>, int> turns_;
  std::map<std::pair<Key, int>, std::size_t> indices_;
  std::map<std::string, std::size_t> sections_;
  std::vector<std::pair<std::size_t, Row>> rows_;
};

bool within(const Tolerance& tolerance, double difference, double size) {
  return std::abs(difference) <= std::max(tolerance.absolute, tolerance.relative * size);
}

// The larger difference in size, where one that cannot be told is larger than any.
bool exceeds(double difference, double than) {
  return !std::isnan(than) && (std::isnan(difference) || std::abs(difference) > std::abs(than));
}

void judge(ValueRow& row, const Tolerance& tolerance) {
  const Value* first = nullptr;
  for (const auto& cell : row.cells) {
    if (!cell) {
      row.everywhere = false;
      continue;
    }
    if (first == nullptr) {
      first = &*cell;
      continue;
    }
    const double a = first->value, b = cell->value;
    if (std::isnan(a) && std::isnan(b)) {
      if (first->status == cell->status) continue;
      row.differs = true, row.difference = row.relative = none;
      continue;
    }
    const double size = std::max(std::abs(a), std::abs(b)), difference = b - a;  // NaN where one has no number
    if (std::isnan(difference) || !within(tolerance, difference, size)) row.differs = true;
    if (exceeds(difference, row.difference)) {
      row.difference = difference;
      row.relative = std::isnan(difference) ? none : size > 0 ? std::abs(difference) / size : 0;
    }
  }
}

void judge(JudgementRow& row) {
  const std::string* first = nullptr;
  for (const auto& state : row.states) {
    row.everywhere = row.everywhere && state;
    if (!state) continue;
    if (first == nullptr) first = &*state;
    if (*state != *first) row.differs = true;
  }
}

struct Curve {
  const std::vector<double>&time, &y;
};

double largest_of(const std::vector<double>& y) {
  double out = 0;
  for (const double v : y)
    if (!std::isnan(v)) out = std::max(out, std::abs(v));
  return out;
}

// At the instants of A within the times of B.
void judge(CurveRow& row, const Curve& a, const Curve& b, const Tolerance& tolerance) {
  const double size = std::max(largest_of(a.y), largest_of(b.y));
  const bool alike = a.time == b.time;
  row.other_instants = row.other_instants || !alike;
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    if (!alike && (b.time.empty() || a.time[i] < b.time.front() || a.time[i] > b.time.back())) continue;
    const double seen = alike ? b.y[i] : read_between(b.time, b.y, a.time[i], nth_of_instant(a.time, i)), difference = seen - a.y[i];
    if (std::isnan(seen) && std::isnan(a.y[i])) continue;
    if (std::isnan(difference)) {
      row.gap = row.differs = true;
      continue;
    }
    if (!within(tolerance, difference, size)) row.differs = true;
    if (std::abs(difference) > std::abs(row.difference)) {
      row.difference = difference;
      row.at = a.time[i];
      row.relative = std::abs(difference) / size;
    }
  }
}

std::vector<ValueRow> values_of(const std::vector<Results>& reports, const Tolerance& tolerance) {
  Rows<ValueRow, std::tuple<std::string, std::string, std::string>> rows;
  for (std::size_t r = 0; r < reports.size(); ++r)
    for (const Value& v : reports[r].values) {
      ValueRow& row = rows.of(r, v.section, {v.section, v.name, v.unit});
      row.section = v.section, row.name = v.name, row.unit = v.unit;
      row.cells.resize(reports.size());
      row.cells[r] = v;
    }
  std::vector<ValueRow> out = rows.take();
  for (ValueRow& row : out) judge(row, tolerance);
  // What one check alone measured stands with its verdict.
  std::erase_if(out, [](const ValueRow& row) {
    return row.section == checks_section && std::ranges::count_if(row.cells, [](const auto& cell) { return cell.has_value(); }) < 2;
  });
  return out;
}

std::vector<JudgementRow> judgements_of(const std::vector<Results>& reports) {
  Rows<JudgementRow, std::pair<std::string, std::string>> rows;
  for (std::size_t r = 0; r < reports.size(); ++r)
    for (const Judgement& j : reports[r].judgements) {
      JudgementRow& row = rows.of(r, j.section, {j.section, j.name});
      row.section = j.section, row.name = j.name;
      row.states.resize(reports.size());
      row.states[r] = j.state;
    }
  std::vector<JudgementRow> out = rows.take();
  for (JudgementRow& row : out) judge(row);
  return out;
}

// A report without its data has no curves, which is no difference: curves count among those reports that have some.
std::vector<CurveRow> curves_of(const std::vector<Results>& reports, const Tolerance& tolerance) {
  Rows<CurveRow, std::pair<std::string, std::string>> rows;
  for (std::size_t r = 0; r < reports.size(); ++r)
    for (std::size_t s = 0; s < reports[r].curves.size(); ++s)
      for (std::size_t c = 0; c < reports[r].curves[s].headings.size(); ++c) {
        const std::string &section = reports[r].curves[s].section, &heading = reports[r].curves[s].headings[c];
        CurveRow& row = rows.of(r, section, {section, heading});
        row.section = section, row.heading = heading;
        row.sources.resize(reports.size());
        row.sources[r] = CurveRow::Source{s, c};
      }
  std::vector<CurveRow> out = rows.take();
  for (CurveRow& row : out) {
    std::optional<std::size_t> first;
    for (std::size_t r = 0; r < reports.size(); ++r) {
      if (!row.sources[r]) {
        if (reports[r].curves_missing.empty()) row.everywhere = false;
        continue;
      }
      const auto curve = [&](std::size_t of) {
        const CurveRow::Source& source = *row.sources[of];
        const Curves& curves = reports[of].curves[source.curves];
        return Curve{curves.time, curves.columns[source.column]};
      };
      if (first)
        judge(row, curve(*first), curve(r), tolerance);
      else
        first = r;
    }
  }
  return out;
}

template <class Row>
bool all_agree(const std::vector<Row>& rows) {
  return std::ranges::all_of(rows, [](const Row& r) { return r.everywhere && !r.differs; });
}

}  // namespace

std::size_t nth_of_instant(const std::vector<double>& time, std::size_t i) {
  std::size_t n = 0;
  while (n < i && time[i - n - 1] == time[i]) ++n;
  return n;
}

double read_between(const std::vector<double>& time, const std::vector<double>& y, double at, std::size_t nth) {
  const auto after = std::ranges::lower_bound(time, at);
  if (after == time.end()) return none;
  const auto i = static_cast<std::size_t>(after - time.begin());
  if (*after == at) {
    const auto last = static_cast<std::size_t>(std::upper_bound(after, time.end(), at) - time.begin()) - 1;
    return y[std::min(i + nth, last)];
  }
  if (i == 0) return none;
  const double part = (at - time[i - 1]) / (time[i] - time[i - 1]);
  return y[i - 1] + part * (y[i] - y[i - 1]);
}

Comparison compare(const std::vector<Results>& reports, const Tolerance& tolerance) {
  Comparison out;
  for (const Results& r : reports) out.reports.push_back(&r);
  out.tolerance = tolerance;
  out.values = values_of(reports, tolerance);
  out.judgements = judgements_of(reports);
  out.curves = curves_of(reports, tolerance);
  const bool instants = std::ranges::none_of(out.curves, [](const CurveRow& c) { return c.other_instants; });
  out.agree = all_agree(out.values) && all_agree(out.judgements) && all_agree(out.curves) && instants;
  return out;
}

}  // namespace pmreport::compare
