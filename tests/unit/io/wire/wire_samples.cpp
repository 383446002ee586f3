#include "tests/unit/io/wire/wire_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "common/io/scene_file.h"
#include "common/planning/region.h"

namespace accord::wire_samples {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Configuration random_configuration(RandomStream& random, const Region& within) {
  Configuration q;
  for (std::size_t k = 0; k < within.lower.size(); ++k) {
    q.push_back(random.uniform(within.lower[k], within.upper[k]));
  }
  return q;
}

}  // namespace

std::vector<std::string> example_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(ACCORD_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      if (!line.starts_with("accord:")) continue;
      names.push_back(entry.path().filename().string());
      break;
    }
  }
  std::ranges::sort(names);
  return names;
}

std::shared_ptr<const Scene> load_example(const std::string& name) {
  const SceneResult result = load_scene(ACCORD_SOURCE_DIR "/scenes/" + name);
  for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
  return result.scene;
}

std::shared_ptr<const Scene> small_scene() {
  const SceneResult result = parse_scene(R"(
accord: scene/1
name: small
clearance: 0.05
environment:
  bounds: [[-5, -3], [5, 3]]
  obstacles:
    - {box: [4, 0.5], at: [-3, 2]}
    - {sphere: 0.25, at: [3, -2]}
    - {polygon: [[0, 2], [1, 2], [0, 2.5]], name: corner}
models:
  agv: {disk: 0.3, speed: 1.0}
  cart: {footprint: [[-0.2, -0.1], [0.3, 0], [-0.2, 0.1]], speed: 1, turn: 2}
robots:
  - {name: a, model: agv, start: [-4, 0], goal: [4, 0]}
  - {name: b, model: agv, start: [4, 0], goal: [-4, 0]}
  - {name: c, model: cart, start: [0, -2, 0], goal: [1, -2, 1.5]}
)",
                                         "small.yaml", {});
  for (const Diagnostic& fault : result.faults) ADD_FAILURE() << to_string(fault);
  return result.scene;
}

double random_number(RandomStream& random, double least, double most) {
  switch (random.below(8)) {
    case 0:
      return std::clamp(0.0, least, most);
    case 1:
      return least <= 0 && most >= 0 ? -0.0 : least;
    case 2:
      return std::clamp(std::numeric_limits<double>::denorm_min(), least, most);
    case 3:
      return most;
    default:
      return random.uniform(least, most);
  }
}

Trajectory random_path(RandomStream& random, std::size_t dof, double from, std::size_t waypoints) {
  Trajectory path(dof);
  for (std::size_t i = 0; i < waypoints; ++i) {
    Configuration q;
    for (std::size_t k = 0; k < dof; ++k) q.push_back(random_number(random, -50, 50));
    path.append(from, q);
    from += random.uniform(1e-9, 3);
  }
  return path;
}

Subproblem random_subproblem(RandomStream& random, const Scene& scene) {
  Subproblem out;
  out.seed = random.next();
  out.from = random_number(random, 0, 100);
  out.to = out.from + random.uniform(0, 50);
  out.horizon = random.below(3) == 0 ? kInfinity : out.to + random.uniform();
  out.clear_until = random.below(2) == 0 ? kInfinity : out.to;
  out.whole = random.below(2) == 0;
  for (std::uint32_t id = 0; id < scene.robots.size(); ++id) {
    const std::size_t dof = scene.robot({id}).model->dof();
    const std::uint64_t version = random.next();
    const std::size_t waypoints = 1 + random.below(5);
    const std::size_t choice = random.below(3);
    if (choice == 0) {
      const double until = random.below(2) == 0 ? kInfinity : out.to;
      out.outsiders.push_back(
          {{id}, version, random_path(random, dof, out.from, waypoints), until});
    } else if (choice == 1 || out.tasks.empty()) {
      const Region whole = whole_region(scene, {id});
      Task task{{id},
                version,
                random_configuration(random, whole),
                out.to,
                random_configuration(random, whole),
                whole,
                random_path(random, dof, out.from, waypoints),
                random_path(random, dof, out.to, waypoints),
                static_cast<int>(random.below(6)) - 1};
      out.tasks.push_back(std::move(task));
    }
  }
  if (out.tasks.empty()) return random_subproblem(random, scene);
  out.limits = {random.below(1000), random.below(1000),   1 + random.below(9),   random.below(1000),
                random.below(1000), 1 + random.below(99), 1 + random.below(1000)};
  return out;
}

Resolution random_resolution(RandomStream& random, const Subproblem& subproblem) {
  Resolution out;
  out.solved = random.below(2) == 0;
  out.solver = "prioritized-query";
  out.roadmap_level = static_cast<int>(random.below(6)) - 1;
  out.effort = {random.next(), random.next(), 0, random.below(9), random.next()};
  out.end = random_number(random, 0, 1000);
  for (const Task& task : subproblem.tasks) {
    out.paths.push_back(
        random_path(random, task.start.size(), subproblem.from, 1 + random.below(4)));
    if (!out.solved && random.below(2) == 0) out.left.push_back(task.robot);
  }
  if (!out.solved && out.left.empty()) out.paths.clear();
  return out;
}

PlanRequest random_request(RandomStream& random) {
  const auto bytes = [&](std::size_t most) {
    std::string out(random.below(most), '\0');
    for (char& c : out) c = static_cast<char>(random.next());
    return out;
  };
  const auto numbers = [&]() -> std::optional<Configuration> {
    if (random.below(3) == 0) return std::nullopt;
    Configuration q;
    for (std::size_t k = 1 + random.below(7); k > 0; --k) {
      q.push_back(random_number(random, -100, 100));
    }
    return q;
  };
  PlanRequest out;
  out.id = "order:" + std::to_string(random.next());
  out.scene_text = bytes(300);
  out.scene_name = random.below(2) == 0 ? "" : "depot";
  for (std::size_t i = random.below(4); i > 0; --i) {
    out.attachments.push_back({"meshes/m" + std::to_string(i) + ".stl", bytes(200)});
  }
  for (std::size_t i = random.below(5); i > 0; --i) {
    out.queries.push_back({"agv" + std::to_string(i), numbers(), numbers()});
  }
  out.method = random.below(2) == 0 ? "arc" : "cbs-mp";
  out.seed = random.next();
  for (std::size_t i = random.below(4); i > 0; --i) {
    out.solvers.push_back("solver" + std::to_string(i));
  }
  out.deadline = random_number(random, 0, 1e7);
  out.priority = static_cast<std::int32_t>(random.next());
  return out;
}

}  // namespace accord::wire_samples
