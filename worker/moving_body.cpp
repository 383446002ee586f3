#include "worker/moving_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void interpolate(ConfigurationView a, ConfigurationView b, double s, Configuration& out) {
  out.resize(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) out[k] = a[k] + s * (b[k] - a[k]);
}

}  // namespace

MovingBody::MovingBody(const CollisionWorld& world, RobotId robot, RobotId other, Trajectory path,
                       double from, double until, const LocalRoadmap* remembered)
    : world_(world),
      robot_(robot),
      other_(other),
      path_(std::move(path)),
      from_(from),
      until_(until),
      remembered_(remembered) {
  const Vec3 room = Vec3::Constant(world_.required_separation());
  for (std::size_t i = path_.segment_at(from); i < path_.size(); ++i) {
    const bool last = i + 1 == path_.size();
    if (path_.time(i) >= until) continue;
    const ConfigurationView begin = path_.configuration(i);
    const ConfigurationView end = last ? begin : path_.configuration(i + 1);
    Piece piece{path_.time(i), last ? until : path_.time(i + 1), {}, {}, {}};
    if (i == 0) piece.t0 = std::min(piece.t0, from);
    piece.from.assign(begin.begin(), begin.end());
    piece.to.assign(end.begin(), end.end());
    if (!last && piece.t1 > until) {
      interpolate(begin, end, (until - path_.time(i)) / (piece.t1 - path_.time(i)), piece.to);
      piece.t1 = until;
    }
    piece.bounds = world_.swept_bounds(other, piece.from, piece.to);
    piece.bounds.min -= room;
    piece.bounds.max += room;
    pieces_.push_back(std::move(piece));
  }
}

bool MovingBody::is(RobotId other, const Trajectory& path, double until) const {
  return other == other_ && until == until_ && path == path_;
}

void MovingBody::add_unsafe(ConfigurationView q, const Aabb& here, double since,
                            const std::optional<Name>& name, std::vector<Interval>& unsafe) {
  if (!name || remembered_ == nullptr || name->roadmap != remembered_) {
    find_unsafe(q, here, since, unsafe);
    return;
  }
  const auto [found, is_new] = known_.try_emplace(name->node, Known{since, {}});
  Known& known = found->second;
  if (is_new || since < known.since) {
    known = {since, {}};
    find_unsafe(q, here, since, known.unsafe);
  }
  unsafe.insert(unsafe.end(), known.unsafe.begin(), known.unsafe.end());
}

void MovingBody::find_unsafe(ConfigurationView q, const Aabb& here, double since,
                             std::vector<Interval>& unsafe) {
  const double probe = world_.scene().timestep;
  for (const Piece& piece : pieces_) {
    if (piece.t1 <= since || !piece.bounds.overlaps(here)) continue;
    if (std::isinf(piece.t1)) {
      if (!world_.are_clear(robot_, q, other_, piece.from)) {
        unsafe.push_back({piece.t0, kInfinity});
      }
      continue;
    }
    double t = std::max({piece.t0, from_, since});
    const double end = piece.t1;
    while (t < end) {
      const auto touch = contact(piece, q, t, end);
      if (!touch) break;
      // Contact lasts until a probe at rest is clear again; what lies between probes is given up.
      double clear = std::min(*touch + probe, end);
      while (clear < end) {
        const double s = (clear - piece.t0) / (piece.t1 - piece.t0);
        interpolate(piece.from, piece.to, s, other_from_);
        ++checks_;
        if (world_.are_clear(robot_, q, other_, other_from_)) break;
        clear = std::min(clear + probe, end);
      }
      unsafe.push_back({*touch, clear});
      t = clear;
    }
  }
}

std::optional<Interval> MovingBody::share(const Piece& piece, ConfigurationView a,
                                          ConfigurationView b, double t0, double t1) {
  const double lo = std::max(t0, piece.t0), hi = std::min(t1, piece.t1);
  if (lo >= hi) return std::nullopt;
  const double span = t1 - t0;
  interpolate(a, b, (lo - t0) / span, mine_from_);
  interpolate(a, b, (hi - t0) / span, mine_to_);
  if (std::isinf(piece.t1)) {
    other_from_ = other_to_ = piece.from;
  } else {
    const double length = piece.t1 - piece.t0;
    interpolate(piece.from, piece.to, (lo - piece.t0) / length, other_from_);
    interpolate(piece.from, piece.to, (hi - piece.t0) / length, other_to_);
  }
  return Interval{lo, hi};
}

std::optional<double> MovingBody::contact(const Piece& piece, ConfigurationView q, double t0,
                                          double t1) {
  const auto shared = share(piece, q, q, t0, t1);
  if (!shared) return std::nullopt;
  ++checks_;
  return world_.first_contact(robot_, {mine_from_, mine_to_, shared->lo, shared->hi}, other_,
                              {other_from_, other_to_, shared->lo, shared->hi});
}

bool MovingBody::touches(const Piece& piece, ConfigurationView a, ConfigurationView b, double t0,
                         double t1) {
  if (!share(piece, a, b, t0, t1)) return false;
  ++checks_;
  return !world_.motions_are_clear(robot_, mine_from_, mine_to_, other_, other_from_, other_to_);
}

MovingBody::Passage MovingBody::passage(ConfigurationView a, ConfigurationView b,
                                        const Aabb& bounds, double t, double duration) {
  for (const Piece& piece : pieces_) {
    if (piece.t0 >= t + duration || piece.t1 <= t || !piece.bounds.overlaps(bounds)) continue;
    if (!touches(piece, a, b, t, t + duration)) continue;
    return std::isinf(piece.t1) ? Passage::kBlockedForGood : Passage::kBlocked;
  }
  return Passage::kClear;
}

}  // namespace accord
