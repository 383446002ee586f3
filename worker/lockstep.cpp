#include "worker/lockstep.h"

#include <algorithm>
#include <span>
#include <unordered_map>

#include "common/geometry/point_motion.h"
#include "common/planning/random.h"

namespace accord {
namespace {

// Steps in which the robots have come no closer to their goals all in all, after which it is left
// at that.
constexpr std::uint64_t kPatience = 12;
// Moves that may be considered in a step, for each robot: backtracking must not run away.
constexpr std::uint64_t kMovesPerRobot = 60;
// Robots that push each other one after another: recursion must not run out of stack.
constexpr std::size_t kLongestChain = 400;
// Of the decisions of robots that are pushed or have waited for this many steps one in so many is
// perturbed, by up to so much.
constexpr std::uint32_t kLongWait = 8;
constexpr std::uint64_t kPerturbed = 32;
constexpr double kPerturbation = 4.0;

}  // namespace

struct Lockstep::Agent {
  LatticeWays ways;
  double radius;  // m
  Node at;
  Node next;  // where it is decided
  bool is_decided = false;
  std::uint32_t waited = 0;             // steps since it last was at its goal
  std::vector<std::size_t> neighbours;  // whom it may conflict with in this step
  std::vector<Vec3> steps;

  const Vec3& place() const { return ways.position(at); }
  bool has_arrived() const { return at == ways.goal(); }
};

// What one robot asks of another: to get out of the way of its motion.
struct Lockstep::Push {
  const Agent& by;
  Node to;
  bool in_time;  // in this step; else before the next, in which the motion is made
};

Lockstep::Lockstep(const CollisionWorld& world, const Lattice& lattice,
                   const std::vector<Traveller>& travellers, std::uint64_t seed)
    : world_(world), lattice_(lattice), seed_(seed), weights_(lattice.size(), 1), tally_(world) {
  double largest = 0;
  std::vector<Node> near;
  for (const Traveller& traveller : travellers) {
    const double radius = *world.radius(traveller.robot);
    largest = std::max(largest, radius);
    lattice.within(traveller.goal, 2 * radius + world.required_separation(), near);
    for (const Node node : near) ++weights_[node];
  }
  reach_ = 2 * (largest + lattice.spacing()) + world.required_separation();
  for (const auto& [robot, start, goal] : travellers) {
    LatticeWays ways(world, lattice, weights_, robot, start, goal);
    const Node at = ways.start().value_or(ways.goal());
    agents_.push_back({std::move(ways), *world.radius(robot), at, at, false, 0, {}, {}});
    order_.push_back(order_.size());
  }
}

Lockstep::~Lockstep() = default;

bool Lockstep::run(const std::atomic<bool>& stop) {
  const auto has_way = [](const Agent& agent) { return agent.ways.start().has_value(); };
  if (!std::ranges::all_of(agents_, has_way)) return false;
  // Those who have farthest to go first.
  std::ranges::stable_sort(order_, std::greater{},
                           [&](std::size_t i) { return agents_[i].ways.cost(agents_[i].at); });
  for (Agent& agent : agents_) agent.steps = {agent.place()};
  std::uint64_t least = cost_left();
  for (std::uint64_t last = 0; least > 0 && steps_ <= last + kPatience && !stop;) {
    step();
    for (Agent& agent : agents_) agent.steps.push_back(agent.place());
    if (cost_left() >= least) continue;
    least = cost_left();
    last = steps_;
  }
  return true;
}

std::vector<std::vector<Vec3>> Lockstep::take_steps() {
  std::vector<std::vector<Vec3>> steps;
  for (Agent& agent : agents_) steps.push_back(std::move(agent.steps));
  return steps;
}

std::vector<std::vector<Vec3>> Lockstep::ways_left() const {
  std::vector<std::vector<Vec3>> ways;
  for (const Agent& agent : agents_) {
    std::vector<Vec3>& way = ways.emplace_back();
    for (Node at = agent.at; at != agent.ways.goal();) {
      at = agent.ways.best_next(at);
      way.push_back(agent.ways.position(at));
    }
  }
  return ways;
}

std::uint64_t Lockstep::cost_left() const {
  std::uint64_t sum = 0;
  for (const Agent& agent : agents_) sum += agent.ways.cost(agent.at);
  return sum;
}

void Lockstep::step() {
  ++steps_;
  find_neighbours();
  rank();
  decided_.clear();
  most_moves_ = moves_ + kMovesPerRobot * agents_.size();
  for (const std::size_t i : order_) {
    if (!agents_[i].is_decided) decide(i, nullptr);
  }
  for (Agent& agent : agents_) {
    agent.at = agent.next;
    agent.is_decided = false;
    agent.waited = agent.has_arrived() ? 0 : agent.waited + 1;
  }
}

void Lockstep::rank() {
  std::ranges::stable_sort(order_, std::greater{},
                           [&](std::size_t i) { return agents_[i].waited; });
}

void Lockstep::find_neighbours() {
  using Cell = Eigen::Array<std::int64_t, 3, 1>;
  const auto cell_of = [&](const Agent& agent) -> Cell {
    return (agent.place() / reach_).array().floor().cast<std::int64_t>();
  };
  const auto key_of = [](const Cell& cell) {
    return combine({static_cast<std::uint64_t>(cell.x()), static_cast<std::uint64_t>(cell.y()),
                    static_cast<std::uint64_t>(cell.z())});
  };
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    cells[key_of(cell_of(agents_[i]))].push_back(i);
    agents_[i].neighbours.clear();
  }
  const auto meet = [&](std::size_t i, const std::vector<std::size_t>& others) {
    for (const std::size_t j : others) {
      if (j == i || (agents_[j].place() - agents_[i].place()).norm() > reach_) continue;
      agents_[i].neighbours.push_back(j);
    }
  };
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Cell middle = cell_of(agents_[i]);
    for (std::int64_t n = 0; n < 27; ++n) {
      const auto found = cells.find(key_of(middle + Cell(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1)));
      if (found != cells.end()) meet(i, found->second);
    }
  }
}

