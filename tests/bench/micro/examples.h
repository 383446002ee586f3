// The example scenes of scenes/, and plans of them, for benchmarks.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "client/engine/planner.h"
#include "common/io/scene_file.h"

namespace accord::micro {

inline std::filesystem::path example_path(const std::string& name) {
  return std::filesystem::path(ACCORD_SOURCE_DIR) / "scenes" / (name + ".yaml");
}

// Ends the program where the scene cannot be read: nothing could be measured.
inline std::shared_ptr<const Scene> example(const std::string& name) {
  SceneResult result = load_scene(example_path(name));
  if (!result.scene) {
    std::cerr << example_path(name) << ": not a scene\n";
    std::exit(1);
  }
  return result.scene;
}

inline Plan example_plan(const std::shared_ptr<const Scene>& scene) {
  return plan(scene, {});
}

}  // namespace accord::micro
