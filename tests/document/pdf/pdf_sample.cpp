#include <tests/document/pdf/pdf_sample.hpp>

#include <cairo.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace sample {

using namespace pmreport;
using namespace pmreport::document;

std::string ball(int width, int height) {
  cairo_surface_t* const surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
  cairo_t* const cr = cairo_create(surface);
  cairo_scale(cr, width, width);
  cairo_set_source_rgb(cr, 0.86, 0.87, 0.89);
  cairo_rectangle(cr, 0.05, 0.55, 0.9, 0.1);
  cairo_fill(cr);
  cairo_pattern_t* const shade = cairo_pattern_create_radial(0.45, 0.3, 0.02, 0.5, 0.36, 0.24);
  cairo_pattern_add_color_stop_rgb(shade, 0, 0.75, 0.86, 0.97);
  cairo_pattern_add_color_stop_rgb(shade, 1, 0.08, 0.25, 0.45);
  cairo_set_source(cr, shade);
  cairo_arc(cr, 0.5, 0.36, 0.22, 0, 2 * std::numbers::pi);
  cairo_fill(cr);
  cairo_pattern_destroy(shade);
  std::string png;
  cairo_surface_write_to_png_stream(
      surface,
      [](void* closure, const unsigned char* data, unsigned int length) {
        static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
      },
      &png);
  cairo_destroy(cr);
  cairo_surface_destroy(surface);
  return png;
}

figure::Figure plot(const std::string& id, int panels, int columns) {
  figure::Figure f;
  f.id = id;
  f.caption = "The five limb lengths over the motion. Limb 3 comes near the end of its stroke at t = 4.9 s.";
  f.data = "data/displacement.csv";
  f.columns = columns;
  if (columns == 1 && panels == 1) f.width = figure::Width::column;
  for (int p = 0; p < panels; ++p) {
    figure::Panel panel{fmt::format("limb {}", p + 1), {"time", "s"}, {"length", "mm"}, {}, {}, {}};
    for (int s = 0; s < 3; ++s) {
      figure::Series series{fmt::format("l{}", s + 1), {}, {}, -1};
      for (int i = 0; i <= 500; ++i) {
        const double t = 10.0 * i / 500;
        series.x.push_back(t);
        series.y.push_back(i > 300 && i < 320 ? std::numeric_limits<double>::quiet_NaN()
                                              : 550 + 20 * std::sin(t + p) + 8 * std::cos(2 * t + s));
      }
      panel.series.push_back(series);
    }
    f.panels.push_back(panel);
  }
  return f;
}

Table grid(int rows, int columns) {
  Table t;
  t.caption = "Values at chosen times.";
  for (int j = 0; j < columns; ++j) {
    t.headings.push_back(j == 0 ? "time [s]" : fmt::format("q{} [mm]", j));
    t.numeric.push_back(true);
  }
  for (int i = 0; i < rows; ++i) {
    t.rows.emplace_back();
    for (int j = 0; j < columns; ++j) t.rows.back().push_back(fmt::format("{}.{:02}", i + 1, j));
  }
  return t;
}

