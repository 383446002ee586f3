// Values know their lines and paths, whichever format they come from.
#include "common/io/document.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/io/json_reader.h"
#include "common/io/limits.h"
#include "common/io/yaml_reader.h"

namespace accord {
namespace {

constexpr std::size_t kEnough = 1000;

// "line path = text" of all scalars, in order.
void collect(const Value& value, std::vector<std::string>& out) {
  if (value.is_scalar()) {
    out.push_back(std::to_string(value.line()) + " " + value.path() + " = " +
                  std::string(value.text()));
  }
  bool key = value.is_map();
  for (const Value child : value) {
    if (!key) collect(child, out);
    if (value.is_map()) key = !key;
  }
}

std::vector<std::string> scalars(const Document* document) {
  std::vector<std::string> out;
  if (document != nullptr) collect(document->root(), out);
  return out;
}

std::string fault_of_yaml(const std::string& text, std::size_t max_values = kEnough) {
  Faults faults("f");
  EXPECT_EQ(read_yaml(text, "f", max_values, faults), nullptr);
  const auto list = faults.take();
  return list.size() == 1 ? to_string(list[0]) : std::to_string(list.size()) + " faults";
}

std::string fault_of_json(const std::string& text, std::size_t max_values = kEnough) {
  Faults faults("f");
  EXPECT_EQ(read_json(text, "f", max_values, faults), nullptr);
  const auto list = faults.take();
  return list.size() == 1 ? to_string(list[0]) : std::to_string(list.size()) + " faults";
}

TEST(YamlReader, KeepsLinesAndPaths) {
  Faults faults("f");
  const auto document =
      read_yaml("a: 1\nb:\n  - {c: x, d: [2, 3]}\n  - 'e'\n", "f", kEnough, faults);
  EXPECT_EQ(scalars(document.get()),
            (std::vector<std::string>{"1 a = 1", "3 b[0].c = x", "3 b[0].d[0] = 2",
                                      "3 b[0].d[1] = 3", "4 b[1] = e"}));
  EXPECT_EQ(faults.count(), 0U);
}

TEST(YamlReader, TellsQuotedFromPlainAndNull) {
  Faults faults("f");
  const auto document = read_yaml("[1, '1', \"1\", ~, null, ]", "f", kEnough, faults);
  std::vector<ValueKind> kinds;
  for (const Value item : document->root()) kinds.push_back(item.kind());
  EXPECT_EQ(kinds, (std::vector{ValueKind::kPlain, ValueKind::kQuoted, ValueKind::kQuoted,
                                ValueKind::kNull, ValueKind::kNull}));
}

TEST(YamlReader, TakesAByteOrderMarkAndWindowsLineEnds) {
  Faults faults("f");
  const auto document = read_yaml(
      "\xEF\xBB\xBF"
      "a: 1\r\nb: 2\r\n",
      "f", kEnough, faults);
  EXPECT_EQ(scalars(document.get()), (std::vector<std::string>{"1 a = 1", "2 b = 2"}));
}

TEST(YamlReader, RefusesMoreValuesThanAllowed) {
  EXPECT_EQ(fault_of_yaml("[1,\n 2,\n 3,\n 4]", 4), "f:4: more than 4 keys and values");
}

TEST(YamlReader, ReportsEveryAnchorAliasAndTag) {
  Faults faults("f");
  EXPECT_EQ(read_yaml("a: &x [1, !t 2]\nb: [*x, {c: *x}]\n*x : &y !t 3\n", "f", kEnough, faults),
            nullptr);
  std::vector<std::string> list;
  for (const Diagnostic& fault : faults.take()) list.push_back(to_string(fault));
  const std::string anchor = "anchors (&name) are not supported; write values out";
  const std::string alias = "aliases (*name) are not supported; write values out";
  const std::string tag = "the tag \"!t\" is not supported; expected plain values";
  EXPECT_EQ(list,
            (std::vector<std::string>{"f:1: a: " + anchor, "f:1: a[1]: " + tag,
                                      "f:2: b[0]: " + alias, "f:2: b[1].c: " + alias,
                                      "f:3: *: " + alias, "f:3: *: " + anchor, "f:3: *: " + tag}));
}

TEST(YamlReader, ReportsNoMoreAliasesThanFaultsAreListed) {
  Faults faults("f");
  std::string text = "a: &x 1\nb: [";
  for (std::size_t i = 0; i < 2 * limits::kFaults; ++i) text += "*x, ";
  EXPECT_EQ(read_yaml(text + "]", "f", 10 * limits::kFaults, faults), nullptr);
  EXPECT_EQ(faults.count(), limits::kFaults);
}

TEST(YamlReader, SaysHowDeepValuesMayLieWhereBracketsNeverEnd) {
  EXPECT_EQ(fault_of_yaml(std::string(2000, '[')),
            "f:1: more than 1000 brackets are open at once; expected at most 32 levels of nesting");
}

TEST(YamlReader, RefusesWhatOnlyLooksLikeText) {
  EXPECT_EQ(fault_of_yaml(std::string("a: 1\nb: \0", 9)),
            "f:2: not text: the byte \"\\x00\"; expected UTF-8");
  EXPECT_EQ(fault_of_yaml("\xFF\xFE"
                          "a"),
            "f:1: not text: the byte \"\\xFF\"; expected UTF-8");
}

TEST(JsonReader, KeepsLinesOfNumbersBeforeLineFeeds) {
  Faults faults("f");
  const auto document =
      read_json("{\"a\": 1\n,\n\"b\": [2\n, 3.5\n, \"x\", true\n]}", "f", kEnough, faults);
  EXPECT_EQ(scalars(document.get()),
            (std::vector<std::string>{"1 a = 1", "3 b[0] = 2", "4 b[1] = 3.5", "5 b[2] = x",
                                      "5 b[3] = true"}));
}

TEST(JsonReader, KeepsLargeSeedsExact) {
  Faults faults("f");
  const auto document = read_json("18446744073709551615", "f", kEnough, faults);
  EXPECT_EQ(document->root().text(), "18446744073709551615");
}

TEST(JsonReader, SaysWhereSyntaxBreaks) {
  EXPECT_EQ(fault_of_json("{\"a\": 1,\n \"b\": }"), "f:2: not valid JSON near \"\"b\": }\"");
  EXPECT_EQ(fault_of_json("[1, NaN]"), "f:1: not valid JSON near \"1, N\"");
  EXPECT_EQ(fault_of_json("[1,\n1e999]"), "f:2: the number \"1e999\" is too large");
  EXPECT_EQ(fault_of_json("[1, 2, 3]", 3), "f:1: more than 3 keys and values");
  EXPECT_EQ(fault_of_json(""), "f:1: not valid JSON near \"\"");
}

TEST(JsonReader, RefusesNestingWithoutEnd) {
  EXPECT_EQ(fault_of_json(std::string(1'000'000, '['), 2'000'000),
            "f:1: nested more than 32 levels deep");
}

}  // namespace
}  // namespace accord
