#include <tests/proof/pieces.hpp>

#include <algorithm>

namespace pmreport::test {

mechanics::Enclosure bounds_of(std::vector<Pieces> coordinates);  // in pieces_upward.cpp

namespace {

template <class T>
void at(const Pieces& p, T t, T& value, T& rate, T& acceleration) {
  const auto after = std::ranges::upper_bound(p.cubics.begin() + 1, p.cubics.end(), t, {}, &Cubic::from);
  const Cubic& cubic = *(after - 1);
  const T s = t - cubic.from, c0 = cubic.c[0], c1 = cubic.c[1], c2 = cubic.c[2], c3 = cubic.c[3];
  value = c0 + s * (c1 + s * (c2 + s * c3));
  rate = c1 + s * (2 * c2 + s * 3 * c3);
  acceleration = 2 * c2 + 6 * c3 * s;
}

}  // namespace

Law law_of(std::vector<Pieces> coordinates) {
  return [coordinates = std::move(coordinates)](long double t, long double* value, long double* rate, long double* acceleration) {
    for (const Pieces& p : coordinates) at(p, t, *value++, *rate++, *acceleration++);
  };
}

mechanics::Trajectory pieces_motion(std::vector<Pieces> coordinates, double begin, double end, int samples) {
  std::vector<double> times;
  for (int k = 0; k < samples; ++k) times.push_back(k + 1 == samples ? end : begin + (end - begin) * k / (samples - 1));
  mechanics::Trajectory out = mechanics::sampled(
      [coordinates](double t, double* value, double* rate, double* acceleration) {
        for (const Pieces& p : coordinates) at(p, t, *value++, *rate++, *acceleration++);
        return true;
      },
      std::move(times), static_cast<int>(coordinates.size()));
  for (const Pieces& p : coordinates)
    for (const Cubic& c : p.cubics)
      if (begin < c.from && c.from < end) out.knots.push_back(c.from);
  std::ranges::sort(out.knots);
  out.knots.erase(std::unique(out.knots.begin(), out.knots.end()), out.knots.end());
  out.over = bounds_of(std::move(coordinates));
  return out;
}

}  // namespace pmreport::test
