#include "common/io/wire/model_decoder.h"

#include <cmath>

#include "accord.pb.h"
#include "common/io/kinematic_tree.h"
#include "common/io/planar_checks.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kRate{limits::kMinRate, limits::kRate, ""};

class ModelDecoder {
 public:
  ModelDecoder(bool planar, const PayloadPath& at, ShapeDecoder& shapes, Inspector& inspector,
               RobotModel& out)
      : planar_(planar), at_(at), shapes_(shapes), inspector_(inspector), out_(out) {}

  bool take(const payload::Model& from) {
    out_.name = from.name();
    out_.speed = from.speed();
    return inspector_.name(out_.name, PayloadPath(at_, "name")) &&
           inspector_.index(static_cast<std::uint64_t>(from.kind()), 4, "kind",
                            PayloadPath(at_, "kind")) &&
           take_kind(from) && take_dofs(from) && take_links(from) && take_joints(from) &&
           take_bodies(from) && take_may_touch(from) && (is_arm() ? is_sound_arm() : is_mobile());
  }

 private:
  bool is_arm() const { return out_.kind == RobotKind::kArm; }

  bool take_kind(const payload::Model& from) {
    out_.kind = static_cast<RobotKind>(from.kind());
    const bool fits = is_arm() || planar_ == (out_.kind != RobotKind::kBall);
    return fits || inspector_.fail(PayloadPath(at_, "kind"),
                                   "discs and footprints are for planar scenes, balls for others");
  }

