#include <reports/document/html/html_page.hpp>

#include <algorithm>
#include <functional>
#include <string_view>

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

// Cairo defines every glyph that a drawing needs, and pages of many drawings would have the same outlines in each: half of their size.
std::string with_shared_glyphs(const std::string& svg, Glyphs& shared) {
  constexpr std::string_view opening = "<symbol overflow=\"visible\" id=\"", closing = "</symbol>\n", use = "href=\"#";
  std::map<std::string, std::string, std::less<>> elsewhere;  // ids of this drawing's glyphs that another has
  std::string out;
  std::size_t at = 0;
  while (at < svg.size()) {
    const std::size_t begin = std::min(svg.find(opening, at), svg.size()), end = svg.find(closing, begin);
    out.append(svg, at, begin - at);
    at = begin;
    if (end == std::string::npos) break;
    at = end + closing.size();
    const std::size_t name = begin + opening.size(), quote = svg.find('"', name);
    const std::string id = svg.substr(name, quote - name);
    const auto [known, is_new] = shared.try_emplace(svg.substr(quote, end - quote), id);
    if (is_new)
      out.append(svg, begin, at - begin);
    else
      elsewhere.emplace(id, known->second);
  }
  out.append(svg, at);
  if (elsewhere.empty()) return out;
  std::string joined;
  for (at = 0; at < out.size();) {
    const std::size_t found = out.find(use, at), begin = found == std::string::npos ? out.size() : found + use.size();
    joined.append(out, at, begin - at);
    at = std::min(out.find('"', begin), out.size());
    const std::string_view id = std::string_view(out).substr(begin, at - begin);
    const auto other = elsewhere.find(id);
    joined.append(other == elsewhere.end() ? id : std::string_view(other->second));
  }
  return joined;
}

}  // namespace

std::string inline_svg(const std::string& svg, Glyphs& shared) { return with_attributes(with_shared_glyphs(without_name(svg), shared)); }

std::string inline_svg(const std::string& svg) {
  Glyphs none;
  return inline_svg(svg, none);
}

}  // namespace pmreport::document
