#include "interval_judges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace pmreport::judges {

namespace {

constexpr int digits = 200;  // binary; no double lies between a value and what is said of it

// x^n over an interval: its extremes are at the ends, and at zero for n > 0.
void power_range(mpfi_t r, const mpfi_t a, double n) {
  mpfr_t exponent, at;
  mpfr_init2(exponent, 53);
  mpfr_init2(at, mpfi_get_prec(r));
  mpfr_set_d(exponent, n, MPFR_RNDN);
  const bool through_zero = mpfi_has_zero(a) > 0;
  if (through_zero && n < 0) {
    mpfr_set_inf(&r->left, -1);
    mpfr_set_inf(&r->right, 1);
  } else {
    mpfr_pow(&r->left, &a->left, exponent, MPFR_RNDD);
    mpfr_pow(at, &a->right, exponent, MPFR_RNDD);
    const bool undefined = mpfr_nan_p(&r->left) || mpfr_nan_p(at);
    mpfr_min(&r->left, &r->left, at, MPFR_RNDD);
    mpfr_pow(&r->right, &a->left, exponent, MPFR_RNDU);
    mpfr_pow(at, &a->right, exponent, MPFR_RNDU);
    mpfr_max(&r->right, &r->right, at, MPFR_RNDU);
    if (through_zero && mpfr_sgn(&r->left) > 0) mpfr_set_zero(&r->left, 1);
    if (undefined) mpfr_set_nan(&r->left);
  }
  mpfr_clear(exponent);
  mpfr_clear(at);
}
template <int numerator, int denominator>
void power_range(mpfi_t r, const mpfi_t a, const mpfi_t) {
  power_range(r, a, static_cast<double>(numerator) / denominator);
}
template <int numerator, int denominator>
void power_value(arb_t r, const arb_t a, const arb_t, slong bits) {
  arb_t exponent;
  arb_init(exponent);
  arb_set_d(exponent, static_cast<double>(numerator) / denominator);
  arb_pow(r, a, exponent, bits);
  arb_clear(exponent);
}

template <int (*f)(mpfi_ptr, mpfi_srcptr)>
void range_of_one(mpfi_t r, const mpfi_t a, const mpfi_t) {
  f(r, a);
}
template <int (*f)(mpfi_ptr, mpfi_srcptr, mpfi_srcptr)>
void range_of_two(mpfi_t r, const mpfi_t a, const mpfi_t b) {
  f(r, a, b);
}
template <void (*f)(arb_t, const arb_t, slong)>
void value_of_one(arb_t r, const arb_t a, const arb_t, slong bits) {
  f(r, a, bits);
}
template <void (*f)(arb_t, const arb_t, const arb_t, slong)>
void value_of_two(arb_t r, const arb_t a, const arb_t b, slong bits) {
  f(r, a, b, bits);
}

// Over all a of one interval and b of another: each end is that of the ends.
void smaller_range(mpfi_t r, const mpfi_t a, const mpfi_t b) {
  mpfr_min(&r->left, &a->left, &b->left, MPFR_RNDD);
  mpfr_min(&r->right, &a->right, &b->right, MPFR_RNDU);
}
void larger_range(mpfi_t r, const mpfi_t a, const mpfi_t b) {
  mpfr_max(&r->left, &a->left, &b->left, MPFR_RNDD);
  mpfr_max(&r->right, &a->right, &b->right, MPFR_RNDU);
}

// Of a function that is bounded by 2, 3 or 4 units: a number just below a power of two has twice as many of its last place, its own error
// and one each for two roundings.
constexpr double of_two = 7, of_three = 10, of_four = 13;

}  // namespace