// Chooses a move for robot i. False: it has none that suits those already decided and the push, and
// stays.
bool Lockstep::decide(std::size_t i, const Push* push) {
  Agent& agent = agents_[i];
  const std::uint32_t now = agent.ways.cost(agent.at);
  std::vector<Node> candidates;
  list_candidates(i, push != nullptr, candidates);
  const Node best = candidates.front();
  bool may_ask = !push && agent.ways.cost(best) < now;
  for (const Node to : candidates) {
    // Before it gives up getting closer.
    if (may_ask && agent.ways.cost(to) >= now) {
      may_ask = false;
      if (try_clearing(i, best)) return true;
    }
    const bool suits = !push || push->in_time ||
                       !is_in_the_way(push->by, push->to, agent.ways.position(to), agent);
    if (suits && try_move(i, to)) return true;
  }
  if (push && try_displaced(i, *push)) return true;
  choose(i, agent.at);
  return false;
}

// Where robot i can be after the step, best first.
void Lockstep::list_candidates(std::size_t i, bool is_pushed, std::vector<Node>& out) const {
  const Agent& agent = agents_[i];
  agent.ways.next(agent.at, out);
  out.push_back(agent.at);
  const bool is_perturbed =
      (is_pushed || agent.waited > kLongWait) && combine({seed_, i, steps_}) % kPerturbed == 0;
  const Vec3& goal = agent.ways.position(agent.ways.goal());
  std::ranges::stable_sort(out, {}, [&](Node node) {
    double cost = agent.ways.cost(node);
    if (is_perturbed) {
      cost += kPerturbation * RandomStream(combine({seed_, i, steps_, node})).uniform();
    }
    return std::pair(cost, (agent.ways.position(node) - goal).squaredNorm());
  });
}

