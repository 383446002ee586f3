// Distances between two pieces, by their shapes, at random places up to some of their own sizes
// apart. "distance": exact, to 1e-10 m; "keeps-apart": as a proof asks, which needs to know no more
// than that they are 5 cm apart, or not.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "common/geometry/compile_shape.h"
#include "common/geometry/gap.h"
#include "tests/bench/micro/counters.h"
#include "tests/contract/test_scenes.h"

namespace accord::micro {
namespace {

constexpr std::size_t kPairs = 512;
constexpr double kKeep = 0.05;  // m

struct NamedShape {
  std::string name;
  Shape shape;
};

// Some 0.4 m long each.
std::vector<NamedShape> spatial_shapes() {
  return {{"sphere", Sphere{0.2}},
          {"capsule", Capsule{0.1, 0.4}},
          {"cylinder", Cylinder{0.1, 0.4}},
          {"box", Box{Vec3(0.4, 0.3, 0.2)}},
          {"hull", Mesh{test_scenes::box_mesh(Vec3(0.4, 0.3, 0.2))}},  // a mesh that is convex
          {"mesh", Mesh{test_scenes::ring_mesh(0.1, 0.2, 0.1, 64)}}};
}

std::vector<NamedShape> planar_shapes() {
  return {{"disc", Sphere{0.2}},
          {"box", Box{Vec3(0.4, 0.3, 1)}},
          {"polygon", Polygon{{{0.2, 0}, {0.1, 0.2}, {-0.1, 0.15}, {-0.2, -0.05}, {0, -0.2}}}}};
}

template <int D>
Pose random_place(test_scenes::Random& random) {
  constexpr double kSpan = 0.6;  // m
  if constexpr (D == 3) return test_scenes::random_pose(random, kSpan);
  return test_scenes::at(test_scenes::uniform(random, -kSpan, kSpan),
                         test_scenes::uniform(random, -kSpan, kSpan), 0, 0, 0,
                         test_scenes::uniform(random, -3, 3));
}

// A shape's piece at as many random places. All shapes here are of one piece.
template <int D>
std::vector<Piece<D>> scatter(const Shape& shape, unsigned seed) {
  test_scenes::Random random(seed);
  MeshCache meshes;
  std::vector<Piece<D>> pieces;
  for (std::size_t i = 0; i < kPairs; ++i) {
    pieces.push_back(compile_shape<D>(shape, random_place<D>(random), meshes).front());
  }
  return pieces;
}

template <int D>
void measure(benchmark::State& state, const Shape& first, const Shape& second, bool exact) {
  const std::vector<Piece<D>> a = scatter<D>(first, 1), b = scatter<D>(second, 2);
  const double radii = a.front().radius + b.front().radius;
  Wanted wanted;
  wanted.contact = radii;
  if (!exact) {
    wanted.contact += kKeep;
    wanted.enough = radii + kKeep;
    wanted.hull_will_do = true;
  }
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < kPairs; ++i) {
      const Placed<D> one{&a[i], a[i].frame}, other{&b[i], b[i].frame};
      benchmark::DoNotOptimize(gap(one, other, wanted, Vec<D>(Vec<D>::Zero())).distance - radii);
    }
  }
  count_items(state, kPairs);
}

template <int D>
void add_pairs(const std::string& space, const std::vector<NamedShape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i; j < shapes.size(); ++j) {
      const std::string pair = space + "/" + shapes[i].name + "-" + shapes[j].name;
      for (const bool exact : {true, false}) {
        benchmark::RegisterBenchmark(
            ((exact ? "distance/" : "keeps-apart/") + pair).c_str(),
            [exact, a = shapes[i].shape, b = shapes[j].shape](benchmark::State& state) {
              measure<D>(state, a, b, exact);
            });
      }
    }
  }
}

[[maybe_unused]] const bool kAdded = [] {
  add_pairs<2>("planar", planar_shapes());
  add_pairs<3>("spatial", spatial_shapes());
  return true;
}();

}  // namespace
}  // namespace accord::micro
