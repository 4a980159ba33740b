#include <core/classification/classification.hpp>

#include <algorithm>
#include <tuple>

namespace pmreport::classification {

namespace {

constexpr int most_pairs = 6, fewest_chains = 3, most_chains = 6, most_freedoms = 6;

int constraints_of(const std::string& digits) {
  int sum = 0;
  for (const char c : digits) sum += most_pairs - (c - '0');
  return sum;
}

// All rising strings of `count` digits 1 to 6.
std::vector<std::string> rising(std::size_t count) {
  std::vector<std::string> out{""};
  for (std::size_t n = 0; n < count; ++n) {
    std::vector<std::string> longer;
    for (const std::string& s : out)
      for (char c = s.empty() ? '1' : s.back(); c <= '0' + most_pairs; ++c) longer.push_back(s + c);
    out = std::move(longer);
  }
  return out;
}

bool before(const Scheme& a, const Scheme& b) {
  const auto key = [](const Scheme& s) { return std::tuple(-s.chains(), -s.freedoms(), s.cross.size(), s.parallel, s.cross); };
  return key(a) < key(b);
}

// Table 1 as corrected, by k = 6 .. 3 and within by m = 6 .. 1; see `corrections` for what differs from the print.
constexpr const char* corrected_table[] = {
    "66666-6 6666-66 666-666 "
    "56666-6 66666-5 5666-66 6666-56 566-666 666-566 "
    "55666-6 56666-5 5566-66 5666-56 6666-55 556-666 566-566 666-556 "
    "55566-6 55666-5 5556-66 5566-56 5666-55 555-666 556-566 566-556 666-555 "
    "55556-6 55566-5 5555-66 5566-55 5556-56 555-566 566-555 556-556 "
    "55555-6 55556-5 5555-56 5556-55 555-556 556-555 ",
    "6666-6 666-66 "
    "5666-6 6666-5 566-66 666-56 "
    "4666-6 6666-4 5566-6 5666-5 466-66 666-46 556-66 566-56 666-55 "
    "5556-6 555-66 556-56 566-55 "
    "5555-6 555-56 556-55 "
    "555-55 5555-5 ",
    "666-6 "
    "566-6 666-5 "
    "466-6 556-6 566-5 666-4 "
    "366-6 666-3 456-6 466-5 566-4 "
    "356-6 366-5 566-3 455-6 456-5 556-4 555-5 "
    "355-6 356-5 556-3 445-6 446-5 456-4 455-5 555-4 ",
    "66-6 "
    "56-6 66-5 "
    "55-6 56-5 "
    "45-6 46-5 56-4 36-6 66-3 55-5 "
    "26-6 66-2 35-6 56-3 36-5 44-6 46-4 55-4 45-5 "
    "25-6 26-5 56-2 35-5 55-3 44-5 45-4 "};

std::vector<Scheme> parse(const char* text) {
  std::vector<Scheme> out;
  std::string parallel, digits;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c == '-') {
      parallel.swap(digits);
      digits.clear();
    } else if (*c == ' ') {
      out.push_back({parallel, digits});
      digits.clear();
    } else {
      digits += *c;
    }
  }
  return out;
}

// Sets schemes in columns by m, under a head.
void set(std::vector<SchemeRow>& rows, const std::string& head, const std::vector<Scheme>& schemes) {
  std::array<std::vector<std::string>, 6> columns;
  for (const bool base : {true, false})
    for (const Scheme& s : schemes)
      if (is_base(s) == base) columns[static_cast<std::size_t>(most_freedoms - s.freedoms())].push_back(s.name() + (base ? "" : "*"));
  std::size_t height = 0;
  for (const auto& c : columns) height = std::max(height, c.size());
  for (std::size_t i = 0; i < height; ++i) {
    SchemeRow row{i == 0 ? head : "", {}};
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (i < columns[j].size()) row.cells[j] = columns[j][i];
    rows.push_back(std::move(row));
  }
}

std::vector<Scheme> with_chains(const std::vector<Scheme>& all, int k) {
  std::vector<Scheme> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out), [&](const Scheme& s) { return s.chains() == k; });
  return out;
}

}  // namespace

int Scheme::freedoms() const { return most_freedoms - constraints_of(parallel) - constraints_of(cross); }

