#include "common/geometry/advancement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/capsules.h"
#include "common/geometry/opening.h"
#include "common/geometry/tolerances.h"

namespace accord {
namespace {

// Beyond this many looks a motion is taken to make contact, which is the safe answer: bodies that
// glide along each other for long, hardly farther apart than they must be.
constexpr int kMostLooks = 200000;

}  // namespace

template <int D>
void Advancement<D>::move_to(double u) {
  first.move_to(u);
  if (two) second.move_to(u);
}

template <int D>
const Placed<D>& Advancement<D>::other(const Pair<D>& pair) {
  switch (pair.other) {
    case Pair<D>::Other::kSame:
      return first.piece(pair.b);
    case Pair<D>::Other::kSecond:
      return second.piece(pair.b);
    case Pair<D>::Other::kFixed:
      break;
  }
  return fixed[static_cast<std::size_t>(pair.b)];
}

template <int D>
Twist<D> Advancement<D>::velocity(Traveller<D>& traveller, const Pair<D>& pair, int piece,
                                  const Vec<D>& at) {
  const int link = traveller.chain().pieces()[static_cast<std::size_t>(piece)].link;
  Twist<D> twist = traveller.twist(link);
  twist.linear = twist.at(at - traveller.frame(link).t);
  if (pair.other == Pair<D>::Other::kSame) {
    const Twist<D>& base = traveller.twist(pair.ancestor);
    twist.linear -= base.at(at - traveller.frame(pair.ancestor).t);
    twist.angular -= base.angular;
  }
  return twist;
}

template <int D>
void Advancement<D>::cover_along_normal(const Pair<D>& pair, const Placed<D>& a, const Placed<D>& b,
                                        double back, double forward, Cover& cover) {
  const Vec<D>& n = pair.normal;
  const Twist<D> va = velocity(first, pair, pair.a, a.frame.t);
  Twist<D> vb;
  if (pair.other == Pair<D>::Other::kSame) vb = velocity(first, pair, pair.b, b.frame.t);
  if (pair.other == Pair<D>::Other::kSecond) vb = velocity(second, pair, pair.b, b.frame.t);
  const Opening<D> opening{a,
                           b,
                           n,
                           va.turn(n),
                           vb.turn(n),
                           n.dot(b.frame.t - a.frame.t),
                           n.dot(vb.linear - va.linear),
                           pair.keep};
  const double now = opening(0);
  if (now <= 0) return;
  if (cover.back < back) {
    cover.back = std::max(cover.back, safe_way(opening, now, pair.bend, -1.0, back));
  }
  if (cover.forward < forward) {
    cover.forward = std::max(cover.forward, safe_way(opening, now, pair.bend, 1.0, forward));
  }
}

template <int D>
typename Advancement<D>::Cover Advancement<D>::look(Pair<D>& pair, double back, double forward) {
  const Placed<D>& a = first.piece(pair.a);
  const Placed<D>& b = other(pair);
  const double need = pair.keep + pair.speed * std::max(back, forward);
  const double far = need + a.piece->bound + b.piece->bound;
  if ((b.frame.t - a.frame.t).squaredNorm() > far * far) return {back, forward, false};
  ++distances;
  Vec<D> between = Vec<D>::Zero();
  const Opinion opinion = by_capsules(a, b, pair.keep, need, between);
  if (opinion == Opinion::kApart) return {back, forward, false};
  if (opinion == Opinion::kTouching) return {0, 0, true};
  if (pair.normal.isZero(0)) pair.normal = between;
  // A little more than needed: pairs at rest to each other need no more than what is contact.
  const Wanted wanted{need + kContactResolution, pair.keep, 1e-10, 0.02, true};
  const Gap<D> gap = accord::gap(a, b, wanted, pair.normal);
  pair.normal = gap.normal;
  const double slack = gap.distance - pair.keep;
  if (slack <= 0) return {0, 0, true};
  if (gap.distance >= need) return {back, forward, false};
  const double step = slack / pair.speed;
  Cover cover{std::min(back, step), std::min(forward, step), false};
  if (gap.separates) cover_along_normal(pair, a, b, back, forward, cover);
  const double least = kContactResolution / pair.speed;
  cover.contact = (cover.back < back && cover.back < least) ||
                  (cover.forward < forward && cover.forward < least);
  return cover;
}

template <int D>
void Advancement<D>::start() {
  looks_ = 0;
  ids_.clear();
  intervals_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) ids_.push_back(i);
  intervals_.push_back({0, 1, 0, pairs.size()});
}

