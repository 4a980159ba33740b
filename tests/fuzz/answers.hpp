// What holds for every row of bytes that is read as a chunk's answers: it is none, or what was read is written and read again as the same.
#pragma once

#include <core/chunks/bytes.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

using pmreport::chunks::Bytes;

// As a chunk's answers, of which `kinds` tells the order.
struct Answers {
  explicit Answers(std::string_view order) : kinds(order) {}
  std::string_view kinds;
  std::vector<std::string> texts;
  std::vector<std::vector<double>> lists;
  std::vector<std::vector<std::string>> lists_of_texts;
  std::vector<std::array<std::uint32_t, 9>> runs;
  std::vector<std::uint64_t> numbers;

  void read(pmreport::chunks::Reader r) {
    for (const char kind : kinds) switch (kind & 7) {
        case 0:
          r.get(texts.emplace_back());
          break;
        case 1:
          r.get(lists.emplace_back());
          break;
        case 2:
          r.get(lists_of_texts.emplace_back());
          break;
        case 3:
          r.get_runs(std::span<std::uint32_t>(runs.emplace_back()));
          break;
        default:
          r.get(numbers.emplace_back());
      }
    r.end();
  }
  Bytes written() const {
    pmreport::chunks::Writer w;
    std::size_t text = 0, list = 0, of_texts = 0, run = 0, number = 0;
    for (const char kind : kinds) switch (kind & 7) {
        case 0:
          w.put(texts[text++]);
          break;
        case 1:
          w.put(lists[list++]);
          break;
        case 2:
          w.put(lists_of_texts[of_texts++]);
          break;
        case 3:
          w.put_runs(std::span<const std::uint32_t>(runs[run++]));
          break;
        default:
          w.put(numbers[number++]);
      }
    return w.take();
  }
};

inline std::string broken_by_answers(std::string_view kinds, const Bytes& bytes) {
  Answers first(kinds), second(kinds);
  try {
    first.read(pmreport::chunks::Reader(bytes));
  } catch (const pmreport::chunks::NotReadable&) {
    return {};
  }
  const Bytes again = first.written();
  try {
    second.read(pmreport::chunks::Reader(again));
  } catch (const pmreport::chunks::NotReadable&) {
    return "what was written cannot be read";
  }
  return second.written() == again ? "" : "what was written is read as something else";
}

}  // namespace fuzz
