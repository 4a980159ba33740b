#include <reports/figure/embedding.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <stdexcept>
#include <string_view>

#include <reports/figure/text.hpp>

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
struct IdPlace {
  std::string_view before;
  char after;
};
constexpr std::array<IdPlace, 3> marks{{{" id=\"", '"'}, {"href=\"#", '"'}, {"url(#", ')'}}};

std::string with_own_ids(const std::string& svg, const std::string& prefix) {
  std::map<std::string, std::string, std::less<>> names;
  std::array<std::size_t, marks.size()> next{};  // where each mark comes next
  std::string result;
  result.reserve(svg.size());
  for (std::size_t position = 0;;) {
    for (std::size_t m = 0; m < marks.size(); ++m) {
      if (next[m] != std::string::npos && next[m] <= position) next[m] = svg.find(marks[m].before, position);
    }
    const std::size_t m = static_cast<std::size_t>(std::min_element(next.begin(), next.end()) - next.begin());
    if (next[m] == std::string::npos) return result.append(svg, position);
    const std::size_t begin = next[m] + marks[m].before.size(), end = svg.find(marks[m].after, begin);
    const auto name = names.try_emplace(svg.substr(begin, end - begin), prefix + std::to_string(names.size() + 1)).first;
    result.append(svg, position, begin - position).append(name->second);
    position = end;
  }
}

bool digit(char c) { return c >= '0' && c <= '9'; }

// Cairo writes a millionth of a point; a hundredth (3.5 µm) is finer than any printer and makes the file a quarter smaller.
std::string with_short_numbers(const std::string& svg) {
  std::string result;
  result.reserve(svg.size());
  std::size_t copied = 0;
  for (std::size_t dot = svg.find('.'); dot != std::string::npos; dot = svg.find('.', dot + 1)) {
    std::size_t begin = dot, end = dot + 1;
    while (begin > copied && digit(svg[begin - 1])) --begin;
    while (end < svg.size() && digit(svg[end])) ++end;
    if (begin == dot || end - dot <= 3) continue;
    double value = 0;
    std::from_chars(svg.data() + begin, svg.data() + end, value);
    std::string number = fmt::format("{:.2f}", value);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    result.append(svg, copied, begin - copied).append(number);
    copied = end;
  }
  return result.append(svg, copied);
}

std::string title_of(const Figure& figure) {
  std::string title;
  for (const Panel& panel : figure.panels) {
    if (!panel.title.empty()) title += (title.empty() ? "" : ", ") + panel.title;
  }
  if (title.empty()) title = figure.id;
  return as_xml(title);
}

}  // namespace

std::string embeddable_svg(const std::string& svg, const Figure& figure) {
  const std::size_t root = svg.find("<svg "), rest = svg.find('>', root);
  if (root == std::string::npos || rest == std::string::npos) throw std::runtime_error("Cairo wrote an SVG without a root element");
  const std::string head = with_short_numbers(svg.substr(root, rest - root)) + " role=\"img\">\n<title>" + title_of(figure) + "</title>";
  return head + with_own_ids(with_short_numbers(svg.substr(rest + 1)), prefix_of(figure.id));
}

}  // namespace pmreport::figure
