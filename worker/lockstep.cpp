#include "worker/lockstep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "common/geometry/point_motion.h"
#include "common/planning/random.h"

namespace accord {
namespace {

// A start or goal is linked with the lattice by straight motions of up to this many spacings.
constexpr double kLinkLength = 2.0;
// Moves that may be considered in a step, for each robot: backtracking must not run away.
constexpr std::uint64_t kMovesPerRobot = 60;
constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();

}  // namespace

// What one asks of another: not to be in the way of its motion.
struct Lockstep::Push {
  Vec3 from;
  Vec3 motion;
  double keep;  // m; 0: the motion is made in this step, else in the next, from there

  bool suits(const Vec3& point) const {
    return keep == 0 || !first_within(from - point, motion, keep);
  }
};

struct Lockstep::Agent {
  // Off the lattice.
  struct Place {
    Vec3 point;
    std::vector<Node> next;  // where it can go from here in a step
    std::uint32_t distance;  // steps to the goal
  };

  Traveller traveller;
  double radius;                                // m
  std::vector<Place> own;                       // its goal, its start, and others
  std::vector<std::pair<Node, Node>> entries;   // from nodes of the lattice to its own
  std::vector<std::uint32_t> distances;         // steps to the goal, by node of the lattice
  Node at = 0;
  Node next = 0;
  bool is_decided = false;
  std::uint32_t waited = 0;               // steps since it last was at its goal
  std::vector<std::uint32_t> neighbours;  // whom it may conflict with in this step
};

Lockstep::Lockstep(const CollisionWorld& world, const Lattice& lattice,
                   std::vector<Traveller> travellers)
    : world_(world), lattice_(lattice) {
  double largest = 0;
  for (Traveller& traveller : travellers) {
    Agent agent;
    agent.radius = *world.radius(traveller.robot);
    agent.traveller = std::move(traveller);
    largest = std::max(largest, agent.radius);
    agents_.push_back(std::move(agent));
  }
  reach_ = 2 * (largest + lattice.spacing()) + world.required_separation();
}

Lockstep::~Lockstep() = default;

const Vec3& Lockstep::position(const Agent& agent, Node node) const {
  return node < lattice_.size() ? lattice_.position(node) : agent.own[node - lattice_.size()].point;
}

std::uint32_t Lockstep::distance(const Agent& agent, Node node) const {
  return node < lattice_.size() ? agent.distances[node]
                                : agent.own[node - lattice_.size()].distance;
}

bool Lockstep::motion_is_free(const Agent& agent, const Vec3& from, const Vec3& to) const {
  const RobotId robot = agent.traveller.robot;
  const std::size_t dof = world_.scene().robot(robot).model->dof();
  return world_.motion_is_free(robot, {from.data(), dof}, {to.data(), dof});
}

// Links the start and the goal with the lattice. False: cannot.
bool Lockstep::join(Agent& agent) {
  const Node goal = lattice_.size();
  agent.own.push_back({agent.traveller.goal, {}, 0});
  if (!link_goal(agent)) return false;
  find_distances(agent);
  const std::optional<Node> start = visit(agent, agent.traveller.start, kLinkLength);
  if (!start) return false;
  agent.at = agent.traveller.start == agent.traveller.goal ? goal : *start;
  return true;
}

// Ways of straight motions from the lattice to the goal: of one step where there are such, else of
// the least number.
bool Lockstep::link_goal(Agent& agent) {
  const Vec3 goal = agent.traveller.goal;
  std::vector<Node> near;
  lattice_.within(goal, kLinkLength * lattice_.spacing(), near);
  int least = 0;
  for (const Node node : near) {
    const Vec3& from = lattice_.position(node);
    const int steps = steps_between(from, goal);
    if (least > 0 && steps > least) break;
    if (!motion_is_free(agent, from, goal)) continue;
    least = steps;
    Node last = lattice_.size();
    for (int k = 1; k < steps; ++k) {
      agent.own.push_back({goal + (from - goal).normalized() * (k * lattice_.spacing()),
                           {last},
                           static_cast<std::uint32_t>(k)});
      last = lattice_.size() + static_cast<Node>(agent.own.size()) - 1;
    }
    agent.entries.emplace_back(node, last);
  }
  return least > 0;
}

int Lockstep::steps_between(const Vec3& a, const Vec3& b) const {
  constexpr double kRounding = 1e-9;
  return std::max(1, static_cast<int>(std::ceil((b - a).norm() / lattice_.spacing() - kRounding)));
}

void Lockstep::find_distances(Agent& agent) {
  agent.distances.assign(lattice_.size(), kFar);
  std::vector<Node> queue;
  for (const auto& [from, to] : agent.entries) {
    agent.distances[from] = distance(agent, to) + 1;
    queue.push_back(from);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const Node next : lattice_.neighbours(queue[i])) {
      if (agent.distances[next] != kFar) continue;
      agent.distances[next] = agent.distances[queue[i]] + 1;
      queue.push_back(next);
    }
  }
}

