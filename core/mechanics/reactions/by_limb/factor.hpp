// Wide systems C x = d of full row rank, by Householder reflections from the right,
//     C H_1 ... H_m = [L 0],   H_i = 1 - f_i v_i v_i^T,   f_i = 2 / v_i^2               (1)
// With y = (L^-1 d; 0), x = H_1 ... H_m y is the least-norm solution, and H_1 ... H_m applied to the last n - m unit vectors is an
// orthonormal basis of what the equations leave open. All of it comes without pivots, hence without a branch: all lanes do the same.
#pragma once

#include <core/mechanics/reactions/by_limb/pack.hpp>

namespace pmreport::mechanics {

// C is m x n, m <= n, row-major. What is left in it: L below the diagonal, and from the diagonal on the vectors of the reflections.
template <class T>
struct WideSystem {
  T* c;
  T* diagonal;  // of L, m
  T* factor;    // H_i = 1 - factor_i v_i v_i^T, m
  int m, n;

  PMREPORT_INLINE void decompose() {
    for (int i = 0; i < m; ++i) {
      T* v = c + i * n;
      const T first = v[i];
      if (i + 1 == n) {  // a single number is reflected for nothing
        diagonal[i] = first;
        factor[i] = T(0.0);
        break;
      }
      T square = first * first;
      for (int j = i + 1; j < n; ++j) square += v[j] * v[j];
      const T norm = root(square), away = where_less(first, T(0.0), -norm, norm);  // no cancellation in first + away
      diagonal[i] = -away;
      factor[i] = T(1.0) / (square + first * away);
      v[i] = first + away;
      for (int r = i + 1; r < m; ++r) reflect(i, c + r * n);
    }
  }
  // x = least-norm solution for d, which becomes L^-1 d.
  PMREPORT_INLINE void solve(T* d, T* x) const {
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < i; ++j) d[i] -= c[i * n + j] * d[j];
      d[i] = d[i] / diagonal[i];
      x[i] = d[i];
    }
    for (int j = m; j < n; ++j) x[j] = T(0.0);
    turn_back(x);
  }
  // Vector k of n - m that span what C does not see.
  PMREPORT_INLINE void open(int k, T* x) const {
    for (int j = 0; j < n; ++j) x[j] = T(j == m + k ? 1.0 : 0.0);
    turn_back(x);
  }

 private:
  PMREPORT_INLINE void reflect(int i, T* x) const {
    const T* v = c + i * n;
    T along = v[i] * x[i];
    for (int j = i + 1; j < n; ++j) along += v[j] * x[j];
    along = along * factor[i];
    for (int j = i; j < n; ++j) x[j] -= along * v[j];
  }
  PMREPORT_INLINE void turn_back(T* x) const {
    for (int i = m - 1; i >= 0; --i) reflect(i, x);
  }
};

}  // namespace pmreport::mechanics
