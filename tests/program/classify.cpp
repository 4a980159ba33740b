// `pmreport classify`, against the tables of an independent enumeration and the corrected print.
#include <catch2/catch.hpp>

#include <tests/program/process.hpp>

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

using namespace program_test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

// The schemes of a table by chains and freedoms: "5/3/5556-6".
std::set<std::string> keys(const Json& table) {
  std::set<std::string> out;
  for (const auto& [k, columns] : table.items())
    for (const auto& [m, names] : columns.items())
      for (const Json& name : names) out.insert(k + "/" + m + "/" + name.get<std::string>());
  return out;
}

}  // namespace

TEST_CASE("classify tells programs every scheme, its chains, its freedoms and whether the paper has it") {
  const Result result = run({PROGRAM, "classify", "--json"});
  REQUIRE(result.status == 0);
  const Json told = Json::parse(result.out);
  std::ifstream file(std::string(TEST_DATA) + "/parallel-cross-classification.json");
  REQUIRE(file);
  const Json reference = Json::parse(file);
  std::set<std::string> rule, base, only;
  for (const Json& s : told["schemes"]) {
    const std::string name = s["name"];
    const std::string key = std::to_string(s["chains"].get<int>()) + "/" + std::to_string(s["freedoms"].get<int>()) + "/" + name;
    rule.insert(key);
    (s["base"].get<bool>() ? base : only).insert(key);
    std::string digits;
    for (const Json& p : s["parallel"]) digits += std::to_string(p.get<int>());
    digits += '-';
    for (const Json& p : s["cross"]) digits += std::to_string(p.get<int>());
    CHECK(digits == name);
  }
  CHECK(rule == keys(reference["generated"]));
  CHECK(base == keys(reference["table1_corrected"]));
  std::set<std::string> rule_only;
  for (const Json& s : reference["rule_only"])
    rule_only.insert(std::to_string(s[0].get<int>()) + "/" + std::to_string(s[1].get<int>()) + "/" + s[2].get<std::string>());
  CHECK(only == rule_only);
  CHECK(told["totals"] == Json{{"by_rule", 151}, {"base_schemes", 118}, {"six_chains", 40}});
}

TEST_CASE("classify prints both tables as corrected, with what the rule admits beyond them") {
  const Result result = run({PROGRAM, "classify"});
  CHECK(result.status == 0);
  CHECK_THAT(
      result.out,
      Contains("151 schemes by the rule; 118 base schemes in Table 1, 40 of them with six chains in Table 2; 33 by the rule alone") &&
          Contains("\n5     6666-6    5666-6    4666-6    5556-6    5555-6    5555-5\n") && Contains(" 4566-6*   4566-5* ") &&
          Contains("\n4-2   6666-66   5666-66   5566-66   5556-66   5555-66   5555-56\n") &&
          Contains("\n5     2         4         9         4 (12)    3 (12)    2 (9)     24 (48)\n") &&
          Contains("Table 2, k = 6, m = 2: 666-566  -> 555-566  has five freedoms as printed\n"));
  CHECK(result.err.empty());
}
