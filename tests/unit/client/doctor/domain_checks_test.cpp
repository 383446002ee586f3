#include "tests/unit/client/doctor/healthy.h"

namespace accord::testing {
namespace {

// A worker of this machine that is heard of, by shared memory, and has said nothing.
Observations with_silent_neighbour(SharedPort port) {
  Observations seen = healthy();
  SeenParticipant& worker = worker_of(seen);
  worker.is_of_this_host = true;
  worker.endpoints = worker.samples = 0;
  worker.locators = {{SeenLocator::Kind::kSharedMemory, "", 7412, false}};
  seen.shared_ports = {{7412, port}};
  return seen;
}

TEST(SharedPortCheck, TellsAnotherIpcNamespaceFromAnotherUser) {
  using State = SharedPort::State;
  EXPECT_EQ(complaints(with_silent_neighbour({State::kMissing, 0})),
            Complaints{"fault shm-not-shared"});
  EXPECT_EQ(complaints(with_silent_neighbour({State::kOwn, 1000})),
            Complaints{"fault shm-not-shared"});
  EXPECT_EQ(complaints(with_silent_neighbour({State::kDenied, 0})),
            Complaints{"fault shm-other-user"});
  EXPECT_EQ(complaints(with_silent_neighbour({State::kOpen, 1000})), Complaints{"fault no-data"});
}

TEST(SharedPortCheck, KnowsThatTwoWhoClaimOnePortAreApart) {
  Observations seen = with_silent_neighbour({SharedPort::State::kOpen, 1000});
  SeenParticipant other = worker_of(seen);
  other.guid = "010f00020000000000000003";
  other.endpoints = 7;  // the one that is here
  other.name->role = AccordName::Role::kCoordinator;
  seen.as_told.survey.participants.push_back(other);
  EXPECT_EQ(complaints(seen), Complaints{"fault shm-not-shared"});
}

TEST(AddressCheck, TellsWhatBecameOfEachPeer) {
  Observations seen = healthy();
  seen.options.discovery = DdsOptions::Discovery::kPeers;
  seen.options.addresses = {{"10.0.0.2"}, {"10.0.0.3"}, {"10.1.0.1"}, {"10.0.0.4", 7500}};
  seen.addresses = {{{"10.0.0.2"}, 3, 3, ""},  // whoever is there listens at other ports
                    {{"10.0.0.3"}, 3, 3, ""},
                    {{"10.1.0.1"}, 3, 0, "Network is unreachable"},
                    {{"10.0.0.4", 7500}, 1, 0, ""}};
  EXPECT_EQ(complaints(seen), Complaints{"fault peer-unreachable"});
  EXPECT_EQ(finding_of(seen, Concern::kPeerUnreachable).seen,
            "10.0.0.3: nobody listens there (connection refused), 10.1.0.1: Network is unreachable "
            "and 10.0.0.4:7500: no answer");
}

TEST(AddressCheck, DoesNotBelieveAParticipantThatSaysToBeWhereNoWayLeads) {
  Observations seen = healthy();
  worker_of(seen).endpoints = worker_of(seen).samples = 0;
  EXPECT_EQ(complaints(seen), Complaints{"fault no-data"});
  seen.silent[worker_of(seen).guid] = {{{"10.0.0.2", 7410}, 1, 0, "No route to host"}};
  EXPECT_EQ(complaints(seen), Complaints{"fault peer-unreachable"});
}

TEST(AddressCheck, StartsADiscoveryServerThatIsNotThere) {
  Observations seen = healthy();
  seen.options.discovery = DdsOptions::Discovery::kServer;
  seen.options.addresses = {{"10.0.0.2", 11811}};
  seen.addresses = {{{"10.0.0.2", 11811}, 1, 1, ""}};
  EXPECT_EQ(complaints(seen), Complaints{"fault server-unreachable"});
  EXPECT_TRUE(mends_with(finding_of(seen, Concern::kServerUnreachable),
                         "fast-discovery-server -i 0 -l 10.0.0.2 -p 11811"));
  SeenParticipant server;
  server.server = 0;
  seen.as_told.survey.participants.push_back(server);
  EXPECT_EQ(complaints(seen), Complaints{});
}

TEST(TransportCheck, NamesWhoIsThereByOtherWaysOnly) {
  Observations seen = healthy();
  seen.as_told.survey = {};
  EXPECT_EQ(complaints(seen), (Complaints{"fault transport", "warning service"}));
  seen.by_udp.reset();
  EXPECT_EQ(complaints(seen), Complaints{"warning service"});
  seen.by_memory->survey = healthy().as_told.survey;
  EXPECT_EQ(complaints(seen), (Complaints{"fault transport", "warning service"}));
}

TEST(TransportCheck, KnowsInterfacesThatHearAndCannotAnswer) {
  Observations seen = healthy();
  worker_of(seen).endpoints = worker_of(seen).samples = 0;
  EXPECT_EQ(complaints(seen), Complaints{"fault no-data"});
  seen.options.interfaces = {"127.0.0.1"};
  EXPECT_EQ(complaints(seen), Complaints{"fault transport"});
  seen.by_udp.reset();
  EXPECT_EQ(complaints(seen), Complaints{"fault no-data"});
}

TEST(SecurityCheck, NamesWhoShowsACertificateAndSaysNothing) {
  Observations seen = healthy();
  worker_of(seen).demands_security = true;  // but lets others in
  EXPECT_EQ(complaints(seen), Complaints{});
  worker_of(seen).endpoints = worker_of(seen).samples = 0;
  EXPECT_EQ(complaints(seen), Complaints{"fault security"});
}

TEST(ProtocolCheck, TellsAnotherProtocolFromAnotherVersion) {
  Observations seen = healthy();
  seen.as_told.survey.workers[0].version = "0.2.0";
  EXPECT_EQ(complaints(seen), Complaints{"warning protocol"});
  worker_of(seen).name->protocol = 2;
  EXPECT_EQ(complaints(seen), Complaints{"fault protocol"});
}

TEST(ClusterCheck, NamesTheClustersThatAreThere) {
  Observations seen = healthy();
  seen.options.cluster = "plant";
  seen.as_told.survey.service.reset();
  seen.as_told.survey.workers.clear();
  seen.by_udp.reset();
  EXPECT_EQ(complaints(seen), (Complaints{"fault cluster", "warning service"}));
  EXPECT_EQ(finding_of(seen, Concern::kCluster).mend, Complaints{"--cluster default"});
}

TEST(ClockCheck, TellsHowFarAndWhichWay) {
  Observations seen = healthy();
  worker_of(seen).clock_ahead = -3600.5;
  EXPECT_EQ(complaints(seen), Complaints{"warning clock-skew"});
  EXPECT_NE(finding_of(seen, Concern::kClockSkew)
                .seen.find("worker 0000000000000077 is 3600.500 s behind"),
            std::string::npos);
}

TEST(ServiceCheck, TellsNobodyFromNoAnswer) {
  Observations seen = healthy();
  seen.as_told.survey = {};
  seen.by_udp.reset();
  seen.domains_here = {0, 7};
  EXPECT_EQ(complaints(seen), Complaints{"warning service"});
  EXPECT_NE(finding_of(seen, Concern::kService).seen.find("also in domain 7"), std::string::npos);
}

TEST(DataCheck, MissesWhatAServiceSaysThatIsThere) {
  Observations seen = healthy();
  seen.as_told.survey.service.reset();
  EXPECT_EQ(complaints(seen), (Complaints{"fault no-data", "warning service"}));
}

TEST(ServiceCheck, FindsWorkersThatTheServiceDoesNotUse) {
  Observations seen = healthy();
  seen.as_told.survey.workers[0].standing = "distrusted";
  EXPECT_EQ(complaints(seen), Complaints{"fault workers"});
  seen.as_told.survey.workers.clear();
  EXPECT_EQ(complaints(seen), Complaints{"fault workers"});
  seen = healthy();
  seen.as_told.survey.service->workers = 0;
  seen.as_told.survey.participants.pop_back();
  seen.by_udp.reset();
  EXPECT_EQ(complaints(seen), Complaints{"fault workers"});
  EXPECT_EQ(finding_of(seen, Concern::kWorkers).mend, Complaints{"accord-worker"});
}

TEST(DomainCheck, SaysWhyItCouldNotJoinAndNothingThatFollows) {
  Observations seen = healthy();
  seen.as_told = {"DDS could not join domain 0", {}};
  EXPECT_EQ(complaints(seen), Complaints{"fault domain"});
}

TEST(Settled, IsASurveyInWhichAllHaveSpoken) {
  Observations seen = healthy();
  EXPECT_TRUE(is_settled(seen.options, seen.as_told.survey));
  worker_of(seen).endpoints = worker_of(seen).samples = 0;
  EXPECT_FALSE(is_settled(seen.options, seen.as_told.survey));
  seen = healthy();
  seen.as_told.survey.participants[0].clock_ahead.reset();
  EXPECT_FALSE(is_settled(seen.options, seen.as_told.survey));
}

}  // namespace
}  // namespace accord::testing
