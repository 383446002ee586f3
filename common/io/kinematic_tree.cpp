#include "common/io/kinematic_tree.h"

#include <algorithm>

#include "common/io/words.h"

namespace accord {

std::optional<KinematicTree> arrange_tree(const std::vector<std::string>& links,
                                          const std::vector<Place>& link_places,
                                          const std::vector<Joint>& joints,
                                          const std::vector<Place>& joint_places, Faults& faults) {
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
    faults.add(link_places[0], "the joints form a cycle: every link is the child of another");
  }
  for (std::size_t i = 1; i < roots.size(); ++i) {
    faults.add(link_places[static_cast<std::size_t>(roots[i])],
               "no joint leads here from " + name(roots[0]) + "; expected one tree of links");
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
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (std::ranges::find(tree.joints, i) != tree.joints.end()) continue;
    faults.add(joint_places[i], "part of a cycle of joints that does not hang on the root " +
                                    name(roots[0]));
  }
  return std::nullopt;
}

}  // namespace accord
