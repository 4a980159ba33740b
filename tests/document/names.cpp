// Ids may hold anything; the names of files may not.
#include <catch2/catch.hpp>
#include <reports/document/names.hpp>
#include <set>

#include <tests/document/sample.hpp>

using namespace pmreport;
using namespace pmreport::document;

namespace {

std::vector<std::string> data_names(const std::vector<std::string>& ids) {
  Report r;
  for (const std::string& id : ids) r.data.push_back({id, {}, {}});
  return names_of(r).data;
}

}  // namespace

TEST_CASE("an id that is a good name is the name") {
  CHECK(data_names({"displacement", "l1_force", "A-1.b"}) == std::vector<std::string>{"displacement", "l1_force", "A-1.b"});
}

TEST_CASE("no id leads out of the report's folder") {
  const std::vector<std::string> ids{
      "../../etc/passwd",    "/etc/passwd", "..", ".", "", ".hidden", "-rf", std::string("a\0b", 3), "a/b", "a\\b", "C:x", "机构",
      std::string(4000, 'x')};
  for (const std::string& name : data_names(ids)) {
    CAPTURE(name);
    CHECK_FALSE(name.empty());
    CHECK(name.size() <= 200);
    CHECK(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") == std::string::npos);
    CHECK(name.front() != '.');
    CHECK(name.front() != '-');
  }
}

TEST_CASE("two things never share a name, even where upper and lower case are one") {
  const auto names = data_names({"a", "A", "a", "a-2", "../a", "", "data", ""});
  std::set<std::string> lower;
  for (std::string name : names) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    CAPTURE(name);
    CHECK(lower.insert(name).second);
  }
}

TEST_CASE("a section called summary does not take the anchor of the summary") {
  Report r;
  r.sections = {{"summary", "x", "X", {}}, {"checks", "x", "X", {}}, {"files", "x", "X", {}}};
  CHECK(names_of(r).sections == std::vector<std::string>{"summary-2", "checks-2", "files-2"});
}

TEST_CASE("files lie in data/ with their extensions, whatever they are called, and never in the place of a table or of one another") {
  Report r;
  r.data = {{"workspace", {}, {}}};
  for (const char* name : {"data/workspace.stl", "data/WORKSPACE.STL", "../../etc/passwd", "/abs/x.ply", "data/../up.npy",
                           "data/workspace.csv", "data/机构.stl", "", "data/.hidden", "data/-rf.s/h", "data/a.b.stl"})
    r.files.push_back({name, "", ""});
  const Names names = names_of(r);
  CHECK(names.files == std::vector<std::string>{"workspace.stl", "WORKSPACE-2.STL", "etc-passwd", "abs-x.ply", "up.npy", "workspace-2.csv",
                                                "file.stl", "file", "file.hidden", "rf.s-h", "a.b.stl"});
  const std::vector<std::string> all = files_of(names);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == all.size());
}

TEST_CASE("a figure finds the file of its data, whatever its name had to become") {
  Report r;
  r.data = {{"my data", {}, {}}, {"my/data", {}, {}}};
  figure::Figure f;
  const Names names = names_of(r);
  f.data = "data/my/data.csv";
  CHECK(data_file(r, names, f) == "data/my-data-2.csv");
  f.data = "data/none.csv";
  CHECK(data_file(r, names, f).empty());
}
