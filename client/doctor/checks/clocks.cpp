// Whether the machines' clocks agree.
#include <fmt/format.h>

#include <cmath>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {
namespace {

constexpr double kTolerance = 0.1;  // s; a message is seldom on its way for longer

std::string with_clock(const SeenParticipant& peer) {
  const double ahead = peer.clock_ahead.value_or(0);
  return fmt::format("{} is {:.3f} s {}", name_of(peer), std::abs(ahead),
                     ahead > 0 ? "ahead" : "behind");
}

}  // namespace

void check_clocks(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  Peers timed = members(seen, seen.as_told.survey);
  std::erase_if(timed, [](const SeenParticipant* peer) { return !peer->clock_ahead; });
  if (timed.empty()) return;  // nothing came that would tell
  Peers skewed = timed;
  std::erase_if(skewed, [](const SeenParticipant* peer) {
    return std::abs(peer->clock_ahead.value_or(0)) <= kTolerance;
  });
  if (skewed.empty()) {
    out.push_back(
        fine(Concern::kClockSkew,
             fmt::format("{} clocks are within {} s of this machine's", timed.size(), kTolerance)));
    return;
  }
  out.push_back({Severity::kWarning,
                 Concern::kClockSkew,
                 "clocks that differ from this machine's: " + names_of(skewed, with_clock),
                 "Planning does not depend on clocks, but robots that are to begin a plan at one "
                 "instant do: they would be where they were proved to be at other times. Logs of "
                 "different hosts do not line up either.",
                 {"timedatectl set-ntp true    # on every host",
                  "chronyc tracking    # how far a host's clock is off, where chrony runs"}});
}

}  // namespace accord
