// Slices, pictures and files of a workspace.
#include <core/numbers.hpp>
#include <reports/section/workspace/export_mesh.hpp>
#include <reports/section/workspace/export_npy.hpp>
#include <reports/section/workspace/index_map.hpp>
#include <reports/section/workspace/slice.hpp>
#include <reports/section/workspace/surface.hpp>
#include <reports/section/workspace/workspace.hpp>

#include <core/analysis/workspace/scan_of.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/stage.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace pmreport::section {

namespace {

constexpr std::size_t slice_points = 121, coarse_points = 41, surface_points = 65;  // along an axis
constexpr scene::Color membrane{0.10f, 0.45f, 0.75f, 0.28f};

// A scan over some of the axes, for pictures: evenly, whatever the section counts.
scan::Scan part_of(const Workspace& w, const std::vector<double>& at, const std::vector<std::size_t>& axes, std::size_t points) {
  scan::Scan out;
  out.at = at;
  for (const std::size_t a : axes) {
    scan::Axis axis = w.scan.points[a];
    if (axis.to < axis.from) std::swap(axis.from, axis.to);
    axis.count = points;
    out.points.push_back(axis);
  }
  return out;
}

// To the box of the points at which the value is not negative, and a step more, evenly. False: there are none.
bool narrow_to(scan::Scan& scan, const std::vector<double>& value) {
  std::vector<std::size_t> low(scan.points.size(), value.size()), high(scan.points.size(), 0);
  bool some = false;
  for (std::size_t k = 0; k < value.size(); ++k) {
    if (!(value[k] >= 0)) continue;
    some = true;
    std::size_t rest = k;
    for (std::size_t a = scan.points.size(); a-- > 0; rest /= scan.points[a].count) {
      const std::size_t at = rest % scan.points[a].count;
      low[a] = std::min(low[a], at), high[a] = std::max(high[a], at);
    }
  }
  for (std::size_t a = 0; some && a < scan.points.size(); ++a) {
    const scan::Axis axis = scan.points[a];
    scan.points[a].from = axis.value(low[a] > 0 ? low[a] - 1 : 0);
    scan.points[a].to = axis.value(std::min(high[a] + 1, axis.count - 1));
    scan.points[a].count = surface_points;
  }
  return some;
}

class Drawing {
 public:
  Drawing(const Context& context, const Workspace& w, const WorkspaceOptions& options, std::string id)
      : context_(context), machine_(context.analysis.machine()), w_(w), options_(options), id_(std::move(id)) {}

  Drawn all() {
    if (w_.scan.points.size() >= 2) slices();
    if (w_.scan.points.size() == 3) surface();
    counts();
    return std::move(out_);
  }

 private:
  const Coordinate& coordinate(std::size_t axis) const {
    return machine_.topology().coordinates[static_cast<std::size_t>(w_.scan.points[axis].input)];
  }
  // Where the slices are taken: through home, or through the middle of the range where home is beyond it; or as asked.
  std::vector<std::vector<double>> cuts() const {
    std::vector<double> middle = analysis::home_of(w_, machine_);
    for (const scan::Axis& a : w_.scan.points) {
      double& x = middle[static_cast<std::size_t>(a.input)];
      if (x < std::min(a.from, a.to) || x > std::max(a.from, a.to)) x = 0.5 * (a.from + a.to);
    }
    if (options_.slices.empty()) return {middle};
    std::vector<std::vector<double>> out;
    for (const Eigen::VectorXd& q : options_.slices) {
      out.push_back(middle);
      for (std::size_t i = 0; i < middle.size(); ++i)
        if (const double x = q(static_cast<Eigen::Index>(i)); !std::isnan(x)) out.back()[i] = x;
    }
    return out;
  }
  std::string held_words(const std::vector<double>& at, std::size_t first, std::size_t second) const {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const int input = static_cast<int>(i);
      if (input == w_.scan.points[first].input || input == w_.scan.points[second].input) continue;
      const Coordinate& c = machine_.topology().coordinates[i];
      parts.push_back(fmt::format("{} = {}", symbol(c.name), show(at[i], c.unit)));
    }
    return listed(parts, "and");
  }

