// The scalar that writes down what is done with it: what it writes, read back as plainly as can be.
#include <catch2/catch.hpp>
#include <pmreport/recorded.hpp>
#include <pmreport/rotation.hpp>
#include <tests/pmreport/functions.hpp>

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

using namespace pmreport;
using functions::Random;

namespace {

// The host's side of a recording.
struct List {
  std::vector<pm_step> steps;
  pm_recording recording{};

  explicit List(std::size_t capacity = 1000) : steps(capacity) { recording = {sizeof(pm_recording), steps.data(), capacity, 0, nullptr}; }
  Recorded input(int i = 0) { return Recorded::input(recording, i); }
  std::size_t count() const { return recording.count; }

  // The values of all steps; masks are one or zero.
  std::vector<double> run(const std::vector<double>& q) const {
    std::vector<double> v;
    for (std::size_t i = 0; i < count(); ++i) {
      const pm_step& s = steps[i];
      const auto at = [&](std::int32_t k) { return v.at(static_cast<std::size_t>(k)); };
      const double a = s.operation >= PM_OP_ADD ? at(s.a) : 0;
      const auto b = [&] { return at(s.b); };
      switch (s.operation) {
        case PM_OP_CONSTANT:
          v.push_back(s.constant);
          break;
        case PM_OP_INPUT:
          v.push_back(q.at(static_cast<std::size_t>(s.a)));
          break;
        case PM_OP_ADD:
          v.push_back(a + b());
          break;
        case PM_OP_SUBTRACT:
          v.push_back(a - b());
          break;
        case PM_OP_MULTIPLY:
          v.push_back(a * b());
          break;
        case PM_OP_DIVIDE:
          v.push_back(a / b());
          break;
        case PM_OP_NEGATE:
          v.push_back(-a);
          break;
        case PM_OP_SQRT:
          v.push_back(std::sqrt(a));
          break;
        case PM_OP_SIN:
          v.push_back(std::sin(a));
          break;
        case PM_OP_COS:
          v.push_back(std::cos(a));
          break;
        case PM_OP_TAN:
          v.push_back(std::tan(a));
          break;
        case PM_OP_ASIN:
          v.push_back(std::asin(a));
          break;
        case PM_OP_ACOS:
          v.push_back(std::acos(a));
          break;
        case PM_OP_ABS:
          v.push_back(std::abs(a));
          break;
        case PM_OP_ATAN2:
          v.push_back(std::atan2(a, b()));
          break;
        case PM_OP_HYPOT:
          v.push_back(std::hypot(a, b()));
          break;
        case PM_OP_LESS:
          v.push_back(a < b());
          break;
        case PM_OP_AND:
          v.push_back(a * b());
          break;
        case PM_OP_OR:
          v.push_back(a + b() > 0);
          break;
        case PM_OP_NOT:
          v.push_back(1 - a);
          break;
        case PM_OP_CHOOSE:
          v.push_back(a != 0 ? b() : at(s.c));
          break;
        default:
          FAIL("operation " << s.operation);
      }
    }
    return v;
  }
  double value(const Recorded& x, const std::vector<double>& q) {
    const std::int32_t step = x.step(recording);
    return run(q).at(static_cast<std::size_t>(step));
  }
};

constexpr int recorded_tries = 10;

}  // namespace

TEST_CASE("what is recorded of every function gives its value again") {
  Random random(51);
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    List list;
    const Recorded y = f(list.input());
    CHECK_FALSE(y.is_constant());
    for (int i = 0; i < recorded_tries; ++i) {
      const double x = random.within(min, max);
      CAPTURE(name, x);
      CHECK(list.value(y, {x}) == f(x));
    }
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    List list;
    const Recorded a = list.input(0), b = list.input(1), y = f(a, b);
    CHECK_FALSE(y.is_constant());
    for (int i = 0; i < recorded_tries; ++i) {
      const double x0 = random.within(min, max), x1 = random.within(min, max);
      CAPTURE(name, x0, x1);
      CHECK(list.value(y, {x0, x1}) == f(x0, x1));
    }
  });
}

TEST_CASE("what depends on no coordinate is a constant, and nothing is written down") {
  Random random(52);
  List list;
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    const double x = random.within(min, max);
    const Recorded y = f(Recorded(x));
    CAPTURE(name, x);
    CHECK(y.is_constant());
    CHECK(y.constant() == f(x));
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    const double x0 = random.within(min, max), x1 = random.within(min, max);
    const Recorded y = f(Recorded(x0), Recorded(x1));
    CAPTURE(name, x0, x1);
    CHECK(y.is_constant());
    CHECK(y.constant() == f(x0, x1));
  });
  CHECK(list.count() == 0);
  CHECK(Recorded().is_constant());
  CHECK(Recorded().constant() == 0);
}

