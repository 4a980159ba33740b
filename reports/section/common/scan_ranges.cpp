#include <reports/section/common/scan_ranges.hpp>

#include <fmt/format.h>

namespace pmreport::section {

using analysis::ScanRange;
using scenario::Entry;
using scenario::Reading;
using scenario::Value;

namespace {

constexpr double most_values = 1e6;  // of a range

// [from, to] or [from, to, how many]; what is wrong is told.
std::optional<ScanRange> read_range(const Entry& e, int coordinate, const Reading& r) {
  const Value& v = e.value;
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  const bool list = v.kind == Value::Kind::array && (v.items.size() == 2 || v.items.size() == 3);
  if (!list) {
    if (v.kind != Value::Kind::refused)
      diagnostics.add(
          v.place, fmt::format("expected a range of {}, seen {}", e.key, name_of(v)),
          fmt::format("write {0} = [\"...\", \"...\"], from and to, or {0} = [\"...\", \"...\", 61], of a grid how many values", e.key));
    return std::nullopt;
  }
  const Dimension dimension = parse_unit(r.mechanism.topology->coordinates[static_cast<std::size_t>(coordinate)].unit)->dimension;
  const auto from = r.reader.quantity(v.items[0], dimension), to = r.reader.quantity(v.items[1], dimension);
  std::optional<double> count = 0.0;
  if (v.items.size() == 3) count = r.reader.integer(v.items[2], 1, most_values);
  if (!from || !to || !count) return std::nullopt;
  const ScanRange out{coordinate, *from, *to, static_cast<std::size_t>(*count)};
  if (out.from == out.to && out.count != 1) {
    diagnostics.add(v.place, fmt::format("expected a range of {}, seen one value at both ends", e.key),
                    fmt::format("put it into at = {{ {} = ... }}, or give how many values as 1", e.key));
    return std::nullopt;
  }
  if (out.from != out.to && out.count == 1) {
    diagnostics.add(v.items[2].place, fmt::format("expected 2 or more values between the ends of {}, seen 1", e.key));
    return std::nullopt;
  }
  return out;
}

}  // namespace

std::vector<ScanRange> read_scan_ranges(const Entry& entry, const std::string& where, const Reading& r) {
  std::vector<ScanRange> out;
  const Value* table = table_of(&entry, where, r.reader);
  if (table == nullptr || !r.mechanism.topology) return out;
  std::vector<std::string> known;
  for (const Coordinate& c : r.mechanism.topology->coordinates) known.push_back(c.name);
  for (const Entry& e : table->entries) {
    const int i = scenario::index_of(*r.mechanism.topology, e.key);
    if (i < 0)
      refuse_coordinate(e.place, e.key, r.mechanism, known, entry.key, r.reader.diagnostics());
    else if (const auto range = read_range(e, i, r))
      out.push_back(*range);
  }
  if (table->entries.empty())
    r.reader.diagnostics().add(entry.value.place, fmt::format("expected at least one coordinate in {}, and there is none", entry.key),
                               fmt::format("write {} = {{ {} = [\"...\", \"...\"] }}", entry.key, known.front()));
  return out;
}

}  // namespace pmreport::section
