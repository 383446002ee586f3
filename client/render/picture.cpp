#include "client/render/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "client/render/camera.h"
#include "client/render/drawn_robot.h"
#include "client/render/labels.h"
#include "client/render/outline.h"
#include "client/render/palette.h"
#include "client/render/svg.h"

namespace accord {
namespace {

constexpr double kWidth = 880;  // pixels, of the whole picture
constexpr double kPadding = 24;
constexpr double kTitleHeight = 40;
constexpr std::size_t kMaxNamed = 40;   // robots; with more, names would only clutter
constexpr std::size_t kMaxGhosts = 24;  // robots whose poses along the way are shown
constexpr std::size_t kMaxEdged = 50;   // robots whose goals are set off from what is below
constexpr const char* kDarkName =
    "fill=\"#1f2430\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";
constexpr double kNameRoom = 0.76;  // of a disc, for its name between the outlines of goals
constexpr int kGhosts = 6;          // poses of each

class Picture {
 public:
  Picture(const Scene& scene, const Plan* plan)
      : scene_(scene),
        plan_(plan),
        robots_(drawn_robots(scene, plan)),
        cameras_(
            lay_out(scene, robots_, {kPadding, kPadding + kTitleHeight}, kWidth - 2 * kPadding)),
        svg_(kWidth, height()) {}

  std::string str() {
    svg_.rectangle(Vec2::Zero(), {kWidth, height()}, "fill=\"#fff\"");
    draw_title();
    for (std::size_t i = 0; i < cameras_.size(); ++i) draw_panel(cameras_[i], i);
    return svg_.str();
  }

 private:
  double height() const {
    const Camera& last = cameras_.back();
    return std::ceil(last.corner.y() + last.size().y() + kPadding);
  }

  void draw_title() {
    svg_.text({kPadding, kPadding + 14}, scene_.name,
              "font-size=\"17\" font-weight=\"600\" fill=\"#1f2430\"");
    std::string facts =
        fmt::format("{} robot{}", scene_.robots.size(), scene_.robots.size() == 1 ? "" : "s");
    if (plan_ != nullptr && plan_->status == PlanStatus::kSolved) {
      facts += fmt::format(" · makespan {:.1f} s · sum of costs {:.1f} s", plan_->makespan,
                           plan_->sum_of_costs);
    }
    svg_.text({kPadding, kPadding + 31}, facts, "font-size=\"12\" fill=\"#69707f\"");
    const double right = kWidth - kPadding;
    svg_.text({right, kPadding + 31},
              plan_ != nullptr ? "filled: start, outlined: goal, line: path"
                               : "filled: start, outlined: goal",
              "font-size=\"12\" fill=\"#69707f\" text-anchor=\"end\"");
  }

  void draw_panel(const Camera& camera, std::size_t index) {
    const std::string corners =
        fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}Z", camera.corner.x(), camera.corner.y(),
                    camera.size().x(), camera.size().y(), -camera.size().x());
    svg_.define_clip(fmt::format("panel{}", index), corners);
    svg_.rectangle(camera.corner, camera.size(), "fill=\"#f6f7f9\"");
    svg_.open(fmt::format("clip-path=\"url(#panel{})\"", index));
    draw_obstacles(camera);
    for (const DrawnRobot& drawn : robots_) draw_way(camera, drawn);
    if (robots_.size() <= kMaxGhosts) {
      for (const DrawnRobot& drawn : robots_) draw_ghosts(camera, drawn);
    }
    for (const DrawnRobot& drawn : robots_) draw_goal_area(camera, drawn);
    for (const DrawnRobot& drawn : robots_) draw_start(camera, drawn);
    // Where robots change places, every goal is below another one's start.
    for (const DrawnRobot& drawn : robots_) draw_goal(camera, drawn);
    if (robots_.size() <= kMaxNamed) draw_names(camera);
    svg_.close();
    svg_.rectangle(camera.corner, camera.size(),
                   scene_.bounds ? "fill=\"none\" stroke=\"#3a4252\" stroke-width=\"1.5\""
                                 : "fill=\"none\" stroke=\"#d5d9e0\"");
    if (cameras_.size() > 1) {
      svg_.text(camera.corner + Vec2(8, 17),
                camera.view == View::kTop ? "from above" : "from the side",
                "font-size=\"11\" fill=\"#69707f\"");
    }
  }

  void add(const Camera& camera, const Outline& outline, std::string& polygons) {
    if (outline.radius > 0) {
      svg_.circle(camera.pixels(outline.points.front()), outline.radius * camera.scale);
    } else {
      polygons += line_data(camera.pixels(outline.points), true);
    }
  }

