// Bounds the smallest distance along linear motions from below by bisecting them, most promising
// part first. Internal to the verifier.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace accord::verification {

struct Closest {
  double distance;   // m, a lower bound
  double time;       // s
  std::size_t item;  // which of the motions
};

// Distance is a callable double(item, t, cutoff): a lower bound on the distance at that instant of
// the motion `item`, at most cutoff.
template <typename Distance>
class Bisection {
 public:
  // Only distances below `upper` (m) are looked for, with at most `budget` queries beyond one a
  // motion.
  Bisection(const Distance& distance, double upper, std::size_t budget)
      : distance_(distance), upper_(upper), budget_(budget) {}

  // A motion during [t0, t1] on which the distance changes by at most `travel` (m), evenly.
  void add(std::size_t item, double t0, double t1, double travel) {
    const double middle = t0 + (t1 - t0) / 2;
    const double lower = distance_(item, middle, upper_ + travel / 2) - travel / 2;
    if (lower >= upper_) return;
    parts_.push_back({lower, t0, t1, travel, item});
    std::ranges::push_heap(parts_, kHigher);
  }

  // nullopt: nothing comes closer than `upper`.
  std::optional<Closest> solve() {
    for (; budget_ >= 2 && !parts_.empty() && parts_.front().travel > kTightness; budget_ -= 2) {
      std::ranges::pop_heap(parts_, kHigher);
      const Part part = parts_.back();
      parts_.pop_back();
      const double middle = part.t0 + (part.t1 - part.t0) / 2;
      add(part.item, part.t0, middle, part.travel / 2);
      add(part.item, middle, part.t1, part.travel / 2);
    }
    if (parts_.empty()) return std::nullopt;
    const Part& lowest = parts_.front();
    return Closest{lowest.lower, lowest.t0 + (lowest.t1 - lowest.t0) / 2, lowest.item};
  }

 private:
  struct Part {
    double lower;
    double t0;
    double t1;
    double travel;
    std::size_t item;
  };
  static constexpr double kTightness = 1e-3;  // m of travel: twice the bound's slack
  static constexpr auto kHigher = [](const Part& a, const Part& b) { return a.lower > b.lower; };

  const Distance& distance_;
  double upper_;
  std::size_t budget_;
  std::vector<Part> parts_;  // a heap, lowest bound first
};

}  // namespace accord::verification
