#include "coordinator/service/service_log.h"

#include <spdlog/fmt/fmt.h>

#include <string>
#include <vector>

#include "common/runtime/log.h"
#include "common/transport/task_name.h"
#include "coordinator/dispatch/worker_record.h"

namespace accord {
namespace {

using Kind = BoardNote::Kind;

LogLevel level_of(const BoardNote& note) {
  switch (note.kind) {
    case Kind::kWelcomed:
    case Kind::kLeaving:
    case Kind::kLeft:
      return LogLevel::kInfo;
    case Kind::kRefused:
    case Kind::kGone:
    case Kind::kSilent:
    case Kind::kGivenUp:
      return LogLevel::kWarning;
    case Kind::kDistrusted:
      return LogLevel::kError;
    case Kind::kAssigned:
    case Kind::kDropped:
      return LogLevel::kDebug;
    case Kind::kReassigned:
      break;
  }
  // Of a worker that is lost or leaves, one line says so, however many tasks it had.
  const bool is_telling = note.reason == Reassigned::kFailed ||
                          note.reason == Reassigned::kRefused ||
                          note.reason == Reassigned::kDistrusted;
  return is_telling ? LogLevel::kWarning : LogLevel::kDebug;
}

const char* words_of(Kind kind) {
  switch (kind) {
    case Kind::kWelcomed:
      return "worker takes tasks";
    case Kind::kLeaving:
      return "worker takes no more tasks";
    case Kind::kRefused:
      return "worker refused";
    case Kind::kDistrusted:
      return "worker distrusted";
    case Kind::kLeft:
      return "worker has left";
    case Kind::kGone:
      return "worker lost";
    case Kind::kSilent:
      return "worker lost: silent for too long";
    case Kind::kAssigned:
      return "task assigned";
    case Kind::kReassigned:
      return "task given out anew";
    case Kind::kGivenUp:
      return "task given up";
    case Kind::kDropped:
      return "result dropped";
  }
  return "";
}

double statistic(const Plan& plan, std::string_view name) {
  for (const auto& [key, value] : plan.statistics) {
    if (key == name) return value;
  }
  return 0;
}

}  // namespace

void log_note(const BoardNote& note) {
  const LogLevel level = level_of(note);
  if (!logs(level)) return;
  std::vector<LogField> fields;
  if (note.task) {
    fields.emplace_back("request", note.request);
    fields.emplace_back("task", task_name(note.task->task));
    fields.emplace_back("epoch", note.task->epoch);
  }
  if (note.worker != EndpointId{}) fields.emplace_back("worker", to_string(note.worker));
  if (note.record != nullptr) {
    fields.emplace_back("host", note.record->info.host);
    fields.emplace_back("pid", note.record->info.process);
    fields.emplace_back("threads", note.record->info.threads);
  }
  std::string words = words_of(note.kind);
  if (!note.text.empty()) words += ": " + std::string(note.text);
  log(level, words, std::move(fields));
}

void log_accepted(const std::string& request) {
  log(LogLevel::kInfo, "accepted", {{"request", request}});
}

void log_planned(const PlanningThreads::Planned& planned) {
  const Plan& plan = planned.plan;
  log(LogLevel::kInfo,
      fmt::format("planned: {}{}{}", to_string(plan.status), plan.message.empty() ? "" : ": ",
                  plan.message),
      {{"request", planned.id},
       {"status", to_string(plan.status)},
       {"seconds", plan.planning_time},
       {"conflicts", statistic(plan, "conflicts_found")},
       {"resolutions", statistic(plan, "conflicts_resolved")},
       {"rounds", statistic(plan, "rounds")}});
}

void log_news(const FleetNews& news) {
  if (const auto* reply = std::get_if<RequestReply>(&news); reply != nullptr && !reply->accepted) {
    // Who asks again and again after what nobody knows does not fill the log.
    const bool is_question = reply->reason == Rejection::kUnknownRequest;
    log(is_question ? LogLevel::kDebug : LogLevel::kInfo, "rejected: " + reply->text,
        {{"request", reply->id}, {"reason", to_string(reply->reason)}, {"field", reply->field}});
  }
  if (const auto* finished = std::get_if<FinishedPlan>(&news)) {
    log(LogLevel::kInfo, "plan handed out",
        {{"request", finished->id},
         {"status", to_string(finished->plan.status)},
         {"content", finished->content}});
  }
}

void log_request(const FleetRequest& request) {
  if (const auto* cancel = std::get_if<CancelRequest>(&request)) {
    log(LogLevel::kDebug, "asked to cancel it", {{"request", cancel->id}});
  } else if (const auto* resend = std::get_if<ResendRequest>(&request)) {
    log(LogLevel::kDebug, "asked how it stands", {{"request", resend->id}});
  } else {
    log(LogLevel::kDebug, "asked for a plan", {{"request", std::get<PlanRequest>(request).id}});
  }
}

}  // namespace accord
