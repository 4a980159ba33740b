// How an expression behaves over a span of time: steps as fine as it wavers, and switches where its branches meet. What is right is known
// from the expressions: zeros of sines, corners of pulses.
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/expression/range.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::scenario;

namespace {

Expression parsed(const char* text) { return Expression::parse(text, Time::allowed); }
Behaviour over(const char* text, double end) { return behaviour(parsed(text), 0, end); }

// The switches lie where they should, to `margin`, and nowhere else.
void check_switches(const char* text, double end, const std::vector<double>& times, double margin = 1e-12) {
  CAPTURE(text);
  const Behaviour b = over(text, end);
  CHECK(b.complete);
  REQUIRE(b.switches.size() == times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    CHECK(b.switches[i].before <= b.switches[i].after);
    CHECK(b.switches[i].before == Approx(times[i]).margin(margin));
    CHECK(b.switches[i].after == Approx(times[i]).margin(margin));
  }
}

}  // namespace

TEST_CASE("between two steps no sine turns by more than a radian, however fast it turns") {
  // 20 Hz over 600 s: equal steps of a second would see nothing at all.
  for (const char* text : {"sin(2*pi*20*t/1 s)", "(sin(2*pi*20*t/1 s))^2", "3 + cos(5*sin(2*pi*20*t/1 s))"}) {
    CAPTURE(text);
    const Behaviour b = over(text, 600);
    CHECK(b.steps.front() == 0);
    CHECK(b.steps.back() == 600);
    CHECK(b.switches.empty());
    double longest = 0;
    for (std::size_t i = 1; i < b.steps.size(); ++i) longest = std::max(longest, b.steps[i] - b.steps[i - 1]);
    CHECK(longest <= 1 / (2 * pi * 20));
  }
}

TEST_CASE("a transition of a microsecond in a minute is stepped through") {
  for (const char* text : {"tanh((t - 17.3 s)/1e-6 s)", "exp(-((t - 17.3 s)/1e-6 s)^2)", "step5(t, 17.3 s, 17.300002 s)"}) {
    CAPTURE(text);
    const Behaviour b = over(text, 60);
    const auto inside = std::count_if(b.steps.begin(), b.steps.end(), [](double t) { return std::abs(t - 17.3) < 1e-5; });
    CHECK(inside >= 3);
    CHECK(b.steps.size() < 2000);
  }
}

TEST_CASE("what wavers without end is not looked at to the end, and says so") {
  CHECK_FALSE(over("sin(2*pi*1e9*t/1 s)", 1).complete);
  CHECK_FALSE(over("sin(1 s/(t - 0.5 s))", 1).complete);
}

TEST_CASE("a text that is all switches ends in time") {
  std::string text = "0";
  while (text.size() < 1950) text += "+abs(sin(2*pi*2000*t/1 s)-0.3)";
  CHECK_FALSE(over(text.c_str(), 10).complete);
}

TEST_CASE("switches are found where the branches of abs, min, max and step5 meet") {
  check_switches("abs(t/2 s - 1)", 4, {2});
  check_switches("abs(1 - t/2 s)", 4, {2});
  check_switches("max(t/1 s, 2 - t/1 s)", 3.1, {1});
  check_switches("min(0.3, t/1 s)", 1, {0.3});
  check_switches("step5(t, 0.2 s, 0.7 s)", 1, {0.2, 0.7});
  check_switches("abs(sin(2*pi*t/1 s))", 2.2, {0.5, 1, 1.5, 2});
  check_switches("abs(sin(2*pi*20*t/1 s))", 0.11, {0.025, 0.05, 0.075, 0.1});
  check_switches("sin(2*pi*t/1 s) + t^2/1 s^2 + exp(-t/1 s)", 5, {});
}

TEST_CASE("a switch on a switch is found though it is shorter than any step") {
  // A pulse of 2 ms in ten minutes: its peak is the first that is seen, its feet are seen from there.
  check_switches("max(0, 1 - abs(t - 301.7 s)/1 ms)", 600, {301.699, 301.7, 301.701}, 1e-9);
}