// A place off the lattice, with ways of a step from there on, of up to `most` spacings where there
// are none so short. nullopt where there are none.
std::optional<Lockstep::Node> Lockstep::visit(Agent& agent, const Vec3& point, double most) {
  for (std::size_t i = 0; i < agent.own.size(); ++i) {
    if ((agent.own[i].point - point).squaredNorm() < 1e-18) {
      return lattice_.size() + static_cast<Node>(i);
    }
  }
  Agent::Place place{point, {}, kFar};
  const auto add = [&](Node node) {
    place.next.push_back(node);
    place.distance = std::min(place.distance, distance(agent, node) + 1);
  };
  const Vec3 goal = agent.traveller.goal;
  if ((goal - point).norm() <= lattice_.spacing() && motion_is_free(agent, point, goal)) {
    add(lattice_.size());
  }
  std::vector<Node> near;
  lattice_.within(point, most * lattice_.spacing(), near);
  for (const Node node : near) {
    const Vec3& to = lattice_.position(node);
    if (agent.distances[node] == kFar) continue;
    const int steps = steps_between(point, to);
    if (steps > 1 && !place.next.empty()) break;
    if (!motion_is_free(agent, point, to)) continue;
    Node next = node;
    for (int k = steps - 1; k > 0; --k) {
      agent.own.push_back({point + (to - point).normalized() * (k * lattice_.spacing()),
                           {next},
                           distance(agent, next) + 1});
      next = lattice_.size() + static_cast<Node>(agent.own.size()) - 1;
    }
    add(next);
  }
  if (place.next.empty()) return std::nullopt;
  agent.own.push_back(std::move(place));
  return lattice_.size() + static_cast<Node>(agent.own.size()) - 1;
}

std::optional<std::vector<std::vector<Vec3>>> Lockstep::run(std::size_t most_steps,
                                                            const std::atomic<bool>& stop) {
  std::vector<std::vector<Vec3>> places;
  for (Agent& agent : agents_) {
    if (!join(agent) || stop) return std::nullopt;
    places.push_back({agent.traveller.start});
    order_.push_back(static_cast<std::uint32_t>(order_.size()));
  }
  // Those with far to go first.
  std::ranges::stable_sort(order_, std::greater{}, [&](std::uint32_t i) {
    return distance(agents_[i], agents_[i].at);
  });
  // Steps without one more robot at its goal after which it is not worth going on.
  constexpr std::size_t kPatience = 12;
  std::size_t most = 0, last = 0;
  for (std::size_t step = 0; step < most_steps && step < last + kPatience; ++step) {
    const std::size_t there = arrived();
    if (there == agents_.size()) break;
    if (there > most || step < 2 * kPatience) {
      most = there;
      last = step;
    }
    if (stop) return std::nullopt;
    this->step();
    for (std::size_t i = 0; i < agents_.size(); ++i) {
      places[i].push_back(position(agents_[i], agents_[i].at));
    }
  }
  // The rest of the way, as if alone.
  std::size_t length = 0;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    Agent& agent = agents_[i];
    while (agent.at != lattice_.size()) {
      agent.at = best_next(agent);
      places[i].push_back(position(agent, agent.at));
    }
    length = std::max(length, places[i].size());
  }
  for (auto& own : places) own.resize(length, own.back());
  if (getenv("LD")) fprintf(stderr, "ended after %zu with %zu\n", last, most);
  return places;
}

// The next node on the shortest way.
Lockstep::Node Lockstep::best_next(const Agent& agent) const {
  std::vector<Node> candidates;
  const bool is_off = agent.at >= lattice_.size();
  const std::span<const Node> next =
      is_off ? agent.own[agent.at - lattice_.size()].next : lattice_.neighbours(agent.at);
  candidates.assign(next.begin(), next.end());
  for (const auto& [from, to] : agent.entries) {
    if (from == agent.at) candidates.push_back(to);
  }
  return *std::ranges::min_element(candidates, {}, [&](Node node) {
    return std::pair(distance(agent, node),
                     (position(agent, node) - agent.traveller.goal).squaredNorm());
  });
}

