// Numbers and texts as bytes and back: what a chunk's answers are kept as. As this machine has them; a folder of chunks is for machines
// that are alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pmreport::chunks {

using Bytes = std::vector<std::byte>;

// What is read is not what was written.
struct NotReadable : std::runtime_error {
  NotReadable() : std::runtime_error("a chunk is not as it was written") {}
};

class Writer {
 public:
  template <class T>
  requires(std::is_integral_v<T> || std::is_enum_v<T>) void put(T x) { append(&x, sizeof x); }
  void put(double x) { append(&x, sizeof x); }
  void put(std::string_view text) {
    put(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  void put(const char* text) { put(std::string_view(text)); }
  // Of a list: how many, and each.
  template <class T>
  void put(const std::vector<T>& list) {
    put(std::uint64_t{list.size()});
    for (const T& x : list) put(x);
  }
  void put(const std::vector<double>& list) {
    put(std::uint64_t{list.size()});
    put_all(list);
  }
  // Without their count.
  void put_all(std::span<const double> numbers) { append(numbers.data(), numbers.size_bytes()); }
  // Whole numbers, many of which are like the one before: each with how often it follows.
  template <class T>
  void put_runs(std::span<const T> numbers) {
    for (std::size_t first = 0; first < numbers.size();) {
      std::size_t end = first + 1;
      while (end < numbers.size() && numbers[end] == numbers[first]) ++end;
      put_short(numbers[first]);
      put_short(end - first);
      first = end;
    }
  }

  // Room for so many bytes, which grows where they are not enough.
  void reserve(std::size_t bytes) { bytes_.reserve(bytes); }
  Bytes take() { return std::move(bytes_); }

 private:
  void append(const void* from, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  // Seven bits a byte, the lowest first.
  void put_short(std::uint64_t x) {
    for (; x > 127; x >>= 7) bytes_.push_back(static_cast<std::byte>((x & 127) | 128));
    bytes_.push_back(static_cast<std::byte>(x));
  }

  Bytes bytes_;
};

// Each `get` is that of a `put`. Throws NotReadable where bytes are too few or make no sense.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void get(T& x) { copy(&x, sizeof x); }
  void get(bool& x) {
    std::uint8_t byte = 0;
    get(byte);
    x = byte != 0;
  }
  void get(std::string& text) {
    const std::size_t size = count(1);
    text.assign(reinterpret_cast<const char*>(bytes_.data()), size);
    bytes_ = bytes_.subspan(size);
  }
  template <class T>
  void get(std::vector<T>& list) {
    list.resize(count(std::is_same_v<T, double> ? sizeof(double) : 1));
    for (T& x : list) get(x);
  }
  void get_all(std::span<double> numbers) { copy(numbers.data(), numbers.size_bytes()); }
  template <class T>
  void get_runs(std::span<T> numbers) {
    for (std::size_t first = 0; first < numbers.size();) {
      const std::uint64_t value = get_short(), times = get_short();
      if (times == 0 || times > numbers.size() - first || value != static_cast<T>(value)) throw NotReadable();
      for (std::uint64_t i = 0; i < times; ++i) numbers[first++] = static_cast<T>(value);
    }
  }
  // To be called last: nothing may be left.
  void end() const {
    if (!bytes_.empty()) throw NotReadable();
  }

 private:
  void copy(void* to, std::size_t size) {
    if (size > bytes_.size()) throw NotReadable();
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  // No more of them than there are bytes for.
  std::size_t count(std::size_t bytes_each) {
    std::uint64_t n = 0;
    get(n);
    if (n > bytes_.size() / bytes_each) throw NotReadable();
    return static_cast<std::size_t>(n);
  }
  std::uint64_t get_short() {
    std::uint64_t x = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      std::uint8_t byte = 0;
      get(byte);
      x |= std::uint64_t{byte & 127u} << shift;
      if (byte < 128) return x;
    }
    throw NotReadable();
  }

  std::span<const std::byte> bytes_;
};

}  // namespace pmreport::chunks
