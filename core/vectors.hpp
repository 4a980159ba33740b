// The vectors of the processor that the program runs on.
#pragma once

namespace pmreport {

// The level of the x86-64 psABI whose instructions it has: 4, 3, or 0 for less and for other processors. By features: Clang 14 cannot be
// asked for levels. Those that compilers use in loops over numbers are looked at; the others of a level came with the same processors.
inline int vector_level() {
#if defined(__x86_64__)
  const bool v3 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
                  __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  return v4 ? 4 : v3 ? 3 : 0;
#else
  return 0;
#endif
}

}  // namespace pmreport
