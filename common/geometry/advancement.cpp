#include "common/geometry/advancement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/tolerances.h"

namespace accord {
namespace {

// Beyond this many looks a motion is taken to make contact, which is the safe answer: bodies that
// glide along each other for long, hardly farther apart than they must be.
constexpr int kMostLooks = 200000;

// The separation of two pieces along a fixed direction, as the way goes on by s: a concave function
// less what the pieces' paths can bend.
template <int D>
struct Opening {
  const Placed<D>& a;
  const Placed<D>& b;
  Vec<D> normal;
  Vec<D> turn_a;
  Vec<D> turn_b;
  double apart;    // between the frames' origins, along the normal
  double closing;  // its rate
  double keep;

  // Without the bend. The support of a core that turns is that of the core at rest in a direction
  // that turns the other way: n . (p + s w x p) = (n + s n x w) . p.
  double operator()(double s) const {
    return apart + s * closing - support(a, Vec<D>(normal + s * turn_a)) -
           support(b, Vec<D>(-normal - s * turn_b)) - keep;
  }
};

// An x in [0, wanted] such that opening(side * t) - bend t^2 / 2 >= 0 for all t in [0, x]. The
// opening is concave, so that it lies above its chords, and the root of a chord with the bend
// taken off is safe; shorter chords are closer to it.
template <int D>
double safe_way(const Opening<D>& opening, double at_zero, double bend, double side,
                double wanted) {
  double safe = 0;
  double end = wanted;
  for (int i = 0; i < 3; ++i) {
    const double at_end = opening(side * end);
    if (at_end - 0.5 * bend * end * end >= 0) return std::max(safe, end);
    const double slope = (at_end - at_zero) / end;
    const double root = std::sqrt(slope * slope + 2 * bend * at_zero);
    const double x = slope > 0 ? (slope + root) / bend : 2 * at_zero / (root - slope);
    safe = std::max(safe, x * (1 - 1e-12));
    if (1.2 * safe >= 0.9 * end) break;  // a shorter chord would tell little more
    end = 1.2 * safe;
  }
  return std::min(safe, wanted);
}

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
void Advancement<D>::cover_along_normal(const Pair<D>& pair, const Placed<D>& a,
                                        const Placed<D>& b, double back, double forward,
                                        Cover& cover) {
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
  // A little more than needed: pairs at rest to each other need no more than what is contact.
  const Wanted wanted{need + kContactResolution, pair.keep, 1e-10, 0.02};
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
bool Advancement<D>::proves_free() {
  ids_.clear();
  intervals_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) ids_.push_back(i);
  intervals_.push_back({0, 1, 0, pairs.size()});
  int looks = 0;
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    const Interval at = intervals_[k];
    const double middle = 0.5 * (at.low + at.high);
    const double half = 0.5 * (at.high - at.low);
    const std::size_t left = ids_.size();
    double left_end = at.low;
    double right_begin = at.high;
    later_.clear();
    move_to(middle);
    for (std::size_t i = at.begin; i < at.end; ++i) {
      const std::uint32_t id = ids_[i];
      const Cover cover = look(pairs[id], half, half);
      if (cover.contact || ++looks > kMostLooks) return false;
      if (cover.back < half) {
        ids_.push_back(id);
        left_end = std::max(left_end, middle - cover.back);
      }
      if (cover.forward < half) {
        later_.push_back(id);
        right_begin = std::min(right_begin, middle + cover.forward);
      }
    }
    const std::size_t right = ids_.size();
    ids_.insert(ids_.end(), later_.begin(), later_.end());
    if (right > left) intervals_.push_back({at.low, left_end, left, right});
    if (ids_.size() > right) intervals_.push_back({right_begin, at.high, right, ids_.size()});
  }
  return true;
}

// Each pair of ids_ goes from its `from` to its `until` in steps of its own; the one that is least
// far goes next, so that the first contact is the earliest.
template <int D>
std::optional<double> Advancement<D>::march() {
  int looks = 0;
  while (!ids_.empty()) {
    double u = std::numeric_limits<double>::infinity();
    for (const std::uint32_t id : ids_) u = std::min(u, pairs[id].from);
    move_to(u);
    std::size_t left = 0;
    for (const std::uint32_t id : ids_) {
      Pair<D>& pair = pairs[id];
      if (pair.from <= u) {
        const double rest = pair.until - u;
        const Cover cover = look(pair, 0, rest);
        if (cover.contact || ++looks > kMostLooks) return u;
        if (cover.forward >= rest) continue;  // done
        pair.from = u + cover.forward;
      }
      ids_[left++] = id;
    }
    ids_.resize(left);
  }
  return std::nullopt;
}

template <int D>
std::optional<double> Advancement<D>::first_contact() {
  // One look at the middle settles most pairs, and ends the way of the rest where one touches.
  constexpr double kMiddle = 0.5;
  ids_.clear();
  later_.clear();
  move_to(kMiddle);
  bool contact = false;
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    Pair<D>& pair = pairs[i];
    const Cover cover = look(pair, kMiddle, kMiddle);
    contact = contact || cover.contact;
    pair.from = 0;
    pair.until = kMiddle - cover.back;
    pair.again = kMiddle + cover.forward;
    if (pair.until > 0) ids_.push_back(i);
    if (pair.again < 1) later_.push_back(i);
  }
  if (const auto u = march()) return u;
  if (contact) return kMiddle;
  ids_ = later_;
  for (const std::uint32_t id : ids_) {
    pairs[id].from = pairs[id].again;
    pairs[id].until = 1;
  }
  return march();
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
