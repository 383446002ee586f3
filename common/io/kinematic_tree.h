// Whether links and joints form one tree, the order of its parts, and who are neighbours in it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/io/diagnostic.h"
#include "common/model/robot.h"

namespace accord {

struct KinematicTree {
  std::vector<int> links;           // indices as given: the root, then the rest as given
  std::vector<std::size_t> joints;  // indices as given, parents before children
};

// Reports links with two parents, several roots, and cycles. Requires: parents and children are
// indices of links; there is at least one link.
std::optional<KinematicTree> arrange_tree(const std::vector<std::string>& links,
                                          const std::vector<Place>& link_places,
                                          const std::vector<Joint>& joints,
                                          const std::vector<Place>& joint_places, Faults& faults);

// Adds to may_touch the pairs of links that touch by construction: on one rigid group, or on two
// that a movable joint joins. Requires: joints parents first.
void allow_neighbours(RobotModel& model);

}  // namespace accord
