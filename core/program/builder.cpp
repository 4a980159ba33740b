#include <core/program/builder.hpp>

#include <bit>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace pmreport::program {

namespace {

// What an operation on constants comes to, where that is a double and nothing was rounded. What is added to a program afterwards, its
// derivatives for one, is then the same function of real numbers as its unfolded steps, and an interval holds it; the rest stay operations.
//
// The error of a sum is a double (Knuth); that of a product, of a quotient times its divisor and of a root times itself too, given by fma,
// unless it is too small to be one.
std::optional<double> exactly(Operation o, double a, double b) {
  const auto finite = [](double x) { return std::isfinite(x) ? std::optional(x) : std::nullopt; };
  const auto without_error = [&](double x, double error, double smallest) {
    const bool error_is_a_number = std::abs(smallest) > 0x1p-900;
    return error == 0 && error_is_a_number ? finite(x) : std::nullopt;
  };
  const auto sum = [&](double x, double y) {
    const double s = x + y, of_y = s - x, error = (x - (s - of_y)) + (y - of_y);
    return error == 0 ? finite(s) : std::nullopt;
  };
  const auto product = [&](double x, double y) {
    if (x == 0 || y == 0) return finite(x * y);
    return without_error(x * y, std::fma(x, y, -(x * y)), x * y);
  };
  switch (o) {
    case Operation::add:
      return sum(a, b);
    case Operation::subtract:
      return sum(a, -b);
    case Operation::multiply:
      return product(a, b);
    case Operation::square:
      return product(a, a);
    case Operation::divide:
      if (a == 0 && b != 0) return 0;
      return without_error(a / b, std::fma(a / b, b, -a), a);
    case Operation::negate:
      return -a;
    case Operation::abs:
      return std::abs(a);
    case Operation::min:
      return a < b ? a : b;
    case Operation::max:
      return a < b ? b : a;
    case Operation::sqrt:
      if (a == 0) return 0;
      return without_error(std::sqrt(a), std::fma(std::sqrt(a), std::sqrt(a), -a), a);
    case Operation::hypot:
      return a == 0 ? std::optional(std::abs(b)) : b == 0 ? std::optional(std::abs(a)) : std::nullopt;
    case Operation::sin:
    case Operation::tan:
    case Operation::asin:
      return a == 0 ? std::optional(0.0) : std::nullopt;
    case Operation::cos:
      return a == 0 ? std::optional(1.0) : std::nullopt;
    case Operation::acos:
      return a == 1 ? std::optional(0.0) : std::nullopt;
    case Operation::atan2:
      return a == 0 && b > 0 ? std::optional(0.0) : std::nullopt;
    default:
      return std::nullopt;
  }
}

bool commutes(Operation o) { return o == Operation::add || o == Operation::multiply || o == Operation::both || o == Operation::either; }

}  // namespace

std::size_t Builder::Hash::operator()(const Step& s) const {
  std::size_t h = static_cast<std::size_t>(s.operation);
  for (const int x : {s.a, s.b, s.c}) h = h * 1000003 + static_cast<std::size_t>(x);
  return h * 1000003 + std::hash<std::uint64_t>()(std::bit_cast<std::uint64_t>(s.constant));
}
// Zero and minus zero are two constants.
bool Builder::Same::operator()(const Step& x, const Step& y) const {
  return x.operation == y.operation && x.a == y.a && x.b == y.b && x.c == y.c &&
         std::bit_cast<std::uint64_t>(x.constant) == std::bit_cast<std::uint64_t>(y.constant);
}

int Builder::append(const Step& s) {
  const auto [at, made] = numbers_.try_emplace(s, static_cast<int>(steps_.size()));
  if (made) steps_.push_back(s);
  return at->second;
}

// What needs no new operation.
int Builder::known(const Step& s) {
  const int a = s.a, b = s.b;
  switch (s.operation) {
    case Operation::add:
      return is(a, 0) ? b : is(b, 0) ? a : -1;
    case Operation::subtract:
      return is(b, 0) ? a : -1;
    case Operation::multiply:
      return is(a, 0) || is(b, 1) ? a : is(b, 0) || is(a, 1) ? b : -1;
    case Operation::divide:
      return is(b, 1) ? a : -1;
    case Operation::negate:
      return step(a).operation == Operation::negate ? step(a).a : -1;
    case Operation::abs:
      return step(a).operation == Operation::abs || step(a).operation == Operation::square ? a : -1;
    case Operation::min:
    case Operation::max:
      return a == b ? a : -1;
    case Operation::both:
      return a == b || is(b, 1) || is(a, 0) ? a : is(a, 1) || is(b, 0) ? b : -1;
    case Operation::either:
      return a == b || is(b, 0) || is(a, 1) ? a : is(a, 0) || is(b, 1) ? b : -1;
    case Operation::opposite:
      return step(a).operation == Operation::opposite ? step(a).a : -1;
    case Operation::choose:
      return s.b == s.c || is(a, 1) ? s.b : is(a, 0) ? s.c : -1;
    case Operation::settled:
      return is_constant(a) ? b : -1;
    case Operation::uncut:
      return is_constant(a) && is_constant(b) ? s.c : -1;
    default:
      return -1;
  }
}

int Builder::add(Step s) {
  switch (s.operation) {  // what is not an operand does not tell two steps apart
    case Operation::constant:
      return append({s.operation, 0, 0, 0, s.constant});
    case Operation::input:
      return append({s.operation, s.a, 0, 0, 0});
    default:
      s.constant = 0;
      if (operands_of(s.operation) < 3) s.c = 0;
      if (operands_of(s.operation) < 2) s.b = 0;
  }
  if (const int old = known(s); old >= 0) return old;

  const bool constant = is_constant(s.a) && (operands_of(s.operation) < 2 || is_constant(s.b));
  if (constant && s.operation == Operation::less) return this->constant(step(s.a).constant < step(s.b).constant ? 1 : 0);
  if (constant && s.operation == Operation::opposite) return this->constant(1 - step(s.a).constant);
  if (constant && !gives_mask(s.operation) && s.operation != Operation::choose)
    if (const auto x = exactly(s.operation, step(s.a).constant, step(s.b).constant)) return this->constant(*x);

  if (s.operation == Operation::multiply && s.a == s.b) return add(Operation::square, s.a);
  if (s.operation == Operation::subtract && is(s.a, 0)) return add(Operation::negate, s.b);
  if (s.operation == Operation::choose && step(s.a).operation == Operation::less) {
    const int x = step(s.a).a, y = step(s.a).b;
    const auto opposite = [&](int i, int of) { return step(i).operation == Operation::negate && step(i).a == of; };
    if (s.b == x && s.c == y) return add(Operation::min, x, y);
    if (s.b == y && s.c == x) return add(Operation::max, x, y);
    if (is(y, 0) && s.c == x && opposite(s.b, x)) return add(Operation::abs, x);
    if (is(x, 0) && s.b == y && opposite(s.c, y)) return add(Operation::abs, y);
  }
  if (commutes(s.operation) && s.b < s.a) std::swap(s.a, s.b);
  return append(s);
}

}  // namespace pmreport::program