// Looks at the middle, and leaves what that does not prove: pairs, and stretches before and after
// it. True where a pair is in contact there; with `any`, at once.
template <int D>
bool Advancement<D>::split(const Interval& way, bool any, Interval& before, Interval& after) {
  const double middle = 0.5 * (way.low + way.high);
  const double half = 0.5 * (way.high - way.low);
  bool contact = false;
  before = {way.low, way.low, ids_.size(), 0};
  after = {way.high, way.high, 0, 0};
  later_.clear();
  move_to(middle);
  for (std::size_t i = way.begin; i < way.end; ++i) {
    const std::uint32_t id = ids_[i];
    const Cover cover = look(pairs[id], half, half);
    contact = contact || cover.contact || ++looks_ > kMostLooks;
    if (contact && any) return true;
    if (cover.back < half) {
      ids_.push_back(id);
      before.high = std::max(before.high, middle - cover.back);
    }
    if (cover.forward < half) {
      later_.push_back(id);
      after.low = std::min(after.low, middle + cover.forward);
    }
  }
  before.end = after.begin = ids_.size();
  ids_.insert(ids_.end(), later_.begin(), later_.end());
  after.end = ids_.size();
  return contact;
}

template <int D>
bool Advancement<D>::proves_free() {
  start();
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    Interval before;
    Interval after;
    if (split(intervals_[k], true, before, after)) return false;
    if (before.end > before.begin) intervals_.push_back(before);
    if (after.end > after.begin) intervals_.push_back(after);
  }
  return true;
}

// Each pair goes from its `from` to `until` in steps of its own; those that are least far go next,
// so that the first contact is the earliest.
template <int D>
std::optional<double> Advancement<D>::march(const Interval& way) {
  later_.assign(ids_.begin() + static_cast<std::ptrdiff_t>(way.begin),
                ids_.begin() + static_cast<std::ptrdiff_t>(way.end));
  for (const std::uint32_t id : later_) pairs[id].from = way.low;
  while (!later_.empty()) {
    double u = way.high;
    for (const std::uint32_t id : later_) u = std::min(u, pairs[id].from);
    move_to(u);
    const double rest = way.high - u;
    std::size_t left = 0;
    for (const std::uint32_t id : later_) {
      Pair<D>& pair = pairs[id];
      if (pair.from <= u) {
        const Cover cover = look(pair, 0, rest);
        if (cover.contact || ++looks_ > kMostLooks) return u;
        if (cover.forward >= rest) continue;  // done
        pair.from = u + cover.forward;
      }
      later_[left++] = id;
    }
    later_.resize(left);
  }
  return std::nullopt;
}

template <int D>
std::optional<double> Advancement<D>::first_contact() {
  // Halves that share their looks at robots suit many pairs, steps of its own a pair in trouble.
  constexpr std::size_t kFewPairs = 1;
  constexpr double kShort = 1.0 / 64;
  start();
  std::optional<double> contact;  // found at a middle; all before it is still to be proved
  while (!intervals_.empty()) {
    const Interval way = intervals_.back();
    intervals_.pop_back();
    if (way.end - way.begin <= kFewPairs || way.high - way.low <= kShort) {
      if (const auto u = march(way)) return u;
      continue;
    }
    Interval before;
    Interval after;
    if (split(way, false, before, after)) {
      contact = 0.5 * (way.low + way.high);
      intervals_.clear();
    } else if (after.end > after.begin) {
      intervals_.push_back(after);
    }
    if (before.end > before.begin) intervals_.push_back(before);
  }
  return contact;
}

template <int D>
Advancement<D>& thread_advancement() {
  thread_local Advancement<D> advancement;
  return advancement;
}

template class Advancement<2>;
template class Advancement<3>;
template Advancement<2>& thread_advancement();
template Advancement<3>& thread_advancement();

}  // namespace accord
