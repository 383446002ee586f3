// Compiles a scene.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/geometry/mesh_surface.h"
#include "common/geometry/world_core.h"

namespace accord {
namespace {

// A wall's frame: its axis points out of the bounds.
Frame<2> facing(int axis, double sign, const Vec<2>& at) {
  return axis == 0 ? Frame<2>{sign, 0, at} : Frame<2>{0, sign, at};
}

Frame<3> facing(int axis, double sign, const Vec<3>& at) {
  Frame<3> frame;
  const Vec3 z = sign * Vec3::Unit(axis);
  const Vec3 x = Vec3::Unit((axis + 1) % 3);
  frame.r << x, z.cross(x), z;
  frame.t = at;
  return frame;
}

template <int D>
double magnitude(const Extent<D>& extent) {
  double most = 0;
  for (int i = 0; i < D; ++i) {
    for (const double value : {extent.min[i], extent.max[i]}) {
      if (std::isfinite(value)) most = std::max(most, std::abs(value));
    }
  }
  return most;
}

}  // namespace

template <int D>
WorldCore<D>::WorldCore(const Scene& scene, double margin) : scene_(&scene), margin_(margin) {
  MeshCache meshes;
  chains_.reserve(scene.robots.size());
  for (const Robot& robot : scene.robots) chains_.emplace_back(robot, meshes);
  for (const auto& chain : chains_) {
    for (const auto& p : chain.pieces())
      solids_ = solids_ || (p.piece.mesh && p.piece.mesh->closed());
  }
  add_obstacles(scene);
  tree_ = BoxTree<D>(fixed_extents_);
  add_walls(scene);
  fixed_.reserve(fixed_pieces_.size());
  for (const Piece<D>& piece : fixed_pieces_) fixed_.push_back({&piece, piece.frame});
  find_rounding();
  apart_ = scene.clearance + margin + rounding_;
  self_apart_ = margin + rounding_;
  find_what_matters();
}

template <int D>
void WorldCore<D>::add_obstacles(const Scene& scene) {
  MeshCache meshes;
  fixed_pieces_.reserve(scene.obstacles.size() + 2 * D);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Obstacle& obstacle = scene.obstacles[i];
    try {
      for (Piece<D>& piece : compile_shape<D>(obstacle.shape, obstacle.pose, meshes)) {
        const Vec<D> half = half_extents(Placed<D>{&piece, piece.frame});
        const Extent<D> extent{piece.frame.t - half, piece.frame.t + half};
        fixed_extents_.push_back(extent.inflated(piece.radius));
        solids_ = solids_ || (piece.mesh && piece.mesh->closed());
        fixed_pieces_.push_back(std::move(piece));
        obstacle_of_.push_back(static_cast<int>(i));
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("obstacle \"" + obstacle.name + "\" " + error.what());
    }
  }
}

template <int D>
void WorldCore<D>::add_walls(const Scene& scene) {
  if (!scene.bounds) return;
  bounds_ = Extent<D>{scene.bounds->min.head<D>(), scene.bounds->max.head<D>()};
  for (int axis = 0; axis < D; ++axis) {
    for (const bool upper : {false, true}) {
      Piece<D> wall;
      wall.core = Core::kHalfSpace;
      wall.bound = std::numeric_limits<double>::infinity();
      wall.frame = facing(axis, upper ? 1.0 : -1.0, upper ? bounds_->max : bounds_->min);
      fixed_pieces_.push_back(wall);
    }
  }
}

// A distance is the result of some ten operations on coordinates; frames at the end of a chain of
// joints, of some tens.
template <int D>
void WorldCore<D>::find_rounding() {
  double scale = 1;
  for (const auto& extent : fixed_extents_) scale = std::max(scale, magnitude(extent));
  if (bounds_) scale = std::max(scale, magnitude(*bounds_));
  for (const auto& chain : chains_) {
    if (chain.mobile()) continue;
    scale = std::max(scale, magnitude(chain.reach_box()));
  }
  rounding_ = 64 * std::numeric_limits<double>::epsilon() * scale;
}

template <int D>
void WorldCore<D>::find_what_matters() {
  for (const auto& chain : chains_) {
    bool near = chain.mobile();
    if (!near) {
      const Extent<D> reach = chain.reach_box().inflated(apart_);
      near = !tree_.each_overlapping(reach, [](int) { return false; });
      if (bounds_) {
        near = near || (chain.reach_box().min.array() < bounds_->min.array()).any() ||
               (chain.reach_box().max.array() > bounds_->max.array()).any();
      }
    }
    near_fixed_.push_back(near ? 1 : 0);
  }
}

template WorldCore<2>::WorldCore(const Scene&, double);
template WorldCore<3>::WorldCore(const Scene&, double);

}  // namespace accord