  void slices() {
    figure::Figure figure{id_ + "-slices", "", "", figure::Width::full, 2, {}};
    std::vector<std::pair<std::size_t, std::size_t>> planes{{0, 1}};
    if (w_.scan.points.size() == 3) planes.emplace_back(0, 2);
    struct Slice {
      std::array<Coordinate, 2> coordinates;
      std::string title;
      scan::Scan scan;
      scan::Field field;
    };
    std::vector<Slice> slices;
    std::set<std::pair<std::size_t, std::vector<double>>> drawn;  // planes that differ in what they scan alone are one
    for (const std::vector<double>& at : cuts())
      for (const auto& [first, second] : planes) {
        std::vector<double> held = at;
        for (const std::size_t a : {first, second}) held[static_cast<std::size_t>(w_.scan.points[a].input)] = 0;
        if (!drawn.emplace(second, held).second) continue;
        context_.progress.stop_if_asked();
        const scan::Scan scan = part_of(w_, at, {first, second}, slice_points);
        slices.push_back({{coordinate(first), coordinate(second)}, held_words(at, first, second), scan, scan::sample_field(w_.set, scan)});
      }
    std::vector<const scan::Field*> fields;
    for (const Slice& s : slices) fields.push_back(&s.field);
    const std::vector<std::size_t> told = margins_to_tell(fields, w_.margins.margins);
    figure::Figure map{id_ + "-map", "", "", figure::Width::full, 2, {}};
    for (const auto& [coordinates, title, scan, field] : slices) {
      context_.progress.stop_if_asked();
      figure::Panel panel = slice_panel(field, coordinates, w_.margins.margins, told);
      panel.title = title;
      if (!options_.map.empty()) {
        figure::Panel over = index_panel(field.axes, index_over(machine_, w_, field, scan, options_.map), coordinates, {options_.map, ""});
        over.title = panel.title;
        over.named = panel.named;
        for (figure::NamedLine& line : over.named) line.label.clear();
        map.panels.push_back(std::move(over));
      }
      figure.panels.push_back(std::move(panel));
      if (!options_.exports) continue;
      out_.data.push_back(slice_data(fmt::format("{}-slice-{}", id_, figure.panels.size()), field, coordinates, w_.margins.margins));
      figure.data = "data/" + out_.data.front().name + ".csv";
    }
    figure.caption =
        "Slices through the workspace: accepted poses, and refused ones by the first limit that refuses them; the lines are the limits "
        "that bound what is accepted.";
    if (!w_.scan.orientations.empty()) figure.caption += " At one orientation alone.";
    map.caption =
        options_.map == "condition"
            ? "The condition number of the overall Jacobian, moments over the characteristic length, where poses are accepted."
            : "The determinant of the overall Jacobian, made dimensionless by the characteristic length, where poses are accepted.";
    add_in_parts(std::move(figure));
    if (!map.panels.empty()) add_in_parts(std::move(map));
    if (w_.grid && !w_.scan.orientations.empty() && w_.scan.points.size() == 2) {
      figure::Figure counts{
          id_ + "-orientations", "How many of the orientations are accepted at each point.", "", figure::Width::column, 1, {}};
      counts.panels.push_back(
          counts_panel(w_.scan.points, w_.grid->accepted_at, {coordinate(0), coordinate(1)}, w_.scan.orientation_count()));
      out_.blocks.emplace_back(std::move(counts));
    }
  }

  // So many panels that they stay readable in one figure, the others in figures of their own.
  void add_in_parts(figure::Figure whole) {
    constexpr std::size_t together = 4;
    const std::vector<figure::Panel> panels = std::move(whole.panels);
    for (std::size_t first = 0; first < panels.size(); first += together) {
      figure::Figure part = whole;
      if (first > 0) part.id += fmt::format("-{}", first / together + 1), part.caption += " (Continued.)";
      if (!part.data.empty()) part.data = fmt::format("data/{}-slice-{}.csv", id_, first + 1);
      const std::size_t last = std::min(panels.size(), first + together);
      part.panels.assign(panels.begin() + static_cast<std::ptrdiff_t>(first), panels.begin() + static_cast<std::ptrdiff_t>(last));
      out_.blocks.emplace_back(std::move(part));
    }
  }

