#include "common/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "common/geometry/sweep.h"
#include "tests/contract/test_scenes.h"

namespace accord {
namespace {

using test_scenes::Random;
using test_scenes::uniform;

template <int D>
Vec<D> random_vector(Random& random, double low, double high) {
  Vec<D> v;
  for (int i = 0; i < D; ++i) v[i] = uniform(random, low, high);
  return v;
}

template <int D>
std::vector<Extent<D>> random_boxes(Random& random, int count) {
  std::vector<Extent<D>> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec<D> center = random_vector<D>(random, -10, 10);
    const Vec<D> half = random_vector<D>(random, 0, 0.5);
    boxes.push_back({center - half, center + half});
  }
  return boxes;
}

template <int D>
void expect_overlaps_as_by_hand() {
  Random random(1);
  for (const int count : {0, 1, 2, 5, 1000}) {
    const auto boxes = random_boxes<D>(random, count);
    const BoxTree<D> tree(boxes);
    for (const auto& query : random_boxes<D>(random, 100)) {
      std::set<int> expected;
      for (int i = 0; i < count; ++i) {
        if (boxes[static_cast<std::size_t>(i)].overlaps(query)) expected.insert(i);
      }
      std::set<int> found;
      EXPECT_TRUE(
          tree.each_overlapping(query, [&](int item) { return found.insert(item).second; }));
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsWhatOverlaps) {
  expect_overlaps_as_by_hand<2>();
  expect_overlaps_as_by_hand<3>();
}

TEST(BoxTree, StopsWhenTold) {
  Random random(2);
  const BoxTree<2> tree(random_boxes<2>(random, 100));
  int visits = 0;
  EXPECT_FALSE(tree.each_overlapping({Vec2(-20, -20), Vec2(20, 20)}, [&](int) {
    ++visits;
    return visits < 3;
  }));
  EXPECT_EQ(visits, 3);
}

TEST(BoxTree, FindsTheNearest) {
  Random random(3);
  const auto boxes = random_boxes<3>(random, 500);
  const BoxTree<3> tree(boxes);
  for (const auto& query : random_boxes<3>(random, 100)) {
    double expected = 1e300;
    for (const auto& box : boxes) {
      expected = std::min(expected, std::sqrt(box.squared_distance(query)));
    }
    double best = std::numeric_limits<double>::infinity();
    int visits = 0;
    tree.each_near(query, best, [&](int item) {
      ++visits;
      best =
          std::min(best, std::sqrt(boxes[static_cast<std::size_t>(item)].squared_distance(query)));
      return best;
    });
    EXPECT_EQ(best, expected);
    EXPECT_LT(visits, 150);
  }
}

TEST(BoxTree, HoldsManyBoxesInOnePlace) {
  const std::vector<Extent<2>> boxes(1000, {Vec2(0, 0), Vec2(1, 1)});
  const BoxTree<2> tree(boxes);
  int visits = 0;
  tree.each_overlapping({Vec2(0.5, 0.5), Vec2(0.5, 0.5)}, [&](int) {
    ++visits;
    return true;
  });
  EXPECT_EQ(visits, 1000);
}

template <int D>
void expect_sweep_misses_nothing() {
  Random random(4);
  int dropped = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec<D> from = random_vector<D>(random, -5, 5);
    const Vec<D> to = k % 10 == 0 ? from : random_vector<D>(random, -5, 5);
    const double radius = uniform(random, 0, 0.5);
    const Sweep<D> sweep(from, to, radius);
    for (const auto& box : random_boxes<D>(random, 100)) {
      bool touched = false;
      for (int i = 0; i <= 200 && !touched; ++i) {
        const Vec<D> p = from + (to - from) * (i / 200.0);
        touched = box.squared_distance({p, p}) <= radius * radius;
      }
      if (touched) {
        EXPECT_TRUE(sweep(box));
      }
      if (!sweep(box) && sweep.extent().overlaps(box)) ++dropped;
    }
  }
  EXPECT_GT(dropped, 100);
}

TEST(Sweep, KeepsEveryBoxThatTheBallTouches) {
  expect_sweep_misses_nothing<2>();
  expect_sweep_misses_nothing<3>();
}

}  // namespace
}  // namespace accord
