// What holds for every file of a controller's settings: it is refused with a reason, or what is made of it is TOML of these keys and no
// others, with sentences that end no comment: nothing of the file becomes part of the scenario but names and numbers.
#pragma once

#include <core/scenario/diagnostic.hpp>
#include <reports/program/import/imported.hpp>
#include <tests/fuzz/scratch.hpp>

#include <toml++/toml.h>

#include <algorithm>
#include <string>

namespace fuzz {

// The first letter says whose settings they are: L of LinuxCNC, an INI file and, from a line "%%" on, its HAL file; K of Klipper; else of
// Marlin.
inline pmreport::program::Imported imported(const std::string& input) {
  using namespace pmreport::program;
  static const Scratch folder;
  const std::string_view text = std::string_view(input).substr(std::min<std::size_t>(2, input.size()));
  if (input.starts_with('K')) return import_klipper(folder.put("printer.cfg", text));
  if (!input.starts_with('L')) return import_marlin({folder.put("Configuration.h", text)});
  const std::size_t cut = std::min(text.find("%%\n"), text.size());
  return import_linuxcnc(
      {folder.put("machine.ini", text.substr(0, cut)), folder.put("machine.hal", text.substr(std::min(cut + 3, text.size())))});
}

inline std::string broken_by_import(const std::string& input) {
  try {
    const pmreport::program::Imported made = imported(input);
    if (made.mechanism != "gough" && made.mechanism != "linear-delta") return "a mechanism that there is not: " + made.mechanism;
    if (made.title.empty() || has_control(made.title, "")) return "a title that is none";
    for (const auto* sentences : {&made.told, &made.not_taken})
      for (const std::string& s : *sentences)
        if (has_control(s, "")) return "a sentence that ends its comment: " + s;
    const toml::table all = toml::parse("[mechanism.parameters]\n" + made.parameters + "\n" + made.tables);
    for (const auto& [key, value] : all)
      if (key != "mechanism" && key != "limits" && key != "drive" && key != "drives")
        return "a table that no import makes: " + std::string(key.str());
  } catch (const pmreport::scenario::ScenarioError& e) {
    if (e.diagnostics.empty()) return "a refusal without a reason";
    for (const auto& d : e.diagnostics)
      if (d.message.empty() || has_control(to_string(d), "\n\t")) return "a refusal without words, or with a control character";
  } catch (const toml::parse_error& e) {
    return "what is no TOML: " + std::string(e.description());
  }
  return {};
}

}  // namespace fuzz
