#include <reports/document/folder/artwork.hpp>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/write.hpp>
#include <reports/figure/warnings.hpp>

namespace pmreport::document {

std::string to_html(const Report& r) {
  const Names names = names_of(r);
  return to_html(r, names, draw_svg(r, names));
}

void write(const Report& r, const std::string& folder, bool (*interrupted)()) {
  if (interrupted && interrupted()) throw Interrupted("interrupted before the report was written");
  StagedFolder staged(folder);
  write(r, staged, interrupted);
}

void write(const Report& r, StagedFolder& staged, bool (*interrupted)()) {
  const auto go_on = [&] {
    if (interrupted && interrupted()) throw Interrupted("interrupted while the report was written");
  };
  go_on();
  const Names names = names_of(r);
  const Artwork art = draw_all(r, names, interrupted);
  figure::throw_if_libraries_warned();
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
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const std::string stem = "snapshots/" + names.pictures[i];
    add(stem + ".png", pictures[i]->png);
    if (!names.drawn[i]) continue;
    add(stem + ".svg", pictures[i]->svg);
    add(stem + ".pdf", art.picture_pdf[i]);
  }
  for (std::size_t i = 0; i < r.data.size(); ++i)
    staged.add("data/" + names.data[i] + ".csv", [&](const auto& put) {
      to_csv(r.data[i], [&](std::string_view piece) {
        go_on();
        put(piece);
      });
    });
  for (std::size_t i = 0; i < r.files.size(); ++i) add("data/" + names.files[i], r.files[i].bytes);
  add("summary.md", to_markdown(r));
  add("junit.xml", to_junit(r));
  add("results.json", to_json(r));
  go_on();
  staged.commit();
}

}  // namespace pmreport::document
