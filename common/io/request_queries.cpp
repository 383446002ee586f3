#include "common/io/request_queries.h"

#include <unordered_map>

#include "common/io/configuration_checks.h"
#include "common/io/diagnostic.h"
#include "common/io/query_checks.h"
#include "common/io/words.h"

namespace accord {
namespace {

std::string query_in_words(std::size_t index) {
  return "queries[" + std::to_string(index) + "]";
}

class QueryTaker {
 public:
  QueryTaker(const Scene& scene, Faults& faults)
      : scene_(scene),
        faults_(faults),
        checks_(scene.robots.size(), {QueryCheck::kPassed, QueryCheck::kPassed}) {
    for (std::uint32_t i = 0; i < scene.robots.size(); ++i) {
      robots_.emplace(scene.robots[i].name, RobotId{i});
    }
  }

  std::shared_ptr<const Scene> take(const std::vector<PlanRequest::Query>& queries) {
    for (std::size_t i = 0; i < queries.size() && !faults_.full(); ++i) take(queries[i], i);
    // Where one is no configuration there is no use in checking where it lies.
    if (faults_.count() > 0) return nullptr;
    auto scene = std::make_shared<const Scene>(std::move(scene_));
    check_queries(scene, checks_, [&](RobotId robot, QuerySide side, std::string_view text) {
      const std::string key = side == QuerySide::kStart ? ".start" : ".goal";
      report(query_in_words(query_of_.at(robot.value)) + key, text);
      return !faults_.full();
    });
    return scene;
  }

 private:
  void report(const std::string& key, std::string_view text) { faults_.add("", 0, key, text); }

  void take(const PlanRequest::Query& query, std::size_t index) {
    const std::string at = query_in_words(index);
    const auto found = robots_.find(query.robot);
    if (found == robots_.end()) return report_unknown(query.robot, at + ".robot");
    const RobotId id = found->second;
    const auto [first, is_new] = query_of_.emplace(id.value, index);
    if (!is_new) {
      return report(at + ".robot",
                    in_quotes(query.robot) + " has " + query_in_words(first->second) + " already");
    }
    if (!query.start && !query.goal) {
      return report(at, "expected a start, a goal, or both");
    }
    Robot& robot = scene_.robots[id.index()];
    QueryChecks& checks = checks_[id.index()];
    if (query.start) take(*query.start, *robot.model, at + ".start", robot.start, checks.start);
    if (query.goal) take(*query.goal, *robot.model, at + ".goal", robot.goal, checks.goal);
  }

  void take(const Configuration& from, const RobotModel& model, const std::string& at,
            Configuration& out, QueryCheck& check) {
    if (from.size() != model.dof()) {
      return report(at, "expected " + configuration_in_words(model) + ", not " +
                            std::to_string(from.size()) +
                            (from.size() == 1 ? " number" : " numbers"));
    }
    for (std::size_t k = 0; k < from.size(); ++k) {
      const Range range = range_of(model, k);
      const std::string one = at + "[" + std::to_string(k) + "]";
      if (!(from[k] >= range.min && from[k] <= range.max)) {  // nor if it is NaN
        report(one, "expected " + in_words(range) + ", not " + in_words(from[k]));
      } else if (const auto fault = limit_fault(model.dofs[k], from[k])) {
        report(one, *fault);
      }
    }
    out = from;
    check = QueryCheck::kDue;
  }

  void report_unknown(const std::string& name, const std::string& at) {
    constexpr std::size_t kHelped = 5;  // no more are shown, and a look among many takes its time
    std::vector<std::string_view> known;
    if (faults_.count() < kHelped) {
      for (const Robot& robot : scene_.robots) known.push_back(robot.name);
    }
    report(at, "unknown robot " + in_quotes(name) + suggestion(name, known));
  }

  Scene scene_;
  Faults& faults_;
  std::vector<QueryChecks> checks_;
  std::unordered_map<std::string, RobotId> robots_;          // by name
  std::unordered_map<std::uint32_t, std::size_t> query_of_;  // by robot
};

}  // namespace

tl::expected<std::shared_ptr<const Scene>, RequestFault> with_queries(
    std::shared_ptr<const Scene> scene, const std::vector<PlanRequest::Query>& queries) {
  if (queries.empty()) return scene;
  Faults faults("");
  auto placed = QueryTaker(*scene, faults).take(queries);
  if (faults.count() > 0) {
    return tl::unexpected(request_fault(Rejection::kBadQuery, faults.take()));
  }
  return placed;
}

}  // namespace accord