TEST_CASE("a switch and its way back are found within a hundredth of a step") {
  // Away from its vertex nothing tells a parabola that comes above zero for 2 ms in ten minutes.
  check_switches("max(0, 1 - ((t - 301.7 s)/1 ms)^2)", 600, {301.699, 301.701}, 1e-9);
  check_switches("abs((t/1 s - 7.03)^2 - 1e-8)", 60, {7.03 - 1e-4, 7.03 + 1e-4}, 1e-9);
  // What stays zero turns everywhere, and is no switch anywhere.
  check_switches("abs(0*t/1 s) + max(0, min(0, t/1 s))", 60, {});
}

TEST_CASE("an angle on the ray itself switches where it turns round") {
  check_switches("atan2(0, cos(t/1 s))", 4, {pi / 2});
  check_switches("atan2(0*t/1 s, 1 - t/1 s)", 4, {1});
  check_switches("atan2(0, 1 + t/1 s)", 4, {});
}

TEST_CASE("what only touches zero does not switch, and what stays zero switches where it begins") {
  check_switches("abs((t/1 s - 1)^2)", 2.1, {});
  check_switches("abs(max(0, t/1 s - 1))", 2.1, {1});
}

TEST_CASE("places without a value or a derivative are switches, crossed or touched") {
  check_switches("1 s/(t - 0.7 s)", 1, {0.7});
  check_switches("1/(t/1 s - 0.7)^2", 1, {0.7}, 1e-6);
  check_switches("sqrt((t/1 s - 0.7)^2)", 1, {0.7}, 1e-6);
  check_switches("(abs(t/1 s - 0.7))^1.5", 1, {0.7, 0.7}, 1e-6);
  check_switches("tan(t/1 s)", 2, {pi / 2});
  check_switches("asin(sin(t/1 s))", 4, {pi / 2}, 1e-6);
  check_switches("atan2(sin(t/1 s), cos(t/1 s))", 4, {pi});
}

TEST_CASE("no term leaves its range") {
  const char* texts[] = {"sin(3*t/1 s) * cos(t^2/1 s^2)",
                         "exp(-t/1 s) + sinh(t/4 s) - cosh(sin(t/1 s))",
                         "tanh(t/1 s - 2) * atan(t/1 s) / (1 + t/1 s)",
                         "abs(sin(t/1 s)) + min(t/1 s, 2) * max(1, 3 - t/1 s)",
                         "sqrt(t/1 s) + log(1 + t/1 s) + (t/1 s)^-2 + (t/1 s)^3 + (1 - t/1 s)^2 + (t/1 s)^0.7",
                         "asin(sin(t/1 s)) + acos(cos(2*t/1 s)) + atan2(sin(t/1 s), cos(t/1 s))",
                         "tan(t/3 s) + step5(t, 1 s, 2 s) - step5(t, 3 s, 2 s)"};
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> time(0.01, 4), share(0, 1);
  for (const char* text : texts) {
    const Expression e = parsed(text);
    for (int i = 0; i < 200; ++i) {
      const double a = time(generator), b = a + std::pow(share(generator), 3), t = a + share(generator) * (b - a);
      std::vector<scenario::Range> ranges;
      ranges_of(e.terms(), a, b, ranges);
      std::vector<Jet<double>> values;
      e.evaluate(t, {}, values);
      for (std::size_t k = 0; k < values.size(); ++k) {
        CAPTURE(text, a, b, t, k, values[k].value, ranges[k].value.low, ranges[k].value.high);
        CHECK(ranges[k].value.low <= values[k].value);
        CHECK(values[k].value <= ranges[k].value.high);
        CHECK(ranges[k].rate.low <= values[k].rate);
        CHECK(values[k].rate <= ranges[k].rate.high);
      }
    }
  }
}
