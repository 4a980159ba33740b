#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/text/units.hpp>
#include <limits>

using namespace pmreport;

namespace {
// Factors are products and powers of table values: a few roundings.
constexpr double rounding = 1e-15;
}  // namespace

TEST_CASE("every unit has its factor and dimension") {
  struct Case {
    const char* text;
    double factor;
    Dimension dimension;  // length, mass, time, angle
  };
  const Case cases[] = {
      {"m", 1, {1, 0, 0, 0}},
      {"mm", 0.001, {1, 0, 0, 0}},
      {"µm", 0.000001, {1, 0, 0, 0}},
      {"\u03bcm", 0.000001, {1, 0, 0, 0}},
      {"um", 0.000001, {1, 0, 0, 0}},
      {"nm", 0.000000001, {1, 0, 0, 0}},
      {"km", 1000, {1, 0, 0, 0}},
      {"in", 0.0254, {1, 0, 0, 0}},
      {"ft", 0.3048, {1, 0, 0, 0}},
      {"urad", 0.000001, {0, 0, 0, 1}},
      {"µrad", 0.000001, {0, 0, 0, 1}},
      {"\u03bcrad", 0.000001, {0, 0, 0, 1}},
      {"arcsec", pi / 180 / 3600, {0, 0, 0, 1}},
      {"lb", 0.45359237, {0, 1, 0, 0}},
      {"lbf", 4.4482216152605, {1, 1, -2, 0}},
      {"kgf", 9.80665, {1, 1, -2, 0}},
      {"lbf*ft", 1.3558179483314004, {2, 1, -2, 0}},
      {"lbf/in^2", 6894.757293168361, {-1, 1, -2, 0}},
      {"deg", pi / 180, {0, 0, 0, 1}},
      {"°", pi / 180, {0, 0, 0, 1}},
      {"min", 60, {0, 0, 1, 0}},
      {"h", 3600, {0, 0, 1, 0}},
      {"Hz", 1, {0, 0, -1, 0}},
      {"rpm", 0.10471975511965977, {0, 0, -1, 1}},
      {"kN", 1000, {1, 1, -2, 0}},
      {"N*m", 1, {2, 1, -2, 0}},
      {"Nm", 1, {2, 1, -2, 0}},
      {"N*mm", 0.001, {2, 1, -2, 0}},
      {"kN*m", 1000, {2, 1, -2, 0}},
      {"t", 1000, {0, 1, 0, 0}},
      {"g", 0.001, {0, 1, 0, 0}},
      {"GPa", 1e9, {-1, 1, -2, 0}},
      {"kW", 1000, {2, 1, -3, 0}},
      {"%", 0.01, {}},
      {"", 1, {}},
      {"deg/s^2", pi / 180, {0, 0, -2, 1}},
      {"kg*m^2", 1, {2, 1, 0, 0}},
      {"mm/min", 0.001 / 60, {1, 0, -1, 0}},
      {"1/s", 1, {0, 0, -1, 0}},
      {"s^-1", 1, {0, 0, -1, 0}},
      {"m / s ^ 2", 1, {1, 0, -2, 0}},
      {"g/cm^3", 1000, {-3, 1, 0, 0}},
  };
  for (const Case& c : cases) {
    CAPTURE(c.text);
    const auto unit = parse_unit(c.text);
    REQUIRE(unit);
    CHECK(unit->factor == Approx(c.factor).epsilon(4 * rounding));
    CHECK(unit->dimension == c.dimension);
  }
}

TEST_CASE("what is not in the table is no unit") {
  for (const char* text : {"furlong", "mM", "kmm", "N*", "/s", "m//s", "m^", "m^x", "m^1.5", "m^99", "5", "1^2", "m s", "*", "^2", "m\n"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_unit(text));
  }
  CHECK_FALSE(parse_unit(std::string(100000, 'm')));
}

TEST_CASE("the unit that is not known is found among those that are") {
  CHECK(unknown_unit_in("furlong") == "furlong");
  CHECK(unknown_unit_in("N*furlong") == "furlong");
  CHECK(unknown_unit_in("m/fortnight^2") == "fortnight");
  for (const char* wrong_otherwise : {"N*", "/s", "m^x", "5", ""}) {
    CAPTURE(wrong_otherwise);
    CHECK(unknown_unit_in(wrong_otherwise).empty());
  }
}

