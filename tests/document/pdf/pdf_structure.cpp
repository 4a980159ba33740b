// What PDF/UA (ISO 14289-1) asks of structure and metadata, checked in the file as qpdf reads it.
#include <reports/document/html/figure_words.hpp>
#include <reports/document/pdf/pdf_artifacts.hpp>
#include <reports/document/pdf/pdf_attachments.hpp>
#include <reports/document/write.hpp>
#include <tests/document/pdf/pdf_sample.hpp>
#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

using namespace pmreport;
using namespace pmreport::document;
using nlohmann::json;
using sample::ask;
using sample::contains;

namespace {

// The objects of a PDF, as qpdf tells them.
class Objects {
 public:
  explicit Objects(const std::string& told) : all_(json::parse(told)["qpdf"][1]) {}
  std::vector<json> fonts() const {
    std::vector<json> all;
    for (const auto& [name, entry] : all_.items())
      if (entry.contains("value") && entry["value"].is_object() && entry["value"].value("/Type", json()) == "/Font")
        all.push_back(entry["value"]);
    return all;
  }
  json root() const { return at(all_["trailer"]["value"]["/Root"]); }
  json information() const { return at(all_["trailer"]["value"]["/Info"]); }
  static bool is_reference(const json& j) {
    static const std::regex reference("\\d+ \\d+ R");
    return j.is_string() && std::regex_match(j.get<std::string>(), reference);
  }
  // What `j` is or refers to; of a stream its dictionary.
  json at(const json& j) const {
    if (!is_reference(j)) return j;
    const json& entry = all_["obj:" + j.get<std::string>()];
    return entry.contains("stream") ? entry["stream"]["dict"] : at(entry["value"]);
  }
  json get(const json& dictionary, const char* key) const { return dictionary.contains(key) ? at(dictionary[key]) : json(); }
  std::vector<json> list(const json& j) const {  // resolved
    std::vector<json> all;
    const json what = at(j);
    if (what.is_array())
      for (const json& i : what) all.push_back(at(i));
    else if (!what.is_null())
      all.push_back(what);
    return all;
  }
  std::vector<json> pages() const { return pages_below(root()["/Pages"], false); }
  std::vector<json> references_of_pages() const { return pages_below(root()["/Pages"], true); }

 private:
  std::vector<json> pages_below(const json& node, bool references) const {
    const json what = at(node);
    if (what["/Type"] == "/Page") return {references ? node : what};
    std::vector<json> all;
    for (const json& kid : at(what["/Kids"]))
      for (json& page : pages_below(kid, references)) all.push_back(std::move(page));
    return all;
  }
  json all_;
};

std::optional<Objects> objects_of(const Report& r) {
  const auto told = ask("qpdf --json=2 --json-key=qpdf {}", to_pdf(r));
  return told ? std::optional<Objects>(Objects(*told)) : std::nullopt;
}

bool is_element(const json& j) { return j.is_object() && j.contains("/S"); }

// Every element below, parents first, with the role of its parent.
void each_element(const Objects& o, const json& element, const std::string& parent,
                  const std::function<void(const json&, const std::string&)>& visit) {
  visit(element, parent);
  for (const json& kid : o.list(element.value("/K", json())))
    if (is_element(kid)) each_element(o, kid, element["/S"], visit);
}

void each_element(const Objects& o, const std::function<void(const json&, const std::string&)>& visit) {
  for (const json& top : o.list(o.get(o.root(), "/StructTreeRoot")["/K"])) each_element(o, top, "", visit);
}

std::vector<json> kids_in(const Objects& o, const json& element, const std::string& role) {
  std::vector<json> all;
  for (const json& kid : o.list(element.value("/K", json())))
    if (is_element(kid) && kid["/S"] == role) all.push_back(kid);
  return all;
}

// Rows of a table, in its head and body.
std::vector<json> rows_of(const Objects& o, const json& table) {
  std::vector<json> rows = kids_in(o, table, "/TR");
  for (const char* part : {"/THead", "/TBody"})
    for (const json& p : kids_in(o, table, part))
      for (json& row : kids_in(o, p, "/TR")) rows.push_back(std::move(row));
  return rows;
}

Report whole() {
  Report r = sample::full_report();
  r.key_numbers = sample::report().key_numbers;
  r.cover = std::get<Gallery>(r.sections[1].blocks[0]).pictures[0];
  r.cover->id = "cover";
  r.files = {{"data/mesh.stl", "boundary of the workspace", "12345"}};
  r.assumptions = {"Bodies are rigid."};
  return r;
}

}  // namespace

