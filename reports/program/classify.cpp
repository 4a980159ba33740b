// `pmreport classify`: the class of parallel-cross mechanisms.
#include <core/classification/classification.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace pmreport::program {

namespace {

constexpr const char* source = "Glazunov et al. 2008, Development of manipulators with a parallel-cross structure";
constexpr int width = 10;  // of a column

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string heading(const char* first) {
  std::string line = fmt::format("{:<6}", first);
  for (int m = 6; m >= 1; --m) line += fmt::format("{:<{}}", fmt::format("m = {}", m), width);
  return trimmed(line);
}

std::string table(const char* first, const std::vector<classification::SchemeRow>& rows) {
  std::string out = heading(first);
  for (const classification::SchemeRow& r : rows) {
    std::string line = fmt::format("{:<6}", r.head);
    for (const std::string& cell : r.cells) line += fmt::format("{:<{}}", cell, width);
    out += trimmed(line);
  }
  return out;
}

std::string counts() {
  std::string out = heading("k");
  for (const classification::SchemeCount& c : classification::scheme_counts()) {
    std::string line = fmt::format("{:<6}", c.chains);
    int base = 0, rule = 0;
    for (std::size_t i = 0; i < c.base.size(); ++i) {
      base += c.base[i], rule += c.by_rule[i];
      line += fmt::format("{:<{}}", c.base[i] == c.by_rule[i] ? std::to_string(c.base[i]) : fmt::format("{} ({})", c.base[i], c.by_rule[i]),
                          width);
    }
    out += trimmed(line + (base == rule ? std::to_string(base) : fmt::format("{} ({})", base, rule)));
  }
  return out;
}

std::size_t six_chains() {
  const auto& all = classification::base_schemes();
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const classification::Scheme& s) { return s.chains() == 6; }));
}

std::string text() {
  const std::size_t rule = classification::admitted_schemes().size(), base = classification::base_schemes().size();
  std::string out = fmt::format(
      "Parallel-cross mechanisms\nsource: {}\n\n"
      "A scheme is the number of pairs of one freedom in each of its k chains, chains in parallel first, then those across. m: degrees of "
      "freedom.\n"
      "{} schemes by the rule; {} base schemes in Table 1, {} of them with six chains in Table 2; {} by the rule alone, marked *.\n\n",
      source, rule, base, six_chains(), rule - base);
  out += "Table 1, as corrected\n" + table("k", classification::table_of_base_schemes());
  out += "\nTable 2, as corrected: six chains\n" + table("", classification::table_of_six_chains());
  out += "\nNumbers in Table 1 (by the rule)\n" + counts();
  out += "\nCorrections of the printed tables; digits within one side have no order\n";
  for (const classification::Correction& c : classification::corrections())
    out += fmt::format("Table {}, k = {}, m = {}: {:<8} -> {:<8} {}\n", c.table, c.chains, c.freedoms,
                       c.printed.empty() ? "(none)" : c.printed, c.corrected, c.why);
  return out;
}

std::string json() {
  using Json = nlohmann::ordered_json;
  const auto pairs = [](const std::string& digits) {
    Json list = Json::array();
    for (const char c : digits) list.push_back(c - '0');
    return list;
  };
  const std::vector<classification::Scheme> all = classification::admitted_schemes();
  Json j{{"schema_version", 1},
         {"source", source},
         {"totals", {{"by_rule", all.size()}, {"base_schemes", classification::base_schemes().size()}, {"six_chains", six_chains()}}}};
  j["schemes"] = Json::array();
  for (const classification::Scheme& s : all)
    j["schemes"].push_back({{"name", s.name()},
                            {"chains", s.chains()},
                            {"freedoms", s.freedoms()},
                            {"parallel", pairs(s.parallel)},
                            {"cross", pairs(s.cross)},
                            {"base", is_base(s)}});
  j["corrections"] = Json::array();
  for (const classification::Correction& c : classification::corrections())
    j["corrections"].push_back({{"table", c.table},
                                {"chains", c.chains},
                                {"freedoms", c.freedoms},
                                {"printed", c.printed},
                                {"corrected", c.corrected},
                                {"why", c.why}});
  return j.dump(2) + "\n";
}

}  // namespace

int classify(const Options& options) {
  put("{}", options.json ? json() : text());
  return all_well;
}

}  // namespace pmreport::program
