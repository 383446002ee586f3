#include "common/transport/dds/fleet/plan_sender.h"

#include <algorithm>
#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/plan_pieces.h"

namespace accord::dds {
namespace {

constexpr std::size_t kWaitingBytes = 2 * kPlanWireBytes;
// So many pieces are written before those who listen are waited for: half of a history, so that
// what is overwritten has either been got by all or has been waited for.
constexpr std::size_t kAhead = kFleetTopic<PathPiece>.writer_depth / 2;
// ns, how long. Who takes longer misses pieces, and asks for them.
constexpr std::uint32_t kPatience = 100'000'000;
constexpr int kTries = 20;  // of one write, each of some milliseconds

std::size_t memory_of(const FinishedPlan& finished) {
  std::size_t bytes = 0;
  for (const RobotPlan& robot : finished.plan.robots) {
    bytes += robot.trajectory.size() * waypoint_bytes(robot.trajectory.dof());
    for (const PlanSegment& segment : robot.segments) {
      bytes += sizeof(segment) + segment.robots.size() * sizeof(std::string);
    }
  }
  return bytes;
}

template <typename Value>
void write_patiently(const Value& value, eprosima::fastdds::dds::DataWriter& writer) {
  for (int i = 0; i < kTries && !write(value, writer); ++i) {
  }
}

}  // namespace

PlanSender::PlanSender(eprosima::fastdds::dds::DataWriter& outlines,
                       eprosima::fastdds::dds::DataWriter& paths)
    : outlines_(outlines), paths_(paths), thread_([this] { run(); }) {}

PlanSender::~PlanSender() {
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
    if (std::ranges::find(waiting_, plan.id, &FinishedPlan::id) != waiting_.end()) return true;
    if (!waiting_.empty() && waiting_bytes_ + bytes > kWaitingBytes) return false;
    waiting_bytes_ += bytes;
    waiting_.push_back(std::move(plan));
  }
  wake_.notify_one();
  return true;
}

void PlanSender::run() {
  while (true) {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    const FinishedPlan plan = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= memory_of(plan);
    lock.unlock();
    send_now(plan);
  }
}

void PlanSender::send_now(const FinishedPlan& plan) {
  const PlanPieces pieces(plan);
  write_patiently(pieces.outline(), outlines_);
  for (std::size_t robot = 0; robot < plan.plan.robots.size(); ++robot) {
    for (const PathPiece& piece : pieces.of_robot(robot)) {
      if (ended_) return;
      write_patiently(piece, paths_);
      if (++ahead_ >= kAhead) let_them_catch_up();
    }
  }
}

void PlanSender::let_them_catch_up() {
  paths_.wait_for_acknowledgments({0, kPatience});
  ahead_ = 0;
}

}  // namespace accord::dds
