#include <reports/document/names.hpp>
#include <set>

namespace pmreport::document {

namespace {

constexpr std::size_t longest = 100;  // of 255 that file systems allow: the extension and a number come on top

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

std::string plain(const std::string& id, const std::string& otherwise) {
  std::string out;
  for (const char c : id.substr(0, longest)) {
    if (is_plain(c)) {
      out += c;
    } else if (!out.ends_with('-')) {
      out += '-';
    }
  }
  out.erase(0, out.find_first_not_of(".-"));  // never hidden, never an option of a command, never ".."
  while (out.ends_with('.') || out.ends_with('-')) out.pop_back();
  return out.empty() ? otherwise : out;
}

std::string lower(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

class Unique {
 public:
  explicit Unique(std::set<std::string> taken = {}) : taken_(std::move(taken)) {}
  std::string operator()(const std::string& id, const std::string& otherwise, const std::string& extension = "") {
    const std::string wanted = plain(id, otherwise);
    std::string name = wanted + extension;
    for (int n = 2; !taken_.insert(lower(name)).second; ++n) name = wanted + "-" + std::to_string(n) + extension;
    return name;
  }

 private:
  std::set<std::string> taken_;
};

template <class Wanted, class Visit>
void each_block(const Report& r, Visit visit) {
  for (const Section& section : r.sections) {
    for (const Block& block : section.blocks) {
      if (const auto* wanted = std::get_if<Wanted>(&block)) visit(*wanted);
    }
  }
}

}  // namespace

std::vector<const figure::Figure*> figures_of(const Report& r) {
  std::vector<const figure::Figure*> all;
  each_block<figure::Figure>(r, [&](const figure::Figure& f) { all.push_back(&f); });
  return all;
}

std::vector<const Picture*> pictures_of(const Report& r) {
  std::vector<const Picture*> all;
  if (r.cover) all.push_back(&*r.cover);
  each_block<Gallery>(r, [&](const Gallery& gallery) {
    for (const Picture& picture : gallery.pictures) all.push_back(&picture);
  });
  return all;
}

Names names_of(const Report& r) {
  Names names;
  Unique section({"contents", "summary", "checks", "files", "scenario", "provenance"});
  for (const Section& s : r.sections) names.sections.push_back(section(s.id, "section"));
  Unique figure, picture, data;
  for (const figure::Figure* f : figures_of(r)) names.figures.push_back(figure(f->id, "figure"));
  for (const Picture* p : pictures_of(r)) {
    names.pictures.push_back(picture(p->id, "snapshot"));
    names.drawn.push_back(!p->pdf.empty() && !p->svg.empty());
  }
  for (const Data& d : r.data) names.data.push_back(data(d.name, "data"));
  std::set<std::string> tables;
  for (const std::string& name : names.data) tables.insert(lower(name) + ".csv");
  Unique file(tables);
  for (const File& f : r.files) {
    const std::string id = f.name.starts_with("data/") ? f.name.substr(5) : f.name;
    const std::size_t last = id.rfind('.');
    const std::size_t dot = last != std::string::npos && id.find('/', last) == std::string::npos ? last : std::string::npos;
    const std::string extension = dot == std::string::npos ? "" : plain(id.substr(dot + 1), "");
    names.files.push_back(file(id.substr(0, dot), "file", extension.empty() ? "" : "." + extension));
  }
  return names;
}

std::vector<std::string> files_of(const Names& names) {
  std::vector<std::string> files{"report.html", "report.pdf"};
  for (const std::string& name : names.figures) {
    files.push_back("figures/" + name + ".svg");
    files.push_back("figures/" + name + ".pdf");
  }
  for (std::size_t i = 0; i < names.pictures.size(); ++i) {
    files.push_back("snapshots/" + names.pictures[i] + ".png");
    if (!names.drawn[i]) continue;
    files.push_back("snapshots/" + names.pictures[i] + ".svg");
    files.push_back("snapshots/" + names.pictures[i] + ".pdf");
  }
  for (const std::string& name : names.data) files.push_back("data/" + name + ".csv");
  for (const std::string& name : names.files) files.push_back("data/" + name);
  files.insert(files.end(), {"summary.md", "junit.xml", "results.json"});
  return files;
}

std::string data_file(const Report& r, const Names& names, const figure::Figure& f) {
  for (std::size_t i = 0; i < r.data.size(); ++i) {
    if (f.data == "data/" + r.data[i].name + ".csv") return "data/" + names.data[i] + ".csv";
  }
  return "";
}

}  // namespace pmreport::document
