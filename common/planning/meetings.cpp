#include "common/planning/meetings.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/planning/conflict.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of so many, to box what they sweep costs more than to compare each with each.
constexpr std::size_t kFew = 24;
// Parts that the time until all have parked is cut into, at most.
constexpr double kMostSlabs = 64;

// Two movers during [from, until] (s), or as long as both have to keep clear.
std::optional<Meeting> meeting_of(const CollisionWorld& world, const std::vector<Mover>& movers,
                                  std::size_t i, std::size_t j, double from, double until) {
  const Mover& a = movers[i];
  const Mover& b = movers[j];
  if (!a.is_in_question && !b.is_in_question) return std::nullopt;
  until = std::min({until, a.until, b.until});
  if (!(until >= from)) return std::nullopt;
  if (paths_are_clear(world, a.robot, *a.path, b.robot, *b.path, from, until)) return std::nullopt;
  const auto time = earliest_contact(world, a.robot, *a.path, b.robot, *b.path, from, until);
  return Meeting{i, j, time.value_or(from)};
}

std::optional<Meeting> each_with_each(const CollisionWorld& world, const std::vector<Mover>& movers,
                                      double from) {
  for (std::size_t i = 0; i < movers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (auto meeting = meeting_of(world, movers, i, j, from, kInfinity)) return meeting;
    }
  }
  return std::nullopt;
}

class Slabs {
 public:
  Slabs(const CollisionWorld& world, const std::vector<Mover>& movers, double from)
      : world_(world), movers_(movers), from_(from), end_(from) {
    for (std::size_t i = 0; i < movers.size(); ++i) {
      active_.push_back({i, {}});
      end_ = std::max(end_, std::min(movers[i].until, movers[i].path->end_time()));
    }
    slabs_ = count();
  }

  std::optional<Meeting> run() {
    for (std::size_t slab = 0; slab < slabs_; ++slab) {
      if (auto meeting = look(begin_of(slab), begin_of(slab + 1))) return meeting;
    }
    return look(end_, kInfinity);  // all are parked
  }

 private:
  struct Boxed {
    std::size_t mover;
    Aabb box;
  };

  // So many that in each robots sweep little more than their own size.
  std::size_t count() {
    double swept = 0, sizes = 0;
    for (const Mover& mover : movers_) {
      swept += size_of(box_of(mover, from_, std::min(end_, mover.until)));
      sizes += size_of(box_of(mover, from_, from_));
    }
    return static_cast<std::size_t>(std::clamp(swept / sizes, 1.0, kMostSlabs));
  }

  static double size_of(const Aabb& box) { return (box.max - box.min).maxCoeff(); }

  double begin_of(std::size_t slab) const {
    const double share = static_cast<double>(slab) / static_cast<double>(slabs_);
    return slab == slabs_ ? end_ : from_ + share * (end_ - from_);
  }

  // Sort and sweep (Baraff 1992) along the axis on which the boxes are spread the widest.
  std::optional<Meeting> look(double begin, double end) {
    std::erase_if(active_, [&](const Boxed& b) { return movers_[b.mover].until < begin; });
    for (Boxed& boxed : active_) boxed.box = box_of(movers_[boxed.mover], begin, end);
    const Eigen::Index axis = widest_axis();
    std::ranges::sort(active_, {}, [&](const Boxed& b) { return b.box.min[axis]; });
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const Boxed& one = active_[i];
      for (std::size_t j = i + 1; j < active_.size(); ++j) {
        const Boxed& other = active_[j];
        if (other.box.min[axis] > one.box.max[axis]) break;
        if (!one.box.overlaps(other.box)) continue;
        if (auto meeting = meeting_of(world_, movers_, one.mover, other.mover, begin, end)) {
          return meeting;
        }
      }
    }
    return std::nullopt;
  }

  // All that a mover sweeps during [begin, end], and the room that it has to keep.
  Aabb box_of(const Mover& mover, double begin, double end) {
    const Trajectory& path = *mover.path;
    at_.resize(path.dof());
    to_.resize(path.dof());
    path.at(begin, at_);
    Aabb box = world_.swept_bounds(mover.robot, at_, at_);
    for (std::size_t i = path.segment_at(begin); i + 1 < path.size() && path.time(i) < end; ++i) {
      path.at(std::min(path.time(i + 1), end), to_);
      box.merge(world_.swept_bounds(mover.robot, at_, to_));
      at_.swap(to_);
    }
    const Vec3 room = Vec3::Constant(world_.required_separation());
    return {box.min - room, box.max + room};
  }

  Eigen::Index widest_axis() const {
    Vec3 low = Vec3::Constant(kInfinity), high = -low;
    for (const Boxed& boxed : active_) {
      low = low.cwiseMin(boxed.box.min);
      high = high.cwiseMax(boxed.box.min);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  const CollisionWorld& world_;
  const std::vector<Mover>& movers_;
  double from_;  // s
  double end_;   // s: nobody who has to keep clear moves after it
  std::size_t slabs_ = 1;
  std::vector<Boxed> active_;  // those that still have to keep clear
  Configuration at_, to_;      // scratch
};

}  // namespace

std::optional<Meeting> find_meeting(const CollisionWorld& world, const std::vector<Mover>& movers,
                                    double from) {
  if (movers.size() <= kFew) return each_with_each(world, movers, from);
  return Slabs(world, movers, from).run();
}

}  // namespace accord
