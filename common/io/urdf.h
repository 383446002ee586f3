// Arms from URDF: what of it decides where bodies are and may go. Read with tinyxml2 rather than
// urdfdom, which loses the order of joints and all positions, and knows no capsules.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/io/mesh.h"
#include "common/model/robot.h"

namespace accord {

// A model, and who to blame for its parts.
struct UrdfModel {
  RobotModel model;
  std::vector<Place> joint_places;  // of model.joints
  std::vector<Place> body_places;   // of model.bodies
};

// Reads links, joints and <collision> shapes: box, cylinder, sphere, capsule (radius; length of
// the part between the half spheres), mesh. Joints: fixed, revolute, continuous, prismatic. Links
// form one tree. What else URDF may hold is passed over. Meshes named by package://name/path are
// looked for as path in the URDF's folder and the one above. Reports every fault with its line in
// this file; nullopt then. may_touch holds what follows from the joints; see srdf.h for the rest.
std::optional<UrdfModel> parse_urdf(std::string_view text, const std::filesystem::path& path,
                                    MeshStore& meshes, Faults& faults);

}  // namespace accord
