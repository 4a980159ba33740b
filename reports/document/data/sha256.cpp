#include <glib.h>

#include <memory>
#include <reports/document/data/sha256.hpp>

namespace pmreport::document {

std::string sha256(std::string_view bytes) {
  const std::unique_ptr<gchar, decltype(&g_free)> hex{
      g_compute_checksum_for_data(G_CHECKSUM_SHA256, reinterpret_cast<const guchar*>(bytes.data()), bytes.size()), g_free};
  return hex.get();
}

}  // namespace pmreport::document
