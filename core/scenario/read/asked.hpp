// What the reading code asks of a scenario: the keys of every table, and what it takes every value for. Whoever describes scenarios to
// others, such as editors, has one read and looks here, so that no description differs from what is read.
#pragma once

#include <core/scenario/read/document.hpp>
#include <core/scenario/section/key.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

struct Asked {
  struct Name {
    std::string key;
    bool needed = false;  // its absence is told
  };
  std::shared_ptr<const Value> document;           // that was read; what follows points into it
  std::map<const Value*, std::vector<Name>> keys;  // of tables, in the order in which they are asked for
  std::map<const Value*, Shape> taken;             // values, as what they were read last

  void note_key(const Value& table, std::string_view key, bool needed);
};

}  // namespace pmreport::scenario
