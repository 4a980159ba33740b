#include <core/numbers.hpp>
#include <reports/section/snapshots/snapshots.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr int smallest_picture = 64, largest_picture = 8000;  // [px]; drawn at twice the size, and 16384 is the renderer's end
constexpr int most_overlaid = 12;
constexpr std::size_t most_times = 100, most_views = 20;
const std::vector<std::string> grounds{"white", "transparent"};

// The camera stands in front at azimuth 0, looking along +Y, and on the right at 90°, looking along -X.
const std::vector<View>& named_views() {
  static const std::vector<View> all{
      {"auto", 0, 0},       {"isometric", 45 * deg, 35.264389682754654 * deg},  // atan(1/√2): the three axes look equally long
      {"front", 0, 0},      {"side", 90 * deg, 0},
      {"top", 0, 90 * deg},
  };
  return all;
}

std::optional<View> read_view(const scenario::Value& value, const scenario::Reader& reader) {
  if (value.kind == scenario::Value::Kind::table) {
    scenario::TableReader table(value, "a view", value.place, reader);
    const scenario::Entry *azimuth = table.need("azimuth", "{azimuth = \"30 deg\", elevation = \"20 deg\"}"),
                          *elevation = table.find("elevation");
    table.finish();
    View view = view_at(0, 0);
    for (const auto& [entry, angle] : {std::pair{azimuth, &view.azimuth}, {elevation, &view.elevation}}) {
      if (entry == nullptr) continue;
      const auto given = reader.quantity(entry->value, {0, 0, 0, 1});
      if (!given) return std::nullopt;
      *angle = *given;
    }
    if (std::abs(view.elevation) > 90.000001 * deg) {  // a millionth of a degree for rounding
      reader.diagnostics().add(elevation->value.place, fmt::format("expected an elevation from -90 deg to 90 deg, seen {} deg",
                                                                   format_number(view.elevation / deg, 6)));
      return std::nullopt;
    }
    return view_at(view.azimuth, view.elevation);
  }
  std::vector<std::string> names;
  for (const View& v : named_views()) names.push_back(v.name);
  if (value.kind != scenario::Value::Kind::text && value.kind != scenario::Value::Kind::refused) {
    reader.diagnostics().add(value.place, fmt::format("expected a view, seen {}", name_of(value)),
                             fmt::format("write {}, or {{azimuth = \"30 deg\", elevation = \"20 deg\"}}", listed(names, "or", true)));
    return std::nullopt;
  }
  const auto index = reader.word(value, names, "the views");
  return index ? std::optional(named_views()[*index]) : std::nullopt;
}

std::vector<std::string> names_of_views() {
  std::vector<std::string> names;
  for (const View& v : named_views()) names.push_back(v.name);
  return names;
}

void read_times(const scenario::Entry& e, const scenario::Reading& r, SnapshotsOptions& options) {
  for (const scenario::Value& item : items_of(e, most_times, r.reader))
    options.times.push_back(read_time(item, r.span, r.reader).value_or(0));
}

void read_views(const scenario::Entry& e, const scenario::Reading& r, SnapshotsOptions& options) {
  for (const scenario::Value& item : items_of(e, most_views, r.reader)) {
    auto view = read_view(item, r.reader);
    if (!view) continue;
    if (std::any_of(options.views.begin(), options.views.end(), [&](const View& v) { return v.name == view->name; }))
      r.reader.diagnostics().add(item.place, fmt::format("the view {} stands here twice", in_quotes(view->name)));
    options.views.push_back(std::move(*view));
  }
}

void read_size(const scenario::Entry& e, const scenario::Reading& r, SnapshotsOptions& options) {
  if (const auto* size = r.reader.list(e.value, 2, "width and height in pixels"))
    for (const std::size_t i : {0u, 1u})
      if (const auto pixels = r.reader.integer((*size)[i], smallest_picture, largest_picture))
        (i == 0 ? options.width : options.height) = static_cast<int>(*pixels);
}

