#include "common/io/kinematic_tree.h"

#include "common/io/words.h"

namespace accord {

std::optional<KinematicTree> arrange_tree(const std::vector<std::string>& links,
                                          const std::vector<Joint>& joints,
                                          const std::vector<Place>& joint_places,
                                          const std::string& file, Faults& faults) {
  const auto name = [&](int link) { return in_quotes(links[static_cast<std::size_t>(link)]); };
  std::vector<int> parent_joint(links.size(), -1);
  bool sound = true;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    int& joint = parent_joint[static_cast<std::size_t>(joints[i].child)];
    if (joint >= 0) {
      faults.add(joint_places[i], "the link " + name(joints[i].child) + " is the child of joint " +
                                      in_quotes(joints[static_cast<std::size_t>(joint)].name) +
                                      " already");
      sound = false;
    }
    joint = static_cast<int>(i);
  }
  std::vector<int> roots;
  for (int link = 0; link < static_cast<int>(links.size()); ++link) {
    if (parent_joint[static_cast<std::size_t>(link)] < 0) roots.push_back(link);
  }
  if (roots.empty()) {
    faults.add(file, 0, "robot", "the joints form a cycle: every link is the child of another");
  } else if (roots.size() > 1) {
    faults.add(file, 0, "robot", "the links form more than one tree: " + name(roots[0]) + " and " +
                                     name(roots[1]) + " are both without a parent");
  }
  if (!sound || roots.size() != 1) return std::nullopt;

  KinematicTree tree{{roots[0]}, {}};
  for (int link = 0; link < static_cast<int>(links.size()); ++link) {
    if (link != roots[0]) tree.links.push_back(link);
  }
  std::vector<int> reached{roots[0]};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].parent != reached[next]) continue;
      tree.joints.push_back(i);
      reached.push_back(joints[i].child);
    }
  }
  if (tree.joints.size() == joints.size()) return tree;
  faults.add(file, 0, "robot", "the joints form a cycle beside the tree of " + name(roots[0]));
  return std::nullopt;
}

}  // namespace accord