  // What the set looks like along each axis.
  void projections(const scan::Field& field) {
    figure::Figure figure{id_ + "-projections",
                          "The workspace as it is seen along one coordinate: outline of all accepted poses, whatever that coordinate is.",
                          "",
                          figure::Width::full,
                          2,
                          {}};
    const std::vector<double> least = field.least();
    for (const auto& [first, second, along] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 1}}) {
      figure::Panel panel = outline_panel({field.axes[first], field.axes[second]}, largest_along_others(field.axes, least, first, second),
                                          {coordinate(first), coordinate(second)}, "");
      panel.title = "along " + symbol(coordinate(along).name);
      figure.panels.push_back(std::move(panel));
    }
    out_.blocks.emplace_back(std::move(figure));
  }

  void surface() {
    // A surface over other coordinates has no place beside the mechanism.
    const bool in_space = coordinate(0).name == "x" && coordinate(1).name == "y" && coordinate(2).name == "z";
    scene::Surface surface;
    if (w_.scan.orientations.empty()) {
      // Once over the whole range, and once more closely where the first look found anything.
      scan::Scan scan = part_of(w_, w_.scan.at, {0, 1, 2}, coarse_points);
      const std::vector<double> coarse = scan::sample_field(w_.set, scan).least();
      if (!narrow_to(scan, coarse)) return;
      const scan::Field field = scan::sample_field(w_.set, scan);
      surface = boundary_surface(field, w_.set.rounding);
      projections(field);
    } else if (w_.grid) {
      std::vector<double> value;
      for (const std::uint32_t n : w_.grid->accepted_at) value.push_back(n >= w_.request.at_least.front() ? 1 : -1);
      surface = boundary_surface(w_.scan.points, value);
    }
    if (surface.triangles.empty()) return;
    surface.color = membrane;
    if (options_.exports) {
      out_.files.push_back({"data/" + id_ + ".stl", "boundary of the workspace as a surface, binary STL [m]", to_stl(surface, id_)});
      out_.files.push_back({"data/" + id_ + ".ply", "the same as PLY [m]", to_ply(surface, id_)});
    }
    if (!options_.pictures || !in_space) return;
    scene::Bounds bounds;
    scene::include(bounds, machine_, machine_.home_pose());
    scene::include(bounds, surface);
    scene::Extras extras;
    extras.labels = false;
    extras.surfaces = {surface};
    const std::array views{View{"isometric", 45 * deg, std::atan(1 / std::numbers::sqrt2)}, View{"front", 0, 0}};
    std::vector<Stage::Ordered> ordered;
    for (const View& view : views)
      ordered.push_back(context_.stage.picture(machine_, machine_.home_pose(), extras, bounds, view, id_ + "-" + view.name,
                                               fmt::format("Boundary of the workspace, the mechanism at home, {} view", view.name),
                                               {1200, 900, false, 2}));
    document::Gallery gallery{{},
                              fmt::format("The boundary of the workspace of the {}, with the mechanism inside.",
                                          w_.tool ? "tool point" : "platform's reference point")};
    for (Stage::Ordered& o : ordered) {
      context_.progress.stop_if_asked();
      gallery.pictures.push_back(o.wait());
    }
    out_.blocks.emplace_back(std::move(gallery));
  }

  void counts() {
    if (!w_.grid || !options_.exports) return;
    std::vector<std::size_t> shape;
    for (const scan::Axis& a : w_.scan.points) shape.push_back(a.count);
    out_.files.push_back({"data/" + id_ + "-counts.npy",
                          "accepted orientations at each point of the grid, NPY, the scanned coordinates in order",
                          to_npy(shape, w_.grid->accepted_at)});
  }

  const Context& context_;
  const mechanics::Machine& machine_;
  const Workspace& w_;
  const WorkspaceOptions& options_;
  std::string id_;
  Drawn out_;
};

}  // namespace

Drawn draw_workspace(const Context& context, const Workspace& w, const WorkspaceOptions& options, const std::string& id) {
  return Drawing(context, w, options, id).all();
}

}  // namespace pmreport::section
