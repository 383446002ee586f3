#include "common/io/mobile_models.h"

#include <limits>

#include "common/io/fields.h"
#include "common/io/limits.h"
#include "common/io/polygon.h"

namespace accord {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kSpeed{limits::kMinRate, limits::kRate, "m/s"};
constexpr Range kTurn{limits::kMinRate, limits::kRate, "rad/s"};

RobotKind to_kind(std::string_view kind) {
  if (kind == "disk") return RobotKind::kDisk;
  return kind == "ball" ? RobotKind::kBall : RobotKind::kFootprint;
}

std::optional<Shape> read_body(const Value& value, std::string_view kind, SceneContext& context) {
  if (kind == "footprint") {
    const auto polygon = read_polygon(value, context.faults);
    const auto blame = [&](std::string_view text) { fault_at(value, text, context.faults); };
    if (!polygon || !context.afford(*polygon, blame)) return std::nullopt;
    return *polygon;
  }
  const auto radius = read_number(value, kSizeRange, context.faults);
  return radius ? std::optional<Shape>(Sphere{*radius}) : std::nullopt;
}

// Whether the kind fits the scene; reports if not.
bool fits(const Value& body, std::string_view kind, SceneContext& context) {
  if (kind == "ball" && context.space == Space::kPlanar) {
    fault_at(body,
             "balls leave the plane of a planar scene; use a disk, or bounds of three numbers",
             context.faults);
    return false;
  }
  if (kind != "ball" && context.space == Space::kSpatial) {
    fault_at(body,
             "a " + std::string(kind) + " is for planar scenes, whose bounds have two numbers each",
             context.faults);
    return false;
  }
  return true;
}

}  // namespace

std::optional<RobotModel> read_mobile_model(const Value& value, std::string_view kind,
                                            SceneContext& context) {
  std::vector<std::string_view> keys{kind, "speed"};
  if (kind == "footprint") keys.push_back("turn");
  const Fields fields(value, "a " + std::string(kind) + " model", keys, context.faults);
  const auto number = [&](std::string_view key, Range range, std::string_view expected) {
    const auto found = fields.require(key, expected);
    return found ? read_number(*found, range, context.faults) : std::nullopt;
  };
  const Value body_value = *fields.find(kind);
  const auto body = read_body(body_value, kind, context);
  const auto speed = number("speed", kSpeed, "a speed in m/s");
  std::optional<double> turn = 0;
  if (kind == "footprint") turn = number("turn", kTurn, "a turning rate in rad/s");
  if (!fits(body_value, kind, context) || !body || !speed || !turn) return std::nullopt;

  RobotModel model;
  model.kind = to_kind(kind);
  model.speed = *speed;
  model.dofs = {{"x", -kInfinity, kInfinity, *speed, false},
                {"y", -kInfinity, kInfinity, *speed, false}};
  if (kind == "ball") model.dofs.push_back({"z", -kInfinity, kInfinity, *speed, false});
  if (kind == "footprint") model.dofs.push_back({"heading", -kInfinity, kInfinity, *turn, true});
  model.links = {std::string(kind)};
  model.bodies = {{std::string(kind), 0, *body, Pose::Identity()}};
  return model;
}

}  // namespace accord
