#include <core/scan/judge/kernel.hpp>

#include <core/vectors.hpp>

#include <algorithm>

namespace pmreport::scan {

namespace {

[[gnu::always_inline]] inline double told(double margin, double slack) {
  const double at_least = margin >= -slack ? is_on_a_limit : is_refused;
  return margin > slack ? is_kept : at_least;
}

[[gnu::always_inline]] inline std::size_t judge_all(std::size_t margins, const double* slack, std::size_t count, const double* values,
                                                    double* known) {
  constexpr std::size_t block = 512;  // what is known of so many poses stays in the first-level cache from margin to margin
  std::uint64_t left = 0;
  for (std::size_t start = 0; start < count; start += block) {
    const std::size_t n = std::min(block, count - start);
    double* state = known + start;
    for (std::size_t m = 0; m < margins; ++m) {
      const double* value = values + m * count + start;
      const double s = slack[m];
#ifndef __clang__
#pragma GCC ivdep
#endif
      for (std::size_t k = 0; k < n; ++k) {
        const double x = told(value[k], s);
        state[k] = x < state[k] ? x : state[k];
      }
    }
    for (std::size_t k = 0; k < n; ++k) left += state[k] > is_refused ? 1u : 0u;
  }
  return left;
}

[[gnu::always_inline]] inline Refusals explain_one(double slack, std::size_t count, const double* values, double* known) {
  std::uint64_t any = 0, first = 0;
#ifndef __clang__
#pragma GCC ivdep
#endif
  for (std::size_t k = 0; k < count; ++k) {
    const double x = told(values[k], slack), before = known[k];
    const std::uint64_t refused = x > is_refused ? 0u : 1u, was_left = before > is_refused ? 1u : 0u;
    any += refused;
    first += refused & was_left;
    known[k] = x < before ? x : before;
  }
  return {any, first};
}

[[gnu::flatten]] std::size_t judge_plain(std::size_t m, const double* s, std::size_t n, const double* v, double* k) {
  return judge_all(m, s, n, v, k);
}
[[gnu::flatten]] Refusals explain_plain(double s, std::size_t n, const double* v, double* k) { return explain_one(s, n, v, k); }
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("arch=x86-64-v3")]] std::size_t judge_v3(std::size_t m, const double* s, std::size_t n, const double* v,
                                                                     double* k) {
  return judge_all(m, s, n, v, k);
}
[[gnu::flatten, gnu::target("arch=x86-64-v3")]] Refusals explain_v3(double s, std::size_t n, const double* v, double* k) {
  return explain_one(s, n, v, k);
}
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] std::size_t judge_v4(std::size_t m, const double* s, std::size_t n, const double* v,
                                                                     double* k) {
  return judge_all(m, s, n, v, k);
}
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] Refusals explain_v4(double s, std::size_t n, const double* v, double* k) {
  return explain_one(s, n, v, k);
}
#endif

}  // namespace

const JudgeKernel& judge_kernel() {
  static const JudgeKernel kernel = [] {
#if defined(__x86_64__)
    if (vector_level() >= 4) return JudgeKernel{judge_v4, explain_v4};
    if (vector_level() >= 3) return JudgeKernel{judge_v3, explain_v3};
#endif
    return JudgeKernel{judge_plain, explain_plain};
  }();
  return kernel;
}

}  // namespace pmreport::scan
