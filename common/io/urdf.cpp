#include "common/io/urdf.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "common/io/kinematic_tree.h"
#include "common/io/limits.h"
#include "common/io/urdf_shapes.h"
#include "common/io/words.h"
#include "common/io/xml_reader.h"

namespace accord {
namespace {

constexpr Range kVelocity{limits::kMinRate, limits::kRate, ""};

class UrdfParser {
 public:
  UrdfParser(const std::filesystem::path& path, MeshStore& meshes, Faults& faults)
      : file_(path.string()), folder_(path.parent_path()), meshes_(meshes), faults_(faults) {}

  std::optional<UrdfModel> parse(std::string_view text) {
    const std::size_t before = faults_.count();
    tinyxml2::XMLDocument document;
    if (!parse_xml(text, file_, document, faults_)) return std::nullopt;
    const tinyxml2::XMLElement* robot = document.RootElement();
    if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
      faults_.add(file_, robot == nullptr ? 1 : robot->GetLineNum(), "",
                  "expected a URDF: the element <robot>");
      return std::nullopt;
    }
    const XmlElement root(*robot, "robot", file_, faults_);
    root.report_misspelt({"link", "joint", "material", "transmission", "gazebo"});
    read_links(root);
    read_joints(root);
    if (faults_.count() == before) arrange();
    if (faults_.count() == before) check_use(root);
    if (faults_.count() != before) return std::nullopt;
    out_.model.kind = RobotKind::kArm;
    return std::move(out_);
  }

 private:
  void read_links(const XmlElement& root) {
    for (const auto* it = root.raw().FirstChildElement("link"); it != nullptr && !faults_.full();
         it = it->NextSiblingElement("link")) {
      const auto name = root.with_key(*it, "link").name("name");
      if (!name) continue;
      const XmlElement link = root.with_key(*it, "link[" + *name + "]");
      if (links_.size() >= limits::kLinks) {
        return link.fault("more than " + std::to_string(limits::kLinks) + " links");
      }
      if (!link_index_.emplace(*name, static_cast<int>(links_.size())).second) {
        link.fault("another link has this name");
        continue;
      }
      link.report_misspelt({"inertial", "visual", "collision"});
      links_.push_back(*name);
      link_places_.push_back(link.place());
      read_bodies(link, *name);
    }
    if (links_.empty() && !faults_.full()) root.fault("expected at least one link");
  }

  void read_bodies(const XmlElement& link, const std::string& name) {
    int number = 0;
    for (const auto* it = link.raw().FirstChildElement("collision");
         it != nullptr && !faults_.full(); it = it->NextSiblingElement("collision")) {
      const XmlElement body =
          link.with_key(*it, link.key() + ".collision[" + std::to_string(number++) + "]");
      if (out_.model.bodies.size() >= limits::kBodies) {
        return body.fault("more than " + std::to_string(limits::kBodies) + " collision shapes");
      }
      body.report_misspelt({"origin", "geometry"});
      const Pose pose = read_origin(body);
      const auto geometry = body.required_child("geometry");
      auto shape = geometry ? read_urdf_shape(*geometry, folder_, meshes_, faults_) : std::nullopt;
      if (!shape) continue;
      out_.model.bodies.push_back(
          {name, static_cast<int>(links_.size()) - 1, std::move(*shape), pose});
      out_.body_places.push_back(body.place());
    }
  }

  void read_joints(const XmlElement& root) {
    for (const auto* it = root.raw().FirstChildElement("joint"); it != nullptr && !faults_.full();
         it = it->NextSiblingElement("joint")) {
      const auto name = root.with_key(*it, "joint").name("name");
      if (!name) continue;
      const XmlElement joint = root.with_key(*it, "joint[" + *name + "]");
      if (joints_.size() >= limits::kLinks) {
        return joint.fault("more than " + std::to_string(limits::kLinks) + " joints");
      }
      if (!joint_names_.insert(*name).second) {
        joint.fault("another joint has this name");
        continue;
      }
      read_joint(joint, *name);
    }
  }

