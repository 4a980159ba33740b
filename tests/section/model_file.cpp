// The model of the machine that goes with a report.
#include <reports/section/make_report.hpp>
#include <tests/scene/glb.hpp>
#include <tests/section/gantry.hpp>
#include <tests/section/whole_report.hpp>

using namespace pmreport;

namespace {

document::Report report(const std::string& motion, const std::string& more) {
  return whole_report::report_of("title = \"Gantry\"\n[mechanism]\nuse = \"gantry\"\n" + motion + more, gantry::source());
}
std::string motion(int samples) {
  return "[motion]\nduration = \"2 s\"\nsamples = " + std::to_string(samples) + "\nx = \"50 mm * (1 + sin(2*pi*t/2 s))\"\n";
}
const std::string snapshots = "[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\"]\nsize = [80, 64]\n";
const std::string portrait = "[[section]]\nkind = \"mechanism\"\n";

std::vector<std::string> models_of(const document::Report& r) {
  std::vector<std::string> out;
  for (const document::File& f : r.files)
    if (f.name == "data/model.glb") out.push_back(f.bytes);
  return out;
}

}  // namespace

TEST_CASE("a report with pictures of a motion brings the machine as an animated model") {
  const document::Report r = report(motion(21), snapshots);
  REQUIRE(models_of(r).size() == 1);
  CHECK(r.files.back().title == "the machine as a 3D model, with the motion as animation (glTF 2.0)");
  const glb::File file(models_of(r)[0]);
  std::vector<double> times;
  const std::vector<double> at = file.keys("platform", "translation", &times);
  REQUIRE(times.size() == 21);
  CHECK(times[7] == Approx(0.7));
  CHECK((glb::vector(at, 0) - Eigen::Vector3d(0.05, 0, 0)).norm() < 1e-8);  // single precision of 0.1 m
  CHECK((glb::vector(at, 5) - Eigen::Vector3d(0.1, 0, 0)).norm() < 1e-8);
  CHECK(models_of(report(motion(21), snapshots)) == models_of(r));
}

TEST_CASE("a long motion is thinned to 240 keys, from its first sample to its last") {
  const glb::File file(models_of(report(motion(1001), snapshots)).at(0));
  std::vector<double> times;
  file.keys("platform", "translation", &times);
  REQUIRE(times.size() == 240);
  CHECK(times.front() == 0);
  CHECK(times.back() == 2);
  for (std::size_t k = 1; k < times.size(); ++k) CHECK(times[k] - times[k - 1] < 0.0101);  // every fourth or fifth sample
}

TEST_CASE("samples out of reach are no keys") {
  // The feeler reaches 200 mm; beyond it are the samples at 0.4, 0.5 and 0.6 s, and a second later.
  const document::Report r = whole_report::of_stage(", dependent = \"phi\"", "x = \"0 mm\"\ny = \"220 mm * sin(2*pi*t/2 s)\"\n", snapshots);
  std::vector<double> times;
  glb::File(models_of(r).at(0)).keys("table", "rotation", &times);
  REQUIRE(times.size() == 15);
  CHECK(times[3] == Approx(0.3));
  CHECK(times[4] == Approx(0.7));
}

TEST_CASE("without a motion the model stands at home, and without pictures there is none") {
  const document::Report still = report("", portrait);
  REQUIRE(models_of(still).size() == 1);
  CHECK(still.files.back().title == "the machine as a 3D model (glTF 2.0)");
  CHECK_FALSE(glb::File(models_of(still)[0]).json.contains("animations"));
  CHECK(models_of(report(motion(21), "[[section]]\nkind = \"displacement\"\n")).empty());
}
