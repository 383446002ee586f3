#include "common/io/models.h"

#include <array>
#include <set>
#include <string_view>

#include "common/io/fields.h"
#include "common/io/limits.h"
#include "common/io/mobile_models.h"
#include "common/io/planar_checks.h"
#include "common/io/srdf.h"
#include "common/io/urdf.h"
#include "common/io/words.h"

namespace accord {
namespace {

constexpr std::array<std::string_view, 4> kKinds = {"disk", "footprint", "ball", "urdf"};

// Adds what the SRDF beside the URDF says, where there is one.
void add_srdf(std::filesystem::path path, const Value& urdf, RobotModel& model,
              SceneContext& context) {
  path.replace_extension(".srdf");
  if (!context.files.exists(path)) return;
  const auto text = context.files.read(path, limits::kUrdfBytes);
  if (!text) return fault_at(urdf, text.error(), context.faults);
  apply_srdf(*text, path.string(), model, context.faults);
}

std::optional<RobotModel> read_arm(const Value& value, SceneContext& context) {
  const std::size_t before = context.faults.count();
  const Fields fields(value, "a urdf model", {"urdf"}, context.faults);
  const Value urdf = *fields.find("urdf");
  const auto path = context.file_of(urdf);
  const auto text =
      path ? context.files.read(*path, limits::kUrdfBytes) : tl::unexpected(std::string());
  if (!text) {
    if (path) fault_at(urdf, text.error(), context.faults);
    return std::nullopt;
  }
  auto arm = parse_urdf(*text, *path, context.meshes, context.faults);
  if (!arm) return std::nullopt;
  add_srdf(*path, urdf, arm->model, context);
  for (std::size_t i = 0; i < arm->model.bodies.size(); ++i) {
    context.afford(arm->model.bodies[i].shape,
                   [&](auto why) { context.faults.add(arm->body_places[i], why); });
  }
  if (context.space == Space::kPlanar) check_planar_joints(*arm, context.faults);
  if (context.faults.count() != before) return std::nullopt;
  return std::move(arm->model);
}

std::shared_ptr<const RobotModel> read_model(const std::string& name, const Value& value,
                                             SceneContext& context) {
  if (!expect_map(value, "a model, such as {disk: 0.3, speed: 1}", context.faults)) return nullptr;
  const std::string_view kind = only_kind_of(value, kKinds, "kind of robot", context.faults);
  if (kind.empty()) return nullptr;
  std::optional<RobotModel> model;
  if (kind == "urdf") {
    model = read_arm(value, context);
  } else {
    model = read_mobile_model(value, kind, context);
  }
  if (!model) return nullptr;
  model->name = name;
  return std::make_shared<const RobotModel>(std::move(*model));
}

}  // namespace

std::optional<Models> read_models(const Value& map, SceneContext& context) {
  if (!expect_map(map, "a map of models", context.faults)) return std::nullopt;
  Models models;
  for (auto it = map.begin(); it != map.end(); ++it) {
    const Value key = *it;
    const Value value = *++it;
    if (context.faults.full()) break;
    if (models.size() >= limits::kModels) {
      fault_at(map, "more than " + std::to_string(limits::kModels) + " models", context.faults);
      break;
    }
    const auto name = read_name(key, context.faults);
    if (!name) continue;
    if (models.contains(*name)) {
      fault_at(value, "another model has this name", context.faults);
      continue;
    }
    models.emplace(*name, read_model(*name, value, context));
  }
  return models;
}

}  // namespace accord
