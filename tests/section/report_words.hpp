// A section as a reader has it before him: its words, tables, figures, values and proofs.
#pragma once

#include <reports/document/report.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace report_words {

using namespace pmreport;

// The blocks of one kind, in order; they live as long as the section.
template <class Block>
std::vector<const Block*> pointers(const document::Section& s) {
  std::vector<const Block*> out;
  for (const document::Block& b : s.blocks)
    if (const auto* found = std::get_if<Block>(&b)) out.push_back(found);
  return out;
}
template <class Block>
std::vector<Block> blocks(const document::Section& s) {
  std::vector<Block> out;
  for (const Block* b : pointers<Block>(s)) out.push_back(*b);
  return out;
}

// All that a reader reads in paragraphs and tables, a line each.
inline std::string text_of(const document::Section& s) {
  std::string out;
  for (const document::Block& b : s.blocks) {
    if (const auto* p = std::get_if<document::Paragraph>(&b)) out += p->text + "\n";
    if (const auto* t = std::get_if<document::Table>(&b)) {
      out += t->caption + "\n";
      for (const auto& row : t->rows) {
        for (const std::string& cell : row) out += cell + " | ";
        out += "\n";
      }
    }
  }
  return out;
}

// The first table whose caption begins so.
inline const document::Table& table_of(const document::Section& s, const std::string& caption = "") {
  for (const document::Table* t : pointers<document::Table>(s))
    if (t->caption.starts_with(caption)) return *t;
  FAIL("no table \"" << caption << "\"");
  throw std::logic_error("not reached");
}

// The row of such a table that has this first cell.
inline std::vector<std::string> row_of(const document::Section& s, const std::string& caption, const std::string& first) {
  for (const document::Table* t : pointers<document::Table>(s))
    if (t->caption.starts_with(caption))
      for (const auto& row : t->rows)
        if (row.front() == first) return row;
  FAIL("no row " << first << " in the table \"" << caption << "\"");
  return {};
}

// A value by its name, of a section's result or of a whole report.
template <class Result>
double value(const Result& r, const std::string& name) {
  for (const document::Value& v : r.values)
    if (v.name == name) return v.value;
  FAIL("no value " << name);
  return 0;
}

// Every line of evidence passes but for so many that there is nothing to hold against.
inline bool proved(const document::Section& s, int not_examined = 0) {
  for (const document::Proof* p : pointers<document::Proof>(s))
    for (const document::Evidence& e : p->lines) {
      if (e.verdict() == document::Verdict::not_examined) --not_examined;
      if (e.failed()) return false;
    }
  return not_examined == 0;
}

// The same, and there are as many lines as told; -1: at least one.
inline void check_proofs(const document::Section& s, int lines = -1, int not_examined = 0) {
  int seen = 0;
  for (const document::Proof* p : pointers<document::Proof>(s))
    for (const document::Evidence& e : p->lines) {
      INFO(e.claim << ": " << e.value << " " << e.reason);
      if (e.verdict() == document::Verdict::not_examined) --not_examined;
      CHECK_FALSE(e.failed());
      ++seen;
    }
  CHECK(not_examined == 0);
  if (lines < 0)
    CHECK(seen > 0);
  else
    CHECK(seen == lines);
}

}  // namespace report_words
