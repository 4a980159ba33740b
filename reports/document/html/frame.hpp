// What every page stands in: head with title, maker and styles, and the body.
#pragma once

#include <reports/document/html/html_writer.hpp>

#include <initializer_list>
#include <string>

namespace pmreport::document {

// `maker`: "pmreport 1.0".
template <class Body>
void write_frame(HtmlWriter& html, const std::string& title, const std::string& maker, std::initializer_list<const char*> styles,
                 Body body) {
  html.markup("<!DOCTYPE html>\n");
  html.element("html", {{"lang", "en"}}, [&] {
    html.element("head", [&] {
      html.open("meta", {{"charset", "utf-8"}});
      html.open("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
      html.open("meta", {{"name", "generator"}, {"content", maker}});
      html.element("title", title);
      html.element("style", [&] {
        for (const char* style : styles) html.markup(style);
      });
    });
    html.element("body", body);
  });
}

}  // namespace pmreport::document