std::size_t Lockstep::arrived() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      agents_, [&](const Agent& agent) { return agent.at == lattice_.size(); }));
}

void Lockstep::step() {
  find_neighbours(); ++steps_;
  decided_.clear();
  moves_left_ = kMovesPerRobot * agents_.size();
  std::ranges::stable_sort(order_, std::greater{},
                           [&](std::uint32_t i) { return agents_[i].waited; });
  for (const std::uint32_t i : order_) {
    trace_ = steps_ == 300 && (i == order_[0] || i == order_[1]);
    if (!agents_[i].is_decided) decide(i, nullptr);
  }
  for (Agent& agent : agents_) {
    agent.at = agent.next;
    agent.is_decided = false;
    agent.waited = agent.at == lattice_.size() ? 0 : agent.waited + 1;
  }
}

void Lockstep::find_neighbours() {
  using Cell = Eigen::Array<std::int64_t, 3, 1>;
  const auto cell_of = [&](const Vec3& point) -> Cell {
    return (point / reach_).array().floor().cast<std::int64_t>();
  };
  const auto key_of = [](const Cell& cell) {
    return combine({static_cast<std::uint64_t>(cell.x()), static_cast<std::uint64_t>(cell.y()),
                    static_cast<std::uint64_t>(cell.z())});
  };
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
  for (std::uint32_t i = 0; i < agents_.size(); ++i) {
    cells[key_of(cell_of(position(agents_[i], agents_[i].at)))].push_back(i);
  }
  for (std::uint32_t i = 0; i < agents_.size(); ++i) {
    Agent& agent = agents_[i];
    agent.neighbours.clear();
    const Vec3& point = position(agent, agent.at);
    const Cell middle = cell_of(point);
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = cells.find(key_of(middle + Cell(x, y, z)));
          if (found == cells.end()) continue;
          for (const std::uint32_t j : found->second) {
            if (j == i) continue;
            if ((position(agents_[j], agents_[j].at) - point).squaredNorm() < reach_ * reach_) {
              agent.neighbours.push_back(j);
            }
          }
        }
      }
    }
  }
}

// Chooses robot i's move. False: it has none that suits those already decided, and stays.
bool Lockstep::decide(std::uint32_t i, const Push* push) {
  Agent& agent = agents_[i];
  std::vector<Node> candidates{agent.at};
  const bool is_off = agent.at >= lattice_.size();
  const std::span<const Node> next =
      is_off ? agent.own[agent.at - lattice_.size()].next : lattice_.neighbours(agent.at);
  candidates.insert(candidates.end(), next.begin(), next.end());
  for (const auto& [from, to] : agent.entries) {
    if (from == agent.at) candidates.push_back(to);
  }
  const Vec3& goal = agent.traveller.goal;
  static const unsigned long N = getenv("LN") ? strtoul(getenv("LN"), nullptr, 10) : 4;
  static const unsigned long W = getenv("LW") ? strtoul(getenv("LW"), nullptr, 10) : 8;
  const bool wild = N && combine({i, steps_, 7u}) % N == 0 && (W == 0 || agent.waited > W || push);
  std::ranges::stable_sort(candidates, {}, [&](Node node) {
    const double noise = wild ? static_cast<double>(combine({i, steps_, node}) % 1024) / 1024.0 * 4 : 0.0;
    return std::pair(distance(agent, node) + noise, (position(agent, node) - goal).squaredNorm());
  });
  const std::uint32_t now = distance(agent, agent.at);
  bool has_asked = push != nullptr;
  for (const Node node : candidates) {
    if (!has_asked && distance(agent, node) >= now) {
      has_asked = true;
      if (distance(agent, candidates.front()) < now && try_clearing(i, candidates.front())) return true;
    }
    if (push && !push->suits(position(agent, node))) continue;
    if (try_move(i, node)) return true;
  }
  if (push && try_displacement(i, push->motion, *push)) return true;
  if (push && (is_off || push->keep > 0)) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double step : {-lattice_.spacing(), lattice_.spacing()}) {
        Vec3 d = Vec3::Zero();
        d[axis] = step;
        if (axis < 2 && try_displacement(i, d, *push)) return true;
      }
    }
  }
  choose(i, agent.at);
  return false;
}

