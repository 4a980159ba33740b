#include <tests/document/sample.hpp>

#include <fmt/format.h>
#include <png.h>
#include <stdlib.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace sample {

namespace fs = std::filesystem;
using namespace pmreport;
using namespace pmreport::document;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

figure::Figure waves(const std::string& id, const std::string& data, figure::Width width, int panels) {
  figure::Figure f;
  f.id = id;
  f.caption = "Limb lengths of the moving platform against time; the shaded interval is where a limb is longer than its stroke allows.";
  f.data = data;
  f.width = width;
  for (int p = 0; p < panels; ++p) {
    figure::Panel panel{"limb lengths",        {"time", "s"}, {"length", "mm"}, {}, {{3.2, 4.1, figure::Band::Kind::limit}},
                        {{780, "stroke ends"}}};
    for (int s = 0; s < 5; ++s) {
      figure::Series series{fmt::format("l{}", s + 1), {}, {}, -1};
      for (int i = 0; i <= 200; ++i) {
        const double t = 0.05 * i;
        series.x.push_back(t);
        series.y.push_back(i > 120 && i < 130 ? nan : 640 + 60 * std::sin(0.6 * t * (p + 1) + s) + 20 * s);
      }
      panel.series.push_back(series);
    }
    f.panels.push_back(panel);
  }
  return f;
}

}  // namespace

std::string png(int width, int height, unsigned char grey) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_GRAY;
  const std::string pixels(static_cast<std::size_t>(width * height), static_cast<char>(grey));
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, pixels.data(), 0, nullptr);
  std::string out(size, '\0');
  png_image_write_to_memory(&image, out.data(), &size, 0, pixels.data(), 0, nullptr);
  return out;
}

Report report() {
  Report r;
  r.title = "4SPS-SPR: kinematics and statics";
  r.author = "J. Doe, Laboratory of Parallel Mechanisms";
  r.description = "A slow sway of the platform with a light load: the reference case of the laboratory's machine.";
  r.mechanism_title = "4SPS-SPR parallel manipulator, five degrees of freedom";
  r.source = "Wang et al. 2017";
  r.scenario_text =
      "title  = \"4SPS-SPR: kinematics and statics\"\n\n[mechanism]\nuse = \"4sps-spr\"\nparameters = { base_radius = \"400 mm\" }\n\n"
      "[motion]\nduration = \"10 s\"\nsamples  = 501\nx = \"20 mm * sin(2*pi*t/10 s)\"   # a sway\n\n"
      "[[check]]\nthat  = \"max(abs(actuator_force))\"\nbelow = \"400 N\"\n";
  r.summary = {{Paragraph::Tone::plain,
                "The limbs work between 587.9 mm and 731.4 mm; the largest actuator force is 312.4 N in limb 3 at t = 5.02 s."}};
  r.findings = {
      {Finding::Kind::fault, "t = 3.20 s to 4.10 s: limb 3 needs 812.4 mm, its stroke ends at 800.0 mm (45 samples).", "displacement"},
      {Finding::Kind::disagreement, "3 of 4 published values reproduce within their tolerances; 1 does not."},
      {Finding::Kind::result, "The local transmission index is 0.82 at least.", "nowhere"}};
  r.key_numbers = {{"Stroke used most", "812.4 mm", "it ends at 800.0 mm", "l₃, t = 3.6 s", "displacement", 1.07, 0.8124, 0.8, "m"},
                   {"Largest force of an actuator", "312.4 N", "checked: < 400 N", "l₃, t = 5.02 s", "statics", 0.781, 312.4, 400, "N"},
                   {"Volume of the workspace", "0.0123 m³"}};
  r.assumptions = {"Bodies are rigid and keep their declared sizes."};
  r.not_asked = {"dynamics", "workspace"};

  Section displacement{"displacement", "displacement", "Displacement", {}};
  displacement.blocks.push_back(Paragraph{
      Paragraph::Tone::plain, "Lengths of the limbs along the motion. The dependent coordinate y follows from the revolute joint."});
  displacement.blocks.push_back(waves("displacement", "data/displacement.csv", figure::Width::full, 2));
  displacement.blocks.push_back(Table{"Stroke of each limb",
                                      {"limb", "shortest [mm]", "longest [mm]", "stroke from [mm]", "to [mm]", "margin [mm]"},
                                      {false, true, true, true, true, true},
                                      {{"l1", "670.4", "701.2", "450.0", "800.0", "98.8"},
                                       {"l2", "587.9", "709.7", "450.0", "800.0", "90.3"},
                                       {"l3", "612.0", "812.4", "450.0", "800.0", "−12.4"}}});
  displacement.blocks.push_back(Paragraph{Paragraph::Tone::note, "Lengths are from joint centre to joint centre."});
  displacement.blocks.push_back(
      Proof{{{"loop closure: every joint meets", "largest distance between the two bodies' centres of a joint", 2.1e-16, 1e-9, "m"},
             {"forward displacement finds the pose again", "Newton from a guess 1 cm away against the pose that gave the lengths", 4.4e-13,
              1e-9, "m"},
             {"rates are the lengths' derivatives", "jets against differences in extended precision", 0, 1e-8, ""}}});

  Section statics{"statics", "statics", "Statics", {}};
  statics.blocks.push_back(waves("statics", "data/statics.csv", figure::Width::column, 1));
  statics.blocks.push_back(
      Gallery{{{"pose-0", "t = 0 s, isometric", png(64, 48, 230), 64, 48}, {"pose-5", "t = 5 s, isometric", png(64, 48, 200), 64, 48}},
              "The manipulator at both ends of its motion."});
  statics.blocks.push_back(Proof{{{"virtual power balances", "power of the actuators against that of the load", 3.26e-14, 1e-9, "W"}}});
  r.sections = {displacement, statics};

  r.data = {{"displacement", {"t [s]", "x [m]"}, {{0, 0.1, 0.2}, {0.1, nan, 1.0 / 3.0}}},
            {"statics", {"t [s]", "l1_force [N]"}, {{0, 1}, {312.4, -1e-300}}}};
  r.checks = {{"max(abs(actuator_force)) < 400 N", "312.4 N", "400 N", 312.4, 400, "N", true, "", 13}};
  r.values = {{"statics", "largest_actuator_force", "N", 312.4}};
  r.provenance = {"pmreport", "1.0.0", "4sps-spr", "pmreport 1.0.0 plugin", "demo.toml", std::string(64, 'a')};
  return r;
}

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "document-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

Folder::~Folder() { fs::remove_all(path_); }

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> content;
  if (!fs::is_directory(folder)) return content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) content[entry.path().lexically_relative(folder).string()] = bytes_of(entry.path());
  }
  return content;
}

void put(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

}  // namespace sample
