// pmreport schema, held by what it says of every scenario that is shipped and of mistakes in them. The validator is the test's own: it
// knows the words of JSON Schema that are used, and refuses others.
#include <tests/program/workshop.hpp>

#include <toml++/toml.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

using namespace program_test;
using Json = nlohmann::json;
using Catch::Matchers::Contains;

namespace {

namespace fs = std::filesystem;
Json scenario_of(const std::string& text) {
  std::stringstream json;
  json << toml::json_formatter{toml::parse(text)};
  return Json::parse(json.str());
}

class Validator {
 public:
  explicit Validator(Json schema) : schema_(std::move(schema)) {}
  // Where the first thing stands that is wrong, and why; empty: nothing is.
  std::string fault(const Json& document) const { return fault(document, schema_, ""); }

 private:
  static bool is(const Json& x, const std::string& type) {
    return type == "object"    ? x.is_object()
           : type == "array"   ? x.is_array()
           : type == "string"  ? x.is_string()
           : type == "boolean" ? x.is_boolean()
           : type == "integer" ? x.is_number_integer()
           : type == "number"  ? x.is_number()
                               : throw std::runtime_error("no type: " + type);
  }

  std::string fault(const Json& x, const Json& s, const std::string& at) const {
    static const std::set<std::string> words{"$schema", "title",    "description", "default", "$defs",  "additionalProperties",
                                             "then",    "minItems", "maxItems",    "minimum", "maximum"};
    for (const auto& [word, value] : s.items()) {
      if (word == "type") {
        const Json types = value.is_array() ? value : Json::array({value});
        if (std::none_of(types.begin(), types.end(), [&](const Json& t) { return is(x, t); })) return at + ": type";
      } else if (word == "enum") {
        if (std::find(value.begin(), value.end(), x) == value.end()) return at + ": " + x.dump() + " is no choice";
      } else if (word == "const") {
        if (x != value) return at + ": " + x.dump() + " is not " + value.dump();
      } else if (word == "$ref") {
        if (const std::string f = fault(x, schema_.at(Json::json_pointer(value.get<std::string>().substr(1))), at); !f.empty()) return f;
      } else if (word == "anyOf") {
        if (std::none_of(value.begin(), value.end(), [&](const Json& one) { return fault(x, one, at).empty(); })) return at + ": anyOf";
      } else if (word == "allOf") {
        for (const Json& one : value)
          if (const std::string f = fault(x, one, at); !f.empty()) return f;
      } else if (word == "if") {
        if (fault(x, value, at).empty())
          if (const std::string f = fault(x, s.at("then"), at); !f.empty()) return f;
      } else if (word == "required") {
        for (const Json& key : value)
          if (x.is_object() && !x.contains(key.get<std::string>())) return at + ": no " + key.get<std::string>();
      } else if (word == "properties") {
        for (const auto& [key, one] : value.items())
          if (x.is_object() && x.contains(key))
            if (const std::string f = fault(x[key], one, at + "/" + key); !f.empty()) return f;
      } else if (word == "items") {
        for (std::size_t i = 0; x.is_array() && i < x.size(); ++i)
          if (const std::string f = fault(x[i], value, at + "/" + std::to_string(i)); !f.empty()) return f;
      } else if (!words.contains(word)) {
        throw std::runtime_error("the validator does not know the word " + word);
      }
    }
    if (s.value("additionalProperties", true) == false && x.is_object())
      for (const auto& [key, value] : x.items())
        if (!s["properties"].contains(key)) return at + ": unknown key " + key;
    if (x.is_array() && (x.size() < s.value("minItems", 0u) || x.size() > s.value("maxItems", x.size()))) return at + ": number of items";
    if (x.is_number() && (x < s.value("minimum", x) || x > s.value("maximum", x))) return at + ": range";
    return "";
  }

  Json schema_;
};

const Validator& of_any() {
  static const Validator validator(Json::parse(run_pmreport({"schema"}).out));
  return validator;
}
const Validator& of(const std::string& mechanism) {
  static std::map<std::string, Validator> known;
  const auto found = known.find(mechanism);
  return found != known.end() ? found->second
                              : known.emplace(mechanism, Validator(Json::parse(run_pmreport({"schema", mechanism}).out))).first->second;
}

}  // namespace

TEST_CASE("every scenario that is shipped is one by the schema, that of its mechanism and that of any") {
  int shipped = 0;
  for (const auto& entry : fs::recursive_directory_iterator(SOURCE "/plugins")) {
    if (entry.path().extension() != ".toml") continue;
    CAPTURE(entry.path().string());
    const Json scenario = scenario_of(bytes_of(entry.path()));
    CHECK(of_any().fault(scenario) == "");
    CHECK(of(scenario["mechanism"]["use"]).fault(scenario) == "");
    ++shipped;
  }
  CHECK(shipped > 30);
}

