// What is wrong, who is closest: for messages to people.
#include <algorithm>
#include <cmath>
#include <string>

#include "common/geometry/witness.h"
#include "common/geometry/world_core.h"

namespace accord {
namespace {

Vec3 in_space(const Vec<2>& p) {
  return {p.x(), p.y(), 0};
}
Vec3 in_space(const Vec<3>& p) {
  return p;
}

const std::string& body_name(const Scene& scene, RobotId robot, int body) {
  return scene.robot(robot).model->bodies[static_cast<std::size_t>(body)].name;
}

}  // namespace

template <int D>
Fault WorldCore<D>::fault_between(const Placed<D>& a, const Placed<D>& b, Fault::Kind kind) const {
  Fault fault{kind, {}, {}, 0, in_space(meeting_point(a, b))};
  const double radii = a.piece->radius + b.piece->radius;
  if (b.piece->core == Core::kHalfSpace) {  // minus the excess, to the last
    fault.gap = gap(a, b, Wanted{}, Vec<D>(Vec<D>::Zero())).distance - radii;
    return fault;
  }
  const bool inside = solids_ && (contains(a, b) || contains(b, a));
  const double distance = inside ? 0.0 : gap(a, b, Wanted{}, Vec<D>(Vec<D>::Zero())).distance;
  fault.gap = distance > 0 ? distance - radii : -overlap(a, b);
  return fault;
}

template <int D>
Fault WorldCore<D>::closest(RobotId a, ConfigurationView qa, RobotId b,
                            ConfigurationView qb) const {
  Work& work = begin(a, qa, qa);
  work.two = true;
  work.second.start(chains_[b.index()], qb, qb);
  work.move_to(0);
  const auto a_pieces = work.first.chain().pieces();
  const auto b_pieces = work.second.chain().pieces();
  Fault worst{Fault::Kind::kRobot, {}, {}, 1e300, Vec3::Zero()};
  for (std::size_t i = 0; i < a_pieces.size(); ++i) {
    for (std::size_t j = 0; j < b_pieces.size(); ++j) {
      Fault fault = fault_between(work.first.piece(static_cast<int>(i)),
                                  work.second.piece(static_cast<int>(j)), Fault::Kind::kRobot);
      if (fault.gap >= worst.gap) continue;
      worst = fault;
      worst.body = body_name(*scene_, a, a_pieces[i].body);
      worst.other = scene_->robot(b).name + ": " + body_name(*scene_, b, b_pieces[j].body);
    }
  }
  return worst;
}

// The worst excess over the limits; kind kLimit.
template <int D>
std::optional<Fault> WorldCore<D>::limit_fault(RobotId robot, ConfigurationView q) const {
  if (within_limits(robot, q)) return std::nullopt;
  const auto& dofs = scene_->robot(robot).model->dofs;
  Fault worst{Fault::Kind::kLimit, {}, {}, 0, Vec3::Zero()};
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const double excess = std::max(dofs[i].lower - q[i], q[i] - dofs[i].upper);
    if (-excess < worst.gap || !std::isfinite(q[i])) {
      worst.gap = -excess;
      worst.body = dofs[i].name;
    }
  }
  return worst;
}

// Not by is_free's pairs alone, which stop at the first: all of them, and the worst is kept.
template <int D>
std::optional<Fault> WorldCore<D>::fault(RobotId robot, ConfigurationView q) const {
  if (auto limit = limit_fault(robot, q)) return limit;
  if (is_free(robot, q)) return std::nullopt;
  Work& work = begin(robot, q, q);
  add_fixed_pairs(robot, work);
  add_self_pairs(work);
  work.move_to(0);
  std::optional<Fault> worst;
  double worst_slack = 0;
  for (const Pair<D>& pair : work.pairs) {
    const Placed<D>& a = work.first.piece(pair.a);
    const Placed<D>& b = work.other(pair);
    const bool self = pair.other == Pair<D>::Other::kSame;
    const bool wall = !self && b.piece->core == Core::kHalfSpace;
    Fault fault = fault_between(
        a, b, self ? Fault::Kind::kSelf : (wall ? Fault::Kind::kBounds : Fault::Kind::kObstacle));
    const double slack = fault.gap - (pair.keep - a.piece->radius - b.piece->radius);
    if (worst && slack >= worst_slack) continue;
    worst_slack = slack;
    worst = fault;
    const auto pieces = work.first.chain().pieces();
    worst->body = body_name(*scene_, robot, pieces[static_cast<std::size_t>(pair.a)].body);
    const auto index = static_cast<std::size_t>(pair.b);
    if (self) {
      worst->other = body_name(*scene_, robot, pieces[index].body);
    } else if (!wall) {
      worst->other = scene_->obstacles[static_cast<std::size_t>(obstacle_of_[index])].name;
    }
  }
  return worst;
}

template Fault WorldCore<2>::closest(RobotId, ConfigurationView, RobotId, ConfigurationView) const;
template Fault WorldCore<3>::closest(RobotId, ConfigurationView, RobotId, ConfigurationView) const;
template std::optional<Fault> WorldCore<2>::fault(RobotId, ConfigurationView) const;
template std::optional<Fault> WorldCore<3>::fault(RobotId, ConfigurationView) const;

}  // namespace accord
