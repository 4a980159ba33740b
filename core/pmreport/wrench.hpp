// Rows of the overall Jacobian: unit wrenches on the platform, (force; moment about the reference point).
#pragma once

#include <pmreport/scalar.hpp>

namespace pmreport {

// Row i: a force along `direction` whose line passes at `arm` from the reference point. Also the rate of a length along it.
template <class T>
void force_row(Matrix6<T>& g, int i, const Vector3<T>& direction, const Vector3<T>& arm) {
  const Vector3<T> moment = arm.cross(direction);
  for (int k = 0; k < 3; ++k) g(i, k) = direction(k), g(i, k + 3) = moment(k);
}

// Row i: a couple about `direction`.
template <class T>
void couple_row(Matrix6<T>& g, int i, const Vector3<T>& direction) {
  for (int k = 0; k < 3; ++k) g(i, k) = T(0.0), g(i, k + 3) = direction(k);
}

}  // namespace pmreport
