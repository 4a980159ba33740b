#include <core/program/builder.hpp>
#include <core/program/derivative.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace pmreport::program {

namespace {

// A derivative: `factor`, a signed power of two, times what a step gives; or zero. Signs, and the twos of squares and the halves of square
// roots, meet and cancel before they cost a step; what is left differs from steps that are there already by its factor alone: the
// derivative of a rotation's row by its own angle is another row of it.
struct Multiple {
  static constexpr int zero = -1;
  int step = zero;
  double factor = 1;

  bool is_zero() const { return step == zero; }
};

// The rules of differentiation, as steps of a list. `v` is the step that has the value, a and b those of its operands, a' and a'' their
// derivatives. What multiplies a derivative comes from the values alone, so that all directions share it. A number that stands twice in a
// rule is one interval too many: hence squares, and quotients v' = (a' - v b') / b by the value that is there.
class Rules {
 public:
  explicit Rules(Builder& list) : list_(list) {}

  // The step that gives it.
  int written(const Multiple& x) {
    if (x.is_zero()) return list_.constant(0);
    if (x.factor == 1) return x.step;
    if (x.factor == -1) return list_.add(Operation::negate, x.step);
    return list_.add(Operation::multiply, list_.constant(x.factor), x.step);
  }
  Multiple one() { return {list_.constant(1), 1}; }
  Multiple input(int i) { return {list_.input(i), 1}; }

  Multiple first(const Step& s, int v, const Multiple& da, const Multiple& db, const Multiple& dc) {
    const Multiple value = of(v), a = of(s.a), b = of(s.b);
    switch (s.operation) {
      case Operation::add:
        return sum(da, db);
      case Operation::subtract:
        return sum(da, minus(db));
      case Operation::multiply:
        return sum(product(da, b), product(a, db));
      case Operation::square:
        return product(twice(a), da);
      case Operation::divide:
        if (da.is_zero()) return minus(product(quotient_by(v, s.b), db));
        return product(sum(da, minus(product(value, db))), inverse(s.b));
      case Operation::hypot:  // (a a' + b b') / v
        return sum(product(quotient_by(s.a, v), da), product(quotient_by(s.b, v), db));
      case Operation::atan2:  // of (b, a): (b a' - a b') / (a^2 + b^2)
        return uncut(s, sum(product(product(b, by_radius(s)), da), minus(product(product(a, by_radius(s)), db))));
      case Operation::min:
        return chosen(list_.add(Operation::less, s.a, s.b), da, db);
      case Operation::max:
        return chosen(list_.add(Operation::less, s.a, s.b), db, da);
      case Operation::choose:
        return settled(s.a, chosen(s.a, db, dc));
      case Operation::settled:
        return settled(s.a, db);
      case Operation::uncut:
        return uncut(s, dc);
      default:
        return da.is_zero() ? Multiple() : product(slope(s, v), da);
    }
  }

