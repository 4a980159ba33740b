// One type has one name, and one name one type, in whatever source it stands: the linker joins what is named alike, and would not tell.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

// A source without comments, literals and directives.
std::string bare(const std::string& source) {
  static const std::regex noise(
      R"(//[^\n]*|R"(\w*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|(?:^|\n)[ \t]*#(?:[^\n]*\\\n)*[^\n]*)");
  return std::regex_replace(source, noise, " ");
}

// Types that a source defines beside unnamed namespaces and functions, by their full names.
std::set<std::string> types_of(const std::string& source) {
  static const std::regex space(R"((?:^|\s)namespace(?:\s+([\w:]+))?\s*$)");
  static const std::regex type(
      R"(^(?:\s*template\s*<.*>)?\s*(?:struct|class|union|enum(?:\s+class)?)\s+(\w+)(?:\s+final)?\s*(?::[^:][\s\S]*)?$)");
  std::set<std::string> out;
  std::vector<std::string> scopes;
  std::string head;
  for (const char c : bare(source)) {
    if (c != '{' && c != '}' && c != ';') {
      head += c;
      continue;
    }
    if (c == '{') {
      std::smatch part;
      const std::string text = head.substr(std::min(head.size(), head.find_first_not_of(" \t\r\n")));
      if (std::regex_search(text, part, space)) {
        scopes.push_back(part[1].matched ? part[1].str() : "");
      } else if (std::regex_match(text, part, type)) {
        scopes.push_back(part[1]);
        std::string name;
        for (const std::string& scope : scopes) name = name == "-" || scope.empty() || scope == "-" ? "-" : name + "::" + scope;
        if (name != "-") out.insert(name);
      } else {
        scopes.push_back("-");
      }
    } else if (c == '}' && !scopes.empty()) {
      scopes.pop_back();
    }
    head.clear();
  }
  return out;
}

}  // namespace

TEST_CASE("types are found by their full names, and those that no other source can name are left out") {
  CHECK(types_of("namespace a::b { struct C { enum class D { e }; }; class F; template <class T> class G final : public C {}; }") ==
        std::set<std::string>{"::a::b::C", "::a::b::C::D", "::a::b::G"});
  CHECK(types_of("namespace { struct A {}; } void f() { struct B {}; } // struct C {};\nconst char* d = \"struct D {\";").empty());
}

TEST_CASE("no two sources define types of one name") {
  std::map<std::string, std::set<std::string>> sources;
  for (const char* root : {"core", "reports"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(SOURCE) / root)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp") continue;
      for (const std::string& type : types_of(program_test::bytes_of(entry.path())))
        sources[type].insert(std::filesystem::relative(entry.path(), SOURCE).string());
    }
  CHECK(sources.size() > 500);
  for (const auto& [type, all] : sources) {
    CAPTURE(type, all);
    CHECK(all.size() == 1);
  }
}
