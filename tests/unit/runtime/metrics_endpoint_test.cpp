// A process tells where it serves its metrics, and answers who asks how it is.
#include "common/runtime/metrics_endpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "common/runtime/metrics.h"
#include "tests/support/scratch_folder.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

class MetricsEndpoint : public ::testing::Test {
 protected:
  MetricsOptions options(std::optional<std::uint16_t> port) const {
    MetricsOptions out;
    out.port = port;
    out.port_file = (folder_.path() / "port").string();
    return out;
  }
  void write_port(const std::string& text) const { std::ofstream(options(0).port_file) << text; }

  testing::ScratchFolder folder_;
  Metrics metrics_;
};

TEST_F(MetricsEndpoint, TellsItsPortInAFile) {
  const auto server = serve_metrics(options(0), metrics_, {});
  ASSERT_TRUE(server) << server.error();
  EXPECT_EQ(metrics_port_of(options(0)), (*server)->port());
}

TEST_F(MetricsEndpoint, IsNotThereUnlessWanted) {
  const auto server = serve_metrics(options(std::nullopt), metrics_, {});
  ASSERT_TRUE(server);
  EXPECT_EQ(*server, nullptr);
  EXPECT_FALSE(metrics_port_of(options(std::nullopt))) << "nothing was written";
}

TEST_F(MetricsEndpoint, SaysWhereItCannotWriteItsPort) {
  MetricsOptions nowhere = options(0);
  nowhere.port_file = "/nowhere/port";
  const auto server = serve_metrics(nowhere, metrics_, {});
  ASSERT_FALSE(server);
  EXPECT_THAT(server.error(), HasSubstr("cannot write \"/nowhere/port.new\""));
}

TEST_F(MetricsEndpoint, IsAtThePortThatWasTold) {
  write_port("1234\n");
  EXPECT_EQ(metrics_port_of(options(9464)), 9464) << "a number counts more than a file";
}

TEST_F(MetricsEndpoint, IsNotKnownFromAFileThatHoldsNoPort) {
  for (const char* wrong : {"", "\n", "0\n", "65536\n", "-1\n", "12 \n", "12", "port\n"}) {
    write_port(wrong);
    const auto port = metrics_port_of(options(0));
    ASSERT_FALSE(port) << wrong;
    EXPECT_THAT(port.error(), HasSubstr("holds no port")) << wrong;
  }
  EXPECT_FALSE(metrics_port_of({})) << "neither a port nor a file is told";
}

TEST_F(MetricsEndpoint, AnswersWhetherTheProcessIsWell) {
  const auto server =
      serve_metrics(options(0), metrics_, {[] { return true; }, [] { return false; }});
  ASSERT_TRUE(server) << server.error();
  const std::uint16_t port = (*server)->port();
  const auto alive = ask_health("127.0.0.1", port, "/healthz", 5s);
  ASSERT_TRUE(alive) << alive.error();
  EXPECT_TRUE(alive->is_well);
  const auto ready = ask_health("127.0.0.1", port, "/readyz", 5s);
  ASSERT_TRUE(ready) << ready.error();
  EXPECT_FALSE(ready->is_well);
}

TEST_F(MetricsEndpoint, IsNotTakenForAnythingElseThatAnswers) {
  const auto server = serve_metrics(options(0), metrics_, {});
  ASSERT_TRUE(server);
  const auto answer = ask_health("127.0.0.1", (*server)->port(), "/elsewhere", 5s);
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error(), HasSubstr("answers with 404"));
}

TEST_F(MetricsEndpoint, IsSaidToBeSilentWhereNobodyListens) {
  std::uint16_t port = 0;
  {
    const auto server = serve_metrics(options(0), metrics_, {});
    ASSERT_TRUE(server);
    port = (*server)->port();
  }
  const auto answer = ask_health("127.0.0.1", port, "/healthz", 5s);
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error(), HasSubstr("nobody answers at 127.0.0.1:" + std::to_string(port)));
}

}  // namespace
}  // namespace accord
