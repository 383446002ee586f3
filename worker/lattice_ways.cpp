#include "worker/lattice_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace accord {
namespace {

// The start and the goal are linked with nodes up to this many spacings away, by as many steps.
constexpr double kLongestLink = 2.0;
constexpr double kRounding = 1e-9;
constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

}  // namespace

LatticeWays::LatticeWays(const CollisionWorld& world, const Lattice& lattice,
                         const std::vector<std::uint32_t>& weights, RobotId robot,
                         const Vec3& start, const Vec3& goal)
    : world_(world),
      lattice_(lattice),
      weights_(weights),
      robot_(robot),
      dof_(world.scene().robot(robot).model->dof()) {
  add({goal, {}, 0});
  link_goal();
  find_costs();
  start_ = visit(start, kLongestLink);
}

const Vec3& LatticeWays::position(Node node) const {
  return is_off(node) ? places_[node - lattice_.size()].position : lattice_.position(node);
}

std::uint32_t LatticeWays::cost(Node node) const {
  return is_off(node) ? places_[node - lattice_.size()].cost : costs_[node];
}

void LatticeWays::next(Node node, std::vector<Node>& out) const {
  out.clear();
  if (is_off(node)) {
    out = places_[node - lattice_.size()].next;
    return;
  }
  const auto neighbours = lattice_.neighbours(node);
  out.assign(neighbours.begin(), neighbours.end());
  for (const auto& [from, to] : entries_) {
    if (from == node) out.push_back(to);
  }
}

LatticeWays::Node LatticeWays::best_next(Node node) const {
  std::vector<Node> candidates;
  next(node, candidates);
  const Vec3& goal = places_.front().position;
  return *std::ranges::min_element(candidates, {}, [&](Node candidate) {
    return std::pair(cost(candidate), (position(candidate) - goal).squaredNorm());
  });
}

std::optional<LatticeWays::Node> LatticeWays::displaced(Node node, const Vec3& displacement) {
  const Vec3 from = position(node), to = from + displacement;
  if (!motion_is_free(from, to)) return std::nullopt;
  return visit(to, 1.0);
}

LatticeWays::Node LatticeWays::add(Place place) {
  places_.push_back(std::move(place));
  return lattice_.size() + static_cast<Node>(places_.size()) - 1;
}

// Straight ways to the goal: of one step where there are such, else of the least number.
void LatticeWays::link_goal() {
  const Vec3 end = position(goal());
  std::vector<Node> near;
  lattice_.within(end, kLongestLink * lattice_.spacing(), near);
  for (int least = 0; const Node node : near) {
    const Vec3& from = lattice_.position(node);
    const int steps = steps_between(from, end);
    if (least > 0 && steps > least) break;
    if (!motion_is_free(from, end)) continue;
    least = steps;
    Node last = goal();
    for (int k = 1; k < steps; ++k) {
      const Vec3 between = end + (from - end).normalized() * (k * lattice_.spacing());
      last = add({between, {last}, static_cast<std::uint32_t>(k)});
    }
    entries_.emplace_back(node, last);
  }
}

// From the goal outwards, by Dial's algorithm: weights are small integers.
void LatticeWays::find_costs() {
  costs_.assign(lattice_.size(), kNever);
  std::vector<std::vector<Node>> buckets(1);  // by cost
  const auto reach = [&](Node node, std::uint32_t cost) {
    if (costs_[node] <= cost) return;
    costs_[node] = cost;
    if (buckets.size() <= cost) buckets.resize(cost + 1);
    buckets[cost].push_back(node);
  };
  for (const auto& [from, to] : entries_) reach(from, cost(to) + 1);
  for (std::uint32_t cost = 0; cost < buckets.size(); ++cost) {
    for (std::size_t k = 0; k < buckets[cost].size(); ++k) {
      const Node node = buckets[cost][k];
      if (costs_[node] < cost) continue;
      for (const Node before : lattice_.neighbours(node)) reach(before, cost + weights_[node]);
    }
  }
}

// A place, with straight ways on from there: of one step where there are such, else of the least
// number, if that is no more than `spacings`.
std::optional<LatticeWays::Node> LatticeWays::visit(const Vec3& position, double spacings) {
  const auto known = std::ranges::find_if(
      places_, [&](const Place& place) { return (place.position - position).norm() < kRounding; });
  if (known != places_.end()) {
    return lattice_.size() + static_cast<Node>(known - places_.begin());
  }
  Place place{position, {}, kNever};
  const auto link = [&](Node node) {
    place.next.push_back(node);
    place.cost = std::min(place.cost, cost(node) + 1);
  };
  const Vec3 end = this->position(goal());
  if (steps_between(position, end) == 1 && motion_is_free(position, end)) link(goal());
  std::vector<Node> near;
  lattice_.within(position, spacings * lattice_.spacing(), near);
  for (int least = 1; const Node node : near) {
    if (costs_[node] == kNever) continue;
    const Vec3& to = lattice_.position(node);
    const int steps = steps_between(position, to);
    if (steps > least && !place.next.empty()) break;
    if (!motion_is_free(position, to)) continue;
    least = steps;
    Node next = node;
    for (int k = steps - 1; k > 0; --k) {
      const Vec3 between = position + (to - position).normalized() * (k * lattice_.spacing());
      next = add({between, {next}, cost(next) + 1});
    }
    link(next);
  }
  if (place.next.empty()) return std::nullopt;
  return add(std::move(place));
}

bool LatticeWays::motion_is_free(const Vec3& from, const Vec3& to) const {
  return world_.motion_is_free(robot_, {from.data(), dof_}, {to.data(), dof_});
}

int LatticeWays::steps_between(const Vec3& from, const Vec3& to) const {
  const double spacings = (to - from).norm() / lattice_.spacing();
  return std::max(1, static_cast<int>(std::ceil(spacings - kRounding)));
}

}  // namespace accord
