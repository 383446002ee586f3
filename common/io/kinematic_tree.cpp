#include "common/io/kinematic_tree.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

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
    faults.add(joint_places[i],
               "part of a cycle of joints that does not hang on the root " + name(roots[0]));
  }
  return std::nullopt;
}

void allow_neighbours(RobotModel& model) {
  // The rigid group of each link: joints come parents first, so one pass is enough.
  std::vector<int> group(model.links.size());
  std::iota(group.begin(), group.end(), 0);
  const auto group_of = [&](int link) { return group[static_cast<std::size_t>(link)]; };
  for (const Joint& joint : model.joints) {
    if (joint.type == JointType::kFixed) {
      group[static_cast<std::size_t>(joint.child)] = group_of(joint.parent);
    }
  }
  std::set<std::pair<int, int>> joined;
  for (const Joint& joint : model.joints) {
    joined.insert(std::minmax({group_of(joint.parent), group_of(joint.child)}));
  }
  const int count = static_cast<int>(model.links.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      const auto pair = std::minmax({group_of(a), group_of(b)});
      if (pair.first == pair.second || joined.contains(pair)) model.may_touch.insert({a, b});
    }
  }
}

}  // namespace accord
