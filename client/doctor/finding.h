// What `accord doctor` has to say of one concern.
#pragma once

#include <string>
#include <vector>

namespace accord {

enum class Severity {
  kFine,     // looked at, and in order
  kWarning,  // stops nothing, but costs time, or will stop something
  kFault,    // stops data, or plans
};
const char* name_of(Severity severity);

// What is looked at. Their names are for scripts and docs/operations.md, and stay.
enum class Concern {
  kDomain,
  kInterface,
  kShmSmall,
  kShmStale,
  kShmNotShared,
  kShmOtherUser,
  kSocketBuffers,
  kMulticast,
  kPeerUnreachable,
  kServerUnreachable,
  kTransport,
  kSecurity,
  kOtherProtocol,
  kCluster,
  kNoData,
  kClockSkew,
  kService,
  kWorkers,
};
const char* name_of(Concern concern);

struct Finding {
  Severity severity = Severity::kFine;
  Concern concern = Concern::kDomain;
  std::string seen;      // with numbers; may quote what came over the network, as it came
  std::string why = {};  // why it matters; empty where it is fine
  std::vector<std::string> mend = {};  // commands, or flags of Accord's programs; any of them
};

inline Finding fine(Concern concern, std::string seen) {
  return {Severity::kFine, concern, std::move(seen)};
}

}  // namespace accord
