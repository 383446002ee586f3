// Yes or no, and from when on: the queries that planning lives on.
#include <algorithm>
#include <cmath>

#include "common/geometry/count_on_exit.h"
#include "common/geometry/world_core.h"

namespace accord {
namespace {

constexpr double kLimitTolerance = 1e-9;  // rad or m

bool before(ConfigurationView a, ConfigurationView b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

template <int D>
typename WorldCore<D>::Work& WorldCore<D>::begin(RobotId robot, ConfigurationView from,
                                                 ConfigurationView to) const {
  Work& work = thread_advancement<D>();
  work.pairs.clear();
  work.fixed = fixed_;
  work.two = false;
  work.first.start(chains_[robot.index()], from, to);
  return work;
}

template <int D>
bool WorldCore<D>::within_limits(RobotId robot, ConfigurationView q) const {
  const auto& dofs = scene_->robot(robot).model->dofs;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (!(q[i] >= dofs[i].lower - kLimitTolerance && q[i] <= dofs[i].upper + kLimitTolerance)) {
      return false;
    }
  }
  return true;
}

template <int D>
double WorldCore<D>::leaves_limits(RobotId robot, ConfigurationView a, ConfigurationView b) const {
  const auto& dofs = scene_->robot(robot).model->dofs;
  double first = 2;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const double low = dofs[i].lower - kLimitTolerance;
    const double high = dofs[i].upper + kLimitTolerance;
    if (!(a[i] >= low && a[i] <= high)) return 0;
    if (b[i] < low) first = std::min(first, (low - a[i]) / (b[i] - a[i]));
    if (b[i] > high) first = std::min(first, (high - a[i]) / (b[i] - a[i]));
  }
  return first;
}

template <int D>
bool WorldCore<D>::is_free(RobotId robot, ConfigurationView q) const {
  return motion_is_free(robot, q, q);
}

template <int D>
bool WorldCore<D>::motion_is_free(RobotId robot, ConfigurationView a, ConfigurationView b) const {
  if (!within_limits(robot, a) || !within_limits(robot, b)) return false;
  if (before(b, a)) std::swap(a, b);  // the same answer both ways, to the last bit
  Work& work = begin(robot, a, b);
  const CountOnExit<D> counting(work, counter_);
  if (chains_[robot.index()].radius() >= 0) {
    if (!add_disc_pairs(robot, true, work)) return false;
    if (work.pairs.empty()) return true;  // else the bounds are near
  } else {
    add_self_pairs(work);
    add_fixed_pairs(robot, work);
  }
  return !swallowed(work) && work.proves_free();
}

template <int D>
std::optional<double> WorldCore<D>::first_fault(RobotId robot, ConfigurationView a,
                                                ConfigurationView b) const {
  const double limit = leaves_limits(robot, a, b);
  if (limit <= 0) return 0.0;
  Work& work = begin(robot, a, b);
  const CountOnExit<D> counting(work, counter_);
  if (chains_[robot.index()].radius() >= 0) {
    add_disc_pairs(robot, false, work);
  } else {
    add_self_pairs(work);
    add_fixed_pairs(robot, work);
  }
  if (swallowed(work)) return 0.0;
  std::optional<double> contact;
  if (!work.pairs.empty()) contact = work.first_contact();
  if (limit <= 1 && (!contact || limit < *contact)) return limit;
  return contact;
}

template <int D>
Extent<D> WorldCore<D>::rough_extent(RobotId robot, ConfigurationView a,
                                     ConfigurationView b) const {
  const Chain<D>& chain = chains_[robot.index()];
  if (!chain.mobile()) return chain.reach_box();
  const Eigen::Map<const Vec<D>> from(a.data());
  const Eigen::Map<const Vec<D>> to(b.data());
  const double extent = chain.radius() >= 0 ? chain.radius() : chain.reach()[D];
  return Extent<D>{from.cwiseMin(to), from.cwiseMax(to)}.inflated(extent);
}

template <int D>
typename WorldCore<D>::Work* WorldCore<D>::begin_two(RobotId a, ConfigurationView from_a,
                                                     ConfigurationView to_a, RobotId b,
                                                     ConfigurationView from_b,
                                                     ConfigurationView to_b) const {
  const Extent<D> rough = rough_extent(a, from_a, to_a).inflated(apart_);
  if (!rough.overlaps(rough_extent(b, from_b, to_b))) return nullptr;
  Work& work = begin(a, from_a, to_a);
  work.two = true;
  work.second.start(chains_[b.index()], from_b, to_b);
  add_robot_pairs(work);
  return work.pairs.empty() ? nullptr : &work;
}

template <int D>
std::optional<double> WorldCore<D>::first_contact(RobotId a, ConfigurationView from_a,
                                                  ConfigurationView to_a, RobotId b,
                                                  ConfigurationView from_b,
                                                  ConfigurationView to_b) const {
  Work* work = begin_two(a, from_a, to_a, b, from_b, to_b);
  if (work == nullptr) return std::nullopt;
  const CountOnExit<D> counting(*work, counter_);
  if (swallowed(*work)) return 0.0;
  return work->first_contact();
}

template <int D>
bool WorldCore<D>::motions_are_clear(RobotId a, ConfigurationView from_a, ConfigurationView to_a,
                                     RobotId b, ConfigurationView from_b,
                                     ConfigurationView to_b) const {
  Work* work = begin_two(a, from_a, to_a, b, from_b, to_b);
  if (work == nullptr) return true;
  const CountOnExit<D> counting(*work, counter_);
  return !swallowed(*work) && work->proves_free();
}

template Extent<2> WorldCore<2>::rough_extent(RobotId, ConfigurationView, ConfigurationView) const;
template Extent<3> WorldCore<3>::rough_extent(RobotId, ConfigurationView, ConfigurationView) const;
template bool WorldCore<2>::is_free(RobotId, ConfigurationView) const;
template bool WorldCore<3>::is_free(RobotId, ConfigurationView) const;
template bool WorldCore<2>::motion_is_free(RobotId, ConfigurationView, ConfigurationView) const;
template bool WorldCore<3>::motion_is_free(RobotId, ConfigurationView, ConfigurationView) const;
template std::optional<double> WorldCore<2>::first_fault(RobotId, ConfigurationView,
                                                         ConfigurationView) const;
template std::optional<double> WorldCore<3>::first_fault(RobotId, ConfigurationView,
                                                         ConfigurationView) const;
template std::optional<double> WorldCore<2>::first_contact(RobotId, ConfigurationView,
                                                           ConfigurationView, RobotId,
                                                           ConfigurationView,
                                                           ConfigurationView) const;
template std::optional<double> WorldCore<3>::first_contact(RobotId, ConfigurationView,
                                                           ConfigurationView, RobotId,
                                                           ConfigurationView,
                                                           ConfigurationView) const;
template bool WorldCore<2>::motions_are_clear(RobotId, ConfigurationView, ConfigurationView,
                                              RobotId, ConfigurationView, ConfigurationView) const;
template bool WorldCore<3>::motions_are_clear(RobotId, ConfigurationView, ConfigurationView,
                                              RobotId, ConfigurationView, ConfigurationView) const;
template bool WorldCore<2>::within_limits(RobotId, ConfigurationView) const;
template bool WorldCore<3>::within_limits(RobotId, ConfigurationView) const;
template WorldCore<2>::Work& WorldCore<2>::begin(RobotId, ConfigurationView,
                                                 ConfigurationView) const;
template WorldCore<3>::Work& WorldCore<3>::begin(RobotId, ConfigurationView,
                                                 ConfigurationView) const;

}  // namespace accord
