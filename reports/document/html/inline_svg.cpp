#include <reports/document/html/html_page.hpp>

namespace pmreport::document {

namespace {

// stroke-width:0.5;stroke:rgb(0%,0%,0%);  as  stroke-width="0.5" stroke="rgb(0%,0%,0%)"
void append_presentation(std::string& out, std::string_view style) {
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    const std::string_view declaration = style.substr(0, end);
    const std::size_t colon = declaration.find(':');
    if (colon != std::string_view::npos) {
      const std::string_view name = declaration.substr(0, colon);
      out.append(" ").append(name.substr(std::min(name.find_first_not_of(' '), name.size())));
      out.append("=\"").append(declaration.substr(colon + 1)).append("\"");
    }
    style.remove_prefix(std::min(end + 1, style.size()));
  }
}

// Without the first place, if any, where it stands from `before` to `after`.
std::string without(std::string text, std::string_view before, std::string_view after) {
  const std::size_t begin = text.find(before), end = text.find(after, begin == std::string::npos ? text.size() : begin + before.size());
  return end == std::string::npos ? text : text.erase(begin, end + after.size() - begin);
}

std::string without_name(const std::string& svg) { return without(without(svg, " role=\"", "\""), "<title>", "</title>\n"); }

std::string with_attributes(const std::string& svg) {
  constexpr std::string_view opening = " style=\"";
  std::string out;
  std::size_t at = std::min(svg.find("<svg"), svg.size());
  while (at < svg.size()) {
    const std::size_t style = std::min(svg.find(opening, at), svg.size());
    out.append(svg, at, style - at);
    if (style == svg.size()) break;
    const std::size_t value = style + opening.size(), end = std::min(svg.find('"', value), svg.size());
    append_presentation(out, std::string_view(svg).substr(value, end - value));
    at = end + 1;
  }
  return out;
}

}  // namespace

std::string inline_svg(const std::string& svg) { return with_attributes(without_name(svg)); }

}  // namespace pmreport::document
