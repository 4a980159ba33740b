#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <reports/document/folder/artwork.hpp>
#include <reports/document/pdf/pdf_finish.hpp>
#include <reports/document/write.hpp>
#include <reports/figure/draw.hpp>
#include <thread>

namespace pmreport::document {

namespace {

// Figures of one id would share the ids inside their SVG: each is drawn under its unique name.
figure::Figure renamed(const figure::Figure& f, const std::string& name) {
  figure::Figure copy = f;
  copy.id = name;
  return copy;
}

// The calling thread works too, and alone asks whether to go on. The first task that throws, in the order of the tasks' threads, is passed
// on.
void run_all(const std::vector<std::function<void()>>& tasks, bool (*interrupted)()) {
  std::atomic<std::size_t> next = 0;
  const auto stop = [&] { next = tasks.size(); };
  const auto work = [&](bool asks) {
    try {
      for (std::size_t i = next++; i < tasks.size(); i = next++) {
        if (asks && interrupted && interrupted()) throw Interrupted("interrupted while the figures were drawn");
        tasks[i]();
      }
    } catch (...) {
      stop();
      throw;
    }
  };
  const std::size_t workers = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, std::max<std::size_t>(tasks.size(), 1));
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < workers; ++i) others.push_back(std::async(std::launch::async, work, false));
  std::exception_ptr failure;
  try {
    work(true);
  } catch (...) {
    failure = std::current_exception();
  }
  for (auto& other : others) {
    try {
      other.get();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

Artwork draw_all(const Report& r, const Names& names, bool (*interrupted)()) {
  const auto figures = figures_of(r);
  const auto pictures = pictures_of(r);
  Artwork art{
      std::vector<std::string>(figures.size()), std::vector<std::string>(figures.size()), std::vector<std::string>(pictures.size()), {}};
  std::vector<std::function<void()>> tasks{[&] { art.report_pdf = to_pdf(r); }};  // the longest first
  for (std::size_t i = 0; i < figures.size(); ++i) {
    tasks.push_back([&, i] { art.svg[i] = figure::to_svg(renamed(*figures[i], names.figures[i])); });
    tasks.push_back([&, i] { art.pdf[i] = figure::to_pdf(renamed(*figures[i], names.figures[i])); });
  }
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (!pictures[i]->pdf.empty()) tasks.push_back([&, i] { art.picture_pdf[i] = pdf::packed(pictures[i]->pdf); });
  run_all(tasks, interrupted);
  return art;
}

std::vector<std::string> draw_svg(const Report& r, const Names& names) {
  const auto figures = figures_of(r);
  std::vector<std::string> svg;
  for (std::size_t i = 0; i < figures.size(); ++i) svg.push_back(figure::to_svg(renamed(*figures[i], names.figures[i])));
  return svg;
}

}  // namespace pmreport::document
