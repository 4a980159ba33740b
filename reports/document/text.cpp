#include <fmt/format.h>
#include <glib.h>
#include <reports/document/text.hpp>

namespace pmreport::document {

namespace {

// Controls, those that turn the direction of what is read (words would seem to say what they do not), and what Unicode promises never to be
// a character: U+FDD0 to U+FDEF and the last two of every plane.
bool is_no_character(gunichar c) {
  if (c == '\t' || c == '\n' || c == '\r') return false;
  if ((c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069)) return true;
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || (c >= 0xfdd0 && c <= 0xfdef) || (c & 0xfffe) == 0xfffe;
}

}  // namespace

std::string clean(std::string_view raw) {
  std::string out;
  out.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size();) {
    const auto lead = static_cast<unsigned char>(raw[i]);
    if (lead < 0x80) {
      if (!is_no_character(lead)) out += raw[i];
      ++i;
      continue;
    }
    const gunichar c = g_utf8_get_char_validated(raw.data() + i, static_cast<gssize>(raw.size() - i));
    if (c >= 0x80000000u) {  // GLib's two marks for a sequence that is wrong or ends too early
      out += "\uFFFD";
      ++i;
      continue;
    }
    const auto length = static_cast<std::size_t>(g_unichar_to_utf8(c, nullptr));
    if (!is_no_character(c)) out += raw.substr(i, length);
    i += length;
  }
  return out;
}

std::string escape(std::string_view raw) {
  std::string out;
  for (const char c : clean(raw)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string base64(std::string_view bytes) {
  gchar* encoded = g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size());
  const std::string out = encoded;
  g_free(encoded);
  return out;
}

std::string size_of(std::size_t bytes) {
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double size = static_cast<double>(bytes);
  const char* const units[] = {"kB", "MB", "GB"};
  std::size_t unit = 0;
  for (size /= 1000; size >= 999.5 && unit < 2; size /= 1000) ++unit;
  return fmt::format("{:.{}f} {}", size, size < 9.95 ? 1 : 0, units[unit]);
}

}  // namespace pmreport::document