const std::vector<JudgedOperation>& judged_operations() {
  static const std::vector<JudgedOperation> all{
      {"x + y", 2, Operands::any, 0, range_of_two<mpfi_add>, value_of_two<arb_add>},
      {"x - y", 2, Operands::any, 0, range_of_two<mpfi_sub>, value_of_two<arb_sub>},
      {"x y", 2, Operands::any, 0, range_of_two<mpfi_mul>, value_of_two<arb_mul>},
      {"x / y", 2, Operands::any, 0, range_of_two<mpfi_div>, value_of_two<arb_div>},
      {"-x", 1, Operands::any, 0, range_of_one<mpfi_neg>, [](arb_t r, const arb_t a, const arb_t, slong) { arb_neg(r, a); }},
      {"abs", 1, Operands::any, 0, range_of_one<mpfi_abs>, [](arb_t r, const arb_t a, const arb_t, slong) { arb_abs(r, a); }},
      {"square", 1, Operands::any, 0, range_of_one<mpfi_sqr>, value_of_one<arb_sqr>},
      {"sqrt", 1, Operands::positive, 0, range_of_one<mpfi_sqrt>, value_of_one<arb_sqrt>},
      {"smaller", 2, Operands::any, 0, smaller_range, value_of_two<arb_min>},
      {"larger", 2, Operands::any, 0, larger_range, value_of_two<arb_max>},
      {"hypot", 2, Operands::moderate, 3, range_of_two<mpfi_hypot>, value_of_two<arb_hypot>, 0x1p-480},
      {"sin", 1, Operands::angle, of_three, range_of_one<mpfi_sin>, value_of_one<arb_sin>, 0x1p-30},
      {"cos", 1, Operands::angle, of_three, range_of_one<mpfi_cos>, value_of_one<arb_cos>, 0x1p-30},
      {"tan", 1, Operands::angle, of_two, range_of_one<mpfi_tan>, value_of_one<arb_tan>},
      {"asin", 1, Operands::unit, of_three, range_of_one<mpfi_asin>, value_of_one<arb_asin>},
      {"acos", 1, Operands::unit, of_three, range_of_one<mpfi_acos>, value_of_one<arb_acos>},
      {"atan", 1, Operands::any, of_three, range_of_one<mpfi_atan>, value_of_one<arb_atan>},
      {"atan2", 2, Operands::moderate, of_three, range_of_two<mpfi_atan2>, value_of_two<arb_atan2>},
      {"exp", 1, Operands::moderate, of_two, range_of_one<mpfi_exp>, value_of_one<arb_exp>},
      {"log", 1, Operands::positive, of_two, range_of_one<mpfi_log>, value_of_one<arb_log>},
      {"sinh", 1, Operands::moderate, of_four, range_of_one<mpfi_sinh>, value_of_one<arb_sinh>},
      {"cosh", 1, Operands::moderate, of_four, range_of_one<mpfi_cosh>, value_of_one<arb_cosh>},
      {"tanh", 1, Operands::moderate, of_four, range_of_one<mpfi_tanh>, value_of_one<arb_tanh>},
      {"x^2", 1, Operands::any, 0, power_range<2, 1>, power_value<2, 1>},
      {"x^3", 1, Operands::moderate, of_two, power_range<3, 1>, power_value<3, 1>},
      {"x^7", 1, Operands::moderate, of_two, power_range<7, 1>, power_value<7, 1>},
      {"x^-1", 1, Operands::moderate, of_two, power_range<-1, 1>, power_value<-1, 1>},
      {"x^-2", 1, Operands::moderate, of_two, power_range<-2, 1>, power_value<-2, 1>},
      {"x^0.5", 1, Operands::positive, of_two, power_range<1, 2>, power_value<1, 2>},
      {"x^1.7", 1, Operands::positive, of_two, power_range<17, 10>, power_value<17, 10>},
      {"x^-0.3", 1, Operands::positive, of_two, power_range<-3, 10>, power_value<-3, 10>},
  };
  return all;
}

const JudgedOperation& judged_operation(const std::string& name) {
  return *std::find_if(judged_operations().begin(), judged_operations().end(), [&](const JudgedOperation& o) { return o.name == name; });
}

