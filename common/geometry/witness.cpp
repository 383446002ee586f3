#include "common/geometry/witness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/geometry/closed_forms.h"
#include "common/geometry/gap.h"

namespace accord {
namespace {

Vec<2> to_polygon(const Piece<2>& piece, const Vec<2>& p) {
  Vec<2> best = Vec<2>::Zero();
  double least = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (int i = 0; i < piece.vertex_count; ++i) {
    const Vec<2>& a = piece.vertices[static_cast<std::size_t>(i)];
    const Vec<2>& b = piece.vertices[static_cast<std::size_t>((i + 1) % piece.vertex_count)];
    const Vec<2> edge = b - a;
    inside = inside && edge.x() * (p - a).y() - edge.y() * (p - a).x() >= 0;
    const double u = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const Vec<2> move = a + u * edge - p;
    if (move.squaredNorm() < least) {
      least = move.squaredNorm();
      best = move;
    }
  }
  return inside ? Vec<2>(Vec<2>::Zero()) : best;
}

Vec<2> move_into(const Piece<2>& piece, const Vec<2>& p) {
  return to_polygon(piece, p);  // the one core that only planar scenes have
}

Vec<3> move_into(const Piece<3>& piece, const Vec<3>& p) {  // cylinders
  Vec<3> move = Vec<3>::Zero();
  move.z() = std::clamp(p.z(), -piece.half.x(), piece.half.x()) - p.z();
  const double out = p.head<2>().norm();
  if (out > piece.half.y()) move.head<2>() = (piece.half.y() / out - 1) * p.head<2>();
  return move;
}

// Directions along which two planar pieces can be freed with the least motion: normals of edges.
void add_normals(const Placed<2>& placed, std::vector<Vec<2>>& directions) {
  const Frame<2>& f = placed.frame;
  directions.push_back(f.axis());
  directions.push_back({-f.s, f.c});
  const Piece<2>& piece = *placed.piece;
  for (int i = 0; i < piece.vertex_count; ++i) {
    const Vec<2> edge = piece.vertices[static_cast<std::size_t>((i + 1) % piece.vertex_count)] -
                        piece.vertices[static_cast<std::size_t>(i)];
    directions.push_back(f.rotate(Vec<2>(edge.y(), -edge.x()).normalized()));
  }
}

void add_normals(const Placed<3>& placed, std::vector<Vec<3>>& directions) {
  for (int i = 0; i < 3; ++i) directions.push_back(placed.frame.r.col(i));
}

void add_more(const Placed<2>&, const Placed<2>&, std::vector<Vec<2>>& directions) {
  constexpr int kDirections = 64;  // discs against corners
  for (int i = 0; i < kDirections; ++i) {
    const SinCos a = sincos(3.14159265358979323846 * i / kDirections);
    directions.push_back({a.cos, a.sin});
  }
}

// Edges against edges, and a lattice on the half sphere.
void add_more(const Placed<3>& a, const Placed<3>& b, std::vector<Vec<3>>& directions) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec<3> n = a.frame.r.col(i).cross(b.frame.r.col(j));
      if (n.norm() > 1e-6) directions.push_back(n.normalized());
    }
  }
  constexpr int kDirections = 200;  // on a spiral
  for (int i = 0; i < kDirections; ++i) {
    const double z = (i + 0.5) / kDirections;
    const SinCos turn = sincos(2.39996322972865332 * i);  // the golden angle
    const double out = std::sqrt(1 - z * z);
    directions.push_back({out * turn.cos, out * turn.sin, z});
  }
}

}  // namespace

template <int D>
Vec<D> project(const Placed<D>& placed, const Vec<D>& p) {
  const Piece<D>& piece = *placed.piece;
  switch (piece.core) {
    case Core::kSegment:
      return p + to_segment<D>(p - placed.frame.t, placed.frame.axis(), piece.half.x());
    case Core::kBox:
    case Core::kMesh:
      return p + placed.frame.rotate(to_box<D>(placed.frame.inverse(p), piece.half));
    case Core::kPolygon:
    case Core::kCylinder:
      return p + placed.frame.rotate(move_into(piece, placed.frame.inverse(p)));
    case Core::kHalfSpace: {
      const Vec<D> n = placed.frame.axis();
      return p + std::max(n.dot(placed.frame.t - p), 0.0) * n;
    }
    case Core::kPoint:
      break;
  }
  return placed.frame.t;
}

// Alternating projections (von Neumann): slow in the last digits, which nobody reads.
template <int D>
Vec<D> meeting_point(const Placed<D>& a, const Placed<D>& b) {
  constexpr int kRounds = 100;
  Vec<D> on_a = project(a, b.frame.t);
  Vec<D> on_b = project(b, on_a);
  for (int i = 0; i < kRounds; ++i) {
    on_a = project(a, on_b);
    on_b = project(b, on_a);
  }
  return (on_a + on_b) / 2;
}

template <int D>
double overlap(const Placed<D>& a, const Placed<D>& b) {
  std::vector<Vec<D>> directions;
  add_normals(a, directions);
  add_normals(b, directions);
  add_more(a, b, directions);
  const Vec<D> offset = b.frame.t - a.frame.t;
  if (offset.norm() > 0) directions.push_back(offset.normalized());
  double least = std::numeric_limits<double>::infinity();
  for (const Vec<D>& n : directions) {
    least = std::min({least, -separation_along(a, b, n), -separation_along(a, b, Vec<D>(-n))});
  }
  return std::max(least + a.piece->radius + b.piece->radius, 1e-12);
}

template Vec<2> project(const Placed<2>&, const Vec<2>&);
template Vec<3> project(const Placed<3>&, const Vec<3>&);
template Vec<2> meeting_point(const Placed<2>&, const Placed<2>&);
template Vec<3> meeting_point(const Placed<3>&, const Placed<3>&);
template double overlap(const Placed<2>&, const Placed<2>&);
template double overlap(const Placed<3>&, const Placed<3>&);

}  // namespace accord