  void draw_obstacles(const Camera& camera) {
    svg_.open(scene_.planar ? "fill=\"#596377\"" : "fill=\"#596377\" fill-opacity=\"0.55\"");
    std::string polygons;
    for (const Obstacle& obstacle : scene_.obstacles) {
      add(camera, outline(obstacle.shape, obstacle.pose, camera.view, scene_.planar), polygons);
    }
    svg_.path(polygons);
    svg_.close();
  }

  void draw_way(const Camera& camera, const DrawnRobot& drawn) {
    if (drawn.path == nullptr) return;
    std::vector<Vec2> flat;
    for (const Vec3& point : traced_way(drawn)) {
      flat.push_back(camera.pixels(projected(camera.view, point)));
    }
    const double width = robots_.size() > 200 ? 0.8 : robots_.size() > 50 ? 1.3 : 2;
    svg_.path(line_data(flat, false),
              fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
                          "stroke-linejoin=\"round\" stroke-linecap=\"round\" "
                          "stroke-opacity=\"0.75\"",
                          drawn.colour, width));
  }

  void draw_robot(const Camera& camera, const DrawnRobot& drawn, ConfigurationView q,
                  std::string_view attributes) {
    svg_.open(attributes);
    std::string polygons;
    for (const Outline& o : robot_outlines(drawn.robot, q, camera.view, scene_.planar)) {
      add(camera, o, polygons);
    }
    svg_.path(polygons);
    svg_.close();
  }

  // Discs and balls look the same everywhere: their path says it all.
  void draw_ghosts(const Camera& camera, const DrawnRobot& drawn) {
    const RobotKind kind = drawn.robot.model->kind;
    if (drawn.path == nullptr || kind == RobotKind::kDisk || kind == RobotKind::kBall) return;
    const std::string attributes = fmt::format(
        "fill=\"{0}\" fill-opacity=\"0.1\" stroke=\"{0}\" stroke-opacity=\"0.25\" "
        "stroke-width=\"0.7\"",
        drawn.colour);
    const double arrival = drawn.path->arrival_time();
    for (int i = 1; i <= kGhosts && arrival > 0; ++i) {
      draw_robot(camera, drawn, drawn.path->at(arrival * i / (kGhosts + 1)), attributes);
    }
  }

  void draw_goal_area(const Camera& camera, const DrawnRobot& drawn) {
    draw_robot(camera, drawn, drawn.robot.goal, "fill=\"#fff\" fill-opacity=\"0.55\"");
  }

  // With a white edge that sets it off from whatever is below it; crowds have no room for one.
  void draw_goal(const Camera& camera, const DrawnRobot& drawn) {
    const bool crowded = robots_.size() > kMaxEdged;
    const auto outlined = [&](std::string_view colour, double width) {
      draw_robot(camera, drawn, drawn.robot.goal,
                 fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"", colour, width));
    };
    if (!crowded) outlined("#fff", 4.4);
    outlined(drawn.colour, robots_.size() > 200 ? 0.7 : crowded ? 1.3 : 2);
  }

  void draw_start(const Camera& camera, const DrawnRobot& drawn) {
    draw_robot(camera, drawn, drawn.robot.start,
               fmt::format("fill=\"{}\" fill-opacity=\"0.88\" stroke=\"#fff\" "
                           "stroke-opacity=\"0.8\" stroke-width=\"{}\"",
                           drawn.colour, robots_.size() > 200 ? 0.3 : 0.8));
  }

  // The last robots first: they are drawn on top of the others.
  void draw_names(const Camera& camera) {
    svg_.open("text-anchor=\"middle\" font-weight=\"600\"");
    Labels labels(svg_);
    for (auto drawn = robots_.rbegin(); drawn != robots_.rend(); ++drawn) {
      draw_name(camera, drawn->robot, labels);
    }
    svg_.close();
  }

  // Inside discs and balls that are large enough for it, on carts, and below arms' bases.
  void draw_name(const Camera& camera, const Robot& robot, Labels& labels) {
    const Vec2 centre = camera.pixels(projected(camera.view, standing_point(robot, robot.start)));
    if (robot.model->kind == RobotKind::kArm) {
      labels.write(centre + Vec2(0, 16), robot.name, 11, kDarkName);
    } else if (robot.model->kind == RobotKind::kFootprint) {
      labels.write(centre, robot.name, 11, kDarkName);
    } else {
      const double radius =
          robot_outlines(robot, robot.start, camera.view, scene_.planar).front().radius;
      const double room = 2 * radius * camera.scale * kNameRoom;
      const double size = std::min(12.0, Labels::size_for(robot.name, room));
      if (size >= 6) labels.write(centre, robot.name, size, "fill=\"#fff\"");
    }
  }

  const Scene& scene_;
  const Plan* plan_;
  std::vector<DrawnRobot> robots_;
  std::vector<Camera> cameras_;
  Svg svg_;
};

}  // namespace

std::string draw(const Scene& scene, const Plan* plan) {
  return Picture(scene, plan).str();
}

}  // namespace accord
