// Bytes as a row of choices, for what is made of numbers and not of text. Where they end every choice is the first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace fuzz {

class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  bool more() const { return !bytes_.empty(); }
  // From 0 to n - 1, of one byte.
  std::size_t of(std::size_t n) { return take<std::uint8_t>() % n; }
  bool once_in(std::size_t n) { return of(n) == n - 1; }
  // As many bytes as it has; zeros where they end.
  template <class T>
  T take() {
    T out{};
    const std::string_view from = text(sizeof out);
    std::memcpy(&out, from.data(), from.size());
    return out;
  }
  // At most so many.
  std::string_view text(std::size_t most) {
    const std::string_view out = bytes_.substr(0, most);
    bytes_.remove_prefix(out.size());
    return out;
  }

 private:
  std::string_view bytes_;
};

}  // namespace fuzz