bool admitted(const Scheme& s) {
  const auto np = s.parallel.size(), nc = s.cross.size();
  if (s.chains() < fewest_chains || s.chains() > most_chains || nc < 1 || nc > np || nc > np * (np - 1) / 2) return false;
  const std::string all = s.parallel + s.cross;
  if (std::any_of(all.begin(), all.end(), [](char c) { return c < '1' || c > '0' + most_pairs; })) return false;
  const int m = s.freedoms();
  return m >= 1 && std::count(all.begin(), all.end(), '0' + most_pairs) <= m;
}

std::vector<Scheme> admitted_schemes() {
  std::vector<Scheme> out;
  for (std::size_t np = 1; np < most_chains; ++np)
    for (std::size_t nc = 1; np + nc <= most_chains; ++nc)
      for (const std::string& parallel : rising(np))
        for (const std::string& cross : rising(nc))
          if (Scheme s{parallel, cross}; admitted(s)) out.push_back(std::move(s));
  std::sort(out.begin(), out.end(), before);
  return out;
}

const std::vector<Scheme>& base_schemes() {
  static const std::vector<Scheme> all = [] {
    std::vector<Scheme> out;
    for (const char* text : corrected_table)
      for (Scheme& s : parse(text)) out.push_back(std::move(s));
    std::sort(out.begin(), out.end(), before);
    return out;
  }();
  return all;
}

bool is_base(const Scheme& scheme) { return std::binary_search(base_schemes().begin(), base_schemes().end(), scheme, before); }

std::vector<SchemeRow> table_of_base_schemes() {
  std::vector<SchemeRow> rows;
  const std::vector<Scheme> all = admitted_schemes();
  for (int k = most_chains; k >= fewest_chains; --k) set(rows, std::to_string(k), with_chains(all, k));
  return rows;
}

std::vector<SchemeRow> table_of_six_chains() {
  std::vector<SchemeRow> rows;
  const std::vector<Scheme> all = with_chains(base_schemes(), most_chains);
  for (const std::size_t nc : {1u, 2u, 3u}) {
    std::vector<Scheme> split;
    std::copy_if(all.begin(), all.end(), std::back_inserter(split), [&](const Scheme& s) { return s.cross.size() == nc; });
    set(rows, std::to_string(most_chains - nc) + "-" + std::to_string(nc), split);
  }
  return rows;
}

std::vector<SchemeCount> scheme_counts() {
  std::vector<SchemeCount> out;
  const std::vector<Scheme> all = admitted_schemes();
  for (int k = most_chains; k >= fewest_chains; --k) {
    SchemeCount count{k, {}, {}};
    for (const Scheme& s : with_chains(all, k)) {
      const auto column = static_cast<std::size_t>(most_freedoms - s.freedoms());
      ++count.by_rule[column];
      if (is_base(s)) ++count.base[column];
    }
    out.push_back(count);
  }
  return out;
}

const std::vector<Correction>& corrections() {
  static const char* lost = "a digit of the five parallel chains is lost; Table 2 has it";
  static const std::vector<Correction> all{
      {1, 6, 6, "6666-6", "66666-6", lost},
      {1, 6, 5, "5666-6", "56666-6", lost},
      {1, 6, 5, "6666-5", "66666-5", lost},
      {1, 6, 4, "5566-6", "55666-6", lost},
      {1, 6, 4, "5666-5", "56666-5", lost},
      {1, 6, 3, "5556-6", "55566-6", lost},
      {1, 6, 3, "5566-5", "55666-5", lost},
      {1, 6, 2, "5555-6", "55556-6", lost},
      {1, 6, 2, "6655-5", "55566-5", lost},
      {1, 6, 1, "5555-6", "55555-6", lost},
      {1, 6, 1, "5555-5", "55556-5", lost},
      {1, 6, 2, "6655-65", "5566-55", "has three freedoms as printed; Table 2 has 6655-55"},
      {1, 6, 2, "666-566", "555-566", "has five freedoms as printed"},
      {1, 6, 1, "5555-66", "5555-56", "has two freedoms as printed; Table 2 has 5555-56"},
      {1, 6, 1, "5556-65", "5556-55", "has two freedoms as printed; Table 2 has 5556-55"},
      {1, 5, 1, "", "5555-5", "missing; with it the table has the 118 schemes that the text counts"},
      {1, 4, 2, "566-4", "556-4", "has three freedoms as printed"},
      {1, 3, 3, "66-5", "66-3", "has five freedoms as printed"},
      {2, 6, 2, "666-566", "555-566", "has five freedoms as printed"},
  };
  return all;
}

}  // namespace pmreport::classification
