#include <arb.h>
#include <mpfi.h>

#include <boost/numeric/interval.hpp>
#include <tests/bench/interval_kernel.hpp>

namespace pmreport::bench {

namespace {

constexpr int digits = 53;

template <class B>
double with_boost(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  double sum = 0;
  for (const PositionBox& b : boxes) {
    std::array<B, 3> p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = B(b.middle[c] - b.half, b.middle[c] + b.half);
    sum += margins<B>(hexapod, p).lower();
  }
  return sum;
}

}  // namespace

double by_boost(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  return with_boost<boost::numeric::interval<double>>(hexapod, boxes);
}
double by_boost_saving_the_mode(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  using namespace boost::numeric;
  using namespace interval_lib;
  return with_boost<interval<double, policies<save_state<rounded_transc_std<double>>, checking_base<double>>>>(hexapod, boxes);
}

double by_mpfi(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  mpfi_t p[3], d[3], squared, length, part, lean, cosine;
  for (std::size_t c = 0; c < 3; ++c) {
    mpfi_init2(p[c], digits);
    mpfi_init2(d[c], digits);
  }
  for (mpfi_ptr x : {squared, length, part, lean, cosine}) mpfi_init2(x, digits);
  mpfi_set_d(cosine, hexapod.cosine);
  double sum = 0;
  for (const PositionBox& b : boxes) {
    for (std::size_t c = 0; c < 3; ++c) mpfi_interv_d(p[c], b.middle[c] - b.half, b.middle[c] + b.half);
    for (const Hexapod::Leg& leg : hexapod.legs) {
      for (std::size_t c = 0; c < 3; ++c) mpfi_add_d(d[c], p[c], leg.from_base[c]);
      mpfi_sqr(squared, d[0]);
      for (std::size_t c = 1; c < 3; ++c) {
        mpfi_sqr(part, d[c]);
        mpfi_add(squared, squared, part);
      }
      mpfi_mul_d(lean, d[0], leg.axis[0]);
      for (std::size_t c = 1; c < 3; ++c) {
        mpfi_mul_d(part, d[c], leg.axis[c]);
        mpfi_add(lean, lean, part);
      }
      mpfi_sqrt(length, squared);
      mpfi_mul(part, cosine, length);
      mpfi_sub(lean, lean, part);
      mpfi_add(lean, lean, squared);
      sum += mpfr_get_d(&lean->left, MPFR_RNDD);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    mpfi_clear(p[c]);
    mpfi_clear(d[c]);
  }
  for (mpfi_ptr x : {squared, length, part, lean, cosine}) mpfi_clear(x);
  return sum;
}

double by_arb(const Hexapod& hexapod, std::span<const PositionBox> boxes) {
  arb_t p[3], d[3], squared, length, lean, cosine, constant;
  for (std::size_t c = 0; c < 3; ++c) {
    arb_init(p[c]);
    arb_init(d[c]);
  }
  for (arb_ptr x : {squared, length, lean, cosine, constant}) arb_init(x);
  arf_t low;
  arf_init(low);
  arb_set_d(cosine, hexapod.cosine);
  double sum = 0;
  for (const PositionBox& b : boxes) {
    for (std::size_t c = 0; c < 3; ++c) {
      arb_set_d(p[c], b.middle[c]);
      mag_set_d(arb_radref(p[c]), b.half);
    }
    for (const Hexapod::Leg& leg : hexapod.legs) {
      for (std::size_t c = 0; c < 3; ++c) {
        arb_set_d(constant, leg.from_base[c]);
        arb_add(d[c], p[c], constant, digits);
      }
      arb_sqr(squared, d[0], digits);
      for (std::size_t c = 1; c < 3; ++c) arb_addmul(squared, d[c], d[c], digits);
      arb_set_d(constant, leg.axis[0]);
      arb_mul(lean, d[0], constant, digits);
      for (std::size_t c = 1; c < 3; ++c) {
        arb_set_d(constant, leg.axis[c]);
        arb_addmul(lean, d[c], constant, digits);
      }
      arb_sqrt(length, squared, digits);
      arb_submul(lean, cosine, length, digits);
      arb_add(lean, lean, squared, digits);
      arb_get_lbound_arf(low, lean, digits);
      sum += arf_get_d(low, ARF_RND_DOWN);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    arb_clear(p[c]);
    arb_clear(d[c]);
  }
  for (arb_ptr x : {squared, length, lean, cosine, constant}) arb_clear(x);
  arf_clear(low);
  return sum;
}

}  // namespace pmreport::bench
