// docs/operations.md lists every setting of every service as it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "coordinator/main/coordinator_settings.h"
#include "discovery/main/discovery_settings.h"
#include "worker/main/worker_settings.h"

namespace accord {
namespace {

std::string row_of(const Setting& setting) {
  return "| `" + setting.key + "` | `" + setting.flag + "` | " + setting.initial + " | " +
         setting.help + "; " + setting.expected + " |";
}

// The rows of the page's tables that describe a setting.
std::set<std::string> documented() {
  std::ifstream page(std::string(ACCORD_SOURCE_DIR) + "/docs/operations.md");
  std::set<std::string> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| `") && line.find("` | `--") != std::string::npos) rows.insert(line);
  }
  return rows;
}

TEST(Operations, ListsEverySettingAndNoOther) {
  CoordinatorSettings coordinator;
  DiscoverySettings discovery;
  WorkerSettings worker;
  std::set<std::string> rows;
  for (const Settings& table :
       {coordinator_table(coordinator), discovery_table(discovery), worker_table(worker)}) {
    for (const Setting& setting : table.all()) rows.insert(row_of(setting));
  }
  EXPECT_THAT(documented(), ::testing::ContainerEq(rows));
}

// Names are typed by hand in two tables: a slip would hide one setting behind another.
TEST(Settings, HaveNamesOfTheirOwn) {
  CoordinatorSettings coordinator;
  DiscoverySettings discovery;
  WorkerSettings worker;
  for (const Settings& table :
       {coordinator_table(coordinator), discovery_table(discovery), worker_table(worker)}) {
    std::set<std::string> names;
    for (const Setting& setting : table.all()) {
      EXPECT_TRUE(names.insert(setting.key).second) << setting.key;
      EXPECT_TRUE(names.insert(setting.flag).second) << setting.flag;
      EXPECT_TRUE(names.insert(variable_of(setting)).second) << variable_of(setting);
    }
  }
}

}  // namespace
}  // namespace accord
