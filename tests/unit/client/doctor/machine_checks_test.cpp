#include "tests/unit/client/doctor/healthy.h"

namespace accord::testing {
namespace {

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

TEST(Diagnosis, OfWhatIsWellHasNothingButFineLines) {
  EXPECT_EQ(complaints(healthy()), Complaints{});
  EXPECT_GE(diagnose(healthy()).size(), 12U);
}

TEST(Diagnosis, PutsFaultsBeforeWarningsBeforeWhatIsFine) {
  Observations seen = healthy();
  seen.buffers.receive = kMebi;
  worker_of(seen).demands_security = true;
  worker_of(seen).endpoints = worker_of(seen).samples = 0;
  const auto all = diagnose(seen);
  EXPECT_EQ(all[0].severity, Severity::kFault);
  EXPECT_EQ(all[1].severity, Severity::kWarning);
  EXPECT_EQ(all.back().severity, Severity::kFine);
}

TEST(SharedMemoryCheck, TellsFromWhichRoomOnProcessesAreKilled) {
  Observations seen = healthy();
  seen.memory.bytes = seen.memory.free_bytes = 63 * kMebi;
  EXPECT_EQ(complaints(seen), Complaints{"fault shm-small"});
  EXPECT_TRUE(mends_with(finding_of(seen, Concern::kShmSmall), "--shm-size="));
  EXPECT_TRUE(mends_with(finding_of(seen, Concern::kShmSmall), "--dds-segment-bytes 31MiB"));

  seen.memory.free_bytes = 100 * kMebi;  // a worker's, not a coordinator's
  EXPECT_EQ(complaints(seen), Complaints{"warning shm-small"});

  seen.memory.free_bytes = 10 * kMebi;
  seen.memory.owned = 3;  // those who are there have theirs
  EXPECT_EQ(complaints(seen), Complaints{"warning shm-small"});

  seen.options.transport = DdsOptions::Transport::kUdp;
  EXPECT_EQ(complaints(seen), Complaints{});
}

TEST(SharedMemoryCheck, WarnsWhereAnotherUsersIsLeftForUdp) {
  Observations seen = healthy();
  seen.memory.other_user = 7;
  EXPECT_EQ(complaints(seen), Complaints{"warning shm-other-user"});
  seen.options.transport = DdsOptions::Transport::kUdp;
  EXPECT_EQ(complaints(seen), Complaints{});
}

TEST(SharedMemoryCheck, SaysWhoseKeepsAProcessOutThatMayUseNothingElse) {
  Observations seen = healthy();
  seen.options.transport = DdsOptions::Transport::kSharedMemory;
  seen.memory.other_user = 7;
  EXPECT_EQ(complaints(seen), Complaints{}) << "it has found others all the same";
  seen.as_told.survey = {};
  EXPECT_EQ(complaints(seen)[0], "fault shm-other-user");
  EXPECT_EQ(finding_of(seen, Concern::kTransport).seen, "") << "that is why, not the transport";
}

TEST(SharedMemoryCheck, NamesAFolderThatIsNotThere) {
  Observations seen = healthy();
  seen.memory = {};
  EXPECT_EQ(complaints(seen), Complaints{"fault shm-small"});
}

TEST(SharedMemoryCheck, RemovesWhatIsStaleWithTheRightsThatTakes) {
  Observations seen = healthy();
  seen.memory.stale = {"/dev/shm/fastrtps_0123456789abcdef",
                       "/dev/shm/fastrtps_0123456789abcdef_el"};
  seen.memory.stale_bytes = 64 * kMebi;
  EXPECT_EQ(complaints(seen), Complaints{"warning shm-stale"});
  const std::string remove =
      "rm -f /dev/shm/fastrtps_0123456789abcdef /dev/shm/fastrtps_0123456789abcdef_el";
  EXPECT_EQ(finding_of(seen, Concern::kShmStale).mend.back(), remove);
  seen.memory.has_foreign_stale = true;
  EXPECT_EQ(finding_of(seen, Concern::kShmStale).mend.back(), "sudo " + remove);
}

TEST(SocketBufferCheck, SetsEachThatIsTooSmall) {
  Observations seen = healthy();
  seen.buffers.receive = 212992;
  EXPECT_EQ(complaints(seen), Complaints{"warning socket-buffers"});
  const Finding finding = finding_of(seen, Concern::kSocketBuffers);
  EXPECT_TRUE(mends_with(finding, "sysctl -w net.core.rmem_max=4194304"));
  EXPECT_FALSE(mends_with(finding, "wmem_max"));
}

TEST(MulticastCheck, IsAFaultWhereNoInterfaceHasItAndNobodyIsHeard) {
  Observations seen = healthy();
  seen.interfaces[1].multicast_fault = "3 datagrams did not come back";
  EXPECT_EQ(complaints(seen), Complaints{"warning multicast"});  // other hosts are heard
  for (auto& peer : seen.as_told.survey.participants) peer.is_of_this_host = true;
  EXPECT_EQ(complaints(seen), Complaints{"fault multicast"});
  seen.interfaces.push_back({"eth1", "10.1.0.1", true, false, true, std::nullopt});
  EXPECT_EQ(complaints(seen), Complaints{"warning multicast"});
  seen.options.interfaces = {"10.1.0.1"};  // the other one is not used
  EXPECT_EQ(complaints(seen), Complaints{});
}

TEST(MulticastCheck, SwitchesTheFlagOn) {
  Observations seen = healthy();
  seen.interfaces[1].has_multicast_flag = false;
  for (auto& peer : seen.as_told.survey.participants) peer.is_of_this_host = true;
  EXPECT_EQ(complaints(seen), Complaints{"fault multicast"});
  EXPECT_TRUE(mends_with(finding_of(seen, Concern::kMulticast), "ip link set eth0 multicast on"));
}

TEST(MulticastCheck, DoesNotMindWhereAddressesAreTold) {
  Observations seen = healthy();
  seen.interfaces[1].multicast_fault = "3 datagrams did not come back";
  seen.options.discovery = DdsOptions::Discovery::kPeers;
  seen.options.addresses = {{"10.0.0.2"}};
  seen.addresses = {{{"10.0.0.2"}, 3, 0, ""}};
  EXPECT_EQ(complaints(seen), Complaints{});
}

TEST(InterfaceCheck, NamesAddressesThatAreNotThisMachines) {
  Observations seen = healthy();
  seen.options.interfaces = {"10.0.0.1", "10.9.9.9"};
  EXPECT_EQ(complaints(seen), Complaints{"fault interface"});
  EXPECT_NE(finding_of(seen, Concern::kInterface).seen.find("10.9.9.9"), std::string::npos);
  EXPECT_TRUE(mends_with(finding_of(seen, Concern::kInterface), "--interface 10.0.0.1"));
}

}  // namespace
}  // namespace accord::testing
