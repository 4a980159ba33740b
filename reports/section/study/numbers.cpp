// Which numbers of a scenario a study may look at, and what they are called.
#include <reports/section/study/keys.hpp>

#include <reports/section/workspace/options.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using analysis::MachineNumber;
using What = MachineNumber::What;

namespace {

// A number with the section that it comes from; of home there is none.
struct Offered {
  StudiedNumber number;
  const WorkspaceOptions* workspace = nullptr;
};

std::string within_quantities(std::string name) {
  name.erase(0, name.find('.') + 1);
  std::ranges::replace(name, '.', '_');
  return name;
}

std::vector<Offered> offered_by(const std::vector<scenario::Section>& sections, const Topology& topology) {
  std::vector<Offered> out;
  const auto add = [&](What what, const std::string& name, const std::string& unit, std::string title, std::string label,
                       const WorkspaceOptions* w, std::size_t axis) {
    const bool known = std::ranges::any_of(out, [&](const Offered& o) { return o.number.what.name == name; });
    if (!known) out.push_back({{{what, name, 0, axis}, within_quantities(name), unit, std::move(title), std::move(label)}, w});
  };
  for (const scenario::Section& s : sections) {
    const auto* w = dynamic_cast<const WorkspaceOptions*>(s.options.get());
    if (w == nullptr) continue;
    const bool named = !w->name.empty();
    const std::string of = named ? fmt::format("of the workspace {}", in_quotes(w->name)) : "of the workspace",
                      behind = named ? fmt::format(" ({})", w->name) : "";
    const std::size_t axes = w->request.scan.size();
    const char* const size = axes == 3 && w->unit == "m^3"   ? "volume"
                             : axes == 2 && w->unit == "m^2" ? "area"
                             : axes == 1                     ? "extent"
                                                             : "size";
    add(What::volume, quantity_name(*w, "volume"), w->unit, fmt::format("{} {}", size, of), size + behind, w, 0);
    for (std::size_t i = 0; i < axes; ++i) {
      const Coordinate& c = topology.coordinates[static_cast<std::size_t>(w->request.scan[i].coordinate)];
      add(What::low, quantity_name(*w, c.name + "_low"), c.unit, fmt::format("lower end {} in {}", of, c.name),
          c.name + ", lower end" + behind, w, i);
      add(What::high, quantity_name(*w, c.name + "_high"), c.unit, fmt::format("upper end {} in {}", of, c.name),
          c.name + ", upper end" + behind, w, i);
    }
  }
  add(What::condition, "home.condition", "", "condition number at home", "condition number", nullptr, 0);
  add(What::smallest_singular_value, "home.smallest_singular_value", "", "smallest singular value at home", "smallest singular value",
      nullptr, 0);
  return out;
}

std::vector<std::string> names_of(const std::vector<Offered>& offered) {
  std::vector<std::string> out;
  for (const Offered& o : offered) out.push_back(o.number.what.name);
  return out;
}

const Offered* found_in(const std::vector<Offered>& offered, const std::string& name) {
  const auto at = std::ranges::find_if(offered, [&](const Offered& o) { return o.number.what.name == name; });
  return at != offered.end() ? &*at : nullptr;
}

}  // namespace

std::optional<std::size_t> read_studied_number(const scenario::Value& value, const scenario::Reading& r, StudyOptions& options) {
  const auto name = r.reader.text(value);
  if (!name || !r.mechanism.topology) return std::nullopt;
  for (std::size_t i = 0; i < options.numbers.size(); ++i)
    if (options.numbers[i].what.name == *name) return i;
  const std::vector<Offered> offered = offered_by(r.measurable->sections, *r.mechanism.topology);
  const Offered* found = found_in(offered, *name);
  if (found == nullptr) {
    const std::vector<std::string> known = names_of(offered);
    const bool lacking = name->starts_with("workspace.") && !known.front().starts_with("workspace.");
    r.reader.diagnostics().add(
        value.place,
        lacking ? fmt::format("{} belongs to the section \"workspace\", which this scenario does not have", in_quotes(*name))
                : fmt::format("no number that a study could look at is called {}{}", in_quotes(*name), did_you_mean(*name, known)),
        lacking ? "add [[section]], kind = \"workspace\" and scan = { ... }" : fmt::format("they are {}", listed(known, "and")));
    return std::nullopt;
  }
  StudiedNumber number = found->number;
  if (found->workspace != nullptr) {
    const auto of = std::ranges::find(options.workspaces, found->workspace->name);
    number.what.workspace = static_cast<std::size_t>(of - options.workspaces.begin());
    if (of == options.workspaces.end()) {
      options.workspaces.push_back(found->workspace->name);
      options.study.requests.push_back(found->workspace->request);
    }
  }
  options.numbers.push_back(number);
  options.study.numbers.push_back(number.what);
  return options.numbers.size() - 1;
}

std::optional<std::vector<analysis::WorkspaceRequest>> requests_elsewhere(const StudyOptions& options, const scenario::Loaded& other,
                                                                          const scenario::Value& value, const scenario::Reader& reader) {
  const std::vector<Offered> offered = offered_by(other.scenario.sections, other.machine->topology());
  std::vector<analysis::WorkspaceRequest> out(options.study.requests.size());
  for (const StudiedNumber& n : options.numbers) {
    const Offered* found = found_in(offered, n.what.name);
    if (found == nullptr || found->number.unit != n.unit || found->number.what.axis != n.what.axis) {
      reader.diagnostics().add(value.place,
                               found == nullptr ? fmt::format("{} has no {}", in_quotes(value.text), n.what.name)
                                                : fmt::format("{} of {} is of another kind: [{}], and [{}] here", n.what.name,
                                                              in_quotes(value.text), found->number.unit, n.unit),
                               "its section \"workspace\" must scan the same coordinates in the same order, under the same name");
      return std::nullopt;
    }
    if (found->workspace != nullptr) out[n.what.workspace] = found->workspace->request;
  }
  return out;
}

}  // namespace pmreport::section
