// The machine of a plugin in plain C.
#pragma once

#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <string>

struct Slider {
  pmreport::host::PluginFile file;
  pmreport::mechanics::Machine machine;
  explicit Slider(const std::string& fixture)
      : file(pmreport::host::load_plugin(FIXTURES "/" + fixture + ".so")), machine(*file.mechanisms[0], {}) {}
};
