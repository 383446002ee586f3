#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "common/io/plan_file.h"
#include "common/io/words.h"

namespace accord {
namespace {

class PlanWriter {
 public:
  explicit PlanWriter(bool with_times) : with_times_(with_times) {}

  std::string write(const Plan& plan) {
    out_ = "{\n";
    member("accord", [&] { string("plan/1"); });
    member("scene", [&] { string(plan.scene); });
    member("status", [&] { string(to_string(plan.status)); });
    member("message", [&] { string(plan.message); });
    member("method", [&] { string(plan.method); });
    member("seed", [&] { out_ += std::to_string(plan.seed); });
    member("timestep", [&] { number(plan.timestep); });
    if (with_times_) member("planning_time", [&] { number(plan.planning_time); });
    member("makespan", [&] { number(plan.makespan); });
    member("sum_of_costs", [&] { number(plan.sum_of_costs); });
    member("sum_of_costs_timesteps", [&] { out_ += std::to_string(plan.sum_of_costs_timesteps); });
    member("robots", [&] { list(plan.robots, "\n    ", [&](const auto& r) { robot(r); }); });
    out_ += "  \"statistics\": ";
    statistics(plan);
    out_ += "\n}\n";
    return std::move(out_);
  }

 private:
  template <typename Write>
  void member(std::string_view key, Write write) {
    out_ += "  \"";
    out_ += key;
    out_ += "\": ";
    write();
    out_ += ",\n";
  }

  template <typename Items, typename Write>
  void list(const Items& items, std::string_view before_each, Write write) {
    out_ += '[';
    bool first = true;
    for (const auto& item : items) {
      if (!first) out_ += before_each.empty() ? ", " : ",";
      out_ += before_each;
      write(item);
      first = false;
    }
    out_ += ']';
  }

  void robot(const RobotPlan& robot) {
    out_ += "{\"name\": ";
    string(robot.name);
    out_ += ",\n     \"waypoints\": [";
    const Trajectory& path = robot.trajectory;
    for (std::size_t i = 0; i < path.size(); ++i) {
      out_ += i == 0 ? "\n      {\"t\": " : ",\n      {\"t\": ";
      number(path.time(i));
      out_ += ", \"q\": ";
      list(path.configuration(i), "", [&](double value) { number(value); });
      out_ += '}';
    }
    out_ += "],\n     \"segments\": ";
    list(robot.segments, "\n      ", [&](const PlanSegment& s) { segment(s); });
    out_ += '}';
  }

  void segment(const PlanSegment& segment) {
    out_ += "{\"from\": ";
    number(segment.from);
    out_ += ", \"to\": ";
    number(segment.to);
    out_ += ", \"robots\": ";
    list(segment.robots, "", [&](const std::string& name) { string(name); });
    out_ += ", \"solver\": ";
    string(segment.solver);
    out_ += '}';
  }

  void statistics(const Plan& plan) {
    out_ += '{';
    bool first = true;
    for (const auto& [name, value] : plan.statistics) {
      if (!with_times_ && name.ends_with("_time")) continue;
      out_ += first ? "\n    " : ",\n    ";
      string(name);
      out_ += ": ";
      number(value);
      first = false;
    }
    out_ += first ? "}" : "\n  }";
  }

  void number(double value) {
    if (!std::isfinite(value)) {
      out_ += "null";
      return;
    }
    value += 0.0;  // -0 is 0
    std::array<char, 32> text{};
    // Counts are easier to read without an exponent.
    constexpr double kLargestCount = 1e15;
    const bool count = std::abs(value) < kLargestCount && value == std::floor(value);
    const auto end = count
                         ? std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed)
                         : std::to_chars(text.begin(), text.end(), value);
    out_.append(text.begin(), end.ptr);
  }

  void string(std::string_view text) {
    out_ += '"';
    while (!text.empty()) {
      // Whatever is no UTF-8 cannot stand in JSON.
      const std::size_t bad = std::min(first_unprintable(text), text.size());
      for (const char c : text.substr(0, bad)) plain(c);
      text.remove_prefix(bad);
      if (text.empty()) break;
      const auto byte = static_cast<unsigned char>(text.front());
      byte < 0x20 || byte == 0x7F ? escape(byte) : void(out_ += "\xEF\xBF\xBD");
      text.remove_prefix(1);
    }
    out_ += '"';
  }

  void plain(char c) {
    if (c == '"' || c == '\\') out_ += '\\';
    if (c == '\n' || c == '\r' || c == '\t') return escape(static_cast<unsigned char>(c));
    out_ += c;
  }

  void escape(unsigned char byte) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "\\u%04x", byte);
    out_ += text.data();
  }

  bool with_times_;
  std::string out_;
};

}  // namespace

std::string to_json(const Plan& plan) {
  return PlanWriter(true).write(plan);
}

std::string canonical_bytes(const Plan& plan) {
  return PlanWriter(false).write(plan);
}

}  // namespace accord
