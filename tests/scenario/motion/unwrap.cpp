// Angles in tables that come back by a turn.
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/scenario/motion/unwrap.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::vector<double> radians(std::vector<double> degrees) {
  for (double& x : degrees) x *= pi / 180;
  return degrees;
}
std::optional<std::size_t> wrapped(const std::vector<double>& degrees) {
  std::vector<double> times;
  for (std::size_t i = 0; i < degrees.size(); ++i) times.push_back(static_cast<double>(i));
  return wrapped_at(times, radians(degrees));
}
void check_unwrapped(const std::vector<double>& degrees, const std::vector<double>& wanted) {
  std::vector<double> angles = radians(degrees);
  unwrap(angles);
  const std::vector<double> right = radians(wanted);
  for (std::size_t i = 0; i < right.size(); ++i) CHECK(angles[i] == Approx(right[i]).margin(1e-14));
}

// The tracker's yaw, in a file beside a scenario whose [motion] has `keys`.
constexpr std::string_view yaw = "t [s],phi [deg]\n0,176\n1,178\n2,180\n3,-178\n4,-176\n";
std::string turning(const std::string& keys) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\nparameters = { cone = \"180 deg\" }\n[[section]]\nkind = "
         "\"displacement\"\n[motion]\nfile = \"yaw.csv\"\n" +
         keys;
}

}  // namespace

TEST_CASE("an angle that comes back by a turn is found, and a fast turn is none") {
  CHECK(wrapped({176, 178, 180, -178, -176}) == 3u);
  CHECK(wrapped({-170, -176, 178, 172}) == 2u);
  CHECK(wrapped({179, -179, -177}) == 1u);  // by what comes after it
  CHECK(wrapped({10, 5, 0, 355, 350}) == 3u);
  CHECK_FALSE(wrapped({0, 90, 180, 270, 360}));
  CHECK_FALSE(wrapped({0, 350, 700, 1050}));  // as fast before as after
  CHECK_FALSE(wrapped({0, 360}));             // a turn that is meant: nothing says otherwise
  CHECK_FALSE(wrapped({0, 200, 0}));
}

TEST_CASE("unwrapped angles go the shortest way from point to point, over several turns") {
  check_unwrapped({176, 178, 180, -178, -176}, {176, 178, 180, 182, 184});
  check_unwrapped({-176, 176, 170}, {-176, -184, -190});
  check_unwrapped({0, 120, 240, 0, 120, 240, 0}, {0, 120, 240, 360, 480, 600, 720});
}

TEST_CASE("a file whose angle comes back by a turn is refused with its line, unless the scenario says what is meant") {
  const Folder folder;
  folder.write("yaw.csv", yaw);
  const std::filesystem::path file = folder.path() / "a.toml";
  CHECK_THAT(told(turning(""), file),
             Contains("yaw.csv:5:1: error: phi jumps by -358 deg from the point before, and a turn less, 2 deg, would go on as before") &&
                 Contains("unwrap = true in [motion] takes the shortest way from point to point"));
  const Loaded turned = load_text(turning("unwrap = true\n"), file, stage::source(), section::kinds());
  for (const Eigen::Index k : {0, 1, 2, 3, 4}) CHECK(turned.trajectory.value(k, 1) == Approx((176 + 2 * double(k)) * pi / 180));
  CHECK(turned.trajectory.rate(2, 1) == Approx(2 * pi / 180));
  const Loaded taken = load_text(turning("unwrap = false\n"), file, stage::source(), section::kinds());
  CHECK(taken.trajectory.value(3, 1) == Approx(-178 * pi / 180));
  CHECK_THAT(told(turning("unwrap = 3\n"), file), Contains("unwrap") || Contains("true or false"));
}

TEST_CASE("waypoints are held to the same, and an expression has nothing to unwrap") {
  const auto tell = [](const std::string& keys) {
    return told("title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"displacement\"\n[motion]\nsamples = 5\n" + keys);
  };
  std::string points = "profile = \"quintic\"\n";
  for (const auto& [time, angle] : {std::pair{"0 s", "170 deg"}, {"1 s", "175 deg"}, {"2 s", "-179 deg"}})
    points += "[[motion.waypoint]]\ntime = \"" + std::string(time) + "\"\nphi = \"" + angle + "\"\n";
  CHECK_THAT(tell(points), Contains("a.toml:15:") && Contains("phi jumps by -354 deg from the point before"));
  CHECK(tell("unwrap = true\n" + points).empty());
  CHECK_THAT(tell("duration = \"1 s\"\nphi = \"1 deg\"\nunwrap = true\n"),
             Contains("the angles of points are unwrapped, and there are no points"));
  CHECK_THAT(tell("duration = \"1 s\"\nfrom = \"forces\"\nunwrap = true\n[motion.forces]\nq = \"1 N\"\n"),
             Contains("unwrap is of a prescribed motion, and this one follows from forces"));
}
