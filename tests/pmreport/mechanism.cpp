// The plugin's side of the contract: parameters by name, exceptions stopped, sentences cut to the host's room.
#include <catch2/catch.hpp>
#include <cstring>
#include <new>
#include <pmreport/mechanism.hpp>

using namespace pmreport;

namespace {

constexpr double point_declared[] = {1, 2, 3};
constexpr const char* words[] = {"x", "y", "z"};
constexpr Parameter declared[] = {
    Parameter::number("radius", 0.4, {0.01, 100}, "m", "mm", "a radius"),
    Parameter::numbers("point", point_declared, {-5, 5}, 3, 6, "m", "mm", "a point"),
    Parameter::choice("which", words, 1, "one of three"),
};

pm_status guarded(pm_text* text, const auto& thrown) {
  return contract::guard(text, [&]() -> pm_status { throw thrown; });
}

}  // namespace

TEST_CASE("a declared parameter is the contract's parameter") {
  const pm_parameter radius = info(declared[0]), list = info(declared[1]), which = info(declared[2]);
  CHECK(radius.kind == PM_NUMBER);
  REQUIRE(radius.default_count == 1);
  CHECK(radius.defaults[0] == 0.4);
  CHECK(radius.min == 0.01);
  CHECK(radius.max == 100);
  CHECK(radius.unit == std::string("m"));
  CHECK(radius.display == std::string("mm"));
  CHECK(list.kind == PM_NUMBERS);
  REQUIRE(list.default_count == 3);
  CHECK(list.defaults[2] == 3);
  CHECK(list.count_min == 3);
  CHECK(list.count_max == 6);
  CHECK(which.kind == PM_CHOICE);
  REQUIRE(which.choice_count == 3);
  CHECK(which.choices[2] == std::string("z"));
  CHECK(which.defaults[0] == 1);
  CHECK(which.max == 2);
}

TEST_CASE("values are read by the name of their parameter") {
  const double radius[] = {0.7}, coordinates[] = {4, 5, 6, 7}, which[] = {2};
  const pm_value values[] = {{radius, 1}, {coordinates, 4}, {which, 1}};
  const Parameters p(declared, values);
  CHECK(p["radius"] == 0.7);
  REQUIRE(p.numbers("point").size() == 4);
  CHECK(p.numbers("point")[3] == 7);
  CHECK(p.choice("which") == "z");
  CHECK_THROWS_WITH(p["diameter"], Catch::Contains("'diameter'"));
}

TEST_CASE("no exception crosses: it becomes a status and a sentence") {
  char buffer[64] = "";
  pm_text text{buffer, sizeof buffer};
  CHECK(guarded(&text, std::invalid_argument("radius too small")) == PM_BAD_ARGUMENT);
  CHECK(buffer == std::string("radius too small"));
  CHECK(guarded(&text, std::runtime_error("broken")) == PM_FAILED);
  CHECK(buffer == std::string("broken"));
  CHECK(guarded(&text, std::bad_alloc()) == PM_FAILED);
  CHECK(guarded(&text, 42) == PM_FAILED);
  CHECK(std::strlen(buffer) > 0);
  CHECK(contract::guard(&text, [] { return PM_SINGULAR; }) == PM_SINGULAR);
}

TEST_CASE("a sentence never exceeds the host's room, and needs none") {
  char buffer[8] = {'#', '#', '#', '#', '#', '#', '#', '#'};
  pm_text small{buffer, 4}, none{buffer + 4, 0}, null{nullptr, 10};
  guarded(&small, std::runtime_error("abcdefgh"));
  CHECK(std::memcmp(buffer, "abc\0####", 8) == 0);
  CHECK(guarded(&none, std::runtime_error("abc")) == PM_FAILED);
  CHECK(guarded(&null, std::runtime_error("abc")) == PM_FAILED);
  CHECK(guarded(nullptr, std::runtime_error("abc")) == PM_FAILED);
  CHECK(buffer[4] == '#');
}
