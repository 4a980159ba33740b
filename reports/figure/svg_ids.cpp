#include "reports/figure/svg_ids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>

#include "reports/figure/text.hpp"

namespace pmreport::figure {
namespace {

bool plain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'; }

// A name that may stand in an id and in url(#...); different figures keep different prefixes.
std::string prefix_of(const std::string& id) {
  std::string prefix = "f-";
  for (const char c : id) prefix += plain(c) ? std::string(1, c) : fmt::format("_{:02x}", static_cast<unsigned char>(c));
  return prefix + "-";
}

// Each place where Cairo writes an id ends with the quote or parenthesis that follows it.
struct Mark {
  std::string_view before;
  char after;
};
constexpr std::array<Mark, 3> marks{{{" id=\"", '"'}, {"href=\"#", '"'}, {"url(#", ')'}}};

std::string with_own_ids(const std::string& svg, const std::string& prefix) {
  std::map<std::string, std::string, std::less<>> names;
  std::string result;
  result.reserve(svg.size() + svg.size() / 8);
  std::size_t position = 0;
  for (;;) {
    std::size_t found = std::string::npos;
    const Mark* mark = nullptr;
    for (const Mark& candidate : marks) {
      const std::size_t at = svg.find(candidate.before, position);
      if (at < found) {
        found = at;
        mark = &candidate;
      }
    }
    if (mark == nullptr) break;
    const std::size_t begin = found + mark->before.size(), end = svg.find(mark->after, begin);
    const std::string old = svg.substr(begin, end - begin);
    const auto name = names.try_emplace(old, prefix + std::to_string(names.size() + 1)).first;
    result.append(svg, position, begin - position).append(name->second);
    position = end;
  }
  return result.append(svg, position);
}

std::string title_of(const Figure& figure) {
  std::string title;
  for (const Panel& panel : figure.panels) {
    if (!panel.title.empty()) title += (title.empty() ? "" : ", ") + panel.title;
  }
  if (title.empty()) title = figure.id;
  // XML 1.0 has no control characters, not even escaped.
  title.erase(std::remove_if(title.begin(), title.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }),
              title.end());
  return escape_markup(title);
}

}  // namespace

std::string embeddable_svg(const std::string& svg, const Figure& figure) {
  const std::size_t root = svg.find("<svg "), rest = svg.find('>', root);
  if (root == std::string::npos || rest == std::string::npos) throw std::runtime_error("Cairo wrote an SVG without a root element");
  const std::string head = svg.substr(root, rest - root) + " role=\"img\">\n<title>" + title_of(figure) + "</title>";
  return with_own_ids(head + svg.substr(rest + 1), prefix_of(figure.id));
}

}  // namespace pmreport::figure
