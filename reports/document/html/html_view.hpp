// The machine in three dimensions, as data for the page's script.
#pragma once

#include <reports/document/html/html_page.hpp>

namespace pmreport::document {

// A larger model stays outside: the page is sent by mail.
constexpr std::size_t most_model_bytes = 600'000;  // as they stand in the page

// data/model.glb as it stands in the page: packed by gzip, in base64. Empty where the report has none, or one that is too large.
std::string model_in_page(const Report& r);

// The section of the 3D view, hidden until the script finds that it can draw, and its model. Nothing without a model.
void write_view(Page& page);

extern const char* const html_view_style;

}  // namespace pmreport::document
