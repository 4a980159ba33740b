#include <reports/document/folder/artwork.hpp>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

std::string to_html(const Report& r) {
  const Names names = names_of(r);
  return to_html(r, names, draw_svg(r, names));
}

void write(const Report& r, const std::string& folder, bool (*interrupted)()) {
  const auto go_on = [&] {
    if (interrupted && interrupted()) throw Interrupted("interrupted while the report was written");
  };
  go_on();
  StagedFolder staged(folder);  // first: a folder that cannot be written is told before minutes are spent on drawing
  const Names names = names_of(r);
  const Artwork art = draw_all(r, names, interrupted);
  const auto add = [&](const std::string& name, std::string_view bytes) {
    go_on();
    staged.add(name, bytes);
  };
  add("report.html", to_html(r, names, art.svg));
  add("report.pdf", art.report_pdf);
  for (std::size_t i = 0; i < names.figures.size(); ++i) {
    add("figures/" + names.figures[i] + ".svg", art.svg[i]);
    add("figures/" + names.figures[i] + ".pdf", art.pdf[i]);
  }
  const auto pictures = pictures_of(r);
  for (std::size_t i = 0; i < pictures.size(); ++i) add("snapshots/" + names.pictures[i] + ".png", pictures[i]->png);
  for (std::size_t i = 0; i < r.data.size(); ++i) add("data/" + names.data[i] + ".csv", to_csv(r.data[i]));
  for (std::size_t i = 0; i < r.files.size(); ++i) add("data/" + names.files[i], r.files[i].bytes);
  add("summary.md", to_markdown(r));
  add("junit.xml", to_junit(r));
  add("results.json", to_json(r));
  go_on();
  staged.commit();
}

}  // namespace pmreport::document
