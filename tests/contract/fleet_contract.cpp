#include "tests/contract/fleet_contract.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "common/io/plan_file.h"
#include "common/transport/fleet/fleet_limits.h"
#include "tests/contract/fleet_samples.h"

namespace accord::fleet_contract {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using fleet_samples::bits_of;
using fleet_samples::plan_of;

constexpr auto kPatience = 10s;  // how long anything may take that has to happen
constexpr auto kQuiet = 100ms;   // how long nothing is to happen

constexpr std::string_view kProbe = "probe-";

struct Service {
  explicit Service(World& world) : port(world.serve([this] { ++wakes; })) {}

  void take_all() {
    while (auto request = port->take()) {
      // A client that found the service in the midst of a probe asks for what it lacks of it.
      const auto* resend = std::get_if<ResendRequest>(&*request);
      if (resend != nullptr && resend->id.starts_with(kProbe)) continue;
      requests.push_back(std::move(*request));
    }
  }
  static void pause() { std::this_thread::sleep_for(100us); }

  std::atomic<int> wakes = 0;
  int probes = 0;
  std::vector<FleetRequest> requests;
  std::unique_ptr<FleetServicePort> port;
};

struct Client {
  explicit Client(World& world) : port(world.join()) {}

  void take_all() {
    while (auto one = port->take()) news.push_back(std::move(*one));
  }
  void pause() const { port->wait(1ms); }

  template <typename Kind>
  std::vector<Kind> received() const {
    std::vector<Kind> out;
    for (const FleetNews& one : news) {
      if (const auto* kind = std::get_if<Kind>(&one)) out.push_back(*kind);
    }
    return out;
  }

  std::vector<FleetNews> news;
  std::unique_ptr<FleetClientPort> port;
};

// Lets everybody take what comes until something holds.
template <typename Holds, typename... Parties>
bool until(const Holds& holds, Parties&... parties) {
  const auto end = Clock::now() + kPatience;
  while (true) {
    (parties.take_all(), ...);
    if (holds()) return true;
    if (Clock::now() > end) return false;
    (parties.pause(), ...);
  }
}

template <typename... Parties>
void listen(Clock::duration time, Parties&... parties) {
  const auto end = Clock::now() + time;
  until([&] { return Clock::now() > end; }, parties...);
}

[[noreturn]] void broken(const std::string& what) {
  throw std::runtime_error(what);
}

void require(bool holds, const char* what) {
  if (!holds) broken(what);
}

void find_service(Client& client) {
  require(until([&] { return client.port->has_service(); }, client), "the service never appeared");
}

// Until the service has found the client, too: it does not say so, but what it says arrives.
void meet(Service& service, Client& client) {
  find_service(client);
  std::string last;
  const auto hears = [&] {
    last = std::string(kProbe) + std::to_string(++service.probes);
    service.port->publish(plan_of(last, 1, 1));
    return !client.news.empty();
  };
  require(until(hears, client, service), "the service never found a client");
  const auto hears_last = [&] {
    const auto plans = client.received<FinishedPlan>();
    return !plans.empty() && plans.back().id == last;
  };
  require(until(hears_last, client, service), "a plan never came");
  listen(kQuiet / 4, service, client);
  client.news.clear();
}

void deliver(Client& client, Service& service, const FleetRequest& request) {
  const std::size_t before = service.requests.size();
  require(until([&] { return client.port->send(request); }, client, service),
          "a request could not be sent");
  require(until([&] { return service.requests.size() > before; }, client, service),
          "a request never came");
}

// What news is compared by: all there is in it.
bool same(const FleetNews& a, const FleetNews& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        const Kind& other = std::get<Kind>(b);
        if constexpr (std::is_same_v<Kind, FinishedPlan>) {
          return kind.id == other.id && bits_of(kind.plan) == bits_of(other.plan);
        } else {
          return kind == other;
        }
      },
      a);
}

bool has(const Client& client, const FleetNews& news) {
  return std::ranges::any_of(client.news, [&](const FleetNews& one) { return same(one, news); });
}

// Any bytes, or any but zero.
std::string noise(std::size_t bytes) {
  std::string out(bytes, ' ');
  for (std::size_t i = 0; i < bytes; ++i) out[i] = static_cast<char>(i * 2654435761U >> 13U);
  return out;
}
std::string text(std::size_t bytes) {
  std::string out = noise(bytes);
  std::ranges::replace(out, '\0', '0');
  return out;
}

// ---- Requests ----

void requests_arrive_as_they_were(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  for (const FleetRequest& request : fleet_samples::requests()) {
    service.requests.clear();
    deliver(client, service, request);
    require(service.requests.size() == 1, "a request came more than once");
    require(service.requests.front() == request, "a request was changed");
  }
  require(service.port->counters().received == 4 && client.port->counters().sent == 4,
          "requests were not counted");
}