  void read_joint(const XmlElement& element, const std::string& name) {
    element.report_misspelt({"origin", "parent", "child", "axis", "limit", "calibration",
                             "dynamics", "mimic", "safety_controller"});
    Joint joint{.name = name,
                .type = JointType::kFixed,
                .parent = link_of(element, "parent"),
                .child = link_of(element, "child"),
                .origin = read_origin(element),
                .axis = Vec3::UnitX(),
                .dof = -1};
    if (const auto mimic = element.child("mimic")) {
      mimic->fault("joints that mimic another are not supported; make it fixed or free");
    }
    const auto type = element.name("type");
    if (type && *type != "fixed") {
      joint.dof = static_cast<int>(out_.model.dofs.size());
      joint.type = *type == "prismatic" ? JointType::kPrismatic : JointType::kRevolute;
      joint.axis = read_axis(element);
      out_.model.dofs.push_back(read_dof(element, name, *type));
    }
    joints_.push_back(joint);
    joint_places_.push_back(element.place());
  }

  int link_of(const XmlElement& joint, const char* role) {
    const auto element = joint.required_child(role);
    const auto name = element ? element->name("link") : std::nullopt;
    if (!name) return -1;
    const auto found = link_index_.find(*name);
    if (found != link_index_.end()) return found->second;
    std::vector<std::string_view> known(links_.begin(), links_.end());
    element->fault("unknown link " + in_quotes(*name) + suggestion(*name, known));
    return -1;
  }

  static Vec3 read_axis(const XmlElement& joint) {
    const auto element = joint.child("axis");
    const auto axis =
        element ? element->vector("xyz", {-1e6, 1e6, ""}) : std::optional<Vec3>(Vec3::UnitX());
    if (axis && axis->norm() < 1e-6) element->fault("expected a direction, not zero");
    return axis && axis->norm() >= 1e-6 ? axis->normalized() : Vec3::UnitX();
  }

  static DegreeOfFreedom read_dof(const XmlElement& joint, const std::string& name,
                                  const std::string& type) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    DegreeOfFreedom dof{name, -kInfinity, kInfinity, 1, type == "continuous"};
    if (type != "revolute" && type != "continuous" && type != "prismatic") {
      joint.fault("joints of type " + in_quotes(type) +
                  " are not supported; expected fixed, revolute, continuous or prismatic");
      return dof;
    }
    const auto limit = joint.required_child("limit");
    if (!limit) return dof;
    dof.velocity = limit->number("velocity", kVelocity).value_or(1);
    if (dof.wraps) return dof;
    const Range range = type == "prismatic" ? kCoordinateRange : kAngleRange;
    dof.lower = limit->number("lower", range).value_or(-kInfinity);
    dof.upper = limit->number("upper", range).value_or(kInfinity);
    if (dof.lower > dof.upper) {
      limit->fault("lower, " + in_words(dof.lower) + ", must not be above upper, " +
                   in_words(dof.upper));
    }
    return dof;
  }

  // Brings links and joints into the model's order; reports what is no tree.
  void arrange() {
    const auto tree = arrange_tree(links_, link_places_, joints_, joint_places_, faults_);
    if (!tree) return;
    for (const int link : tree->links) {
      out_.model.links.push_back(links_[static_cast<std::size_t>(link)]);
    }
    std::vector<int> index_of(links_.size());
    for (std::size_t i = 0; i < tree->links.size(); ++i) {
      index_of[static_cast<std::size_t>(tree->links[i])] = static_cast<int>(i);
    }
    for (const std::size_t i : tree->joints) {
      Joint joint = joints_[i];
      joint.parent = index_of[static_cast<std::size_t>(joint.parent)];
      joint.child = index_of[static_cast<std::size_t>(joint.child)];
      out_.model.joints.push_back(joint);
      out_.joint_places.push_back(joint_places_[i]);
    }
    for (Body& body : out_.model.bodies) body.link = index_of[static_cast<std::size_t>(body.link)];
    allow_neighbours(out_.model);
  }

  void check_use(const XmlElement& root) const {
    if (out_.model.dofs.empty()) {
      root.fault("no movable joint; what cannot move is an obstacle");
    }
    if (out_.model.bodies.empty()) {
      root.fault("no <collision> shape; an arm without a body cannot be kept from colliding");
    }
  }

  const std::string file_;
  const std::filesystem::path folder_;
  MeshStore& meshes_;
  Faults& faults_;
  UrdfModel out_;
  std::vector<std::string> links_;
  std::vector<Place> link_places_;
  std::unordered_map<std::string, int> link_index_;
  std::vector<Joint> joints_;
  std::vector<Place> joint_places_;
  std::unordered_set<std::string> joint_names_;
};

}  // namespace

std::optional<UrdfModel> parse_urdf(std::string_view text, const std::filesystem::path& path,
                                    MeshStore& meshes, Faults& faults) {
  return UrdfParser(path, meshes, faults).parse(text);
}

}  // namespace accord
