// Programs as JavaScript give what they give here.
#include <tests/recorded_program/apart.hpp>
#include <tests/recorded_program/in_node.hpp>
#include <tests/recorded_program/recording.hpp>

#include <core/program/derivative.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/print_javascript.hpp>

#include <bit>
#include <cmath>

using namespace recording;
using functions::Random;
using program::print_javascript;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bits(double x) { return std::isnan(x) ? 1 : std::bit_cast<std::uint64_t>(x); }

// How many doubles lie between two numbers, counting one of them.
std::uint64_t units_apart(double a, double b) {
  if (bits(a) == bits(b)) return 0;
  const auto rank = [](double x) {
    const auto i = std::bit_cast<std::int64_t>(x);
    return i < 0 ? std::numeric_limits<std::int64_t>::min() - i : i;
  };
  return static_cast<std::uint64_t>(std::abs(rank(a) - rank(b)));
}

template <class T>
std::vector<T> run(const Program& p, const std::vector<double>& in) {
  program::Evaluator<T> evaluator(p);
  const auto inputs = static_cast<std::size_t>(p.inputs()), outputs = p.outputs().size();
  std::vector<T> x(inputs), out(in.size() / inputs * outputs);
  for (std::size_t k = 0; k < in.size() / inputs; ++k) {
    for (std::size_t i = 0; i < inputs; ++i) x[i] = T(in[k * inputs + i]);
    evaluator.run(x, std::span(out).subspan(k * outputs, outputs));
  }
  return out;
}

void add(in_node::Functions& node, const Program& p, const std::vector<double>& in) {
  node.add(print_javascript(p), static_cast<std::size_t>(p.inputs()), p.outputs().size(), in);
}

// Numbers of all sizes, small whole ones among them, and those at which operations differ that are said alike.
double any_number(Random& random) {
  static const double odd[] = {0.0, -0.0, 1, -1, 2, inf, -inf, nan, 5e-324, -5e-324, 1.7976931348623157e308, 1e-300, 3, 0.5};
  const double kind = random.within(0, 4);
  if (kind < 1) return odd[static_cast<std::size_t>(random.within(0, std::size(odd) - 1e-9))];
  if (kind < 2) return random.within(-2, 2);
  return std::copysign(std::exp2(random.within(-60, 60)), random.within(-1, 1));
}

// A list of operations that both languages round alike, on inputs, constants and one another.
Program random_program(Random& random, int inputs, int steps) {
  std::vector<Step> list;
  std::vector<int> numbers, masks;
  const auto append = [&](Step s) {
    (program::gives_mask(s.operation) ? masks : numbers).push_back(static_cast<int>(list.size()));
    list.push_back(s);
  };
  for (int i = 0; i < inputs; ++i) append({Operation::input, i});
  for (const double c : {-0.0, 1e300, -1e-300, 1.0 / 3, -7.0}) append({Operation::constant, 0, 0, 0, c});
  append({Operation::less, 0, 1});
  const auto one_of = [&](const std::vector<int>& all) {
    return all[static_cast<std::size_t>(random.within(0, double(all.size()) - 1e-9))];
  };
  constexpr Operation operations[] = {Operation::add,     Operation::subtract, Operation::multiply, Operation::divide,   Operation::negate,
                                      Operation::sqrt,    Operation::abs,      Operation::square,   Operation::min,      Operation::max,
                                      Operation::less,    Operation::both,     Operation::either,   Operation::opposite, Operation::choose,
                                      Operation::settled, Operation::uncut,    Operation::subtract, Operation::negate};
  for (int i = 0; i < steps; ++i) {
    const Operation o = operations[static_cast<std::size_t>(random.within(0, std::size(operations) - 1e-9))];
    const bool of_masks = o == Operation::both || o == Operation::either || o == Operation::opposite;
    const bool first_mask = of_masks || o == Operation::choose || o == Operation::settled;
    append({o, one_of(first_mask ? masks : numbers), one_of(of_masks ? masks : numbers), one_of(numbers)});
  }
  std::vector<int> outputs;
  for (int i = 0; i < 12; ++i) outputs.push_back(one_of(numbers));
  return Program(list, inputs, outputs);
}

}  // namespace

