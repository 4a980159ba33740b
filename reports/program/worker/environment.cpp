#include <reports/program/worker/environment.hpp>

#include <unistd.h>
#include <cstdlib>
#include <string>
#include <vector>

namespace pmreport::program {

bool matters(std::string_view variable) {
  for (const std::string_view prefix : {"PMREPORT_WORKER", "PANGO", "CAIRO_", "PIXMAN_", "FC_DEBUG", "G_", "MESA_", "GALLIUM_", "LP_",
                                        "LIBGL_", "DRAW_", "ST_DEBUG", "OSMESA_"})
    if (variable.starts_with(prefix)) return false;
  return true;
}

void forget_what_does_not_matter() {
  std::vector<std::string> names;
  for (char** e = environ; *e != nullptr; ++e)
    if (const std::string_view v = *e; !matters(v)) names.emplace_back(v.substr(0, v.find('=')));
  for (const std::string& name : names) unsetenv(name.c_str());
}

}  // namespace pmreport::program
