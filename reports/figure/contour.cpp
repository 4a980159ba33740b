#include <reports/figure/contour.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace pmreport::figure {
namespace {

// An end of a piece: where it is, and on which edge of the grid. Both cells beside an edge find the same point on it.
struct End {
  std::size_t edge;
  Point at;
};
struct Piece {
  End from, to;
};

// Marching squares. A cell whose corners alternate in sign has two pieces; the sign of its middle tells which corners they cut off.
std::vector<Piece> pieces_of(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& values, double pole) {
  const std::size_t columns = x.size(), rows = y.size();
  std::vector<Piece> pieces;
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::array<std::array<std::size_t, 2>, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      // Edges that leave a point to the right have even numbers, upward odd ones.
      const std::array<std::size_t, 4> edges{2 * (j * columns + i), 2 * (j * columns + i + 1) + 1, 2 * ((j + 1) * columns + i),
                                             2 * (j * columns + i) + 1};
      std::array<double, 4> v{};
      for (std::size_t k = 0; k < 4; ++k) v[k] = values[corners[k][1] * columns + corners[k][0]];
      if (!std::all_of(v.begin(), v.end(), [](double a) { return std::isfinite(a); })) continue;
      std::vector<End> cuts;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t n = (k + 1) % 4;
        if ((v[k] < 0) == (v[n] < 0) || std::min(std::abs(v[k]), std::abs(v[n])) > pole) continue;
        const double s = v[k] / (v[k] - v[n]);
        cuts.push_back({edges[k], {x[corners[k][0]] * (1 - s) + x[corners[n][0]] * s, y[corners[k][1]] * (1 - s) + y[corners[n][1]] * s}});
      }
      if (cuts.size() == 2) pieces.push_back({cuts[0], cuts[1]});
      if (cuts.size() == 4) {
        const bool middle_like_first = (v[0] + v[1] + v[2] + v[3] < 0) == (v[0] < 0);
        pieces.push_back({cuts[0], cuts[middle_like_first ? 1 : 3]});
        pieces.push_back({cuts[2], cuts[middle_like_first ? 3 : 1]});
      }
    }
  return pieces;
}

}  // namespace

std::vector<Stroke> zero_lines(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& values, double pole,
                               const std::function<bool(Point)>& wanted) {
  std::vector<Piece> pieces = pieces_of(x, y, values, pole);
  std::erase_if(pieces, [&](const Piece& p) { return !wanted({(p.from.at.x + p.to.at.x) / 2, (p.from.at.y + p.to.at.y) / 2}); });
  std::unordered_map<std::size_t, std::array<std::size_t, 2>> ends;  // of each edge: the pieces that end there, counted from 1
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const std::size_t edge : {pieces[k].from.edge, pieces[k].to.edge}) {
      auto& two = ends[edge];
      (two[0] == 0 ? two[0] : two[1]) = k + 1;
    }
  std::vector<bool> used(pieces.size());
  std::vector<Stroke> strokes;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (used[k]) continue;
    used[k] = true;
    std::vector<End> line{pieces[k].from, pieces[k].to};
    for (int side = 0; side < 2; ++side) {
      for (bool grew = true; grew;) {
        grew = false;
        for (const std::size_t next : ends.at(line.back().edge)) {
          if (next == 0 || used[next - 1]) continue;
          const Piece& p = pieces[next - 1];
          line.push_back(p.from.edge == line.back().edge ? p.to : p.from);
          used[next - 1] = grew = true;
          break;
        }
      }
      std::reverse(line.begin(), line.end());
    }
    // Where a corner is zero itself, edges are cut in one point.
    Stroke stroke;
    for (const End& end : line)
      if (stroke.empty() || stroke.back().x != end.at.x || stroke.back().y != end.at.y) stroke.push_back(end.at);
    if (stroke.size() > 1) strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace pmreport::figure