TEST_CASE("the PDF says its language, that it is tagged, and that viewers show its title") {
  const auto o = objects_of(whole());
  if (!o) return;
  const json root = o->root();
  CHECK(root["/Lang"] == "u:en");
  CHECK(o->get(root, "/MarkInfo")["/Marked"] == true);
  CHECK(o->get(root, "/ViewerPreferences")["/DisplayDocTitle"] == true);
  CHECK(o->get(root, "/Metadata")["/Subtype"] == "/XML");
  for (const json& page : o->pages()) CHECK(page["/Tabs"] == "/S");
  const auto metadata = ask("pdfinfo -meta {}", to_pdf(whole()));
  if (!metadata) return;
  CHECK(contains(*metadata, "<pdfuaid:part>1</pdfuaid:part>"));
  CHECK(contains(*metadata, "kinematics and statics &lt;script&gt;"));
}

TEST_CASE("every font says how its glyphs are found and what they mean") {
  const auto o = objects_of(whole());
  if (!o) return;
  int fonts = 0;
  for (const json& font : o->fonts()) {
    const std::string kind = font["/Subtype"];
    fonts += kind != "/CIDFontType2";
    if (kind == "/CIDFontType2")
      CHECK(font["/CIDToGIDMap"] == "/Identity");
    else
      CHECK(font.contains("/ToUnicode"));
    if (font.contains("/FontDescriptor")) CHECK(o->get(font, "/FontDescriptor").contains("/FontFile2"));
  }
  CHECK(fonts >= 3);
}

TEST_CASE("every figure has words instead of it, every link says where it leads") {
  const Report r = whole();
  const auto o = objects_of(r);
  if (!o) return;
  int figures = 0;
  std::set<std::string> words;
  each_element(*o, [&](const json& e, const std::string&) {
    if (e["/S"] != "/Figure") return;
    ++figures;
    CHECK(e.value("/Alt", "u:").size() > 2);
    words.insert(e.value("/Alt", ""));
    const json box = o->get(e, "/A").value("/BBox", json());
    REQUIRE(box.size() == 4);
    CHECK(box[0].get<double>() >= 18 / 25.4 * 72 - 1);  // within the text
    CHECK(box[2].get<double>() <= 192 / 25.4 * 72 + 1);
    CHECK(box[1].get<double>() >= 22 / 25.4 * 72 - 1);
    CHECK(box[1].get<double>() < box[3].get<double>());
  });
  CHECK(figures == 6 + 4 + 1);  // plots, pictures, the cover
  bool told = false;
  for (const std::string& w : words) told = told || (contains(w, "limb 6") && contains(w, "length [mm] against time [s]"));
  CHECK(told);
  for (const json& page : o->pages())
    for (const json& annotation : o->list(page.value("/Annots", json()))) {
      CHECK(annotation.value("/Contents", "u:").size() > 2);
      CHECK(annotation.contains("/StructParent"));
    }
}

TEST_CASE("tables are regular, and their headings say whether they head a row or a column") {
  const auto o = objects_of(whole());
  if (!o) return;
  int tables = 0, heads = 0;
  each_element(*o, [&](const json& e, const std::string& parent) {
    const std::string role = e["/S"];
    if (role == "/TR") CHECK((parent == "/Table" || parent == "/THead" || parent == "/TBody"));
    if (role == "/TD" || role == "/TH") CHECK(parent == "/TR");
    if (role == "/TH") {
      ++heads;
      const std::string scope = o->get(e, "/A").value("/Scope", "");
      CHECK((scope == "/Column" || scope == "/Row"));
    }
    if (role != "/Table") return;
    ++tables;
    std::set<std::size_t> columns;
    for (const json& row : rows_of(*o, e)) {
      const std::size_t cells = kids_in(*o, row, "/TH").size() + kids_in(*o, row, "/TD").size();
      CHECK(cells == o->list(row["/K"]).size());
      columns.insert(cells);
    }
    CHECK(columns.size() == 1);
  });
  CHECK(tables >= 7);
  CHECK(heads > 30);
}