  bool take_dofs(const payload::Model& from) {
    const auto size = static_cast<std::size_t>(from.dofs_size());
    if (!inspector_.count(size, 1, limits::kLinks, "", PayloadPath(at_, "dofs"))) return false;
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at(at_, "dofs", i);
      const payload::DegreeOfFreedom& dof = from.dofs(static_cast<int>(i));
      out_.dofs.push_back({dof.name(), dof.lower(), dof.upper(), dof.velocity(), dof.wraps()});
      if (!inspector_.name(dof.name(), PayloadPath(at, "name")) ||
          !inspector_.number(dof.velocity(), kRate, PayloadPath(at, "velocity")) ||
          !has_sound_limits(out_.dofs.back(), at)) {
        return false;
      }
    }
    return true;
  }

  bool has_sound_limits(const DegreeOfFreedom& dof, const PayloadPath& at) {
    const bool unbounded = dof.lower == -kInfinity && dof.upper == kInfinity;
    if (unbounded) return true;
    if (dof.wraps || !is_arm()) return inspector_.fail(at, "expected no limits");
    // Angles or lengths; the wider range holds both.
    return inspector_.number(dof.lower, kCoordinateRange, PayloadPath(at, "lower")) &&
           inspector_.number(dof.upper, {dof.lower, limits::kCoordinate, ""},
                             PayloadPath(at, "upper"));
  }

  bool take_links(const payload::Model& from) {
    const auto size = static_cast<std::size_t>(from.links_size());
    if (!inspector_.count(size, 1, limits::kLinks, "", PayloadPath(at_, "links"))) return false;
    for (std::size_t i = 0; i < size; ++i) {
      out_.links.push_back(from.links(static_cast<int>(i)));
      if (!inspector_.name(out_.links.back(), PayloadPath(at_, "links", i))) return false;
    }
    return true;
  }

  bool take_joints(const payload::Model& from) {
    const auto size = static_cast<std::size_t>(from.joints_size());
    const std::size_t links = out_.links.size();
    if (!inspector_.count(size, links - 1, links - 1, "", PayloadPath(at_, "joints"))) return false;
    std::vector<bool> reached(links, false);
    reached[0] = true;
    std::vector<bool> moved(out_.dofs.size(), false);
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at(at_, "joints", i);
      const payload::Joint& joint = from.joints(static_cast<int>(i));
      if (!inspector_.index(joint.parent(), links, "link", PayloadPath(at, "parent")) ||
          !inspector_.index(joint.child(), links, "link", PayloadPath(at, "child"))) {
        return false;
      }
      if (!reached[joint.parent()] || reached[joint.child()]) {
        return inspector_.fail(at, "expected a tree of links, parents before children");
      }
      reached[joint.child()] = true;
      if (!take_joint(joint, at, moved)) return false;
    }
    return !is_arm() || std::ranges::find(moved, false) == moved.end() ||
           inspector_.fail(PayloadPath(at_, "dofs"), "expected a joint for each");
  }

  bool take_joint(const payload::Joint& from, const PayloadPath& at, std::vector<bool>& moved) {
    Joint joint{from.name(),
                JointType::kFixed,
                static_cast<int>(from.parent()),
                static_cast<int>(from.child()),
                Pose::Identity(),
                Vec3::Zero(),
                -1};
    const PayloadPath type(at, "type");
    const PayloadPath dof(at, "dof");
    if (!inspector_.name(joint.name, PayloadPath(at, "name")) ||
        !inspector_.index(static_cast<std::uint64_t>(from.type()), 3, "type", type) ||
        !inspector_.pose(from.origin(), limits::kCoordinate, PayloadPath(at, "origin"),
                         joint.origin) ||
        !inspector_.direction(from.axis(), PayloadPath(at, "axis"), joint.axis)) {
      return false;
    }
    joint.type = static_cast<JointType>(from.type());
    if ((joint.type == JointType::kFixed) != (from.dof() == 0)) {
      return inspector_.fail(dof, "joints move a degree of freedom unless they are fixed");
    }
    if (from.dof() > 0) {
      const std::size_t index = from.dof() - 1;
      if (!inspector_.index(index, moved.size(), "degree of freedom", dof)) return false;
      if (moved[index]) return inspector_.fail(dof, "another joint moves it");
      moved[index] = true;
      joint.dof = static_cast<int>(index);
    }
    out_.joints.push_back(std::move(joint));
    return true;
  }

  bool take_bodies(const payload::Model& from) {
    const auto size = static_cast<std::size_t>(from.bodies_size());
    if (!inspector_.count(size, 1, limits::kBodies, "", PayloadPath(at_, "bodies"))) return false;
    for (std::size_t i = 0; i < size; ++i) {
      const PayloadPath at(at_, "bodies", i);
      const payload::Body& body = from.bodies(static_cast<int>(i));
      Body out{body.name(), 0, Sphere{}, Pose::Identity()};
      if (!inspector_.name(out.name, PayloadPath(at, "name")) ||
          !inspector_.index(body.link(), out_.links.size(), "link", PayloadPath(at, "link")) ||
          !shapes_.take(body.shape(), planar_, PayloadPath(at, "shape"), out.shape) ||
          !inspector_.pose(body.pose(), limits::kCoordinate, PayloadPath(at, "pose"), out.pose)) {
        return false;
      }
      out.link = static_cast<int>(body.link());
      out_.bodies.push_back(std::move(out));
    }
    return true;
  }

  bool take_may_touch(const payload::Model& from) {
    const PayloadPath at(at_, "may_touch");
    const std::size_t links = out_.links.size();
    if (from.may_touch_size() % 2 != 0) return inspector_.fail(at, "expected pairs of links");
    for (int i = 0; i + 1 < from.may_touch_size(); i += 2) {
      const std::uint32_t first = from.may_touch(i);
      const std::uint32_t second = from.may_touch(i + 1);
      if (!inspector_.index(first, links, "link", at) ||
          !inspector_.index(second, links, "link", at)) {
        return false;
      }
      const std::pair pair(static_cast<int>(first), static_cast<int>(second));
      if (first >= second || (!out_.may_touch.empty() && pair <= *out_.may_touch.rbegin())) {
        return inspector_.fail(at, "expected pairs of links in ascending order");
      }
      out_.may_touch.insert(out_.may_touch.end(), pair);
    }
    return true;
  }

  bool is_sound_arm() {
    RobotModel with_neighbours = out_;
    allow_neighbours(with_neighbours);
    if (with_neighbours.may_touch != out_.may_touch) {
      return inspector_.fail(PayloadPath(at_, "may_touch"), "expected all neighbours");
    }
    if (!planar_) return true;
    Faults faults("");
    check_planar_joints({out_, std::vector<Place>(out_.joints.size()), {}}, faults);
    const auto found = faults.take();
    return found.empty() || inspector_.fail(PayloadPath(at_, "joints"), found.front().text);
  }

  bool is_mobile() {
    const PayloadPath& at = at_;
    if (!inspector_.number(out_.speed, kRate, PayloadPath(at, "speed"))) return false;
    const bool turns = out_.kind == RobotKind::kFootprint;
    const std::size_t translations = out_.translations();
    const std::size_t dofs = translations + (turns ? 1 : 0);
    if (out_.dofs.size() != dofs || !out_.joints.empty() || out_.bodies.size() != 1) {
      return inspector_.fail(
          at, "expected one body, no joints and " + std::to_string(dofs) + " degrees of freedom");
    }
    for (std::size_t k = 0; k < dofs; ++k) {
      if (out_.dofs[k].wraps == (k >= translations)) continue;
      return inspector_.fail(PayloadPath(at, "dofs", k), "headings wrap, translations do not");
    }
    const Body& body = out_.bodies.front();
    const bool fits = turns ? std::holds_alternative<Polygon>(body.shape)
                            : std::holds_alternative<Sphere>(body.shape);
    if (!fits || body.pose.matrix() != Pose::Identity().matrix()) {
      return inspector_.fail(PayloadPath(at, "bodies"), turns ? "expected a polygon in its place"
                                                              : "expected a sphere in its place");
    }
    return true;
  }

  bool planar_;
  const PayloadPath& at_;
  ShapeDecoder& shapes_;
  Inspector& inspector_;
  RobotModel& out_;
};

}  // namespace

bool take_model(const payload::Model& from, bool planar, const PayloadPath& at,
                ShapeDecoder& shapes, Inspector& inspector, RobotModel& out) {
  return ModelDecoder(planar, at, shapes, inspector, out).take(from);
}

}  // namespace accord
