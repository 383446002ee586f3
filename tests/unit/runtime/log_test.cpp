// What lines of the log look like, whatever they hold.
#include "common/runtime/log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

namespace accord {
namespace {

using ::testing::EndsWith;
using ::testing::MatchesRegex;

std::string logged(const LogOptions& options, const std::function<void()>& write) {
  ::testing::internal::CaptureStderr();
  start_log("program", options);
  write();
  spdlog::default_logger()->flush();
  return ::testing::internal::GetCapturedStderr();
}

std::string text(const std::function<void()>& write) {
  return logged({LogLevel::kDebug, LogFormat::kText}, write);
}

std::string json(const std::function<void()>& write) {
  return logged({LogLevel::kDebug, LogFormat::kJson}, write);
}

TEST(LogText, SaysTimeProcessLevelAndMessage) {
  EXPECT_THAT(text([] { spdlog::warn("mind {}", "this"); }),
              MatchesRegex("\\[....-..-.. ..:..:..\\....\\] \\[program\\] \\[warning\\] mind "
                           "this\n"));
}

TEST(LogText, CarriesFieldsBehindTheMessage) {
  EXPECT_THAT(text([] {
                log(LogLevel::kInfo, "done",
                    {{"task", 7U},
                     {"change", -1},
                     {"seconds", 0.25},
                     {"late", true},
                     {"worker", "0a02"},
                     {"why", "a \"b\"\n"},
                     {"empty", ""}});
              }),
              EndsWith("[info] done task=7 change=-1 seconds=0.25 late=true worker=0a02 "
                       "why=\"a \\\"b\\\"\\n\" empty=\"\"\n"));
}

TEST(LogText, IsOneLineWhateverTheMessage) {
  EXPECT_THAT(text([] { spdlog::info("a\nb \x1B[0m\xFF é"); }),
              EndsWith("[info] a\\x0Ab \\x1B[0m\\xFF é\n"));
}

TEST(LogJson, IsAnObjectALineWithTheTimeInUtc) {
  const auto record = nlohmann::ordered_json::parse(json([] {
    log(LogLevel::kError, "lost",
        {{"worker", "0a02"}, {"tasks", 3U}, {"share", 0.5}, {"again", false}});
  }));
  EXPECT_THAT(record.at("time").get<std::string>(), MatchesRegex("....-..-..T..:..:..\\....Z"));
  EXPECT_EQ(record.at("level"), "error");
  EXPECT_EQ(record.at("process"), "program");
  EXPECT_EQ(record.at("message"), "lost");
  EXPECT_EQ(record.at("worker"), "0a02");
  EXPECT_EQ(record.at("tasks"), 3);
  EXPECT_EQ(record.at("share"), 0.5);
  EXPECT_EQ(record.at("again"), false);
  EXPECT_EQ(record.size(), 8U);
}

TEST(LogJson, EscapesWhatMessagesAndFieldsHold) {
  const std::string odd = "\"quoted\" \\ \n \t \x01 é";
  const std::string line = json([&] { log(LogLevel::kInfo, odd, {{"name", odd}}); });
  EXPECT_EQ(std::ranges::count(line, '\n'), 1);
  const auto record = nlohmann::json::parse(line);
  EXPECT_EQ(record.at("message"), odd);
  EXPECT_EQ(record.at("name"), odd);
}

TEST(LogJson, ReplacesWhatIsNoUtf8AndNoNumber) {
  const auto record = nlohmann::json::parse(json([] {
    log(LogLevel::kInfo, "a\xFFz", {{"ratio", 0.0 / 0.0}});
  }));
  EXPECT_EQ(record.at("message"), "a\uFFFDz");
  EXPECT_TRUE(record.at("ratio").is_null());
}

TEST(LogJson, DoesNotTakeAMessageForAFormat) {
  const auto record = nlohmann::json::parse(json([] { log(LogLevel::kInfo, "{} {0", {}); }));
  EXPECT_EQ(record.at("message"), "{} {0");
}

TEST(LogScope, GivesItsFieldsToEveryLineOfItsThread) {
  const std::string lines = text([] {
    const LogScope outer({{"request", "a"}, {"step", 1}});
    spdlog::info("one");
    {
      const LogScope inner({{"step", 2}, {"task", 3}});
      spdlog::info("two");
      std::thread([] { spdlog::info("elsewhere"); }).join();
    }
    spdlog::info("three");
  });
  EXPECT_THAT(lines, ::testing::HasSubstr("one request=a step=1\n"));
  EXPECT_THAT(lines, ::testing::HasSubstr("two request=a step=2 task=3\n"));
  EXPECT_THAT(lines, ::testing::HasSubstr("elsewhere\n"));
  EXPECT_THAT(lines, ::testing::HasSubstr("three request=a step=1\n"));
}

TEST(LogLevel, IsTheLeastThatIsWritten) {
  const auto all = [] {
    for (const auto& [name, level] : kLogLevels) {
      if (level != LogLevel::kOff) log(level, name, {});
    }
  };
  for (const auto& [least, lines] : {std::pair(LogLevel::kDebug, 4),
                                     {LogLevel::kInfo, 3},
                                     {LogLevel::kWarning, 2},
                                     {LogLevel::kError, 1},
                                     {LogLevel::kOff, 0}}) {
    const std::string text = logged({least, LogFormat::kText}, all);
    EXPECT_EQ(std::ranges::count(text, '\n'), lines);
  }
}

}  // namespace
}  // namespace accord