  // `dv`: the first derivative. That of a sum is the sum of theirs; the others are first() of the accelerations, and what is quadratic in
  // the rates.
  Multiple second(const Step& s, int v, const Multiple& dv, const Multiple& da, const Multiple& db, const Multiple& dda,
                  const Multiple& ddb, const Multiple& ddc) {
    const Multiple value = of(v), a = of(s.a), b = of(s.b);
    const bool still = da.is_zero() && db.is_zero();
    if (still) return first(s, v, dda, ddb, ddc);
    switch (s.operation) {
      case Operation::multiply:  // a'' b + a b'' + 2 a' b'
        return sum(first(s, v, dda, ddb, ddc), twice(product(da, db)));
      case Operation::square:  // 2 (a'^2 + a a'')
        return twice(sum(squared(da), product(a, dda)));
      case Operation::divide: {
        // v b = a, twice differentiated: v'' = (a'' - v b'' - 2 v' b') / b; of a constant a with v' = -v b' / b:
        // v'' = 2 v (b' / b)^2 - v b'' / b
        if (!da.is_zero() || !dda.is_zero())
          return product(sum(sum(dda, minus(product(value, ddb))), minus(twice(product(dv, db)))), inverse(s.b));
        return sum(twice(product(value, squared(product(inverse(s.b), db)))), first(s, v, dda, ddb, ddc));
      }
      case Operation::sqrt:  // v^2 = a, twice differentiated: v'' = (a'' / 2 - v'^2) / v
        return product(sum(half(dda), minus(squared(dv))), inverse(v));
      case Operation::sin:
      case Operation::cos:
        return sum(first(s, v, dda, ddb, ddc), minus(product(value, squared(da))));
      case Operation::tan:  // v' = (1 + v^2) a'
        return product(slope(s, v), sum(dda, twice(product(value, squared(da)))));
      case Operation::asin:
      case Operation::acos:  // v' = k a', k^2 = 1 / (1 - a^2), k' = k^3 a a' : v'' = k (a'' + a v'^2)
        return product(slope(s, v), sum(dda, product(a, squared(dv))));
      case Operation::hypot: {
        // v^2 = a^2 + b^2, twice differentiated, with a'^2 + b'^2 - v'^2 = ((a b' - b a') / v)^2
        const Multiple across = sum(product(quotient_by(s.a, v), db), minus(product(quotient_by(s.b, v), da)));
        return sum(first(s, v, dda, ddb, ddc), product(squared(across), inverse(v)));
      }
      case Operation::atan2: {
        // v' r^2 = b a' - a b' with r^2 = a^2 + b^2: v'' = (b a'' - a b'') / r^2 - v' (r^2)' / r^2
        const Multiple radial = sum(product(product(b, by_radius(s)), db), product(product(a, by_radius(s)), da));
        return sum(first(s, v, dda, ddb, ddc), minus(twice(product(dv, radial))));
      }
      case Operation::min:
      case Operation::max:
      case Operation::abs: {  // their rates jump where they have a kink
        const int other = s.operation == Operation::abs ? list_.constant(0) : s.b;
        return settled(list_.add(Operation::less, s.a, other), first(s, v, dda, ddb, ddc));
      }
      default:  // linear, piecewise at least
        return first(s, v, dda, ddb, ddc);
    }
  }

 private:
  static Multiple of(int step) { return {step, 1}; }
  static Multiple minus(Multiple x) { return {x.step, -x.factor}; }
  static Multiple twice(Multiple x) { return {x.step, 2 * x.factor}; }
  static Multiple half(Multiple x) { return {x.step, 0.5 * x.factor}; }

  Multiple sum(const Multiple& x, const Multiple& y) {
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    const double first = std::abs(x.factor), second = std::abs(y.factor);
    if (first < second || (first == second && x.factor < 0 && y.factor > 0)) return sum(y, x);
    if (x.step == y.step && x.factor == -y.factor) return {};
    if (x.step == y.step && x.factor == y.factor) return twice(x);
    const int other = written({y.step, std::abs(y.factor / x.factor)});
    const bool same = (x.factor < 0) == (y.factor < 0);
    return {list_.add(same ? Operation::add : Operation::subtract, x.step, other), x.factor};
  }
  Multiple product(const Multiple& x, const Multiple& y) {
    if (x.is_zero() || y.is_zero()) return {};
    return {list_.add(Operation::multiply, x.step, y.step), x.factor * y.factor};
  }
  Multiple squared(const Multiple& x) {
    if (x.is_zero()) return {};
    return {list_.add(Operation::square, x.step), x.factor * x.factor};
  }
  Multiple chosen(int mask, const Multiple& x, const Multiple& y) {
    if (x.is_zero() && y.is_zero()) return {};
    const double factor = x.is_zero() ? y.factor : x.factor;
    const auto branch = [&](const Multiple& z) { return written({z.step, z.factor / factor}); };
    const int first = branch(x);
    return {list_.add(Operation::choose, mask, first, branch(y)), factor};
  }

  // The derivatives of what may jump.
  Multiple settled(int mask, const Multiple& x) { return {list_.add(Operation::settled, mask, written({x.step, 1})), x.factor}; }
  Multiple uncut(const Step& s, const Multiple& x) {
    if (x.is_zero()) return {};
    return {list_.add(Operation::uncut, s.a, s.b, x.step), x.factor};
  }

  // 1 / b; and x / b by it.
  Multiple inverse(int b) { return of(list_.add(Operation::divide, list_.constant(1), b)); }
  Multiple quotient_by(int x, int b) { return product(of(x), inverse(b)); }
  // 1 / (a^2 + b^2)
  Multiple by_radius(const Step& s) {
    const int first = list_.add(Operation::square, s.a);
    return inverse(list_.add(Operation::add, first, list_.add(Operation::square, s.b)));
  }

