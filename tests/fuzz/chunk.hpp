// What holds for every file in the place of a chunk: it is what was kept there, or it counts for nothing.
#pragma once

#include <core/chunks/chunk_folder.hpp>
#include <tests/fuzz/answers.hpp>
#include <tests/fuzz/choices.hpp>
#include <tests/fuzz/scratch.hpp>

#include <string>

namespace fuzz {

// Input: what answers are read, and in which order; their bytes; then a file, or changes of one that was kept.
inline std::string broken_by_chunk(const std::string& input) {
  using namespace pmreport::chunks;
  static const Scratch scratch;
  static const ChunkFolder folder(scratch.path(), 5, {"fuzz", 7, 3});
  static const std::filesystem::path place = [] {
    folder.keep(1, {});
    return std::filesystem::directory_iterator(scratch.path())->path() / "1";
  }();
  Choices choices(input);
  const bool changed = choices.of(2) == 1;
  const std::string_view kinds = choices.text(choices.of(8));
  const std::string_view payload = choices.text(choices.take<std::uint8_t>());
  const auto* first = reinterpret_cast<const std::byte*>(payload.data());
  const Bytes kept(first, first + payload.size());
  if (std::string broken = broken_by_answers(kinds, kept); !broken.empty()) return broken;

  std::string file(choices.text(input.size()));
  if (changed) {
    folder.keep(1, kept);
    std::ifstream in(place, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    for (Choices c(file); c.more() && !bytes.empty();) {
      const std::size_t at = c.take<std::uint16_t>() % bytes.size();
      const auto with = c.take<std::uint8_t>();
      with == 255 ? bytes.resize(at) : void(bytes[at] = static_cast<char>(bytes[at] ^ with));
    }
    file = std::move(bytes);
  }
  std::ofstream(place, std::ios::binary | std::ios::trunc) << file;
  bool damaged = false;
  const std::optional<Bytes> loaded = folder.load(1, damaged);
  if (loaded.has_value() == damaged) return "a chunk that is neither whole nor damaged";
  if (!loaded) return {};
  folder.keep(1, *loaded);
  std::ifstream in(place, std::ios::binary);
  if (std::string(std::istreambuf_iterator<char>(in), {}) != file) return "a file was taken that nobody wrote";
  return changed && *loaded != kept ? "other answers than those that were kept" : "";
}

}  // namespace fuzz