Bounds operand(Operands from, std::mt19937_64& random) {
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto sign = [&] { return random() % 2 == 0 ? 1.0 : -1.0; };
  const auto sized = [&](double least, double most) { return std::exp2(least + (most - least) * share()); };
  constexpr double half_pi = std::numbers::pi / 2, greatest = std::numeric_limits<double>::max();

  double low = 0;
  switch (from) {
    case Operands::any:
      low = sign() * (random() % 4 == 0 ? sized(-1080, 1023.9) : sized(-10, 10));
      if (random() % 64 == 0) low = sign() * greatest;
      break;
    case Operands::angle:
      low = random() % 4 == 0   ? sign() * sized(-60, 21)
            : random() % 2 == 0 ? 20 * (2 * share() - 1)
                                : static_cast<double>(random() % 200) * half_pi;
      if (random() % 8 == 0) low = std::nextafter(low, sign() * greatest);
      break;
    case Operands::unit:
      low = random() % 4 == 0 ? sign() * sized(-60, 0) : random() % 4 == 0 ? sign() * (1 - sized(-53, -1)) : 2.0 * share() - 1;
      if (random() % 16 == 0) low = -1;
      break;
    case Operands::moderate:
      low = random() % 4 == 0 ? sign() * sized(-60, 9.4) : 20 * (2 * share() - 1);
      break;
    case Operands::positive:
      low = random() % 4 == 0 ? sized(-1080, 1023.9) : random() % 4 == 0 ? 1 + sign() * sized(-53, -1) : 10 * share();
      if (random() % 64 == 0) low = -low;
      break;
  }
  if (random() % 16 == 0) low = random() % 2 == 0 ? 0.0 : -0.0;

  double high = low;
  switch (random() % 4) {
    case 0:
      break;
    case 1:
      for (std::uint64_t i = random() % 3 + 1; i > 0; --i) high = std::nextafter(high, greatest);
      break;
    case 2:
      high = low + std::max(std::abs(low), 0x1p-1000) * sized(-50, 0);
      break;
    default:
      high = low + sized(-20, 5);
  }
  if (random() % 16 == 0 && low < 0) high = 0;
  if (from == Operands::unit && random() % 16 != 0) high = std::min(high, 1.0);
  return {low, std::isfinite(high) && low <= high ? high : low};
}

Judges::Judges() {
  for (mpfi_ptr x : {a_, b_, r_}) mpfi_init2(x, digits);
  for (mpfi_ptr x : {a53_, b53_, r53_}) mpfi_init2(x, 53);
  for (arb_ptr x : {x_, y_, z_, u_, v_}) arb_init(x);
  arf_init(end_);
}
Judges::~Judges() {
  for (mpfi_ptr x : {a_, b_, r_, a53_, b53_, r53_}) mpfi_clear(x);
  for (arb_ptr x : {x_, y_, z_, u_, v_}) arb_clear(x);
  arf_clear(end_);
  flint_cleanup();
}

std::optional<std::string> Judges::wrong(const JudgedOperation& o, const Bounds& a, const Bounds& b, const Bounds& ours,
                                         std::mt19937_64& random) {
  const auto told = [&](const std::string& what) {
    return fmt::format("{} over [{:a}, {:a}] and [{:a}, {:a}] is [{:a}, {:a}], {}", o.name, a.low, a.high, b.low, b.high, ours.low,
                       ours.high, what);
  };
  if (std::isnan(ours.low) || std::isnan(ours.high)) return told("no number");
  if (!ours.bounded()) return {};

  mpfi_interv_d(a_, a.low, a.high);
  mpfi_interv_d(b_, b.low, b.high);
  o.range(r_, a_, b_);
  if (mpfi_nan_p(r_) || !mpfi_bounded_p(r_)) return told("where MPFI has no bounds");
  if (mpfr_cmp_d(&r_->left, ours.low) < 0 || mpfr_cmp_d(&r_->right, ours.high) > 0)
    return told(fmt::format("MPFI's is [{:a}, {:a}]", mpfr_get_d(&r_->left, MPFR_RNDN), mpfr_get_d(&r_->right, MPFR_RNDN)));

  // A point is one double of each operand.
  const auto any = [&](const Bounds& x) {
    const double share = static_cast<double>(random() % 5) / 4;
    return std::clamp(x.low + share * x.width(), x.low, x.high);
  };
  const double p = any(a), q = any(b);
  arb_set_d(x_, p);
  arb_set_d(y_, q);
  o.value(z_, x_, y_, digits);
  if (!arb_is_finite(z_)) return told(fmt::format("but Arb has no value at {:a}, {:a}", p, q));
  arb_get_lbound_arf(end_, z_, digits);
  const bool above = arf_cmp_d(end_, ours.high) > 0;
  arb_get_ubound_arf(end_, z_, digits);
  const bool below = arf_cmp_d(end_, ours.low) < 0;
  if (above || below) return told(fmt::format("at {:a}, {:a} Arb has {:a}", p, q, arf_get_d(end_, ARF_RND_NEAR)));
  return {};
}