// Makes the move, if those decided allow it and all others in its way can get out of it.
bool Lockstep::try_move(std::size_t i, Node to) {
  if (moves_ == most_moves_ || chain_ == kLongestChain) return false;
  ++moves_;
  const Agent& agent = agents_[i];
  std::vector<std::size_t> in_the_way;
  for (const std::size_t j : agent.neighbours) {
    if (!are_in_conflict(agent, to, agents_[j])) continue;
    if (agents_[j].is_decided) return false;
    in_the_way.push_back(j);
  }
  const std::size_t decisions = decided_.size();
  choose(i, to);
  const Push push{agent, to, true};
  for (const std::size_t j : in_the_way) {
    // One that was pushed may have pushed it in turn, and right into this one's way.
    const bool makes_way =
        agents_[j].is_decided ? !are_in_conflict(agent, to, agents_[j]) : push_away(j, push);
    if (makes_way) continue;
    undo(decisions);
    return false;
  }
  return true;
}

// Stays, if all that are in the way of a move can get out of it, so that it can be made next.
bool Lockstep::try_clearing(std::size_t i, Node to) {
  const Agent& agent = agents_[i];
  std::vector<std::size_t> in_the_way;
  for (const std::size_t j : agent.neighbours) {
    const Agent& other = agents_[j];
    if (other.is_decided && are_in_conflict(agent, agent.at, other)) return false;
    if (!is_in_the_way(agent, to, other.place(), other)) continue;
    if (other.is_decided) return false;
    in_the_way.push_back(j);
  }
  const std::size_t decisions = decided_.size();
  choose(i, agent.at);
  const Push push{agent, to, false};
  for (const std::size_t j : in_the_way) {
    const Agent& other = agents_[j];
    const bool makes_way = other.is_decided
                               ? !is_in_the_way(agent, to, other.ways.position(other.next), other)
                               : push_away(j, push);
    if (makes_way) continue;
    undo(decisions);
    return false;
  }
  return true;
}

bool Lockstep::push_away(std::size_t j, const Push& push) {
  ++chain_;
  const bool makes_way = decide(j, &push);
  --chain_;
  return makes_way;
}

// Away from whom it is pushed by, or to a side, to places off the lattice.
bool Lockstep::try_displaced(std::size_t i, const Push& push) {
  Agent& agent = agents_[i];
  std::vector<Vec3> displacements{push.by.ways.position(push.to) - push.by.place()};
  if (agent.ways.is_off(agent.at) || !push.in_time) {
    const std::size_t dof = world_.scene().robot(agent.ways.robot()).model->dof();
    for (std::size_t axis = 0; axis < dof; ++axis) {
      const Vec3 side = lattice_.spacing() * Vec3::Unit(static_cast<Eigen::Index>(axis));
      displacements.insert(displacements.end(), {-side, side});
    }
  }
  for (const Vec3& displacement : displacements) {
    if (moves_ == most_moves_) return false;
    const Vec3 place = agent.place() + displacement;
    if (!push.in_time && is_in_the_way(push.by, push.to, place, agent)) continue;
    const std::optional<Node> to = agent.ways.displaced(agent.at, displacement);
    if (to && try_move(i, *to)) return true;
  }
  return false;
}

// Whether a move conflicts with another robot's, or with its rest where that is not decided.
bool Lockstep::are_in_conflict(const Agent& agent, Node to, const Agent& other) const {
  const Vec3 offset = agent.place() - other.place();
  Vec3 drift = agent.ways.position(to) - agent.place();
  if (other.is_decided) drift -= other.ways.position(other.next) - other.place();
  tally_.add(1);
  return first_within(offset, drift, distance_to_keep(agent, other)).has_value();
}

// Whether another robot that rests at a place is in the way of a move.
bool Lockstep::is_in_the_way(const Agent& agent, Node to, const Vec3& place,
                             const Agent& other) const {
  const Vec3 drift = agent.ways.position(to) - agent.place();
  tally_.add(1);
  return first_within(agent.place() - place, drift, distance_to_keep(agent, other)).has_value();
}

double Lockstep::distance_to_keep(const Agent& a, const Agent& b) const {
  return a.radius + b.radius + world_.required_separation();
}

void Lockstep::choose(std::size_t i, Node to) {
  agents_[i].next = to;
  agents_[i].is_decided = true;
  decided_.push_back(i);
}

void Lockstep::undo(std::size_t decisions) {
  while (decided_.size() > decisions) {
    agents_[decided_.back()].is_decided = false;
    decided_.pop_back();
  }
}

}  // namespace accord
