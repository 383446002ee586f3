#include "common/io/shape_fields.h"

#include "common/io/polygon.h"

namespace accord {
namespace {

// What a flat box of a planar scene measures across the plane. It is centred on the plane unless
// `at` says otherwise, and only its cut counts.
constexpr double kFlatBoxHeight = 1;  // m

std::optional<Shape> read_box(const Value& value, SceneContext& context) {
  const bool flat = value.is_list() && value.size() == 2;
  if (flat && context.space == Space::kSpatial) {
    fault_at(value, "expected [x, y, z] in a spatial scene, not " + value.in_words(),
             context.faults);
    return std::nullopt;
  }
  const auto size =
      read_numbers(value, {2, 3}, "full lengths [x, y, z]", kSizeRange, context.faults);
  if (!size) return std::nullopt;
  return Box{{(*size)[0], (*size)[1], flat ? kFlatBoxHeight : (*size)[2]}};
}

std::optional<Shape> read_cylinder(const Value& value, SceneContext& context) {
  if (!expect_map(value, "a map of radius and length", context.faults)) return std::nullopt;
  const Fields fields(value, "a cylinder", {"radius", "length"}, context.faults);
  const auto radius_value = fields.require("radius", "a radius in m");
  const auto length_value = fields.require("length", "a length in m");
  const auto radius =
      radius_value ? read_number(*radius_value, kSizeRange, context.faults) : std::nullopt;
  const auto length =
      length_value ? read_number(*length_value, kSizeRange, context.faults) : std::nullopt;
  if (!radius || !length) return std::nullopt;
  return Cylinder{*radius, *length};
}

std::optional<Shape> read_polygon_shape(const Value& value, SceneContext& context) {
  if (context.space == Space::kSpatial) {
    fault_at(value, "polygons are for planar scenes, whose bounds have two numbers each",
             context.faults);
    return std::nullopt;
  }
  const auto polygon = read_polygon(value, context.faults);
  return polygon ? std::optional<Shape>(*polygon) : std::nullopt;
}

std::optional<Shape> read_mesh(const Fields& fields, const Value& value, SceneContext& context) {
  constexpr Range kScale{1e-9, 1e9, ""};
  double scale = 1;
  const auto factor = fields.find("scale");
  if (factor) {
    const auto number = read_number(*factor, kScale, context.faults);
    if (!number) return std::nullopt;
    scale = *number;
  }
  if (context.space == Space::kPlanar) {
    fault_at(value, "meshes are for spatial scenes; use a polygon in a planar one", context.faults);
    return std::nullopt;
  }
  const auto path = context.file_of(value);
  if (!path) return std::nullopt;
  const MeshBlame blame{
      .file = [&](auto text) { fault_at(value, text, context.faults); },
      .scale = [&](auto text) { fault_at(factor.value_or(value), text, context.faults); }};
  auto surface = context.meshes.load(*path, Vec3::Constant(scale), blame, context.faults);
  if (!surface) return std::nullopt;
  return Mesh{std::move(surface)};
}

}  // namespace

std::optional<Shape> read_shape(const Fields& fields, std::string_view kind,
                                SceneContext& context) {
  const Value value = *fields.find(kind);
  if (kind == "box") return read_box(value, context);
  if (kind == "cylinder") return read_cylinder(value, context);
  if (kind == "polygon") return read_polygon_shape(value, context);
  if (kind == "mesh") return read_mesh(fields, value, context);
  const auto radius = read_number(value, kSizeRange, context.faults);
  return radius ? std::optional<Shape>(Sphere{*radius}) : std::nullopt;
}

}  // namespace accord