void a_large_scene_arrives_whole(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  PlanRequest request;
  request.id = "large";
  request.scene_text = text(limits::kSceneBytes);
  request.attachments = {{"map.pgm", noise(std::size_t{10} << 20U)}};
  deliver(client, service, request);
  require(service.requests.front() == FleetRequest(request), "a large request was changed");
}

void every_request_of_a_burst_arrives(World& world) {
  constexpr std::size_t kMany = 300;
  Service service(world);
  Client first(world);
  Client second(world);
  meet(service, first);
  meet(service, second);
  PlanRequest request;
  request.scene_text = text(10'000);
  for (std::size_t i = 0; i < kMany; ++i) {
    for (Client* client : {&first, &second}) {
      request.id = (client == &first ? "a" : "b") + std::to_string(i);
      require(until([&] { return client->port->send(request); }, service),
              "a request could not be sent");
    }
  }
  // Until nothing has come for a while.
  for (std::size_t before = SIZE_MAX; before != service.requests.size();) {
    before = service.requests.size();
    listen(10 * kQuiet, service);
  }
  require(service.requests.size() == 2 * kMany, "not every request came, each once");
}

void a_request_wakes_the_service(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  listen(kQuiet, service, client);
  const int before = service.wakes;
  require(client.port->send(CancelRequest{"1"}), "a request could not be sent");
  const auto end = Clock::now() + kPatience;
  while (service.wakes == before && Clock::now() < end) service.pause();
  require(service.wakes > before, "the service was not woken");
  require(service.port->take() == FleetRequest(CancelRequest{"1"}), "it was woken too early");
}

void nothing_is_sent_where_no_service_is(World& world) {
  Client client(world);
  Client other(world);
  listen(kQuiet, client, other);
  require(!client.port->has_service(), "there is a service where there is none");
  require(!client.port->send(CancelRequest{"1"}), "a request was sent to nobody");
}

void what_is_too_large_is_not_sent(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  PlanRequest request;
  request.scene_text = text(limits::kSceneBytes + 1);
  require(!client.port->send(request), "a request beyond a limit was sent");
  FinishedPlan plan = plan_of("1", 2, 2);
  plan.plan.robots[0].segments[0].robots = {"nobody"};
  service.port->publish(plan);
  service.port->publish(RequestReply{std::string(kFleetIdBytes + 1, 'a'), true, {}, {}, {}});
  listen(kQuiet, service, client);
  require(client.news.empty(), "news beyond a limit was sent");
  require(service.port->counters().unsent == 2, "it was not counted");
}

// ---- News ----

void every_kind_of_news_arrives_as_it_was(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  for (const FleetNews& news : fleet_samples::news()) {
    client.news.clear();
    service.port->publish(news);
    require(until([&] { return !client.news.empty(); }, client, service), "news never came");
    require(client.news.size() == 1, "news came more than once");
    require(same(client.news.front(), news), "news was changed");
  }
}

void news_of_a_kind_keeps_its_order(World& world) {
  constexpr std::uint32_t kMany = 200;
  Service service(world);
  Client client(world);
  meet(service, client);
  RequestState state;
  for (state.ahead = 0; state.ahead < kMany; ++state.ahead) service.port->publish(state);
  until([&] { return client.news.size() >= kMany; }, client, service);
  const auto received = client.received<RequestState>();
  require(received.size() == kMany, "not all news came, each once");
  for (std::uint32_t i = 0; i < kMany; ++i) {
    require(received[i].ahead == i, "news came out of order");
  }
}

void a_plan_without_paths_arrives(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  FinishedPlan plan{"1", {}};
  plan.plan.status = PlanStatus::kInfeasible;
  plan.plan.message = "\"agv3\" cannot reach its goal";
  service.port->publish(plan);
  require(until([&] { return !client.news.empty(); }, client, service), "the plan never came");
  require(has(client, plan), "the plan was changed");
}

void a_path_of_many_pieces_arrives(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  const FinishedPlan plan = plan_of("long", 2, 30'000);
  service.port->publish(plan);
  require(until([&] { return !client.news.empty(); }, client, service), "the plan never came");
  require(has(client, plan), "the plan was changed");
}

void a_plan_of_a_thousand_robots_arrives_to_the_bit(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  const FinishedPlan plan = plan_of("fleet", 1000, 200);
  const auto begin = Clock::now();
  service.port->publish(plan);
  require(Clock::now() - begin < 1s, "publishing blocked");
  require(until([&] { return !client.news.empty(); }, client, service), "the plan never came");
  require(has(client, plan), "the plan was changed");
  require(to_json(client.received<FinishedPlan>().front().plan) == to_json(plan.plan),
          "the plan has another JSON");
}

void many_plans_arrive_once_each(World& world) {
  constexpr std::size_t kMany = 50;
  Service service(world);
  Client client(world);
  meet(service, client);
  for (std::size_t i = 0; i < kMany; ++i) service.port->publish(plan_of(std::to_string(i), 16, 30));
  until([&] { return client.news.size() >= kMany; }, client, service);
  require(client.news.size() == kMany, "not every plan came, each once");
  for (std::size_t i = 0; i < kMany; ++i) {
    require(has(client, plan_of(std::to_string(i), 16, 30)), "a plan was changed");
  }
}

void all_clients_hear_the_same(World& world) {
  Service service(world);
  Client first(world);
  Client second(world);
  meet(service, first);
  meet(service, second);
  std::vector<FleetNews> news = fleet_samples::news();
  news.emplace_back(plan_of("1", 16, 30));
  for (const FleetNews& one : news) service.port->publish(one);
  for (const FleetNews& one : news) {
    require(until([&] { return has(first, one) && has(second, one); }, first, second, service),
            "news did not come to both as it was");
  }
}

// ---- Coming later, asking again ----

RequestState finished(const std::string& id) {
  RequestState out;
  out.id = id;
  out.phase = RequestPhase::kFinished;
  return out;
}

void answer_resends(Service& service, const FinishedPlan& plan) {
  for (const FleetRequest& request : std::exchange(service.requests, {})) {
    if (request == FleetRequest(ResendRequest{plan.id})) service.port->publish(plan);
  }
}

void who_comes_later_hears_the_latest_and_asks_for_plans(World& world) {
  Service service(world);
  Client early(world);
  meet(service, early);
  const FinishedPlan plan = plan_of("1", 16, 30);
  std::vector<FleetNews> latest = fleet_samples::news();
  latest.emplace_back(ServiceStatus{"0.1.0", "host", 1, 1, 0, 0, 0, 0, 0, true});
  for (const FleetNews& one : latest) service.port->publish(one);
  service.port->publish(plan);
  require(until([&] { return has(early, plan) && has(early, latest.back()); }, early, service),
          "news never came");
  Client late(world);
  find_service(late);
  require(until([&] { return has(late, latest.back()); }, late, service),
          "who came later was not told how the service is");
  const auto is_old = [&](const FleetNews& one) {
    const bool is_status = std::holds_alternative<ServiceStatus>(one);
    return std::holds_alternative<RequestReply>(one) || (is_status && !same(one, latest.back()));
  };
  const auto told = latest.size() - static_cast<std::size_t>(std::ranges::count_if(latest, is_old));
  until([&] { return late.news.size() >= told; }, late, service);
  listen(kQuiet, late, service);
  for (const FleetNews& one : latest) {
    require(has(late, one) != is_old(one),
            "who came later was not told the latest, and that alone");
  }
  require(late.received<FinishedPlan>().empty(), "an old plan came unasked");
  deliver(late, service, ResendRequest{"1"});
  require(service.requests.back() == FleetRequest(ResendRequest{"1"}), "asking was changed");
  service.port->publish(finished("1"));
  service.port->publish(plan);
  const auto has_plan = [&] {
    answer_resends(service, plan);
    return has(late, plan);
  };
  require(until(has_plan, late, service), "the plan never came");
  listen(kQuiet, early, late, service);
  require(early.received<FinishedPlan>().size() == 1, "a plan came again to who had not asked");
}

void a_plan_asked_for_again_is_given_again(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  const FinishedPlan plan = plan_of("1", 16, 30);
  for (std::size_t times = 1; times <= 3; ++times) {
    deliver(client, service, ResendRequest{"1"});
    service.port->publish(plan);
    require(until([&] { return client.received<FinishedPlan>().size() == times; }, client, service),
            "a plan that was asked for never came");
  }
}

void who_never_takes_holds_nobody_up(World& world) {
  Service service(world);
  Client deaf(world);
  Client keen(world);
  meet(service, deaf);
  meet(service, keen);
  Clock::duration longest{0};
  RequestState state;
  for (state.ahead = 0; state.ahead < 5'000; ++state.ahead) {
    const auto begin = Clock::now();
    service.port->publish(state);
    if (state.ahead % 100 == 0) {
      service.port->publish(plan_of(std::to_string(state.ahead), 100, 30));
    }
    longest = std::max(longest, Clock::now() - begin);
    keen.take_all();
  }
  require(longest < 500ms, "publishing blocked");
  const FinishedPlan last = plan_of("last", 16, 30);
  service.port->publish(last);
  require(until([&] { return has(keen, last); }, keen, service),
          "who does not take holds others up");
  // And it still gets what is new.
  require(until([&] { return has(deaf, last); }, deaf, service),
          "who took late never gets anything again");
}

void a_plan_that_is_there_and_does_not_come_is_asked_for(World& world) {
  Service service(world);
  Client client(world);
  Client bystander(world);
  meet(service, client);
  find_service(bystander);
  PlanRequest request;
  request.id = "1";
  deliver(client, service, request);
  service.requests.clear();
  service.port->publish(finished("1"));
  require(until([&] { return service.requests.size() >= 2; }, client, bystander, service),
          "a plan that did not come was not asked for");
  require(service.requests.front() == FleetRequest(ResendRequest{"1"}),
          "something else was asked for");
  const FinishedPlan plan = plan_of("1", 16, 30);
  service.port->publish(plan);
  require(until([&] { return has(client, plan); }, client, bystander, service),
          "the plan never came");
  require(bystander.port->counters().sent == 0 && client.port->counters().sent == 1,
          "what a port asks by itself is counted");
}

void a_service_that_comes_back_is_found(World& world) {
  Client client(world);
  for (int round = 0; round < 3; ++round) {
    Service service(world);
    find_service(client);
    const FinishedPlan plan = plan_of(std::to_string(round), 16, 30);
    deliver(client, service, ResendRequest{plan.id});
    service.port->publish(finished(plan.id));
    service.port->publish(plan);
    const auto has_plan = [&] {
      answer_resends(service, plan);
      return has(client, plan);
    };
    require(until(has_plan, client, service), "the plan never came");
    service.port.reset();
    require(until([&] { return !client.port->has_service(); }, client), "it was never lost");
  }
}

void waiting_ends_when_something_comes(World& world) {
  Service service(world);
  Client client(world);
  meet(service, client);
  listen(kQuiet, client, service);
  const auto begin = Clock::now();
  std::thread other([&] {
    std::this_thread::sleep_for(20ms);
    service.port->publish(RequestState{});
  });
  while (!client.port->take() && Clock::now() - begin < kPatience) client.port->wait(kPatience);
  other.join();
  require(Clock::now() - begin < 5s, "the wait did not end");
  client.take_all();
  const auto again = Clock::now();
  client.port->wait(30ms);
  require(Clock::now() - again < 5s, "the wait did not end in time");
}

// Runs a check that says what is broken by throwing.
Check check(std::string name, void (*run)(World&)) {
  return {std::move(name), [run](World& world) -> Breach {
            try {
              run(world);
            } catch (const std::runtime_error& found) {
              return found.what();
            }
            return {};
          }};
}

}  // namespace

const std::vector<Check>& checks() {
  static const std::vector<Check> all{
      check("RequestsArriveAsTheyWere", requests_arrive_as_they_were),
      check("ALargeSceneArrivesWhole", a_large_scene_arrives_whole),
      check("EveryRequestOfABurstArrives", every_request_of_a_burst_arrives),
      check("ARequestWakesTheService", a_request_wakes_the_service),
      check("NothingIsSentWhereNoServiceIs", nothing_is_sent_where_no_service_is),
      check("WhatIsTooLargeIsNotSent", what_is_too_large_is_not_sent),
      check("EveryKindOfNewsArrivesAsItWas", every_kind_of_news_arrives_as_it_was),
      check("NewsOfAKindKeepsItsOrder", news_of_a_kind_keeps_its_order),
      check("APlanWithoutPathsArrives", a_plan_without_paths_arrives),
      check("APathOfManyPiecesArrives", a_path_of_many_pieces_arrives),
      check("APlanOfAThousandRobotsArrivesToTheBit",
            a_plan_of_a_thousand_robots_arrives_to_the_bit),
      check("ManyPlansArriveOnceEach", many_plans_arrive_once_each),
      check("AllClientsHearTheSame", all_clients_hear_the_same),
      check("WhoComesLaterHearsTheLatestAndAsksForPlans",
            who_comes_later_hears_the_latest_and_asks_for_plans),
      check("APlanAskedForAgainIsGivenAgain", a_plan_asked_for_again_is_given_again),
      check("WhoNeverTakesHoldsNobodyUp", who_never_takes_holds_nobody_up),
      check("APlanThatIsThereAndDoesNotComeIsAskedFor",
            a_plan_that_is_there_and_does_not_come_is_asked_for),
      check("AServiceThatComesBackIsFound", a_service_that_comes_back_is_found),
      check("WaitingEndsWhenSomethingComes", waiting_ends_when_something_comes),
  };
  return all;
}

const Check& check_named(const std::string& name) {
  return *std::ranges::find(checks(), name, &Check::name);
}

}  // namespace accord::fleet_contract
