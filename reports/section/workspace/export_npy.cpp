#include <reports/section/workspace/export_npy.hpp>

#include <bit>
#include <stdexcept>

namespace pmreport::section {

namespace {

void put(std::string& out, std::uint64_t bits, std::size_t bytes) {
  for (std::size_t k = 0; k < bytes; ++k) out += static_cast<char>(bits >> (8 * k) & 0xff);
}

// A tuple of Python: "(3,)", "(3, 4)". The header is filled up with spaces, so that the values begin at a multiple of 64 bytes.
std::string header(const std::string& kind, const std::vector<std::size_t>& shape, std::size_t values) {
  std::size_t places = 1;
  std::string tuple;
  for (const std::size_t n : shape) {
    places *= n;
    tuple += (tuple.empty() ? "" : ", ") + std::to_string(n);
  }
  if (places != values)
    throw std::invalid_argument("expected " + std::to_string(places) + " values for an array of this shape, saw " + std::to_string(values));
  std::string words = "{'descr': '" + kind + "', 'fortran_order': False, 'shape': (" + tuple + (shape.size() == 1 ? ",), }" : "), }");
  constexpr std::size_t before = 10;
  words.resize((before + words.size() + 1 + 63) / 64 * 64 - before - 1, ' ');
  words += '\n';
  std::string out("\x93NUMPY\x01\x00", 8);
  put(out, words.size(), 2);
  return out + words;
}

}  // namespace

std::string to_npy(const std::vector<std::size_t>& shape, const std::vector<std::uint32_t>& values) {
  std::string out = header("<u4", shape, values.size());
  out.reserve(out.size() + 4 * values.size());
  for (const std::uint32_t x : values) put(out, x, 4);
  return out;
}

std::string to_npy(const std::vector<std::size_t>& shape, const std::vector<double>& values) {
  std::string out = header("<f8", shape, values.size());
  out.reserve(out.size() + 8 * values.size());
  for (const double x : values) put(out, std::bit_cast<std::uint64_t>(x), 8);
  return out;
}

}  // namespace pmreport::section
