// What every page stands in: head with title, maker, description, icon and styles, and the body.
#pragma once

#include <reports/document/html/html_writer.hpp>

#include <initializer_list>
#include <string>

namespace pmreport::document {

struct PageHead {
  std::string title;
  std::string maker;        // "pmreport 1.0"
  std::string description;  // a sentence
};

// A platform on three limbs, for the tabs of browsers: without an icon they ask a server for one.
inline constexpr const char* icon =
    "data:image/svg+xml,"
    "%3Csvg%20xmlns=%22http%3A%2F%2Fwww.w3.org/2000/svg%22%20viewBox=%220%200%2016%2016%22%3E%3Cpath%20d=%22M1%2014h14M4%203h8M2%"
    "2014l2-11M8%2014V3M14%2014L12%203%22%20fill=%22none%22%20stroke=%22%231f6fb2%22%20stroke-width=%221.6%22%20stroke-lineca"
    "p=%22round%22/%3E%3C/svg%3E";

template <class Body>
void write_frame(HtmlWriter& html, const PageHead& head, std::initializer_list<const char*> styles, Body body) {
  html.markup("<!DOCTYPE html>\n");
  html.element("html", {{"lang", "en"}}, [&] {
    html.element("head", [&] {
      html.open("meta", {{"charset", "utf-8"}});
      html.open("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
      html.open("meta", {{"name", "generator"}, {"content", head.maker}});
      html.open("meta", {{"name", "description"}, {"content", head.description}});
      html.open("link", {{"rel", "icon"}, {"href", icon}});
      html.element("title", head.title);
      html.element("style", [&] {
        for (const char* style : styles) html.markup(style);
      });
    });
    html.element("body", body);
  });
}

}  // namespace pmreport::document
