#include <utility>

#include "common/transport/dds/fleet/participant.h"
#include "common/transport/dds/fleet/waking_listener.h"
#include "common/transport/dds/signal.h"
#include "common/transport/fleet/fleet_limits.h"
#include "common/transport/fleet/robot_partition.h"
#include "common/transport/fleet/robot_port.h"

namespace accord {
namespace {

using namespace dds;
using eprosima::fastdds::dds::DataReader;

class DdsRobotPort final : public RobotPort {
 public:
  explicit DdsRobotPort(const std::string& robot) : assembly_(robot) {}

  std::optional<std::string> open(const DdsOptions& options, const std::string& robot) {
    auto participant = FleetParticipant::create(options, robot_partition(options.cluster, robot),
                                                kClientRole, nullptr, &refused_);
    if (!participant) return participant.error();
    participant_ = std::move(*participant);
    paths_ = participant_->add_robot_path_reader(&listener_);
    return paths_ == nullptr ? std::optional<std::string>("DDS refused a reader") : std::nullopt;
  }

 private:
  std::optional<RobotPath> take() override {
    while (auto piece = read<PathPiece>(*paths_)) {
      if (fleet_fault(*piece)) continue;
      if (auto path = assembly_.add(std::move(*piece))) return path;
    }
    return std::nullopt;
  }
  void wait(std::chrono::nanoseconds timeout) override { signal_.wait(timeout); }

  Signal signal_;
  WakingListener listener_{[this] { signal_.raise(); }};
  PathAssembly assembly_;
  std::uint64_t refused_ = 0;
  DataReader* paths_ = nullptr;
  // Last, so that its threads have ended before what they call goes.
  std::unique_ptr<FleetParticipant> participant_;
};

}  // namespace

tl::expected<std::unique_ptr<RobotPort>, std::string> make_dds_robot_port(
    const DdsOptions& options, const std::string& robot) {
  if (const auto fault = options_fault(options)) {
    return tl::unexpected(fault->option + ": " + fault->text);
  }
  if (!has_partition(robot)) {
    return tl::unexpected(
        std::string("robot: expected a name of at most 200 bytes without '*', '?', '[' and ']'"));
  }
  auto port = std::make_unique<DdsRobotPort>(robot);
  if (auto fault = port->open(options, robot)) return tl::unexpected(std::move(*fault));
  return port;
}

}  // namespace accord