TEST_CASE("a program as JavaScript is a function, with a name for what is used more than once") {
  const Program p = recorded(2, [](const auto& x) {
    const Recorded far = x[0] * x[0] + 0.1, root = sqrt(far), other = x[1] - -0.25;
    return std::vector<Recorded>{root / (root + other), choose(root < other, -root, 1e300 * x[0]), Recorded(-0.0), x[1]};
  });
  CHECK(print_javascript(p) ==
        "(x,y)=>{\n"
        "const v0=x[0],\n"
        "v1=x[1],\n"
        "v2=Math.sqrt(v0*v0+0.1),\n"
        "v3=v1-(-0.25);\n"
        "y[0]=v2/(v2+v3);\n"
        "y[1]=v2<v3?-v2:v0*1e+300;\n"
        "y[2]=-0;\n"
        "y[3]=v1;\n"
        "}");
}

TEST_CASE("constants are printed to their last bit") {
  if (!in_node::here()) return;
  std::vector<double> all{
      0.0, -0.0, 1, -1, 5e-324, -2.2250738585072014e-308, 1.7976931348623157e308, 0.1, 1e21, 1e22, 123456789012345680.0};
  std::mt19937_64 random(21);
  for (int i = 0; i < 2000; ++i)
    if (const double x = std::bit_cast<double>(static_cast<std::uint64_t>(random())); std::isfinite(x)) all.push_back(x);
  std::vector<Step> steps;
  std::vector<int> outputs;
  for (const double c : all) outputs.push_back(static_cast<int>(steps.size())), steps.push_back({Operation::constant, 0, 0, 0, c});
  in_node::Functions node;
  add(node, Program(steps, 1, outputs), {0});
  const std::vector<double> seen = node.run()[0];
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i], seen[i]);
    CHECK(bits(seen[i]) == bits(all[i]));
  }
}

TEST_CASE("random programs of operations that are rounded alike give the same bits in JavaScript") {
  if (!in_node::here()) return;
  Random random(22);
  in_node::Functions node;
  std::vector<std::vector<double>> expected;
  std::vector<std::string> printed;
  for (int k = 0; k < 300; ++k) {
    const Program p = random_program(random, 4, 80);
    std::vector<double> in;
    for (int i = 0; i < 4 * 50; ++i) in.push_back(any_number(random));
    add(node, p, in);
    expected.push_back(run<double>(p, in));
    printed.push_back(print_javascript(p));
  }
  const auto seen = node.run();
  std::size_t compared = 0;
  for (std::size_t k = 0; k < seen.size(); ++k)
    for (std::size_t i = 0; i < seen[k].size(); ++i, ++compared)
      if (bits(seen[k][i]) != bits(expected[k][i])) {
        INFO(printed[k]);
        CAPTURE(k, i);
        CHECK(seen[k][i] == expected[k][i]);
        REQUIRE(bits(seen[k][i]) == bits(expected[k][i]));
      }
  CHECK(compared == 300 * 50 * 12);
}

TEST_CASE("every operation and its derivatives are in JavaScript what they are here") {
  if (!in_node::here()) return;
  Random random(23);
  const std::vector<int> by{0, 1, 2};
  const std::vector<double> in = random_numbers(random, 3 * 2000, 1);
  in_node::Functions node;
  for (const Program& p : {everything(), program::partials(everything(), by)}) add(node, p, in);
  const auto seen = node.run();
  std::size_t k = 0, open = 0, equal = 0;
  for (const Program& p : {everything(), program::partials(everything(), by)}) {
    const auto expected = run<apart::Number>(p, in);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!apart::allows(expected[i], seen[k][i])) {
        CAPTURE(k, i, expected[i].value, expected[i].off, seen[k][i]);
        CHECK(apart::allows(expected[i], seen[k][i]));
      }
      open += std::isinf(expected[i].off);
      equal += expected[i].off == 0;
    }
    ++k;
  }
  CHECK(open < 10);
  CHECK(equal > 10000);
}

