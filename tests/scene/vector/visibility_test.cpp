#include <cairo.h>

#include <catch2/catch.hpp>
#include <memory>
#include <random>
#include <reports/scene/look.hpp>
#include <reports/scene/vector/visibility.hpp>
#include <tests/scene/vector/nearest.hpp>

using namespace pmreport::scene;
using Eigen::Vector3d;

namespace {

constexpr int width = 800, height = 600;

struct Random {
  std::mt19937 engine;
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Vector3d vector(double half) { return {(*this)(-half, half), (*this)(-half, half), (*this)(-half, half)}; }
};

Solid box(const Vector3d& centre, const Vector3d& half, const Eigen::Matrix3d& axes) {
  return {Solid::Kind::box, centre, half, 0, axes, {}, {0, 0, 0}, 0};
}
Solid plate(const Vector3d& centre, const Eigen::Matrix3d& axes, double size, double thickness) {
  Solid s{Solid::Kind::plate, {0, 0, 0}, {0, 0, 0}, thickness, Eigen::Matrix3d::Identity(), {}, {0, 0, 0}, 0};
  for (int k = 0; k < 7; ++k) s.outline.push_back(centre + size * (std::cos(0.9 * k) * axes.col(0) + std::sin(0.9 * k) * axes.col(1)));
  return s;
}

// Limbs as mechanisms have them, and then anything: all of it runs into its neighbours.
Scene crowd(unsigned seed) {
  Random random{std::mt19937(seed)};
  Scene scene;
  const Color none{0, 0, 0};
  for (int k = 0; k < 7; ++k) {
    const Vector3d a = random.vector(0.4), b = random.vector(0.4), d = (b - a).normalized();
    scene.solids.push_back(cylinder(a, a + 0.6 * (b - a), 0.03, none));  // a tube
    scene.solids.push_back(cylinder(a + 0.4 * (b - a), b, 0.02, none));  // the rod in it
    scene.solids.push_back(ball(b, random(0.025, 0.05), none));
    scene.solids.push_back(cylinder(a - 0.05 * d.unitOrthogonal(), a + 0.05 * d.unitOrthogonal(), 0.03, none));
    scene.solids.push_back(cone(b, b + 0.1 * random.vector(1), 0.04, none));
  }
  for (int k = 0; k < 4; ++k) {
    const Eigen::Matrix3d axes = Eigen::Quaterniond(random(-1, 1), random(-1, 1), random(-1, 1), random(-1, 1)).normalized().matrix();
    scene.solids.push_back(plate(random.vector(0.3), axes, random(0.1, 0.3), random(0.005, 0.05)));
    scene.solids.push_back(box(random.vector(0.3), {random(0.02, 0.1), random(0.02, 0.1), random(0.02, 0.1)}, axes));
  }
  return scene;
}

// The regions in colours that count, without antialiasing.
class Raster {
 public:
  explicit Raster(const std::vector<Seen>& seen)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy) {
    const std::unique_ptr<cairo_t, void (*)(cairo_t*)> cr(cairo_create(surface_.get()), cairo_destroy);
    cairo_set_antialias(cr.get(), CAIRO_ANTIALIAS_NONE);
    for (const Seen& s : seen) {
      for (const auto& path : s.visible) {
        cairo_new_sub_path(cr.get());
        for (const auto& p : path) cairo_line_to(cr.get(), static_cast<double>(p.X) / fine, -static_cast<double>(p.Y) / fine);
        cairo_close_path(cr.get());
      }
      cairo_set_source_rgb(cr.get(), 0, 0, static_cast<double>(s.solid + 1) / 255);
      cairo_fill(cr.get());
    }
    cairo_surface_flush(surface_.get());
  }
  int at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_.get()) + y * cairo_image_surface_get_stride(surface_.get());
    return static_cast<int>(reinterpret_cast<const std::uint32_t*>(row)[x] & 255) - 1;
  }

 private:
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

struct Count {
  int looked = 0, on_solids = 0, near_edge = 0, wrong = 0;
};

// Pixels within 1 px of an edge are left out: there the chords of a drawing, none farther than 0.25 px from its circle, may differ.
Count compare(const Scene& scene, const View& view, int pixels, unsigned seed) {
  const Raster raster(look_at(scene, view, width, height));
  Random random{std::mt19937(seed)};
  Count count;
  for (int n = 0; n < pixels; ++n) {
    const int x = static_cast<int>(random(0, width)), y = static_cast<int>(random(0, height));
    const int expected = test::nearest(scene, view, x + 0.5, y + 0.5);
    bool edge = false;
    for (int k = 0; k < 8 && !edge; ++k)
      edge = test::nearest(scene, view, x + 0.5 + std::cos(k * 0.785398), y + 0.5 + std::sin(k * 0.785398)) != expected;
    ++count.looked;
    if (expected >= 0) ++count.on_solids;
    if (edge)
      ++count.near_edge;
    else if (raster.at(x, y) != expected)
      ++count.wrong;
  }
  return count;
}

}  // namespace

