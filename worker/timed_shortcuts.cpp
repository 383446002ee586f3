#include "worker/timed_shortcuts.h"

#include <algorithm>

#include "common/planning/random.h"
#include "common/planning/splice.h"

namespace accord {
namespace {

constexpr int kMostCuts = 120;
constexpr int kFailuresInARow = 20;
// A cut that saves less is not worth a check.
constexpr double kLeastSaving = 1e-3;     // s
constexpr double kShortestMotion = 1e-5;  // s

class CornerCutter {
 public:
  CornerCutter(Team& team, double hold_until, Trajectory& path, Effort& effort)
      : team_(team), hold_until_(hold_until), path_(path), effort_(effort) {}

  void run(std::uint64_t seed) {
    RandomStream random(seed);
    for (int cut = 0, failures = 0; cut < kMostCuts && failures < kFailuresInARow; ++cut) {
      if (path_.size() < 3) return;
      failures = try_cut(random) ? 0 : failures + 1;
    }
  }

 private:
  bool try_cut(RandomStream& random) {
    double from = random.uniform(path_.start_time(), path_.end_time());
    double to = random.uniform(path_.start_time(), path_.end_time());
    if (from > to) std::swap(from, to);
    // Half of the cuts run between waypoints, which is where waits begin and end.
    if (random.below(2) == 0) {
      from = path_.time(path_.segment_at(from));
      to = path_.time(std::min(path_.segment_at(to) + 1, path_.size() - 1));
    }
    from = snapped(from);
    to = snapped(to);
    const Configuration a = path_.at(from), b = path_.at(to);
    const double duration = team_.duration(a, b);
    if (to - from - duration < kLeastSaving || duration < kShortestMotion) return false;
    ++effort_.motion_checks;
    if (!team_.motion_is_clear(a, b, from, duration) || !team_.motion_is_free(a, b)) return false;
    Trajectory cut = with_cut(from, to, a, b, duration);
    if (!tail_is_clear(cut, from + duration)) return false;
    path_ = std::move(cut);
    return true;
  }

  // A cut near a waypoint is one at it: a path that went on from close behind a corner would leave
  // out the corner, and what lies between is not proved.
  double snapped(double time) const {
    const std::size_t segment = path_.segment_at(time);
    const double before = path_.time(segment);
    const double after = path_.time(std::min(segment + 1, path_.size() - 1));
    if (time - before < 2 * kShortestMotion) return before;
    return after - time < 2 * kShortestMotion ? after : time;
  }

  Trajectory with_cut(double from, double to, const Configuration& a, const Configuration& b,
                      double duration) const {
    Trajectory cut(path_.dof());
    for (std::size_t i = 0; i < path_.size() && path_.time(i) < from - kShortestMotion; ++i) {
      cut.append(path_.time(i), path_.configuration(i));
    }
    if (cut.empty() || from > cut.end_time()) cut.append(from, a);
    double shift = append_apart(from + duration, b, cut) - to;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (path_.time(i) <= to + kShortestMotion) continue;
      shift = append_apart(path_.time(i) + shift, path_.configuration(i), cut) - path_.time(i);
    }
    return cut;
  }

  // Whether what comes after `from` and the rest at the goal are free of what moves.
  bool tail_is_clear(const Trajectory& path, double from) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (path.time(i) < from - kShortestMotion) continue;
      if (!team_.motion_is_clear(path.configuration(i), path.configuration(i + 1), path.time(i),
                                 path.time(i + 1) - path.time(i))) {
        return false;
      }
    }
    const double arrival = path.end_time(), until = std::max(arrival, hold_until_);
    team_.safe_intervals(path.configuration(path.size() - 1), arrival, safe_);
    return std::ranges::any_of(safe_, [&](const Interval& interval) {
      return interval.lo <= arrival && interval.hi >= until;
    });
  }

  Team& team_;
  double hold_until_;
  Trajectory& path_;
  Effort& effort_;
  std::vector<Interval> safe_;  // scratch
};

}  // namespace

void cut_corners(Team& team, double hold_until, std::uint64_t seed, Trajectory& path,
                 Effort& effort) {
  CornerCutter(team, hold_until, path, effort).run(seed);
}

}  // namespace accord
