// One function a concern, or a few that go together, each in a file of its own: adds findings.
#pragma once

#include <vector>

#include "client/doctor/finding.h"
#include "client/doctor/observations.h"

namespace accord {

void check_domain(const Observations& seen, std::vector<Finding>& out);         // and interface
void check_shared_memory(const Observations& seen, std::vector<Finding>& out);  // small, stale
void check_shared_ports(const Observations& seen, std::vector<Finding>& out);   // not shared, user
void check_socket_buffers(const Observations& seen, std::vector<Finding>& out);
void check_multicast(const Observations& seen, std::vector<Finding>& out);
void check_addresses(const Observations& seen, std::vector<Finding>& out);  // peers, servers
void check_transport(const Observations& seen, std::vector<Finding>& out);
void check_security(const Observations& seen, std::vector<Finding>& out);
void check_protocol(const Observations& seen, std::vector<Finding>& out);
void check_cluster(const Observations& seen, std::vector<Finding>& out);
void check_data(const Observations& seen, std::vector<Finding>& out);
void check_clocks(const Observations& seen, std::vector<Finding>& out);
void check_service(const Observations& seen, std::vector<Finding>& out);  // and workers

}  // namespace accord
