#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>
#include <numbers>

namespace pmreport::scenario {
namespace {

constexpr double deg = std::numbers::pi / 180;
constexpr int smallest_picture = 64, largest_picture = 8000;  // [px]; drawn at twice the size, and 16384 is the renderer's end
constexpr std::size_t most_times = 100, most_views = 20;

// The camera stands in front at azimuth 0, looking along +Y, and on the right at 90°, looking along -X.
const std::vector<View>& named_views() {
  static const std::vector<View> all{
      {"isometric", 45 * deg, 35.264389682754654 * deg},  // atan(1/√2): the three axes look equally long
      {"front", 0, 0},
      {"side", 90 * deg, 0},
      {"top", 0, 90 * deg},
  };
  return all;
}

std::optional<View> read_view(const Value& value, const Reader& reader) {
  if (value.kind == Value::Kind::table) {
    TableReader table(value, "a view", value.place, reader);
    const Entry *azimuth = table.need("azimuth", "{azimuth = \"30 deg\", elevation = \"20 deg\"}"), *elevation = table.find("elevation");
    table.finish();
    View view{"", 0, 0};
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
    view.name = fmt::format("azimuth {}°, elevation {}°", format_number(view.azimuth / deg, 4), format_number(view.elevation / deg, 4));
    return view;
  }
  std::vector<std::string> names;
  for (const View& v : named_views()) names.push_back(v.name);
  if (value.kind != Value::Kind::text && value.kind != Value::Kind::refused) {
    reader.diagnostics().add(value.place, fmt::format("expected a view, seen {}", name_of(value)),
                             fmt::format("write {}, or {{azimuth = \"30 deg\", elevation = \"20 deg\"}}", listed(names, "or", true)));
    return std::nullopt;
  }
  const auto index = reader.word(value, names, "the views");
  return index ? std::optional(named_views()[*index]) : std::nullopt;
}

}  // namespace

void read_snapshots(TableReader& table, const std::optional<TimeSpan>& span, SectionRequest& request) {
  const Reader& reader = table.read();
  if (const Entry* e = table.find("times"))
    for (const Value& item : items_of(*e, most_times, reader)) request.times.push_back(read_time(item, span, reader).value_or(0));
  else if (!span || !span->empty())  // else home
    request.times = {span ? span->begin : 0};
  if (const Entry* e = table.find("views"))
    for (const Value& item : items_of(*e, most_views, reader)) {
      auto view = read_view(item, reader);
      if (!view) continue;
      if (std::any_of(request.views.begin(), request.views.end(), [&](const View& v) { return v.name == view->name; }))
        reader.diagnostics().add(item.place, fmt::format("the view {} stands here twice", in_quotes(view->name)));
      request.views.push_back(std::move(*view));
    }
  if (request.views.empty()) request.views = {named_views().front()};
  if (const Entry* e = table.find("size"))
    if (const auto* size = reader.list(e->value, 2, "width and height in pixels"))
      for (const std::size_t i : {0u, 1u})
        if (const auto pixels = reader.integer((*size)[i], smallest_picture, largest_picture))
          (i == 0 ? request.width : request.height) = static_cast<int>(*pixels);
  if (const Entry* e = table.find("ground"))
    if (const auto ground = reader.word(e->value, {"white", "transparent"}, "the grounds")) request.transparent = *ground == 1;
  const std::pair<const char*, bool*> switches[] = {
      {"path", &request.path}, {"labels", &request.labels}, {"frames", &request.frames}, {"load", &request.load}};
  for (const auto& [key, flag] : switches)
    if (const Entry* e = table.find(key)) *flag = reader.boolean(e->value).value_or(*flag);
}

}  // namespace pmreport::scenario
