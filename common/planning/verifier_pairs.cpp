#include "common/planning/verifier_pairs.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <tuple>

#include "common/planning/verifier_parallel.h"
#include "common/planning/verifier_separation.h"
#include "common/planning/verifier_words.h"

namespace accord::verification {
namespace {

struct Contact {
  double time;
  Pair pair;
};

struct SlabResult {
  std::optional<Contact> contact;
  double separation = kSeparationCutoff;
};

// Where both robots of a pair are; keeps its memory from one pair to the next.
struct PairState {
  Configuration a;
  Configuration b;

  void move_to(const Trajectory& path_a, const Trajectory& path_b, double t) {
    a.resize(path_a.dof());
    b.resize(path_b.dof());
    path_a.at(t, a);
    path_b.at(t, b);
  }
};

std::optional<double> first_contact(const Subject& subject, Pair pair, double begin, double end,
                                    PairState& from, PairState& to) {
  const Trajectory& a = subject.path(pair.first);
  const Trajectory& b = subject.path(pair.second);
  std::optional<double> contact;
  from.move_to(a, b, begin);
  for_each_stretch(a, b, begin, end, [&](double t0, double t1) {
    to.move_to(a, b, t1);
    contact = subject.world.first_contact(pair.first, {from.a, to.a, t0, t1}, pair.second,
                                          {from.b, to.b, t0, t1});
    std::swap(from, to);
    return !contact;
  });
  return contact;
}

// The earliest contact of the pairs during a slab; the first pair's where several are as early.
std::optional<Contact> earliest_contact(const Subject& subject, const std::vector<Pair>& pairs,
                                        double begin, double until) {
  std::optional<Contact> earliest;
  PairState from;
  PairState to;
  for (const Pair pair : pairs) {
    const std::optional<double> contact = first_contact(subject, pair, begin, until, from, to);
    if (!contact || (earliest && *contact >= earliest->time)) continue;
    earliest = Contact{*contact, pair};
    if (*contact <= begin) break;
    until = *contact;  // later contacts of other pairs do not matter
  }
  return earliest;
}

// The smallest distance of any of the pairs at an instant, at most the cutoff.
double smallest_separation(const Subject& subject, const std::vector<Pair>& pairs, double t) {
  double smallest = kSeparationCutoff;
  PairState state;
  for (const Pair pair : pairs) {
    state.move_to(subject.path(pair.first), subject.path(pair.second), t);
    smallest = std::min(
        smallest, subject.world.separation(pair.first, state.a, pair.second, state.b, smallest));
  }
  return smallest;
}

SlabResult check_slab(const Subject& subject, const TimeSlabs& slabs, std::size_t slab,
                      bool sample) {
  SlabResult result;
  slabs.for_each_part(slab, subject.world.required_separation(),
                      [&](double begin, double end, std::vector<Pair>& pairs) {
                        if (sample) {
                          result.separation = std::min(result.separation,
                                                       smallest_separation(subject, pairs, begin));
                        }
                        if (!earliest_contact(subject, pairs, begin, end)) return true;
                        // Which pair is named must not depend on how the broad phase went about it.
                        std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
                          return std::tie(a.first, a.second) < std::tie(b.first, b.second);
                        });
                        result.contact = earliest_contact(subject, pairs, begin, end);
                        return false;
                      });
  return result;
}

// The closest that the pair comes from the contact on, until it is apart again. Looks at instants
// ever further apart.
Fault closest_approach(const Subject& subject, const Contact& contact) {
  const Trajectory& a = subject.path(contact.pair.first);
  const Trajectory& b = subject.path(contact.pair.second);
  const double end = std::max(a.end_time(), b.end_time());
  PairState state;
  std::optional<Fault> closest;
  double step = 1e-9 * std::max(1.0, end);
  for (double t = contact.time;; t = std::min(end, t + step), step *= 1.3) {
    state.move_to(a, b, t);
    const Fault here =
        subject.world.closest(contact.pair.first, state.a, contact.pair.second, state.b);
    if (!closest || here.gap < closest->gap) closest = here;
    const bool apart = here.gap > subject.world.required_separation();
    const bool began = closest->gap <= subject.world.required_separation();
    if (t >= end || (apart && began)) return *closest;
  }
}

Violation violation_of(const Subject& subject, const Contact& contact) {
  const Robot& first = subject.robot(contact.pair.first);
  const Robot& second = subject.robot(contact.pair.second);
  const Fault closest = closest_approach(subject, contact);
  return {Violation::Kind::kRobots,
          {first.name, second.name},
          contact.time,
          closest.where,
          closest.gap,
          quoted(first.name) + " and " + quoted(second.name) + " collide at " +
              seconds(contact.time) + " near " + place(subject.scene, closest.where) + ": they " +
              closeness(closest.gap, subject.scene.clearance)};
}

}  // namespace

PairsResult check_pairs(const Subject& subject, const TimeSlabs& slabs, unsigned threads,
                        bool sample) {
  std::vector<SlabResult> results(slabs.count());
  // Slabs after one with a contact need not be looked at; those before it always are, so that the
  // earliest contact does not depend on the threads.
  std::atomic<std::size_t> first_with_contact = std::numeric_limits<std::size_t>::max();
  parallel_for(slabs.count(), threads, [&](std::size_t slab) {
    if (slab > first_with_contact) return;
    results[slab] = check_slab(subject, slabs, slab, sample);
    if (!results[slab].contact) return;
    std::size_t known = first_with_contact;
    while (slab < known && !first_with_contact.compare_exchange_weak(known, slab)) {
    }
  });
  PairsResult out{std::nullopt, kSeparationCutoff};
  for (const SlabResult& result : results) {
    out.sampled_separation = std::min(out.sampled_separation, result.separation);
    if (!result.contact) continue;
    out.violation = violation_of(subject, *result.contact);
    break;
  }
  return out;
}

}  // namespace accord::verification
