#include "client/watch/first_picture.h"

#include <optional>
#include <utility>

namespace accord {
namespace {

using namespace std::chrono_literals;

constexpr WatchTime kTurn = 50ms;
// From the first word of a service: requests that have ended come in this time, which nobody
// counts; and all that is counted comes again within 2 s, whatever got lost.
constexpr WatchTime kAtLeast = 250ms;
constexpr WatchTime kAtMost = 3s;

}  // namespace

WatchTime watch_now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

void take_all(FleetClientPort& port, WatchedFleet& fleet,
              const std::function<void(const WatchedFleet::Change&)>& on_change) {
  const auto tell = [&on_change](const std::optional<WatchedFleet::Change>& change) {
    if (change && on_change) on_change(*change);
  };
  while (auto news = port.take()) tell(fleet.take(std::move(*news), watch_now()));
  tell(fleet.set_present(port.has_service(), watch_now()));
  fleet.forget(watch_now());
}

bool listen_for_first_picture(FleetClientPort& port, WatchedFleet& fleet,
                              std::chrono::nanoseconds patience, const std::atomic<bool>& stop,
                              const std::function<void()>& on_turn) {
  const WatchTime begin = watch_now();
  std::optional<WatchTime> heard;
  while (!stop) {
    port.wait(kTurn);
    take_all(port, fleet);
    if (on_turn) on_turn();
    const WatchTime now = watch_now();
    if (!heard && fleet.service()) heard = now;
    if (!heard && now - begin > patience) return false;
    if (!heard || now - *heard < kAtLeast) continue;
    if (fleet.is_complete() || now - *heard > kAtMost) return true;
  }
  return false;
}

}  // namespace accord