TEST_CASE("zero and one leave no operation behind") {
  List list;
  const Recorded x = list.input();
  const std::int32_t step = x.step(list.recording);
  for (const Recorded& y : {x + 0.0, 0.0 + x, x - 0.0, x * 1.0, 1.0 * x, x / 1.0}) CHECK(y.step(list.recording) == step);
  for (const Recorded& y : {x * 0.0, 0.0 * x}) {
    CHECK(y.is_constant());
    CHECK(y.constant() == 0);
  }
  CHECK(list.count() == 1);
  CHECK(list.value(0.0 - x, {3}) == -3);
}

TEST_CASE("a mask keeps both branches, whatever the coordinates are") {
  List list;
  const Recorded x = list.input(0), y = list.input(1);
  const Recorded both = choose(x < y && !(y < 0.0), Recorded(1.0), Recorded(2.0)), either = choose(x > y || x < -1.0, x, 7.0);
  const std::size_t count = list.count();
  for (const double a : {-2.0, -0.5, 0.5, 2.0})
    for (const double b : {-1.0, 0.0, 1.0}) {
      CAPTURE(a, b);
      CHECK(list.value(both, {a, b}) == (a < b && !(b < 0) ? 1 : 2));
      CHECK(list.value(either, {a, b}) == (a > b || a < -1 ? a : 7));
    }
  CHECK(list.count() == count);  // to read a number adds nothing to it
}

TEST_CASE("a comparison of constants is decided at once") {
  List list;
  const Recorded x = list.input(0), y = list.input(1);
  const auto yes = Recorded(1.0)<Recorded(2.0), no = Recorded(1.0)> Recorded(2.0), open = x < y;
  const std::size_t count = list.count();
  const auto step = [&](const Recorded& z) { return z.step(list.recording); };
  CHECK(step(choose(yes, x, y)) == step(x));
  CHECK(step(choose(no, x, y)) == step(y));
  CHECK(step(choose(!no, x, y)) == step(x));
  CHECK(step(choose(yes || open, x, y)) == step(x));
  CHECK(step(choose(open || yes, x, y)) == step(x));
  CHECK(step(choose(no && open, x, y)) == step(y));
  CHECK(step(choose(open && no, x, y)) == step(y));
  CHECK(list.count() == count);
  CHECK(list.value(choose(yes && open, x, y), {1, 2}) == 1);
  CHECK(list.value(choose(open || no, x, y), {3, 2}) == 2);
}

TEST_CASE("no mask becomes one bool, and no number does") {
  static_assert(!std::is_convertible_v<Recorded, bool>);
  static_assert(!std::is_convertible_v<Recorded, double>);
  static_assert(!std::is_convertible_v<Recorded::Mask, int>);
  SUCCEED();
}

TEST_CASE("steps beyond the list's capacity are counted, and not written") {
  List whole, list(4);
  list.steps.resize(5);  // the host's next number, which nobody may touch
  list.recording.steps = list.steps.data();
  list.steps[4] = {-7, -7, -7, -7, -7};
  for (List* l : {&whole, &list}) {
    Recorded x = l->input();
    for (int i = 0; i < 20; ++i) x = sin(x) + 0.5;
  }
  CHECK(list.count() == whole.count());
  CHECK(list.count() > 20);
  CHECK(list.steps[4].operation == -7);
  CHECK(list.steps[4].constant == -7);
  for (std::size_t i = 0; i < 4; ++i) CHECK(list.steps[i].operation == whole.steps[i].operation);
}

TEST_CASE("a recorded number passes through the contract's arrays") {
  List list;
  const Recorded x = list.input(0), y = sin(x), constant = 0.1;
  std::array<double, 2 * Codec<Recorded>::components> numbers{};
  for (const std::size_t stride : {std::size_t{1}, std::size_t{2}})
    for (const Recorded& z : {x, y, constant}) {
      Codec<Recorded>::store(numbers.data(), stride, z);
      const Recorded back = Codec<Recorded>::load(numbers.data(), stride);
      CHECK(back.is_constant() == z.is_constant());
      if (z.is_constant())
        CHECK(back.constant() == z.constant());
      else
        CHECK(back.step(list.recording) == z.step(list.recording));
    }
}

TEST_CASE("Eigen's vectors and matrices of recorded numbers are those of doubles") {
  List list;
  const std::vector<double> q{0.3, -0.4, 0.5};
  const auto geometry = []<class T>(const T& a, const T& b, const T& c) {
    const Eigen::Vector3d fixed(0.1, -0.2, 0.3);
    const Matrix3<T> r = rotation_z(a) * rotation_y(b) * rotation_x(c);
    const Vector3<T> p = r * fixed + Vector3<T>(a, b, c) * 2.0, u = unit(p);
    Matrix3<T> m = Matrix3<T>::Identity();
    m.row(1) = u.cross(fixed.cast<T>()).transpose();
    return std::array<T, 6>{length(p), u.dot(fixed.cast<T>()), p.squaredNorm(), (r * m)(2, 1), m.trace(), (m.transpose() * p).sum()};
  };
  const auto recorded = geometry(list.input(0), list.input(1), list.input(2));
  const auto expected = geometry(q[0], q[1], q[2]);
  // Eigen adds doubles two at a time, in another order.
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(list.value(recorded[i], q) == Approx(expected[i]).epsilon(1e-15).margin(1e-15));
}
