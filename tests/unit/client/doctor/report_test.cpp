#include "client/doctor/report.h"

#include <gtest/gtest.h>

#include <sstream>

namespace accord {
namespace {

const Finding kFinding{Severity::kFault,
                       Concern::kCluster,
                       "nobody but \"\x1B[2J\"",
                       "Only processes of one cluster work together.",
                       {"--cluster a", "--cluster b"}};

TEST(DoctorReport, SaysWhatWhyAndHowToMendIt) {
  std::ostringstream out;
  write_text({kFinding, fine(Concern::kDomain, "joined domain 0")}, out);
  EXPECT_EQ(out.str(),
            "fault    cluster            nobody but \"\\x1B[2J\"\n"
            "    why      Only processes of one cluster work together.\n"
            "    mend     --cluster a\n"
            "    mend     --cluster b\n"
            "fine     domain             joined domain 0\n");
}

TEST(DoctorReport, IsAnObjectALineForPrograms) {
  std::ostringstream out;
  write_json({kFinding, fine(Concern::kDomain, "joined")}, out);
  EXPECT_EQ(out.str(), R"({"severity":"fault","code":"cluster","seen":"nobody but \"\\x1B[2J\"",)"
                       R"("why":"Only processes of one cluster work together.",)"
                       R"("mend":["--cluster a","--cluster b"]})"
                       "\n"
                       R"({"severity":"fine","code":"domain","seen":"joined","why":"","mend":[]})"
                       "\n");
}

}  // namespace
}  // namespace accord
