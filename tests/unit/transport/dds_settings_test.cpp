// What a person can say of DDS, and what is said of options that make no sense.
#include "common/transport/dds_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/runtime/configuration.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using Flags = std::map<std::string, std::vector<std::string>>;

class DdsSettings : public ::testing::Test {
 protected:
  DdsSettings() { add_dds_settings(table_, options_); }

  std::vector<std::string> faults(const Flags& flags) {
    return configure(table_, {std::nullopt, {}, flags}).usage;
  }

  DdsOptions options_;
  Settings table_;
};

TEST_F(DdsSettings, SetEveryOption) {
  const Flags flags{{"--domain", {"7"}},
                    {"--cluster", {"hall-3"}},
                    {"--transport", {"udp"}},
                    {"--discovery", {"server"}},
                    {"--address", {"10.0.0.7:11811", "10.0.0.8:11812"}},
                    {"--interface", {"10.0.0.1"}},
                    {"--dds-lease", {"3"}},
                    {"--dds-announcement", {"0.05"}},
                    {"--dds-segment-bytes", {"16 MiB"}},
                    {"--dds-datagram-bytes", {"1452"}}};
  EXPECT_THAT(faults(flags), ElementsAre());
  EXPECT_EQ(options_.domain, 7U);
  EXPECT_EQ(options_.cluster, "hall-3");
  EXPECT_EQ(options_.transport, DdsOptions::Transport::kUdp);
  EXPECT_EQ(options_.discovery, DdsOptions::Discovery::kServer);
  EXPECT_THAT(options_.addresses,
              ElementsAre(DdsAddress{"10.0.0.7", 11811}, DdsAddress{"10.0.0.8", 11812}));
  EXPECT_THAT(options_.interfaces, ElementsAre("10.0.0.1"));
  EXPECT_EQ(options_.lease, 3s);
  EXPECT_EQ(options_.announcement, 50ms);
  EXPECT_EQ(options_.segment_bytes, std::size_t{16} << 20);
  EXPECT_EQ(options_.datagram_bytes, 1452U);
  EXPECT_EQ(table_.all().size(), flags.size());
}

TEST_F(DdsSettings, HaveDefaultsThatMakeSense) {
  EXPECT_EQ(options_fault(options_), std::nullopt);
  EXPECT_THAT(faults({}), ElementsAre());
}

TEST_F(DdsSettings, RefuseValuesThatDdsWouldTakeAndMakeNothingOf) {
  EXPECT_THAT(faults({{"--domain", {"233"}}}),
              ElementsAre("--domain: expected a whole number from 0 to 232, not \"233\""));
  EXPECT_THAT(faults({{"--cluster", {"a b"}}}),
              ElementsAre("--cluster: expected 1 to 64 letters, digits, '-', '_' and '.', not "
                          "\"a b\""));
  EXPECT_THAT(faults({{"--interface", {"eth0"}}}),
              ElementsAre("--interface: expected an IPv4 address, not \"eth0\""));
  for (const char* wrong : {"10.0.0.7:", "10.0.0.7:0", "10.0.0.7:65536", "host:80", ":80"}) {
    EXPECT_THAT(faults({{"--address", {wrong}}}),
                ElementsAre("--address: expected an IPv4 address, with or without a port, as in "
                            "10.0.0.7:11811, not \"" +
                            std::string(wrong) + "\""));
  }
}

TEST_F(DdsSettings, RefuseOptionsThatDoNotGoTogether) {
  EXPECT_THAT(faults({{"--discovery", {"peers"}}}),
              ElementsAre("--address: expected some, for discovery by peers or a server"));
  EXPECT_THAT(faults({{"--discovery", {"server"}}, {"--address", {"10.0.0.7"}}}),
              ElementsAre("--address: a discovery server has a port"));
  EXPECT_THAT(faults({{"--dds-lease", {"0.3"}}, {"--discovery", {"multicast"}}}),
              ElementsAre("--dds-lease: expected at least two announcements' time"));
}

}  // namespace
}  // namespace accord
