// What Ren and Zhang 2025 claim of their stiffness maps and of Table 2, by their own model and with the bending that it leaves out.
#include <core/mechanics/stiffness/answers.hpp>
#include <tests/plugins/plugin.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::choice, test::plugin, test::values_with;

namespace {

constexpr double E = 2.1e11, S = std::numbers::pi * 0.015 * 0.015;

class Model {
 public:
  explicit Model(bool bending, const char* sigma = "-1", std::map<std::string, std::vector<double>> more = {})
      : machine_(plugin("p2prpu-prps"),
                 [&] {
                   more["limb_bending"] = {choice(plugin("p2prpu-prps"), "limb_bending", bending ? "full" : "couples")};
                   more["sigma"] = {choice(plugin("p2prpu-prps"), "sigma", sigma)};
                   return values_with(plugin("p2prpu-prps"), more);
                 }()),
        statics_(machine_) {}

  DeformationIndices at(double x, double y, double z, double alpha = 0, double beta = 0) {
    Eigen::VectorXd q(5);
    q << x, y, z, alpha, beta;
    const ElasticPose p = statics_.at(q, Vector6d::Zero(), Eigen::Vector3d::Zero(), {false, false});
    REQUIRE(p.known);
    return deformation_indices(p.compliance);
  }

 private:
  Machine machine_;
  Elastostatics statics_;
};

std::vector<double> from_to(double from, double to, int count) {
  std::vector<double> out;
  for (int k = 0; k < count; ++k) out.push_back(from + (to - from) * k / (count - 1));
  return out;
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double mx = 0, my = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i)
    xx += (x[i] - mx) * (x[i] - mx), yy += (y[i] - my) * (y[i] - my), xy += (x[i] - mx) * (y[i] - my);
  return xy / std::sqrt(xx * yy);
}

}  // namespace

TEST_CASE("the indices of P(2PRPU)/PRPS at (0.8, 0, 1.15) m, by the paper's model, and 19037 times its pF_max with bending") {
  const DeformationIndices i = Model(false).at(0.8, 0, 1.15), bent = Model(true).at(0.8, 0, 1.15);
  CHECK(i.pF_max == Approx(4.597e-9).epsilon(2e-4));
  CHECK(i.pF_min == Approx(2.695e-9).epsilon(2e-4));
  CHECK(i.pT_max == Approx(1.992e-8).epsilon(3e-4));
  CHECK(i.pT_min <= 1e-12 * i.pT_max);
  CHECK(i.PhiT_max == Approx(2.760e-7).epsilon(2e-4));
  CHECK(i.PhiT_min == Approx(5.613e-8).epsilon(2e-4));
  CHECK(bent.pF_max == Approx(8.75e-5).epsilon(1e-3));
  CHECK(std::round(bent.pF_max / i.pF_max) == 19037);
}

TEST_CASE("the stiffness maps of P(2PRPU)/PRPS are symmetric about Y = 0, pF_min is x / 2ES, and PhiT_min, not pT_min, grows with X") {
  Model model(false);
  std::vector<double> xs, phi_min;
  for (const double x : from_to(0.6, 0.96, 7))
    for (const double y : from_to(0, 0.3, 4))
      for (const double z : from_to(1.0, 1.3, 4)) {
        CAPTURE(x, y, z);
        const DeformationIndices a = model.at(x, y, z), b = model.at(x, -y, z);
        for (const auto& [left, right] : {std::pair{a.pF_max, b.pF_max},
                                          {a.pF_min, b.pF_min},
                                          {a.pT_max, b.pT_max},
                                          {a.PhiT_max, b.PhiT_max},
                                          {a.PhiT_min, b.PhiT_min}})
          CHECK(std::abs(left - right) <= 1e-12 * left);
        CHECK(a.pF_min == Approx(x / (2 * E * S)).epsilon(1e-12));
        if (y == 0) CHECK(a.pT_min <= 1e-12 * a.pT_max);  // all along the line: it does not grow with X
        xs.push_back(x), phi_min.push_back(a.PhiT_min);
      }
  CHECK(correlation(xs, phi_min) > 0.9);
}

TEST_CASE("no reading of the signs of Table 2 gives the deflection that it prints") {
  // The pose of Table 2, its angles and its place along Y with either sign, C1 on either side. pF_max bounds what any force can do.
  constexpr double deg = std::numbers::pi / 180, force = 39.05, printed = 2.529e-3;
  double most = 0;
  for (const char* sigma : {"-1", "+1"}) {
    Model model(false, sigma);
    for (const double y : {0.3, -0.3})
      for (const double alpha : {20 * deg, -20 * deg})
        for (const double beta : {30 * deg, -30 * deg}) most = std::max(most, force * model.at(1.0, y, 0.8, alpha, beta).pF_max);
  }
  CHECK(most == Approx(1.616e-5).epsilon(1e-3));
  CHECK(printed / most > 150);
}