TEST_CASE("headings descend one level at a time, and lists and contents are made as the standard has them") {
  const auto o = objects_of(whole());
  if (!o) return;
  int level = 0, titles = 0;
  each_element(*o, [&](const json& e, const std::string& parent) {
    const std::string role = e["/S"];
    if (role.size() == 3 && role[1] == 'H' && role[2] >= '1' && role[2] <= '6') {
      const int here = role[2] - '0';
      CHECK(here <= level + 1);
      level = here;
      titles += here == 1;
    }
    if (role == "/LI") CHECK(parent == "/L");
    if (role == "/LBody") CHECK(parent == "/LI");
    if (role == "/TOCI") CHECK(parent == "/TOC");
    if (role == "/Caption") CHECK((parent == "/Table" || parent == "/Sect"));
  });
  CHECK(titles == 1);
}

TEST_CASE("from every part of a page that is content the way leads to one element, and back") {
  const auto o = objects_of(whole());
  if (!o) return;
  // Page and number of each part, from the elements.
  std::map<std::pair<std::string, int>, int> parts;
  each_element(*o, [&](const json& e, const std::string&) {
    for (const json& kid : o->list(e.value("/K", json())))
      if (kid.is_object() && kid.contains("/MCID")) ++parts[{kid["/Pg"].get<std::string>(), kid["/MCID"].get<int>()}];
  });
  for (const auto& [part, times] : parts) {
    CAPTURE(part.first, part.second);
    CHECK(times == 1);
  }
  // And from the pages, by the tree of parents.
  std::map<int, json> parents;
  const json numbers = o->get(o->get(o->get(o->root(), "/StructTreeRoot"), "/ParentTree"), "/Nums");
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) parents[numbers[i].get<int>()] = o->at(numbers[i + 1]);
  std::size_t found = 0;
  for (const json& reference : o->references_of_pages()) {
    const json page = o->at(reference);
    const json& of_page = parents.at(page["/StructParents"].get<int>());
    for (std::size_t n = 0; n < of_page.size(); ++n, ++found) {
      const json element = o->at(of_page[n]);
      bool back = false;
      for (const json& kid : o->list(element.value("/K", json())))
        back = back || (kid.is_object() && kid.value("/MCID", -1) == static_cast<int>(n) && kid["/Pg"] == reference);
      CHECK(back);
    }
  }
  CHECK(found == parts.size());
}

TEST_CASE("all ink belongs to content or to decoration") {
  const auto plain = ask("qpdf --qdf --object-streams=disable {} -", to_pdf(whole()));
  if (!plain) return;
  const std::set<std::string> ink{"S", "f", "f*", "B", "B*", "Do", "Tj", "TJ", "sh"};
  int pages = 0, marks = 0;
  for (std::size_t at = plain->find("stream\n/Artifact BMC\n1 0 0 -1 0 841"); at != std::string::npos;
       at = plain->find("stream\n/Artifact BMC\n1 0 0 -1 0 841", at + 1)) {
    ++pages;
    std::string content = plain->substr(at + 7, plain->find("\nendstream", at) - at - 7);
    content = std::regex_replace(content, std::regex("\\\\."), "");          // escaped parentheses
    content = std::regex_replace(content, std::regex("\\([^()]*\\)"), " ");  // words are no operators
    content = std::regex_replace(content, std::regex("[\\]>]"), " ");
    std::istringstream words(content);
    int depth = 0;
    for (std::string word; words >> word;) {
      depth += (word == "BDC" || word == "BMC") - (word == "EMC");
      marks += word == "BDC";
      CHECK(depth >= 0);
      if (ink.contains(word)) CHECK(depth > 0);
    }
    CHECK(depth == 0);
  }
  CHECK(pages >= 8);
  CHECK(marks > 100);
}