void read_overlay(const scenario::Entry& e, const scenario::Reading& r, SnapshotsOptions& options) {
  const auto count = r.reader.integer(e.value, 0, most_overlaid);
  if (!count) return;
  if (*count == 1)
    r.reader.diagnostics().add(e.value.place, fmt::format("expected 2 to {} poses, or 0 for no such picture, seen 1", most_overlaid));
  options.overlay = static_cast<int>(*count);
}

void read_ground(const scenario::Entry& e, const scenario::Reading& r, SnapshotsOptions& options) {
  if (const auto ground = r.reader.word(e.value, grounds, "the grounds")) options.transparent = *ground == 1;
}

void complete(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options) {
  auto& own = static_cast<SnapshotsOptions&>(options);
  if (table.find("times") == nullptr && !(r.span && r.span->empty())) own.times = {r.span ? r.span->begin : 0};  // else home
  if (own.views.empty()) own.views = {named_views().front()};
}

std::vector<scenario::Key> all_keys() {
  using O = SnapshotsOptions;
  const Shape angle = Shape::quantity(Dimension{0, 0, 0, 1});
  const Shape view =
      Shape::either({Shape::word(names_of_views()),
                     Shape::table({keys::within("azimuth", angle, "of the camera"), keys::within("elevation", angle, "", "0°")})});
  return {keys::of<O>("times", Shape::list(1, most_times, Shape::quantity(Dimension{0, 0, 1, 0})), "of the motion", "its beginning",
                      read_times),
          keys::of<O>("views", Shape::list(1, most_views, view), "where the camera stands; `auto`: isometric, or where more is seen",
                      "`\"auto\"`", read_views),
          keys::of<O>("overlay", Shape::whole(0, most_overlaid), "poses laid over one another in one more picture; `0` for none",
                      "`5`, in the first section of snapshots of a motion", read_overlay),
          keys::of<O>("size", Shape::list(2, 2, Shape::whole(smallest_picture, largest_picture)), "width and height in pixels",
                      "`[1600, 1200]`", read_size),
          keys::of<O>("ground", Shape::word(grounds), "behind the mechanism", "`\"white\"`", read_ground),
          keys::boolean<O>("path", &O::path, "whether the way of the reference point is drawn"),
          keys::boolean<O>("labels", &O::labels, "whether labels are drawn"),
          keys::boolean<O>("frames", &O::frames, "whether frames are drawn"),
          keys::boolean<O>("load", &O::load, "whether the load is drawn")};
}

// Pixels of all of them may wait to be packed, and are there packed; of one at a time more is held, as it is put on a page.
MemoryNeed::Part memory_of(const SnapshotsOptions& o) {
  constexpr double of_waiting = 5.5, of_one = 2;
  const double pixels = static_cast<double>(o.width) * o.height;
  const auto pictures = static_cast<double>(std::max<std::size_t>(1, o.times.size()) * o.views.size()) + (o.overlay != 0 ? 1 : 0);
  return {pixels * (pictures * of_waiting + of_one), fmt::format("{} pictures of {} x {} pixels", pictures, o.width, o.height),
          "smaller or fewer pictures"};
}

}  // namespace

const SectionKind& snapshots_kind() {
  static const SectionKind kind{
      {.name = "snapshots",
       .purpose = "pictures of the mechanism at times of the motion",
       .several = true,
       .keys = all_keys(),
       .needs = {.motion = false, .pictures = true},
       .make_options = scenario::plain_options<SnapshotsOptions>,
       .complete = complete},
      [](const Context& c, const scenario::Section& s) {
        return snapshots_section(c.analysis, options_of<SnapshotsOptions>(s), c.stage, c.progress, c.number);
      },
      false,
      [](const scenario::Loaded&, const scenario::Section& s, bool) { return memory_of(options_of<SnapshotsOptions>(s)); }};
  return kind;
}

}  // namespace pmreport::section
