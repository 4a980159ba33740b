#include <fmt/core.h>

#include <core/host/refusal.hpp>

namespace pmreport::host {

void refuse(std::string_view where, std::string_view expected, std::string_view seen, std::string_view advice) {
  throw PluginError(fmt::format("{}: expected {}, seen {}; {}", where, expected, seen, advice));
}

std::string quoted(const char* text) { return text == nullptr ? "nothing" : quoted(std::string_view(text)); }

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string out = "'";
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f)
      out += fmt::format("\\x{:02x}", byte);
    else
      out += c;
  }
  return out + (text.size() > longest ? "...'" : "'");
}

}  // namespace pmreport::host
