#include <zlib.h>

#include <algorithm>
#include <limits>
#include <reports/document/html/html_view.hpp>
#include <reports/document/text.hpp>

namespace pmreport::document {

namespace {

// As gzip has it (RFC 1952), without a time of its making: the same bytes every time. Empty where it fails.
std::string gzipped(const std::string& bytes) {
  if (bytes.size() > std::numeric_limits<uInt>::max()) return "";
  z_stream stream{};
  constexpr int window = 15, with_gzip_header = 16, memory = 8;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window + with_gzip_header, memory, Z_DEFAULT_STRATEGY) != Z_OK) return "";
  std::string out(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const bool whole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  out.resize(whole ? stream.total_out : 0);
  deflateEnd(&stream);
  return out;
}

}  // namespace

std::string model_in_page(const Report& r) {
  const auto model = std::ranges::find(r.files, "data/model.glb", &File::name);
  if (model == r.files.end()) return "";
  std::string text = base64(gzipped(model->bytes));
  return text.size() <= most_model_bytes ? text : "";
}

void write_view(Page& page) {
  const std::string model = model_in_page(page.report);
  if (model.empty()) return;
  HtmlWriter& html = page.html;
  html.element("section", {{"id", "machine-view"}, {"aria-labelledby", "machine-view-title"}, {"hidden", ""}}, [&] {
    html.element("h2", {{"id", "machine-view-title"}}, "The machine in 3D");
    html.element("script", {{"type", "model/gltf-binary"}, {"id", "machine-model"}, {"data-coding", "gzip, base64"}},
                 [&] { html.markup(model); });
  });
}

}  // namespace pmreport::document