// The judge of all comparisons: what is wrong by one unit of the last place in one constant, or in one function, must not pass.
TEST_CASE("an error of a last digit that is planted in the printed program is found out") {
  if (!in_node::here()) return;
  const Program p = recorded(2, [](const auto& x) {
    const Recorded turned = sin(x[0]) * x[1];
    return std::vector<Recorded>{turned + 1.0, sqrt(x[1] * 0.3)};
  });
  const std::string sound = print_javascript(p);
  const auto with = [&](const std::string& what, const std::string& by) {
    const std::size_t at = sound.find(what);
    REQUIRE(at != std::string::npos);
    return std::string(sound).replace(at, what.size(), by);
  };
  Random random(25);
  const std::vector<double> in = random_numbers(random, 2 * 500, 1);
  in_node::Functions node;
  for (const std::string& text : {sound, with("0.3", "0.30000000000000004"), with("Math.sin(", "(v=>Math.sin(v)*(1+2**-50))(")})
    node.add(text, 2, 2, in);
  const auto seen = node.run();
  const auto expected = run<apart::Number>(p, in);
  std::vector<int> refused;
  for (const std::vector<double>& of_text : seen) {
    refused.push_back(0);
    for (std::size_t i = 0; i < expected.size(); ++i) refused.back() += !apart::allows(expected[i], of_text[i]);
  }
  CHECK(refused[0] == 0);
  CHECK(refused[1] > 50);
  CHECK(refused[2] > 50);
}

TEST_CASE("elementary functions of the two languages are one unit of the last place apart, and no more") {
  if (!in_node::here()) return;
  Random random(24);
  in_node::Functions node;
  std::vector<std::pair<std::string, std::vector<double>>> expected;
  const auto of_one = [&](const std::string& name, double (*f)(double), auto&& number) {
    std::vector<double> in, out;
    for (int i = 0; i < 50000; ++i) in.push_back(number(i)), out.push_back(f(in.back()));
    node.add("(x,y)=>{y[0]=Math." + name + "(x[0])}", 1, 1, in);
    expected.emplace_back(name, out);
  };
  const auto angle = [&](int i) {
    return i % 2 == 0 ? random.within(-4, 4) : std::copysign(std::exp2(random.within(-30, 20)), random.within(-1, 1));
  };
  const auto part = [&](int i) {
    const double x = i % 2 == 0 ? random.within(-1, 1) : std::exp2(random.within(-50, 0));
    return i % 4 < 2 ? x : std::copysign(1 - std::abs(x), random.within(-1, 1));
  };
  of_one("sin", std::sin, angle);
  of_one("cos", std::cos, angle);
  of_one("tan", std::tan, angle);
  of_one("asin", std::asin, part);
  of_one("acos", std::acos, part);
  const auto of_two = [&](const std::string& name, const std::string& function, double (*f)(double, double), double octaves) {
    std::vector<double> in, out;
    for (int i = 0; i < 50000; ++i) {
      const double size = std::exp2(i % 2 == 0 ? 0 : random.within(-octaves, octaves));
      in.push_back(size * random.within(-1, 1)), in.push_back(i % 4 == 3 ? any_number(random) : size * random.within(-1, 1));
      out.push_back(f(in[in.size() - 2], in.back()));
    }
    node.add("(x,y)=>{y[0]=" + function + "(x[0],x[1])}", 2, 1, in);
    expected.emplace_back(name, out);
  };
  of_two("atan2", "Math.atan2", std::atan2, 60);
  of_two("hypot", program::javascript_hypot(), std::hypot, 1020);
  const auto seen = node.run();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    std::uint64_t worst = 0;
    for (std::size_t i = 0; i < seen[k].size(); ++i) worst = std::max(worst, units_apart(seen[k][i], expected[k].second[i]));
    CAPTURE(expected[k].first);
    CHECK(worst <= 1);
  }
}

TEST_CASE("the input of a printed program may be its output") {
  if (!in_node::here()) return;
  const Program p = recorded(2, [](const auto& x) { return std::vector<Recorded>{x[1], x[0], x[0] - x[1]}; });
  in_node::Functions node;
  node.add("(x,y)=>{const a=[x[0],x[1],0];(" + print_javascript(p) + ")(a,a);y.set(a)}", 2, 3, {3, 8});
  CHECK(node.run()[0] == std::vector<double>{8, 3, -5});
}

TEST_CASE("a program that is one long expression is cut, so that no parser runs out of stack") {
  const Program p = recorded(2, [](const auto& x) {
    Recorded sum = x[0];
    for (int i = 0; i < 3000; ++i) sum = x[1] * (sum + 1.5);
    return std::vector<Recorded>{sum};
  });
  const std::string text = print_javascript(p);
  int depth = 0, most = 0;
  for (const char c : text) most = std::max(most, depth += c == '(' ? 1 : c == ')' ? -1 : 0);
  CHECK(most < 40);
}
