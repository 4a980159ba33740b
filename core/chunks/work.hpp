// Work that is cut in chunks, whose numbers do not depend on who does them, nor on how many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>

namespace pmreport::chunks {

struct Work {
  std::string name;           // within a run
  std::uint64_t meaning = 0;  // a hash of all that decides the answers: equal ones have equal answers
  std::size_t count = 0;      // of chunks
  bool everyone = false;      // what comes next needs the answers wherever the work goes on
};

// What the program does while work takes its time: it is told the share that is done, and asked whether to stop, which it tells by
// throwing. Asked by any of the threads; told by one at a time.
struct Watch {
  std::function<void(double share)> done = [](double) {};
  std::function<void()> stop_if_asked = [] {};
};

// FNV-1a over all that decides what is found.
class Meaning {
 public:
  template <class T>
  Meaning& operator<<(const T& x) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&x);
    for (std::size_t i = 0; i < sizeof(T); ++i) add(bytes[i]);
    return *this;
  }
  Meaning& operator<<(std::string_view text) {
    *this << text.size();
    for (const char c : text) add(static_cast<unsigned char>(c));
    return *this;
  }
  Meaning& operator<<(const std::string& text) { return *this << std::string_view(text); }
  std::uint64_t value() const { return value_; }

 private:
  void add(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }

  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace pmreport::chunks
