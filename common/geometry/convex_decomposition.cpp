#include "common/geometry/convex_decomposition.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace accord {
namespace {

using Loop = std::vector<std::size_t>;  // indices of vertices, counter-clockwise

// Twice the signed area of a triangle: positive for a left turn.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Whether a turn is a straight line but for rounding.
bool flat(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::abs(turn(a, b, c)) <= 1e-13 * ((b - a).squaredNorm() + (c - b).squaredNorm());
}

std::vector<Vec2> without_flat_vertices(std::span<const Vec2> polygon) {
  std::vector<Vec2> v(polygon.begin(), polygon.end());
  for (std::size_t i = 0; v.size() >= 3 && i < v.size();) {
    const std::size_t n = v.size();
    if (flat(v[(i + n - 1) % n], v[i], v[(i + 1) % n])) {
      v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
      i = i >= 1 ? i - 1 : 0;  // its neighbours may have become flat
    } else {
      ++i;
    }
  }
  if (v.size() < 3) v.clear();
  return v;
}

bool is_ear(const std::vector<Vec2>& v, const Loop& loop, std::size_t i) {
  const std::size_t n = loop.size();
  const Vec2& a = v[loop[(i + n - 1) % n]];
  const Vec2& b = v[loop[i]];
  const Vec2& c = v[loop[(i + 1) % n]];
  if (turn(a, b, c) <= 0) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Vec2& p = v[loop[(i + k) % n]];
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  }
  return true;
}

// The ear with the fattest corner; where rounding leaves none, the most convex vertex.
std::size_t next_ear(const std::vector<Vec2>& v, const Loop& loop) {
  const std::size_t n = loop.size();
  std::size_t best = 0;
  double best_score = -1e300;
  bool best_is_ear = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = v[loop[(i + n - 1) % n]];
    const Vec2& b = v[loop[i]];
    const Vec2& c = v[loop[(i + 1) % n]];
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double score = turn(a, b, c) / longest;
    if (best_is_ear && score <= best_score) continue;
    const bool ear = is_ear(v, loop, i);  // the costly part
    if (best_is_ear ? ear : (ear || score > best_score)) {
      best = i;
      best_score = score;
      best_is_ear = ear;
    }
  }
  return best;
}

std::vector<Loop> triangles_of(const std::vector<Vec2>& v) {
  Loop loop(v.size());
  for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = i;
  std::vector<Loop> triangles;
  while (loop.size() >= 3) {
    const std::size_t n = loop.size();
    const std::size_t i = next_ear(v, loop);
    Loop triangle{loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]};
    if (turn(v[triangle[0]], v[triangle[1]], v[triangle[2]]) > 0) triangles.push_back(triangle);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

bool convex(const std::vector<Vec2>& v, const Loop& loop) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(v[loop[i]], v[loop[(i + 1) % n]], v[loop[(i + 2) % n]]) < 0) return false;
  }
  return true;
}

// The two loops as one across an edge that they share, if that is convex and small enough.
std::optional<Loop> merged(const std::vector<Vec2>& v, const Loop& p, const Loop& q,
                           std::size_t most) {
  if (p.size() + q.size() - 2 > most) return std::nullopt;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      const std::size_t i1 = (i + 1) % p.size();
      const std::size_t j1 = (j + 1) % q.size();
      if (p[i] != q[j1] || p[i1] != q[j]) continue;
      Loop loop;  // p from the edge's end round to its start, then q's other vertices
      for (std::size_t k = 0; k < p.size(); ++k) loop.push_back(p[(i1 + k) % p.size()]);
      for (std::size_t k = 1; k + 1 < q.size(); ++k) loop.push_back(q[(j1 + k) % q.size()]);
      if (!convex(v, loop)) return std::nullopt;
      return loop;
    }
  }
  return std::nullopt;
}

// Merges each loop with later ones for as long as any will go.
void merge_all(const std::vector<Vec2>& v, std::vector<Loop>& loops, std::size_t most) {
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = i + 1; j < loops.size();) {
      if (auto loop = merged(v, loops[i], loops[j], most)) {
        loops[i] = std::move(*loop);
        loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1;
      } else {
        ++j;
      }
    }
  }
}

}  // namespace

std::vector<std::vector<Vec2>> convex_decomposition(std::span<const Vec2> polygon,
                                                    std::size_t most) {
  const std::vector<Vec2> v = without_flat_vertices(polygon);
  std::vector<Loop> loops = triangles_of(v);
  merge_all(v, loops, most);
  std::vector<std::vector<Vec2>> pieces;
  for (const Loop& loop : loops) {
    std::vector<Vec2> piece;
    for (const std::size_t i : loop) piece.push_back(v[i]);
    pieces.push_back(without_flat_vertices(piece));
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.empty(); });
  return pieces;
}

}  // namespace accord