// Off the lattice, out of someone's way.
bool Lockstep::try_displacement(std::uint32_t i, const Vec3& displacement, const Push& push) {
  Agent& agent = agents_[i];
  const Vec3 from = position(agent, agent.at), to = from + displacement;
  if (!push.suits(to)) return false;
  if (moves_left_ == 0 || !motion_is_free(agent, from, to)) return false;
  const std::optional<Node> place = visit(agent, to, 1.0);
  return place && try_move(i, *place);
}

bool Lockstep::try_move(std::uint32_t i, Node to) {
  if (moves_left_ == 0) return false;
  --moves_left_;
  ++moves_;
  Agent& agent = agents_[i];
  const bool tr = getenv("LD") && trace_;
  static int depth = 0;
  struct D { D() { ++depth; } ~D() { --depth; } } dd;
  auto nm = [&](const Agent& a, Node n) { static char b[4][80]; static int k = 0; k = (k + 1) % 4; snprintf(b[k], 80, "(%.2f,%.2f)%s", position(a,n).x(), position(a,n).y(), n < lattice_.size() ? "" : "*"); return b[k]; };
  if (tr) fprintf(stderr, "TR %*s%u %s -> %s d %u\n", 2*depth, "", i, nm(agent, agent.at), nm(agent, to), distance(agent, to));
  const Vec3 motion = position(agent, to) - position(agent, agent.at);
  std::vector<std::uint32_t> in_the_way;
  for (const std::uint32_t j : agent.neighbours) {
    if (!conflicts(agent, to, agents_[j])) continue;
    if (agents_[j].is_decided) { if (tr) fprintf(stderr, "TR %*s  hits %u %s -> %s\n", 2*depth, "", j, nm(agents_[j], agents_[j].at), nm(agents_[j], agents_[j].next)); return false; }
    in_the_way.push_back(j);
  }
  const Push push{Vec3::Zero(), motion, 0};
  const std::size_t trail = decided_.size();
  choose(i, to);
  for (const std::uint32_t j : in_the_way) {
    // One that was pushed may have pushed it in turn, and right into this one's way.
    const bool makes_way =
        agents_[j].is_decided ? !conflicts(agent, to, agents_[j]) : decide(j, &push);
    if (makes_way) continue;
    if (tr) fprintf(stderr, "TR %*s  %u cannot make way\n", 2*depth, "", j);
    undo(trail);
    return false;
  }
  return true;
}

// Stays, and has those in the way of a move get out of it, so that it can be made next.
bool Lockstep::try_clearing(std::uint32_t i, Node to) {
  Agent& agent = agents_[i];
  std::vector<std::uint32_t> in_the_way;
  for (const std::uint32_t j : agent.neighbours) {
    if (agents_[j].is_decided && conflicts(agent, agent.at, agents_[j])) return false;
    const Vec3 d = position(agent, agent.at) - position(agents_[j], agents_[j].at);
    const double keep = agent.radius + agents_[j].radius + world_.required_separation();
    if (!first_within(d, position(agent, to) - position(agent, agent.at), keep)) continue;
    if (agents_[j].is_decided) return false;
    in_the_way.push_back(j);
  }
  const std::size_t trail = decided_.size();
  choose(i, agent.at);
  for (const std::uint32_t j : in_the_way) {
    const Push push{position(agent, agent.at), position(agent, to) - position(agent, agent.at),
                    agent.radius + agents_[j].radius + world_.required_separation()};
    const bool makes_way = agents_[j].is_decided
                               ? push.suits(position(agents_[j], agents_[j].next))
                               : decide(j, &push);
    if (makes_way) continue;
    undo(trail);
    return false;
  }
  return true;
}

// Whether a move conflicts with another robot's, or with its rest where that is not decided.
bool Lockstep::conflicts(const Agent& agent, Node to, const Agent& other) const {
  const Vec3& from = position(agent, agent.at);
  const Vec3& there = position(other, other.at);
  Vec3 drift = position(agent, to) - from;
  if (other.is_decided) drift -= position(other, other.next) - there;
  const double keep = agent.radius + other.radius + world_.required_separation();
  return first_within(from - there, drift, keep).has_value();
}

void Lockstep::choose(std::uint32_t i, Node to) {
  agents_[i].next = to;
  agents_[i].is_decided = true;
  decided_.push_back(i);
}

void Lockstep::undo(std::size_t trail) {
  while (decided_.size() > trail) {
    agents_[decided_.back()].is_decided = false;
    decided_.pop_back();
  }
}

}  // namespace accord
