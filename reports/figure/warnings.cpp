#include <reports/figure/warnings.hpp>

#include <glib.h>

#include <mutex>
#include <stdexcept>
#include <string>

namespace pmreport::figure {

namespace {

struct Kept {
  std::mutex guard;
  std::string first;
};
Kept& kept() {
  static Kept& one = *new Kept;
  return one;
}

void keep(const gchar* domain, GLogLevelFlags level, const gchar* message, gpointer) {
  if ((level & (G_LOG_LEVEL_ERROR | G_LOG_LEVEL_CRITICAL | G_LOG_LEVEL_WARNING)) == 0) return;
  if ((level & G_LOG_FLAG_FATAL) != 0) {  // the process ends when this returns
    g_log_default_handler(domain, level, message, nullptr);
    return;
  }
  const std::lock_guard lock(kept().guard);
  if (kept().first.empty())
    kept().first = std::string(domain != nullptr ? domain : "a library") + ": " + (message != nullptr ? message : "");
}

}  // namespace

void keep_library_warnings() { g_log_set_default_handler(keep, nullptr); }

void throw_if_libraries_warned() {
  const std::lock_guard lock(kept().guard);
  if (kept().first.empty()) return;
  throw std::runtime_error("the report cannot be drawn as it should be (" + kept().first +
                           "); is fonts-dejavu-core installed and readable, and do `ulimit -n` and `ulimit -v` leave room?");
}

}  // namespace pmreport::figure