TEST_CASE("a misspelt key is no key, at the top, in a table and in a section") {
  const std::string text(small);
  CHECK(of("4sps-spr").fault(scenario_of(text)) == "");
  for (const auto& [right, wrong, told] : {std::tuple{"title", "titel", "no title"},
                                           {"\n[load]", "\n[laod]", ": unknown key laod"},
                                           {"samples", "sampels", "/motion: "},
                                           {"kind = \"displacement\"", "kind = \"displacment\"", "/section/0/kind: "},
                                           {"kind = \"displacement\"", "kind = \"displacement\"\ntimes = [\"1 s\"]", "unknown key times"},
                                           {"below", "belwo", "/check/0: unknown key belwo"}}) {
    CAPTURE(right, wrong);
    const Json scenario = scenario_of(with(text, {{right, wrong}}));
    CHECK_THAT(of("4sps-spr").fault(scenario), Contains(told));
    if (std::string(right) != "samples") CHECK_THAT(of_any().fault(scenario), Contains(told));
  }
}

TEST_CASE("the schema of a mechanism knows its coordinates, parameters and joints") {
  const std::string text(small);
  for (const auto& [right, wrong, told] :
       {std::tuple{"z = \"550 mm\"", "zeta = \"550 mm\"", "/motion: unknown key zeta"},
        {"z = \"550 mm\"", "z = 550", "/motion/z: type"},
        {"use = \"4sps-spr\"", "use = \"4sps-spr\"\nparameters = { base_radios = \"400 mm\" }",
         "/mechanism/parameters: unknown key base_radios"},
        {"use = \"4sps-spr\"", "use = \"delta\"", "/mechanism/use: "},
        {"\n[load]", "\n[limits]\njoint_force = { Q7 = \"1 N\" }\n\n[load]", "/limits/joint_force: anyOf"}}) {
    CAPTURE(wrong);
    const Json scenario = scenario_of(with(text, {{right, wrong}}));
    CHECK_THAT(of("4sps-spr").fault(scenario), Contains(told));
    if (std::string(wrong) != "z = 550") CHECK(of_any().fault(scenario) == "");  // another mechanism may have them
  }
}

TEST_CASE("a parameter is described by its title, range and default") {
  const Json schema = Json::parse(run_pmreport({"schema", "delta"}).out);
  const Json& parameters = schema["properties"]["mechanism"]["properties"]["parameters"]["properties"];
  CHECK(parameters["arm_length"]["default"] == "524 mm");
  CHECK_THAT(parameters["arm_length"]["description"].get<std::string>(),
             Contains("from the motor's axis to the elbow") && Contains("1 mm to 100000 mm"));
  CHECK(parameters["elbow1"]["enum"] == Json::array({"out", "in"}));
}

TEST_CASE("keys of a section carry the words of their table") {
  const Json schema = Json::parse(run_pmreport({"schema"}).out);
  const Json& size = schema["$defs"]["section_snapshots"]["properties"]["size"];
  CHECK(size["minItems"] == 2);
  CHECK(size["items"]["minimum"] == 64);
  CHECK_THAT(size["description"].get<std::string>(), Contains("width and height in pixels") && Contains("if left out"));
}

// A key that is new to the reader is in the schema by itself; what it takes is seen once reports/program/cli/scenario_shape.cpp asks it.
TEST_CASE("the schema says of every key outside of the sections what may stand there") {
  const Json schema = Json::parse(run_pmreport({"schema", "4sps-spr"}).out);
  for (const auto& [key, value] : schema["properties"].items()) {
    CAPTURE(key);
    CHECK_FALSE(value.empty());
    const Json& table = value.contains("items") ? value["items"] : value;
    if (key == "section" || !table.contains("properties")) continue;
    for (const auto& [below, what] : table["properties"].items()) {
      CAPTURE(below);
      CHECK_FALSE(what.empty());
    }
  }
}

TEST_CASE("the schema of an unknown mechanism tells the known ones") {
  const Result result = run_pmreport({"schema", "gouhg"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Contains("no mechanism is called 'gouhg'; known: "));
}

TEST_CASE("a mechanism that cannot be made does not keep the schema of any from being printed") {
  const Workshop here;
  std::filesystem::copy(FIXTURES "/faulty.so", here / "faulty.so");
  const Result result = run_pmreport({"schema", "--plugin-path", here.path()});
  CHECK(result.status == 0);
  CHECK_THAT(result.err, Contains("warning: not-finite is passed over: "));
  CHECK(Validator(Json::parse(result.out)).fault(scenario_of(std::string(small))) == "");
}