TEST_CASE("ink outside of marks becomes one artifact a run, and marks of ligatures stay within it") {
  CHECK(pdf::with_artifacts("q 0 g\n/P << /MCID 0 >> BDC\n1 w S\nEMC\nQ\n") == "q 0 g\n/P << /MCID 0 >> BDC\n1 w S\nEMC\nQ\n");
  const std::string decorated = pdf::with_artifacts("1 w 0 0 m 9 9 l S\n/P << /MCID 0 >> BDC\nEMC\n");
  CHECK(decorated == "/Artifact BMC\n1 w 0 0 m 9 9 l S\nEMC\n\n/P << /MCID 0 >> BDC\nEMC\n");
  const std::string ligature = pdf::with_artifacts("BT /Span << /ActualText <feff> >> BDC\n(EMC S) Tj\nEMC\nET\n");
  CHECK(sample::count(ligature, "/Artifact BMC") == 1);
  CHECK(ligature.starts_with("/Artifact BMC\nBT /Span"));
  CHECK(ligature.ends_with("ET\n\nEMC\n"));
  const std::string after = pdf::with_artifacts("/P << /MCID 0 >> BDC\nEMC\n0 0 m 9 9 l S\n");
  CHECK(sample::count(after, "EMC\n/Artifact BMC\n") == 1);
}

TEST_CASE("scenario, results and data are attached as they lie beside the report") {
  const Report r = whole();
  const std::string pdf = to_pdf(r);
  const auto listed = ask("pdfdetach -list {}", pdf);
  if (!listed) return;
  CHECK(contains(*listed, "4 embedded files"));
  const auto content = [&](const char* name) { return ask(fmt::format("qpdf --show-attachment={} {{}}", name), pdf).value_or(""); };
  CHECK(content("4sps-spr.toml") == r.scenario_text);
  CHECK(content("displacement.csv") == to_csv(r.data[0]));
  CHECK(json::parse(content("results.json")) == json::parse(to_json(r)));
  const auto o = objects_of(r);
  for (const json& file : o->list(o->root()["/AF"])) {
    CHECK(file["/AFRelationship"] == "/Data");
    CHECK(file.contains("/Desc"));
    const json stream = o->at(o->get(file, "/EF")["/F"]);
    CHECK(stream["/Type"] == "/EmbeddedFile");
    CHECK(stream["/Subtype"].get<std::string>().find('/', 1) != std::string::npos);
    CHECK_FALSE(stream["/Params"].contains("/ModDate"));  // without SOURCE_DATE_EPOCH
  }
}

TEST_CASE("data too large to send along are named, and stay beside the report") {
  Report r = whole();
  r.data[1].columns = {std::vector<double>(400000, 1.0 / 3)};
  const std::string pdf = to_pdf(r);
  const auto listed = ask("pdfdetach -list {}", pdf), text = ask("pdftotext -layout {} -", pdf);
  if (!listed || !text) return;
  CHECK_FALSE(contains(*listed, "statics.csv"));
  CHECK(contains(*text, "data/statics.csv; too large, they lie beside the report"));
}

TEST_CASE("what is too large to be attached is told with the place where it lies") {
  Report r = whole();
  r.scenario_text.clear();
  for (int i = 0; i < 1'400'000; ++i) r.scenario_text += "#.\n";
  const auto text = ask("pdftotext -layout {} -", to_pdf(r));
  if (text) CHECK(contains(*text, "4sps-spr.toml; too large, it lies where it was read from"));
  r.sections.push_back({"long", "", "Long", {Proof{{{std::string(4'100'000, 'a'), "", 0, 1e-9, "m"}}}}});
  const pdf::Attachments all = pdf::attachments_of(r, names_of(r));
  CHECK(all.scenario_left_out == "4sps-spr.toml");
  CHECK(all.left_out == std::vector<std::string>{"results.json"});
  CHECK(std::ranges::none_of(all.files, [](const pdf::Attachment& a) { return a.name == "4sps-spr.toml" || a.name == "results.json"; }));
}

TEST_CASE("data whose cells alone are too many are not written out to learn that they are too large") {
  Report r = whole();
  r.data.resize(2);
  // Of a column of one-digit numbers the bound is all there is: what fits by it is attached.
  r.data[1] = {"digits", {"n"}, {std::vector<double>(1'900'000, 7.0)}};
  CHECK(pdf::attachments_of(r, names_of(r)).left_out.empty());
  // Without a heading it cannot be written at all.
  r.data[1] = {"digits", {}, {std::vector<double>(2'100'000, 7.0)}};
  REQUIRE_THROWS(to_csv(r.data[1]));
  CHECK(pdf::attachments_of(r, names_of(r)).left_out == std::vector<std::string>{"data/digits.csv"});
}
