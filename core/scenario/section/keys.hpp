// Keys, each made in one line: its name, where it goes, what may stand there, what it means.
#pragma once

#include <core/scenario/section/kind.hpp>
#include <core/scenario/section/reading.hpp>
#include <memory>
#include <string>
#include <utility>

namespace pmreport::scenario {

// Options of a kind as they are unless a key says otherwise.
template <class O>
std::shared_ptr<Options> plain_options() {
  return std::make_shared<O>();
}

}  // namespace pmreport::scenario

namespace pmreport::scenario::keys {

// A key that is read in a way of its own: `read` is called as read(entry, reading, options) with options of type O.
template <class O, class Read>
Key of(std::string name, Shape shape, std::string meaning, std::string unset, Read read) {
  return {std::move(name),
          std::move(shape),
          std::move(meaning),
          std::move(unset),
          {},
          false,
          [read](const Entry& e, const Reading& r, Options& options) { read(e, r, static_cast<O&>(options)); }};
}
// What must stand, with an example of the line; what is read when all sections are known.
inline Key required(Key key, std::string example) {
  key.example = std::move(example);
  return key;
}
inline Key late(Key key) {
  key.late = true;
  return key;
}

template <class O>
Key text(std::string name, std::string O::*to, std::string meaning) {
  return of<O>(std::move(name), Shape::text(), std::move(meaning), "",
               [to](const Entry& e, const Reading& r, O& options) { options.*to = r.reader.text(e.value).value_or(""); });
}

template <class O>
Key boolean(std::string name, bool O::*to, std::string meaning) {
  return of<O>(std::move(name), Shape::boolean(), std::move(meaning), O().*to ? "`true`" : "`false`",
               [to](const Entry& e, const Reading& r, O& options) { options.*to = r.reader.boolean(e.value).value_or(options.*to); });
}

template <class O>
Key whole(std::string name, int O::*to, int least, int most, std::string meaning) {
  return of<O>(std::move(name), Shape::whole(least, most), std::move(meaning), std::to_string(O().*to),
               [=](const Entry& e, const Reading& r, O& options) {
                 options.*to = static_cast<int>(r.reader.integer(e.value, least, most).value_or(options.*to));
               });
}

// A key of a table within a section, which the table's own key reads.
inline Key within(std::string name, Shape shape, std::string meaning, std::string unset = {}) {
  return {std::move(name), std::move(shape), std::move(meaning), std::move(unset)};
}

}  // namespace pmreport::scenario::keys
