// The class of parallel-cross mechanisms against an enumeration written another way, and against what the paper says of its tables.
#include <core/classification/classification.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

using namespace pmreport::classification;

namespace {

// Every number of np + nc digits from 1 to 6, sides sorted, kept if it satisfies the rule: no generator, a sieve.
std::set<std::string> by_sieve() {
  std::set<std::string> out;
  for (int k = 3; k <= 6; ++k) {
    const int count = static_cast<int>(std::pow(6, k));
    for (int n = 0; n < count; ++n) {
      std::vector<int> p;
      for (int i = 0, rest = n; i < k; ++i, rest /= 6) p.push_back(rest % 6 + 1);
      int constraints = 0, free = 0;
      for (const int pairs : p) constraints += 6 - pairs, free += pairs == 6;
      const int m = 6 - constraints;
      if (m < 1 || free > m) continue;
      for (int nc = 1; nc <= k - nc; ++nc) {
        const int np = k - nc;
        if (nc > np * (np - 1) / 2) continue;
        std::vector<int> sides = p;
        std::sort(sides.begin(), sides.begin() + np);
        std::sort(sides.begin() + np, sides.end());
        std::string name;
        for (int i = 0; i < k; ++i) name += (i == np ? "-" : "") + std::to_string(sides[static_cast<std::size_t>(i)]);
        out.insert(name);
      }
    }
  }
  return out;
}

std::set<std::string> names(const std::vector<Scheme>& schemes) {
  std::set<std::string> out;
  for (const Scheme& s : schemes) out.insert(s.name());
  return out;
}

// Sides sorted: as printed, digits have no order.
std::string sorted(std::string name) {
  const auto dash = static_cast<std::ptrdiff_t>(name.find('-'));
  std::sort(name.begin(), name.begin() + dash);
  std::sort(name.begin() + dash + 1, name.end());
  return name;
}

int freedoms_of(const std::string& name) {
  int m = 6;
  for (const char c : name)
    if (c != '-') m -= 6 - (c - '0');
  return m;
}

}  // namespace

TEST_CASE("the rule admits 151 schemes, and exactly those of a sieve over all digits") {
  const auto all = admitted_schemes();
  CHECK(all.size() == 151);
  CHECK(names(all).size() == 151);
  CHECK(names(all) == by_sieve());
}

TEST_CASE("the base schemes are the 118 that the paper counts, and the rule admits every one") {
  CHECK(base_schemes().size() == 118);
  CHECK(names(base_schemes()).size() == 118);
  for (const Scheme& s : base_schemes()) {
    CAPTURE(s.name());
    CHECK(admitted(s));
    CHECK(is_base(s));
    CHECK(s.name() == sorted(s.name()));
    CHECK(s.freedoms() == freedoms_of(s.name()));
  }
}

TEST_CASE("with six chains the rule admits the forty of Table 2 and no other") {
  std::set<std::string> by_rule,
      printed{// Table 2 as printed, the misprint in m = 2 corrected
              "66666-6", "56666-6", "55666-6", "55566-6", "55556-6", "55555-6", "66666-5", "56666-5", "55666-5", "66555-5",
              "55556-5", "6666-66", "5666-66", "5566-66", "5556-66", "5555-66", "5555-56", "6666-65", "5666-65", "5566-65",
              "6655-55", "5556-55", "6666-55", "5666-55", "6555-65", "666-666", "566-666", "556-666", "555-666", "555-566",
              "555-556", "666-665", "566-665", "556-665", "665-555", "556-555", "666-655", "566-655", "655-655", "666-555"};
  for (const Scheme& s : admitted_schemes())
    if (s.chains() == 6) by_rule.insert(s.name());
  std::set<std::string> table;
  for (const std::string& name : printed) table.insert(sorted(name));
  CHECK(table.size() == 40);
  CHECK(by_rule == table);
}

TEST_CASE("every closed loop of an admitted scheme has seven pairs or more: the rule admits no truss") {
  for (const Scheme& s : admitted_schemes()) {
    CAPTURE(s.name());
    const int a = s.parallel[0] - '0', b = s.parallel[1] - '0', c = s.cross[0] - '0';  // the fewest on each side
    CHECK(a + b >= 7);
    CHECK(a + b + 2 * c >= 14);  // two loops share the cross chain
  }
}

TEST_CASE("what breaks the rule in one point is not admitted") {
  CHECK(admitted({"666", "666"}));
  CHECK_FALSE(admitted({"66", "66"}));     // two cross chains between two parallel ones
  CHECK_FALSE(admitted({"66", "666"}));    // more across than in parallel
  CHECK_FALSE(admitted({"666", ""}));      // none across
  CHECK_FALSE(admitted({"66666", "66"}));  // seven chains
  CHECK_FALSE(admitted({"266", "6"}));     // two freedoms, and three chains that neither constrain nor drive
  CHECK_FALSE(admitted({"255", "5"}));     // no freedom left
  CHECK_FALSE(admitted({"67", "6"}));      // seven pairs in a chain
}

TEST_CASE("a corrected entry has the freedoms of its column, and what was printed is wrong there") {
  std::set<std::string> tables[2];
  for (const Scheme& s : base_schemes()) {
    tables[0].insert(s.name());
    if (s.chains() == 6) tables[1].insert(s.name());
  }
  for (const Correction& c : corrections()) {
    CAPTURE(c.table, c.printed, c.corrected);
    CHECK(tables[c.table - 1].count(c.corrected) == 1);
    CHECK(freedoms_of(c.corrected) == c.freedoms);
    CHECK(static_cast<int>(c.corrected.size()) == c.chains + 1);
    if (!c.printed.empty()) CHECK((freedoms_of(c.printed) != c.freedoms || static_cast<int>(c.printed.size()) != c.chains + 1));
  }
}

TEST_CASE("the tables hold every scheme once, in the column of its freedoms") {
  std::map<std::string, int> seen;
  int starred = 0;
  for (const SchemeRow& row : table_of_base_schemes())
    for (std::size_t j = 0; j < 6; ++j) {
      std::string name = row.cells[j];
      if (name.empty()) continue;
      if (name.back() == '*') name.pop_back(), ++starred;
      ++seen[name];
      CHECK(freedoms_of(name) == 6 - static_cast<int>(j));
    }
  CHECK(seen.size() == 151);
  CHECK(starred == 33);
  CHECK(std::all_of(seen.begin(), seen.end(), [](const auto& s) { return s.second == 1; }));
  int six = 0;
  for (const SchemeRow& row : table_of_six_chains())
    six += static_cast<int>(std::count_if(row.cells.begin(), row.cells.end(), [](const std::string& s) { return !s.empty(); }));
  CHECK(six == 40);
}

TEST_CASE("the numbers by chains and freedoms are those of the corrected table") {
  const std::array<int, 6> expected[] = {{3, 6, 8, 9, 8, 6}, {2, 4, 9, 4, 3, 2}, {1, 2, 4, 5, 7, 8}, {1, 2, 2, 6, 9, 7}};
  const auto counts = scheme_counts();
  REQUIRE(counts.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(counts[i].chains == 6 - static_cast<int>(i));
    CHECK(counts[i].base == expected[i]);
  }
}
