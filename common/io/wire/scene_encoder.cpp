// Structured bindings throughout: a field that is added to the model cannot be forgotten here.
#include <unordered_map>

#include "accord.pb.h"
#include "common/io/wire/payload_scan.h"
#include "common/io/wire/scene_codec.h"
#include "common/io/wire/trajectory_parts.h"

namespace accord {
namespace {

void put(const Vec3& vector, WireDoubles& out) {
  put_numbers({vector.data(), 3}, out);
}

void put(const Pose& pose, WireDoubles& out) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) out.Add(pose.matrix()(row, column));
  }
}

void put(const DegreeOfFreedom& dof, payload::DegreeOfFreedom& out) {
  const auto& [name, lower, upper, velocity, wraps] = dof;
  out.set_name(name);
  out.set_lower(lower);
  out.set_upper(upper);
  out.set_velocity(velocity);
  out.set_wraps(wraps);
}

void put(const Joint& joint, payload::Joint& out) {
  const auto& [name, type, parent, child, origin, axis, dof] = joint;
  out.set_name(name);
  out.set_type(static_cast<payload::Joint::Type>(type));
  out.set_parent(static_cast<std::uint32_t>(parent));
  out.set_child(static_cast<std::uint32_t>(child));
  put(origin, *out.mutable_origin());
  put(axis, *out.mutable_axis());
  out.set_dof(static_cast<std::uint32_t>(dof + 1));
}

void put(const TriangleMesh& mesh, payload::Mesh& out) {
  const auto& [vertices, triangles, closed] = mesh;
  out.mutable_vertices()->Reserve(static_cast<int>(3 * vertices.size()));
  for (const Vec3& vertex : vertices) put(vertex, *out.mutable_vertices());
  out.mutable_triangles()->Reserve(static_cast<int>(3 * triangles.size()));
  for (const auto& triangle : triangles) {
    out.mutable_triangles()->Add(triangle.begin(), triangle.end());
  }
  out.set_closed(closed);
}

class SceneEncoder {
 public:
  Bytes encode(const Scene& scene) {
    const auto& [name, timestep, clearance, planar, bounds, obstacles, robots] = scene;
    out_.set_name(name);
    out_.set_timestep(timestep);
    out_.set_clearance(clearance);
    out_.set_planar(planar);
    if (bounds) {
      accord::put(bounds->min, *out_.mutable_bounds());
      accord::put(bounds->max, *out_.mutable_bounds());
    }
    for (const Robot& robot : robots) put(robot, *out_.add_robots());
    for (const Obstacle& obstacle : obstacles) put(obstacle, *out_.add_obstacles());
    return serialize_payload(out_);
  }

 private:
  void put(const Robot& robot, payload::Robot& out) {
    const auto& [name, model, base, start, goal] = robot;
    out.set_name(name);
    out.set_model(index_of(model));
    accord::put(base, *out.mutable_base());
    put_numbers(start, *out.mutable_start());
    put_numbers(goal, *out.mutable_goal());
  }

  void put(const Obstacle& obstacle, payload::Obstacle& out) {
    const auto& [name, shape, pose] = obstacle;
    out.set_name(name);
    put(shape, *out.mutable_shape());
    accord::put(pose, *out.mutable_pose());
  }

  void put(const RobotModel& model, payload::Model& out) {
    const auto& [name, kind, dofs, speed, links, joints, bodies, may_touch] = model;
    out.set_name(name);
    out.set_kind(static_cast<payload::Model::Kind>(kind));
    for (const DegreeOfFreedom& dof : dofs) accord::put(dof, *out.add_dofs());
    out.set_speed(speed);
    for (const std::string& link : links) out.add_links(link);
    for (const Joint& joint : joints) accord::put(joint, *out.add_joints());
    for (const Body& body : bodies) put(body, *out.add_bodies());
    for (const auto& [first, second] : may_touch) {
      out.add_may_touch(static_cast<std::uint32_t>(first));
      out.add_may_touch(static_cast<std::uint32_t>(second));
    }
  }

  void put(const Body& body, payload::Body& out) {
    const auto& [name, link, shape, pose] = body;
    out.set_name(name);
    out.set_link(static_cast<std::uint32_t>(link));
    put(shape, *out.mutable_shape());
    accord::put(pose, *out.mutable_pose());
  }

  void put(const Shape& shape, payload::Shape& out) {
    std::visit([&](const auto& kind) { put_kind(kind, out); }, shape);
  }

  static void put_kind(const Sphere& sphere, payload::Shape& out) { out.set_sphere(sphere.radius); }
  static void put_kind(const Capsule& capsule, payload::Shape& out) {
    out.mutable_capsule()->set_radius(capsule.radius);
    out.mutable_capsule()->set_length(capsule.length);
  }
  static void put_kind(const Cylinder& cylinder, payload::Shape& out) {
    out.mutable_cylinder()->set_radius(cylinder.radius);
    out.mutable_cylinder()->set_length(cylinder.length);
  }
  static void put_kind(const Box& box, payload::Shape& out) {
    accord::put(box.size, *out.mutable_box()->mutable_value());
  }
  static void put_kind(const Polygon& polygon, payload::Shape& out) {
    for (const Vec2& vertex : polygon.vertices) {
      put_numbers({vertex.data(), 2}, *out.mutable_polygon()->mutable_value());
    }
  }
  void put_kind(const Mesh& mesh, payload::Shape& out) {
    const auto next = static_cast<std::uint32_t>(meshes_.size());
    const auto [found, is_new] = meshes_.try_emplace(mesh.surface.get(), next);
    if (is_new) accord::put(*mesh.surface, *out_.add_meshes());
    out.set_mesh(found->second);
  }

  std::uint32_t index_of(const std::shared_ptr<const RobotModel>& model) {
    const auto next = static_cast<std::uint32_t>(models_.size());
    const auto [found, is_new] = models_.try_emplace(model.get(), next);
    if (is_new) put(*model, *out_.add_models());
    return found->second;
  }

  payload::Scene out_;
  // Where they stand on the wire: in the order of first use, not of their addresses.
  std::unordered_map<const RobotModel*, std::uint32_t> models_;
  std::unordered_map<const TriangleMesh*, std::uint32_t> meshes_;
};

}  // namespace

Bytes encode_scene(const Scene& scene) {
  return SceneEncoder().encode(scene);
}

}  // namespace accord