TEST_CASE("the visible regions of solids that run into one another show the solid that lines of sight meet first") {
  Count all;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    const Camera camera{{0, 0, 0}, 0.7 * seed, 0.15 * seed, 0.75};
    const Count c = compare(crowd(seed), View(camera, width, height), 1500, seed);
    all.looked += c.looked, all.on_solids += c.on_solids, all.near_edge += c.near_edge, all.wrong += c.wrong;
    CHECK(c.wrong == 0);
  }
  CAPTURE(all.looked, all.on_solids, all.near_edge, all.wrong);
  CHECK(all.looked == 12000);
  CHECK(all.on_solids > 3000);
  CHECK(all.near_edge < 0.05 * all.looked);
}

TEST_CASE("where two surfaces coincide one of them is seen, and no hole") {
  Scene scene;
  const Color none{0, 0, 0};
  scene.solids = {cylinder({-0.3, 0, 0}, {0.3, 0, 0}, 0.1, none), cylinder({-0.1, 0, 0}, {0.3, 0, 0}, 0.1, none),
                  cylinder({0.2, 0, 0}, {0.3, 0, 0}, 0.15, none), box({0, 0, -0.2}, {0.3, 0.1, 0.1}, Eigen::Matrix3d::Identity()),
                  box({0.1, 0, -0.2}, {0.2, 0.1, 0.1}, Eigen::Matrix3d::Identity())};
  for (const double azimuth : {0.0, 0.4, 1.5707963267948966})
    for (const double elevation : {0.0, 0.5, 1.5707963267948966}) {
      CAPTURE(azimuth, elevation);
      const View view({{0, 0, 0}, azimuth, elevation, 1}, width, height);
      const Raster raster(look_at(scene, view, width, height));
      int holes = 0;
      for (int y = 2; y < height - 2; y += 5)
        for (int x = 2; x < width - 2; x += 5) {
          bool inside = true;
          for (int k = 0; k < 8 && inside; ++k)
            inside = test::nearest(scene, view, x + 0.5 + std::cos(k * 0.785398), y + 0.5 + std::sin(k * 0.785398)) >= 0;
          if (inside && raster.at(x, y) < 0) ++holes;
        }
      CHECK(holes == 0);
    }
}

TEST_CASE("a ghost hides nothing but ghosts") {
  Scene scene;
  scene.solids = {ball({0, 0.5, 0}, 0.1, {0, 0, 0}), ball({0, 0, 0}, 0.2, {0, 0, 0, 0.3f}), ball({0, 0.2, 0}, 0.1, {0, 0, 0, 0.3f})};
  const std::vector<Seen> seen = look_at(scene, View({{0, 0, 0}, 0, 0, 1}, width, height), width, height);
  REQUIRE(seen.size() == 3);
  const double pixels = height * height * 3.14159265358979;
  CHECK(area(seen[0].visible) == Approx(0.01 * pixels).epsilon(0.02));
  CHECK(area(seen[1].visible) == Approx(0.04 * pixels).epsilon(0.02));
  CHECK(seen[2].visible.empty());
}

TEST_CASE("solids without extent, out of the picture or out of all numbers are left out") {
  Scene scene;
  const Color none{0, 0, 0};
  const double nan = std::nan("");
  scene.solids = {ball({0, 0, 0}, 0, none),
                  cylinder({0, 0, 0}, {0, 0, 0}, 0.1, none),
                  cylinder({nan, 0, 0}, {1, 0, 0}, 0.1, none),
                  ball({100, 0, 0}, 0.1, none),
                  cone({0, 0, 0}, {1e300, 0, 0}, 0.1, none),
                  box({0, 0, 0}, {0, 0, 0}, Eigen::Matrix3d::Identity()),
                  plate({0, 0, 0}, Eigen::Matrix3d::Zero(), 1, 0.1)};
  CHECK(look_at(scene, View({{0, 0, 0}, 0.3, 0.3, 1}, width, height), width, height).empty());
}

TEST_CASE("a line is hidden where it runs behind a solid, and where it runs inside one") {
  Scene scene;
  scene.solids = {ball({0, 0, 0}, 0.1, {0, 0, 0})};
  const View view({{0, 0, 0}, 0, 0, 1}, width, height);  // looks along +Y
  const std::vector<Seen> seen = look_at(scene, view, width, height);
  REQUIRE(seen.size() == 1);
  const auto at = [&](double x, double y) {
    const Vector3d p = view.see({x, y, 0});
    return Vector3d(p.x(), -p.y(), p.z());
  };
  const auto hidden = [&](double y) { return hidden_intervals(at(-0.4, y), at(0.4, y), seen, [](const Seen&) { return true; }); };
  CHECK(hidden(-0.2).empty());
  for (const double y : {0.0, 0.5}) {
    CAPTURE(y);
    const auto h = hidden(y);
    REQUIRE(h.size() == 1);
    CHECK(h[0].from == Approx(0.375).margin(0.002));
    CHECK(h[0].to == Approx(0.625).margin(0.002));
  }
}
