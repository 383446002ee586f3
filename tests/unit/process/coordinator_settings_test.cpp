// What a coordinator can be told.
#include "coordinator/main/coordinator_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/runtime/configuration.h"

namespace accord {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;

TEST(CoordinatorSettings, AreSoundByDefault) {
  CoordinatorSettings settings;
  const Settings table = coordinator_table(settings);
  EXPECT_TRUE(configure(table, {}).none());
  for (const Setting& setting : table.all()) {
    EXPECT_FALSE(setting.initial.empty()) << setting.key;
    EXPECT_FALSE(setting.help.empty()) << setting.key;
  }
}

TEST(CoordinatorSettings, SetWhatTheyAreNamedAfter) {
  CoordinatorSettings settings;
  const Written written{std::nullopt,
                        {{"ACCORD_JOURNAL", "/var/lib/accord/journal.db"},
                         {"ACCORD_KEEP", "3600"},
                         {"ACCORD_SCENES", "/srv/scenes"},
                         {"ACCORD_LIMITS_QUEUED", "5"},
                         {"ACCORD_LIMITS_PLANNING", "2"},
                         {"ACCORD_LIMITS_REQUEST_BYTES", "1 MiB"},
                         {"ACCORD_LIMITS_ROBOTS", "50"},
                         {"ACCORD_LIMITS_WAYPOINTS", "1000"}},
                        {{"--lease", {"2.5"}},
                         {"--deaths", {"4"}},
                         {"--threads", {"3"}},
                         {"--metrics", {"9464"}},
                         {"--log", {"debug"}}}};
  EXPECT_THAT(configure(coordinator_table(settings), written).usage, ElementsAre());
  EXPECT_EQ(settings.journal, "/var/lib/accord/journal.db");
  EXPECT_EQ(settings.keep, 1h);
  EXPECT_EQ(settings.scenes, "/srv/scenes");
  EXPECT_EQ(settings.limits.queued, 5U);
  EXPECT_EQ(settings.limits.planning, 2U);
  EXPECT_EQ(settings.limits.request_bytes, std::size_t{1} << 20);
  EXPECT_EQ(settings.limits.robots, 50U);
  EXPECT_EQ(settings.limits.waypoints, 1000U);
  EXPECT_EQ(settings.lease, 2500ms);
  EXPECT_EQ(settings.deaths, 4U);
  EXPECT_EQ(settings.threads, 3U);
  EXPECT_EQ(settings.metrics.port, 9464);
  EXPECT_EQ(settings.log.level, LogLevel::kDebug);
}

TEST(MetricsPort, IsANumberAnyOrNone) {
  const auto port_of = [](const char* text) {
    CoordinatorSettings settings;
    const Written written{std::nullopt, {}, {{"--metrics", {text}}}};
    EXPECT_THAT(configure(coordinator_table(settings), written).usage, ElementsAre()) << text;
    return settings.metrics.port;
  };
  EXPECT_EQ(CoordinatorSettings().metrics.port, std::nullopt);
  EXPECT_EQ(port_of("65535"), 65535);
  EXPECT_EQ(port_of("any"), 0);
  EXPECT_EQ(port_of("none"), std::nullopt);
  EXPECT_EQ(port_of("0"), std::nullopt);
}

TEST(CoordinatorSettings, AreBounded) {
  CoordinatorSettings settings;
  const Written written{
      std::nullopt,
      {},
      {{"--max-planning", {"257"}}, {"--max-robots", {"10001"}}, {"--lease", {"0.1"}}}};
  EXPECT_THAT(configure(coordinator_table(settings), written).usage,
              ElementsAre("--lease: expected a number from 0.3 to 3600 s, not \"0.1\"",
                          "--max-planning: expected a whole number from 1 to 256, not \"257\"",
                          "--max-robots: expected a whole number from 1 to 10000, not \"10001\""));
}

TEST(QuarantineFolder, IsBesideTheJournalUnlessItIsNamed) {
  CoordinatorSettings settings;
  EXPECT_EQ(settings.quarantine_folder(), "") << "nothing is kept without a journal";
  settings.journal = "/var/lib/accord/journal.db";
  EXPECT_EQ(settings.quarantine_folder(), "/var/lib/accord/journal.db.quarantine");
  const Settings table = coordinator_table(settings);
  configure(table, {std::nullopt, {}, {{"--quarantine", {"none"}}}});
  EXPECT_EQ(settings.quarantine_folder(), "");
  configure(table, {std::nullopt, {}, {{"--quarantine", {"/srv/quarantine"}}}});
  EXPECT_EQ(settings.quarantine_folder(), "/srv/quarantine");
}

}  // namespace
}  // namespace accord