  // dv/da of a function of one number.
  Multiple slope(const Step& s, int v) {
    const auto of_arc = [&] {  // 1 / sqrt(1 - a^2)
      const int cosine_squared = list_.add(Operation::subtract, list_.constant(1), list_.add(Operation::square, s.a));
      return inverse(list_.add(Operation::sqrt, cosine_squared));
    };
    switch (s.operation) {
      case Operation::negate:
        return minus(one());
      case Operation::sqrt:  // from v^2 = a
        return half(inverse(v));
      case Operation::sin:
        return of(list_.add(Operation::cos, s.a));
      case Operation::cos:
        return minus(of(list_.add(Operation::sin, s.a)));
      case Operation::tan:
        return of(list_.add(Operation::add, list_.add(Operation::square, v), list_.constant(1)));
      case Operation::asin:
        return of_arc();
      case Operation::acos:
        return minus(of_arc());
      case Operation::abs: {
        const int negative = list_.add(Operation::less, s.a, list_.constant(0)), minus_one = list_.constant(-1);
        return of(list_.add(Operation::choose, negative, minus_one, list_.constant(1)));
      }
      default:  // not of one number: constants, inputs, masks
        return {};
    }
  }

  Builder& list_;
};

// The program once more at the head of a list. `then(i, s, v)`: step i of the program became v, and is s by the new numbers.
template <class Then>
std::vector<int> copy(const Program& program, Builder& list, Then&& then) {
  std::vector<int> now;
  for (std::size_t i = 0; i < program.steps().size(); ++i) {
    Step s = program.steps()[i];
    int* operands[] = {&s.a, &s.b, &s.c};
    for (int k = 0; k < operands_of(s.operation); ++k) *operands[k] = now[static_cast<std::size_t>(*operands[k])];
    now.push_back(list.add(s));
    then(i, s, now.back());
  }
  return now;
}

// The derivative of operand k of a step; zero where it has none, or is a mask.
Multiple of_operand(const Step& s, int k, std::span<const Multiple> derivatives) {
  const int operands[] = {s.a, s.b, s.c};
  return k < operands_of(s.operation) ? derivatives[static_cast<std::size_t>(operands[k])] : Multiple();
}

}  // namespace

Program partials(const Program& program, std::span<const int> by) {
  Builder list(4 * program.steps().size());
  Rules rules(list);
  std::vector<std::vector<Multiple>> d(by.size(), std::vector<Multiple>(program.steps().size()));
  const std::vector<int> now = copy(program, list, [&](std::size_t i, const Step& s, int v) {
    const Step& old = program.steps()[i];
    for (std::size_t k = 0; k < by.size(); ++k) {
      const auto operand = [&](int n) { return of_operand(old, n, d[k]); };
      if (old.operation == Operation::input) {
        if (old.a == by[k]) d[k][i] = rules.one();
      } else if (!gives_mask(old.operation)) {
        d[k][i] = rules.first(s, v, operand(0), operand(1), operand(2));
      }
    }
  });
  std::vector<int> outputs;
  for (const int o : program.outputs()) outputs.push_back(now[static_cast<std::size_t>(o)]);
  for (const int o : program.outputs())
    for (const auto& direction : d) outputs.push_back(rules.written(direction[static_cast<std::size_t>(o)]));
  return Program(list.steps(), program.inputs(), outputs);
}

Program in_time(const Program& program, int order) {
  Builder list(4 * program.steps().size());
  Rules rules(list);
  std::vector<Multiple> rate(program.steps().size()), acceleration(program.steps().size());
  const std::vector<int> now = copy(program, list, [&](std::size_t i, const Step& s, int v) {
    const Step& old = program.steps()[i];
    const auto d = [&](int n) { return of_operand(old, n, rate); };
    const auto dd = [&](int n) { return of_operand(old, n, acceleration); };
    if (old.operation == Operation::input) {
      rate[i] = rules.input(program.inputs() + old.a);
      if (order == 2) acceleration[i] = rules.input(2 * program.inputs() + old.a);
    } else if (!gives_mask(old.operation)) {
      rate[i] = rules.first(s, v, d(0), d(1), d(2));
      if (order == 2) acceleration[i] = rules.second(s, v, rate[i], d(0), d(1), dd(0), dd(1), dd(2));
    }
  });
  std::vector<int> outputs;
  for (const int o : program.outputs()) outputs.push_back(now[static_cast<std::size_t>(o)]);
  for (const int o : program.outputs()) outputs.push_back(rules.written(rate[static_cast<std::size_t>(o)]));
  if (order == 2)
    for (const int o : program.outputs()) outputs.push_back(rules.written(acceleration[static_cast<std::size_t>(o)]));
  return Program(list.steps(), (order + 1) * program.inputs(), outputs);
}

}  // namespace pmreport::program