Report full_report() {
  Report r;
  r.title = "4SPS-SPR: kinematics and statics <script>alert(1)</script> θ̇ J⁻¹ κ ≤ ∑ᵢ √∂";
  r.author = "Лев Толстой & Søren Ångström";
  r.mechanism_title = "4SPS-SPR, five degrees of freedom";
  r.source = "Wang et al. 2017, Kinematics and statics of a 4SPS-SPR parallel manipulator";
  r.description =
      "The platform makes a full turn of its working motion under a constant load. The report shows whether the limbs stay within their "
      "strokes and "
      "what the actuators must bear.";
  r.scenario_text = "title = \"4SPS-SPR\"\n\n[mechanism]\nuse = \"4sps-spr\"\t# by name\n\n[motion]\nx = \"20 mm * sin(2*pi*t/10 s)\"\n# " +
                    std::string(180, 'x') +
                    "\n# a long remark of many words that does not fit into one line of the listing and must go over to the next, "
                    "where it begins at the same place\n";
  for (int i = 0; i < 60; ++i) r.scenario_text += fmt::format("samples_{} = {}\n", i, 500 + i);
  r.summary = {{Paragraph::Tone::plain, "501 samples over 10 s; all can be reached."},
               {Paragraph::Tone::note, "The dependent coordinate y stays within 3.2 mm of zero."}};
  r.findings = {{Finding::Kind::fault,
                 "t = 1.32 s: limb 3 needs 812.4 mm, its stroke ends at 800.0 mm. Twelve samples break a limit; they are shaded in "
                 "the curves and keep their values in the data."}};

  Section mechanism{"mechanism", "mechanism", "The mechanism", {}};
  mechanism.blocks.push_back(Paragraph{Paragraph::Tone::plain,
                                       "Four limbs of spherical, prismatic and spherical joints and one of spherical, prismatic and "
                                       "revolute joints carry the platform."});
  mechanism.blocks.push_back(
      Table{"Joints.",
            {"joint", "kind", "from", "to", "limit min [°]", "limit max [°]", "remark"},
            {false, false, false, false, true, true, false},
            {{"A1", "spherical", "base", "cylinder 1", "-60", "60", "cone about the normal of the base"},
             {"B1", "spherical", "rod 1", "platform", "-60", "60", "cone about the normal of the platform, measured from the rod"},
             {"C1", "prismatic", "cylinder 1", "rod 1", "400 mm", "800 mm", "stroke"},
             {"A5", "spherical", "base", "cylinder 5", "-45", "45", ""},
             {"B5", "revolute", "rod 5", "platform", "-90", "90", "its axis is that of the platform's y"}}});
  Section snapshots{"snapshots", "snapshots", "Snapshots", {}};
  const std::string png = ball(1600, 1200);
  snapshots.blocks.push_back(Gallery{{{"s1", "t = 0 s, isometric", png, 1600, 1200},
                                      {"s2", "t = 2.5 s, isometric", png, 1600, 1200},
                                      {"s3", "t = 5 s, isometric", png, 1600, 1200}},
                                     "The mechanism at three times, seen from one place."});
  snapshots.blocks.push_back(Gallery{{{"s4", "t = 5 s, front", png, 1600, 1200}}, "The front."});
  Section displacement{"displacement", "displacement", "Displacement", {}};
  displacement.blocks.push_back(plot("displacement", 6, 2));
  displacement.blocks.push_back(plot("parasitic", 1, 1));
  displacement.blocks.push_back(grid(40, 8));
  displacement.blocks.push_back(Proof{
      {{"loop closure: every joint meets", "largest distance between the two halves of a joint, over all samples", 2.1e-15, 1e-9, "m"},
       {"forward displacement inverts inverse displacement", "Newton from the pose before, against the pose given", 3.4e-12, 2.5e-9, ""}}});
  Section velocity{"velocity", "velocity", "Velocity & <b>rates</b>", {}};
  velocity.blocks.push_back(Paragraph{Paragraph::Tone::note, "Rates come from the same geometry as lengths."});
  velocity.blocks.push_back(plot("velocity", 4, 2));
  velocity.blocks.push_back(Proof{{{"jets equal differences", "", 0.0012, 1e-6, ""},
                                   {"closed form equals the generic model", "", std::numeric_limits<double>::quiet_NaN(), 1e-9, "N"}}});
  Section acceleration{"acceleration", "acceleration", "Acceleration", {}};
  acceleration.blocks.push_back(plot("acceleration", 2, 2));
  acceleration.blocks.push_back(plot("acceleration2", 6, 2));
  Section statics{"statics", "statics", "Statics", {}};
  statics.blocks.push_back(plot("statics", 2, 1));
  statics.blocks.push_back(grid(75, 14));
  r.sections = {mechanism, snapshots, displacement, velocity, acceleration, statics};
  r.data = {{"displacement", {"t [s]"}, {{0, 1}}}, {"statics", {"t [s]"}, {{0, 1}}}};
  r.checks = {{"max(abs(actuator_force)) < 400 N", "312.4 N", "400 N", 312.4, 400, "N", true, "", 41},
              {"max(l3) < 800 mm", "812.4 mm", "800 mm", 0.8124, 0.8, "m", false,
               "t = 1.32 s: limb 3 needs 812.4 mm, its stroke ends at 800.0 mm", 45}};
  r.provenance = {"pmreport",      "1.0.0",
                  "4sps-spr 1.0",  "GNU 12.2.0, Release",
                  "4sps-spr.toml", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"};
  return r;
}

}  // namespace sample
