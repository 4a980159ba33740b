// Writes HTML so that elements nest and user text cannot become markup: text and attributes are escaped here, nowhere else.
#pragma once

#include <reports/document/text.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace pmreport::document {

class HtmlWriter {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string_view>>;

  // <tag>, whatever `inside` writes, </tag>.
  template <class Inside>
  void element(std::string_view tag, Attributes attributes, Inside inside) {
    open(tag, attributes);
    if constexpr (std::is_convertible_v<Inside, std::string_view>) {
      text(inside);
    } else {
      inside();
    }
    out_.append("</").append(tag).append(">");
    if (is_block(tag)) out_ += '\n';
  }
  template <class Inside>
  void element(std::string_view tag, Inside inside) {
    element(tag, {}, inside);
  }

  // An element without content: <img>, <link>. An attribute with an empty value stands as its name alone.
  void open(std::string_view tag, Attributes attributes) {
    out_.append("<").append(tag);
    for (const auto& [name, value] : attributes) {
      out_.append(" ").append(name);
      if (!value.empty()) out_.append("=\"").append(escape(value)).append("\"");
    }
    out_ += '>';
  }

  void text(std::string_view plain) { out_ += escape(plain); }
  void markup(std::string_view trusted) { out_ += trusted; }

  std::string take() { return std::move(out_); }

 private:
  // Between words of a line white space shows; between blocks it only makes the source readable.
  static bool is_block(std::string_view tag) { return tag != "a" && tag != "span" && tag != "strong" && tag != "code"; }

  std::string out_;
};

}  // namespace pmreport::document