TEST_CASE("an example is a quantity of its own dimension") {
  for (int length = -3; length <= 3; ++length)
    for (int mass = -1; mass <= 1; ++mass)
      for (int time = -3; time <= 0; ++time)
        for (int angle = -1; angle <= 1; ++angle) {
          const Dimension d{length, mass, time, angle};
          const std::string example = example_of(d);
          CAPTURE(example);
          const auto blank = example.find(' ');
          const auto unit = parse_unit(blank == std::string::npos ? "" : std::string_view(example).substr(blank + 1));
          REQUIRE(unit);
          CHECK(unit->dimension == d);
        }
}

TEST_CASE("a dimension is called by its name in the field") {
  CHECK(name_of({}) == "a plain number");
  CHECK(name_of({1, 0, 0, 0}) == "a length");
  CHECK(name_of({0, 0, -2, 1}) == "an angular acceleration");
  CHECK(name_of({2, 1, -2, 0}) == "a moment");
  CHECK(name_of({5, 1, -2, -1}) == "m^5*kg/rad/s^2");
  CHECK(name_of({0, -1, 0, 0}) == "1/kg");
}

TEST_CASE("a quantity's own unit is that at its end, where it is one of the whole") {
  const Dimension length = parse_unit("m")->dimension, speed = parse_unit("m/s")->dimension, turning = parse_unit("rad/s")->dimension;
  CHECK(unit_at_end("12.5 mm", length) == "mm");
  CHECK(unit_at_end("1e-3m", length) == "m");
  CHECK(unit_at_end("2*pi rad/s", turning) == "rad/s");
  CHECK(unit_at_end("10 m / 4 s", speed).empty());
  CHECK(unit_at_end("3 mm + 2", length).empty());
  CHECK(unit_at_end("12.5 mm", speed).empty());
  CHECK(unit_at_end("151", Dimension{}).empty());
  CHECK(unit_at_end("15.1 %", Dimension{}) == "%");
}

TEST_CASE("an angle is not a plain number") { CHECK(parse_unit("rad")->dimension != parse_unit("")->dimension); }

TEST_CASE("a quantity is shown in the unit that reads best") {
  struct Case {
    const char* si;
    double largest;
    const char* label;
    double per_si;
  };
  const Case cases[] = {
      {"m", 0.8, "mm", 1e3},
      {"m", 25, "m", 1},
      {"m", 3e-6, "µm", 1e6},
      {"m", 2e-8, "nm", 1e9},
      {"m", 1000, "m", 1},
      {"m", 0, "mm", 1e3},
      {"m", -0.8, "mm", 1e3},
      {"rad", 0.1, "°", 180 / pi},
      {"rad", 5e-6, "µrad", 1e6},
      {"rad", 0, "°", 180 / pi},
      {"rad/s", 3, "°/s", 180 / pi},
      {"rad/s^2", 3, "°/s²", 180 / pi},
      {"m/s^2", 0.3, "mm/s²", 1e3},
      {"N", 250, "N", 1},
      {"N", 25000, "kN", 1e-3},
      {"N*m", 3, "N·m", 1},
      {"N*m", 0.02, "N·mm", 1e3},
      {"kg*m^2", 1, "kg·m²", 1},
      {"", 5, "", 1},
      {"s", 10, "s", 1},
      {"kg^-12*m", 1, "kg⁻¹²·m", 1},
  };
  for (const Case& c : cases) {
    CAPTURE(c.si, c.largest);
    const DisplayUnit shown = display_unit(c.si, c.largest);
    CHECK(shown.label == c.label);
    CHECK(shown.per_si == Approx(c.per_si).epsilon(4 * rounding));
  }
}

TEST_CASE("numbers are written with their significant digits") {
  struct Case {
    double value;
    int digits;
    const char* text;
  };
  const Case cases[] = {
      {812.44, 4, "812.4"},
      {1.26e-4, 3, "1.26e-4"},
      {0.00126, 3, "0.00126"},
      {0, 4, "0"},
      {-0.0, 4, "0"},
      {800, 4, "800"},
      {-2.5, 4, "-2.5"},
      {99.96, 3, "100"},
      {12345.6, 4, "12350"},
      {1234567, 4, "1.235e6"},
      {1e9, 6, "1e9"},
      {1e-300, 2, "1e-300"},
      {123456789, 9, "123456789"},
      {0.1, 17, "0.10000000000000001"},
      {999999.7, 6, "1e6"},
      {1e300 * 10, 3, "1e301"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.value, c.digits);
    CHECK(format_number(c.value, c.digits) == c.text);
  }
  CHECK(format_number(std::numeric_limits<double>::quiet_NaN(), 4) == "—");
  CHECK(format_number(-std::numeric_limits<double>::infinity(), 4) == "—");
}