double Judges::excess(const JudgedOperation& o, const Bounds& a, const Bounds& b, const Bounds& ours) {
  mpfi_interv_d(a53_, a.low, a.high);
  mpfi_interv_d(b53_, b.low, b.high);
  o.range(r53_, a53_, b53_);
  const double low = mpfr_get_d(&r53_->left, MPFR_RNDD), high = mpfr_get_d(&r53_->right, MPFR_RNDU);
  if (!std::isfinite(low) || !std::isfinite(high)) return 0;
  if (!ours.bounded()) return std::numeric_limits<double>::infinity();
  const auto unit = [&o](double x) {
    const double size = std::max(std::abs(x), o.least);
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  };
  return std::max((low - ours.low) / unit(low), (ours.high - high) / unit(high));
}

double Judges::error_of_point(const JudgedOperation& o, double at, double value, double allowed) {
  arb_set_d(x_, at);
  o.value(z_, x_, x_, digits);
  const double truth = std::abs(arf_get_d(arb_midref(z_), ARF_RND_NEAR));
  arb_set_d(y_, value);
  arb_sub(z_, z_, y_, digits);
  const double error = std::abs(arf_get_d(arb_midref(z_), ARF_RND_NEAR));
  if (error == 0) return 0;
  return error / (allowed > 0 ? allowed : std::nextafter(truth, std::numeric_limits<double>::infinity()) - truth);
}

// By differences over 2^-60, 2^-40 for the second, with 400 digits: off by some 2^-80 times the next derivatives but one.
std::optional<std::string> Judges::wrong_derivative(const JudgedOperation& o, int order, double at, const Bounds& ours) {
  if (!ours.bounded()) return {};
  constexpr slong many = 400;
  const slong step = order == 1 ? -60 : -40;
  arb_set_d(x_, at);
  arb_set_ui(z_, 1);
  arb_mul_2exp_si(z_, z_, step);
  arb_add(y_, x_, z_, many);
  o.value(u_, y_, y_, many);
  arb_sub(y_, x_, z_, many);
  o.value(v_, y_, y_, many);
  if (order == 1) {
    arb_sub(u_, u_, v_, many);
    arb_mul_2exp_si(u_, u_, -step - 1);
  } else {
    arb_add(u_, u_, v_, many);
    o.value(v_, x_, x_, many);
    arb_mul_2exp_si(v_, v_, 1);
    arb_sub(u_, u_, v_, many);
    arb_mul_2exp_si(u_, u_, -2 * step);
  }
  const double derivative = arf_get_d(arb_midref(u_), ARF_RND_NEAR);
  const double rounding = 0x1p-52 * std::abs(derivative) + 0x1p-70;
  if (arb_is_finite(u_) && ours.low - rounding <= derivative && derivative <= ours.high + rounding) return {};
  return fmt::format("derivative {} of {} at {:a} is in [{:a}, {:a}], Arb has {:a}", order, o.name, at, ours.low, ours.high, derivative);
}

}  // namespace pmreport::judges
