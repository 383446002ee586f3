#include "common/io/srdf.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "common/io/limits.h"
#include "common/io/words.h"
#include "common/io/xml_reader.h"

namespace accord {
namespace {

std::optional<int> link_of(const XmlElement& element, const char* attribute,
                           const RobotModel& model) {
  const auto name = element.name(attribute);
  if (!name) return std::nullopt;
  const auto found = std::ranges::find(model.links, *name);
  if (found != model.links.end()) return static_cast<int>(found - model.links.begin());
  const std::vector<std::string_view> known(model.links.begin(), model.links.end());
  element.fault("unknown link " + in_quotes(*name) + suggestion(*name, known));
  return std::nullopt;
}

}  // namespace

void apply_srdf(std::string_view text, const std::string& file, RobotModel& model, Faults& faults) {
  tinyxml2::XMLDocument document;
  if (!parse_xml(text, file, document, faults)) return;
  const tinyxml2::XMLElement* robot = document.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    faults.add(file, robot == nullptr ? 1 : robot->GetLineNum(), "",
               "expected an SRDF: the element <robot>");
    return;
  }
  const XmlElement root(*robot, "robot", file, faults);
  root.report_misspelt({"disable_collisions", "enable_collisions", "disable_default_collisions",
                        "group", "group_state", "end_effector", "virtual_joint", "passive_joint",
                        "link_sphere_approximation", "joint_property"});
  std::size_t pairs = 0;
  for (const auto* it = robot->FirstChildElement("disable_collisions");
       it != nullptr && !faults.full(); it = it->NextSiblingElement("disable_collisions")) {
    const XmlElement element = root.with_key(*it, "disable_collisions");
    if (++pairs > limits::kSrdfPairs) {
      return element.fault("more than " + std::to_string(limits::kSrdfPairs) + " pairs");
    }
    const auto first = link_of(element, "link1", model);
    const auto second = link_of(element, "link2", model);
    if (first && second && *first != *second) {
      model.may_touch.insert(std::minmax({*first, *second}));
    }
  }
}

}  // namespace accord
