// Whether somebody wants certificates, which Accord's processes do not have.
#include <fmt/format.h>

#include "client/doctor/checks/checks.h"
#include "client/doctor/checks/peers.h"

namespace accord {

void check_security(const Observations& seen, std::vector<Finding>& out) {
  if (!seen.as_told.join_fault.empty()) return;
  const Peers closed = members_with(seen, Silence::kSecurity);
  if (closed.empty()) {
    out.push_back(fine(Concern::kSecurity, "nobody of the cluster asks for a certificate"));
    return;
  }
  out.push_back(
      {Severity::kFault,
       Concern::kSecurity,
       "shows a certificate, and answers nobody who has none: " + names_of(closed),
       "A participant with DDS security speaks with those whose certificate it can "
       "check; this one has none.",
       {"unset FASTRTPS_DEFAULT_PROFILES_FILE    # for that process, where a profile "
        "switches security on",
        "accord doctor --domain N    # where secured and open processes are kept apart"}});
}

}  // namespace accord
