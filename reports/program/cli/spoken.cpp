#include <reports/program/cli/spoken.hpp>

#include <CLI/CLI.hpp>

namespace pmreport::program {

namespace {

// Those of "TEXT:{toml,klipper}", which is how CLI11 tells them.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.find('}');
  std::vector<std::string> out;
  if (begin == std::string::npos || end == std::string::npos) return out;
  for (std::size_t at = begin + 1; at < end;) {
    const std::size_t comma = std::min(type.find(',', at), end);
    out.push_back(type.substr(at, comma - at));
    at = comma + 1;
  }
  return out;
}

void add(const CLI::App& app, const std::vector<std::string>& words, SpokenCommand& out) {
  out.words = words;
  out.description = app.get_description();
  for (const CLI::Option* o : app.get_options()) {
    const std::string type = o->get_type_name();
    if (o->get_positional()) {
      out.arguments.push_back({o->get_single_name(), o->get_description(), o->get_required(), o->get_items_expected_max() > 1,
                               type.starts_with(mechanism_argument), choices_in(type)});
      continue;
    }
    SpokenOption option{{}, o->get_description(), o->get_items_expected_max() > 0, choices_in(type), o->get_group() == of_every_command};
    for (const std::string& name : o->get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : o->get_lnames()) option.names.push_back("--" + name);
    out.options.push_back(std::move(option));
  }
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    std::vector<std::string> longer = words;
    longer.push_back(below->get_name());
    add(*below, longer, out.commands.emplace_back());
  }
}

void append(const SpokenCommand& command, std::vector<const SpokenCommand*>& out) {
  out.push_back(&command);
  for (const SpokenCommand& below : command.commands) append(below, out);
}

}  // namespace

SpokenCommand spoken(const CLI::App& app) {
  SpokenCommand out;
  add(app, {}, out);
  return out;
}

std::vector<const SpokenCommand*> all_of(const SpokenCommand& program) {
  std::vector<const SpokenCommand*> out;
  append(program, out);
  return out;
}

}  // namespace pmreport::program
