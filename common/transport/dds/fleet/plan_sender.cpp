#include "common/transport/dds/fleet/plan_sender.h"

#include <algorithm>
#include <utility>

#include "common/transport/dds/fleet/patient_write.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/plan_pieces.h"

namespace accord::dds {
namespace {

constexpr std::size_t kWaitingBytes = 2 * kPlanWireBytes;
// So many pieces are written before those who listen are waited for: half of a history, so that
// what is overwritten has either been got by all or has been waited for.
constexpr std::size_t kAhead = kFleetTopic<PathPiece>.writer_depth / 2;
}  // namespace

PlanSender::PlanSender(const std::string& cluster, const RosOptions& ros,
                       eprosima::fastdds::dds::DataWriter& outlines,
                       eprosima::fastdds::dds::DataWriter& paths, RobotReaders& robots,
                       FleetTraffic& traffic)
    : outlines_(outlines),
      paths_(paths),
      robots_(robots),
      traffic_(traffic),
      robot_writers_(cluster, paths, traffic),
      ros_(participant_of(paths), ros),
      latest_(kWaitingBytes),
      thread_([this] { run(); }) {
  robots_.set_listener([this] { robots_changed(); });
  robots_changed();  // those that were found before
}

PlanSender::~PlanSender() {
  robots_.set_listener({});
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

bool PlanSender::send(FinishedPlan plan) {
  const std::size_t bytes = memory_of(plan);
  {
    const std::scoped_lock lock(mutex_);
    const auto is_same = [&](const Waiting& other) { return other.plan->id == plan.id; };
    if (std::ranges::any_of(waiting_, is_same)) return true;
    if (!waiting_.empty() && waiting_bytes_ + bytes > kWaitingBytes) return false;
    waiting_bytes_ += bytes;
    auto scene = std::exchange(plan.scene, nullptr);
    waiting_.push_back({std::make_shared<const FinishedPlan>(std::move(plan)), std::move(scene)});
  }
  wake_.notify_one();
  return true;
}

void PlanSender::robots_changed() {
  {
    const std::scoped_lock lock(mutex_);
    are_robots_changed_ = true;
  }
  wake_.notify_one();
}

void PlanSender::run() {
  while (true) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return ended_ || are_robots_changed_ || !waiting_.empty(); });
    if (ended_) return;
    // A plan finds the writers that there are to be.
    if (std::exchange(are_robots_changed_, false)) {
      lock.unlock();
      look_after_robots();
      continue;
    }
    const auto [plan, scene] = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= memory_of(*plan);
    lock.unlock();
    latest_.add(plan);
    send_now(*plan);
    if (!ended_ && scene != nullptr) ros_.publish(plan->plan, *scene);
  }
}

void PlanSender::look_after_robots() {
  for (const std::string& robot : robot_writers_.keep(robots_.robots())) {
    const auto [plan, place] = latest_.of(robot);
    if (plan == nullptr) continue;
    for (const PathPiece& piece : PlanPieces(*plan).of_robot(place)) robot_writers_.write(piece);
  }
}

void PlanSender::send_now(const FinishedPlan& plan) {
  const PlanPieces pieces(plan);
  write_patiently(pieces.outline(), outlines_, traffic_);
  for (std::size_t robot = 0; robot < plan.plan.robots.size(); ++robot) {
    for (const PathPiece& piece : pieces.of_robot(robot)) {
      if (ended_) return;
      robot_writers_.write(piece);
      write_patiently(piece, paths_, traffic_);
      if (++ahead_ >= kAhead) let_them_catch_up();
    }
  }
}

void PlanSender::let_them_catch_up() {
  paths_.wait_for_acknowledgments(kPatience);
  ahead_ = 0;
}

}  // namespace accord::dds
