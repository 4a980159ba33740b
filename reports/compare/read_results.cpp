// results.json as reports/document/data/json.cpp writes it. Whatever else the file may be, the user is told what and where.
#include <reports/compare/data_names.hpp>
#include <reports/compare/results.hpp>
#include <reports/compare/spreadsheet.hpp>

#include <reports/document/data/results.hpp>
#include <reports/document/write.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::compare {

namespace {

using Json = nlohmann::json;

constexpr int version_read = 2;
// Ours nest five deep. What nests by the million would fill memory before it is refused.
constexpr int deepest = 64;

[[noreturn]] void refuse(const std::string& label, const std::string& what) { throw InputError(printable(label) + ": " + what); }

// "line 3, column 14" of the byte that the parser stopped at, counted from 1.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::size_t at = std::min(byte > 0 ? byte - 1 : 0, text.size());
  const auto begin = text.begin(), here = begin + static_cast<std::ptrdiff_t>(at);
  const auto line = std::count(begin, here, '\n') + 1;
  const std::size_t start = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return fmt::format("line {}, column {}", line, start == std::string::npos ? at + 1 : at - start);
}

Json parse(const std::string& text, const std::string& label) {
  const auto not_too_deep = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > deepest) refuse(label, fmt::format("expected the results of a report; seen lists in lists more than {} deep", deepest));
    return true;
  };
  try {
    return Json::parse(text, not_too_deep);
  } catch (const Json::parse_error& e) {
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) refuse(label, "expected the results of a report; the file is empty");
    const bool ended = e.byte > text.size();
    refuse(label, fmt::format("expected JSON; {} at {}. Make the report again", ended ? "the file ends in its midst," : "it is none",
                              place_of(text, e.byte)));
  } catch (const Json::exception&) {  // a number beyond all doubles
    refuse(label, "expected JSON with numbers that a computer can hold; seen one that is too large. Make the report again");
  }
}

// Reads what must be there, and names the place of what is not: "values[3].unit".
class Place {
 public:
  Place(const Json& json, std::string path, const std::string& label) : json_(json), path_(std::move(path)), label_(label) {}

  std::string text(const char* key) const {
    const Json& found = member(key);
    if (!found.is_string()) wrong(key, "a text", found);
    return found.get<std::string>();
  }
  bool truth(const char* key) const {
    const Json& found = member(key);
    if (!found.is_boolean()) wrong(key, "true or false", found);
    return found.get<bool>();
  }
  double number(const char* key) const {  // null: NaN
    const Json& found = member(key);
    if (found.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!found.is_number()) wrong(key, "a number or null", found);
    return found.get<double>();
  }
  Place object(const char* key) const {
    const Json& found = member(key);
    if (!found.is_object()) wrong(key, "an object", found);
    return {found, path_of(key), label_};
  }
  template <class Read>
  void each(const char* key, Read read) const {
    const Json& found = member(key);
    if (!found.is_array()) wrong(key, "a list", found);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string path = fmt::format("{}[{}]", path_of(key), i);
      if (!found[i].is_object()) refuse(label_, fmt::format("{}: expected an object; seen {}", path, found[i].type_name()));
      read(Place(found[i], path, label_));
    }
  }

 private:
  std::string path_of(const char* key) const { return path_.empty() ? key : path_ + "." + key; }
  const Json& member(const char* key) const {
    const auto found = json_.find(key);
    if (found == json_.end()) refuse(label_, fmt::format("{} is missing. Make the report again", path_of(key)));
    return *found;
  }
  [[noreturn]] void wrong(const char* key, const char* expected, const Json& seen) const {
    refuse(label_, fmt::format("{}: expected {}; seen {}", path_of(key), expected, seen.type_name()));
  }

  const Json& json_;
  std::string path_;
  const std::string& label_;
};

// "not_decided" for people.
std::string words_of(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

Json results_in(const std::string& text, const std::string& label) {
  Json json = parse(text, label);
  const auto schema = json.is_object() ? json.find("schema") : json.end();
  if (!json.is_object() || schema == json.end() || *schema != document::results_schema)
    refuse(label, fmt::format("expected the results.json of a report, with \"schema\": \"{}\"; seen other JSON", document::results_schema));
  const auto version = json.find("schema_version");
  if (version == json.end() || *version != version_read)
    refuse(label, fmt::format("expected schema_version {}; seen {}. Make the report again with this program", version_read,
                              version == json.end()  ? "none"
                              : version->is_number() ? version->dump()
                                                     : version->type_name()));
  return json;
}

Results results_from(const Json& json, const std::string& label) {
  const Place all(json, "", label);
  const Place from = all.object("provenance");
  Results out;
  out.label = label;
  out.title = all.text("title");
  out.mechanism = all.object("mechanism").text("name");
  out.scenario = from.text("scenario");
  out.scenario_sha256 = from.text("scenario_sha256");
  out.version = from.text("version");
  out.plugin_build = from.text("plugin_build");
  out.passed = all.object("verdict").truth("passed");
  all.each("values", [&](const Place& v) {
    out.values.push_back({v.text("section"), v.text("name"), v.text("unit"), v.number("value"), v.text("status")});
  });
  const std::string checks(checks_section);
  all.each("checks", [&](const Place& c) {
    out.values.push_back({checks, c.text("name"), c.text("unit"), c.number("value"), c.text("status")});
    out.judgements.push_back({checks, c.text("name"), c.truth("passed") ? "passed" : "failed"});
  });
  all.each("sections", [&](const Place& s) {
    const std::string section = s.text("id");
    s.each("evidence", [&](const Place& e) { out.judgements.push_back({section, e.text("claim"), words_of(e.text("state"))}); });
  });
  return out;
}

}  // namespace

Results read_results(const std::string& text, const std::string& label) { return results_from(results_in(text, label), label); }

std::vector<DataName> data_names(const std::string& text, const std::string& label) {
  const Json json = results_in(text, label);
  std::vector<DataName> out;
  Place(json, "", label).each("data", [&](const Place& d) { out.push_back({d.text("name"), d.text("csv")}); });
  return out;
}

// Values by way of the file's text, so that those of a report that was made and of one that was read are the same; curves as they are, of
// which the text may be large.
Results results_of(const document::Report& report, const std::string& label) {
  Results out = read_results(document::to_json(report), label);
  for (const document::Data& data : report.data) {
    if (!data.words.empty() || data.headings.empty() || data.headings.front() != time_heading || !is_a_course(data.columns.front()))
      continue;
    Curves curves{data.name, {data.headings.begin() + 1, data.headings.end()}, data.columns.front(), {}};
    curves.columns.assign(data.columns.begin() + 1, data.columns.end());
    for (auto& column : curves.columns)
      for (double& y : column)
        if (!std::isfinite(y)) y = std::numeric_limits<double>::quiet_NaN();  // an empty cell, in the file
    out.curves.push_back(std::move(curves));
  }
  return out;
}

}  // namespace pmreport::compare
