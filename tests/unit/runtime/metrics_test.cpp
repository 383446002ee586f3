// What Prometheus gets to read, and whether it gets it.
#include "common/runtime/metrics.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>

#include "common/runtime/metric_readings.h"
#include "common/runtime/metrics_server.h"
#include "common/runtime/process_metrics.h"

namespace accord {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// The whole answer to GET `path`, its head included.
std::string get(std::uint16_t port, const std::string& path) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  std::string answer;
  if (connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    const std::string request = "GET " + path + " HTTP/1.0\r\n\r\n";
    if (write(socket, request.data(), request.size()) > 0) {
      char bytes[4096];
      for (ssize_t n = 0; (n = read(socket, bytes, sizeof bytes)) > 0;) {
        answer.append(bytes, static_cast<std::size_t>(n));
      }
    }
  }
  close(socket);
  return answer;
}

TEST(Metrics, AreWrittenAsPrometheusReadsThem) {
  Metrics metrics;
  metrics.counter("tasks_total", "Tasks", {{"outcome", "done"}}).add(2);
  metrics.counter("tasks_total", "Tasks", {{"outcome", "done"}}).add();
  metrics.gauge("busy", "Busy threads").set(4);
  metrics.histogram("planning_seconds", "Planning", {0.1, 1}).observe(0.5);
  const std::string text = metrics.collect();
  EXPECT_THAT(text, HasSubstr("# HELP tasks_total Tasks\n# TYPE tasks_total counter\n"
                              "tasks_total{outcome=\"done\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("busy 4\n"));
  EXPECT_THAT(text, HasSubstr("planning_seconds_bucket{le=\"0.1\"} 0\n"
                              "planning_seconds_bucket{le=\"1\"} 1\n"
                              "planning_seconds_bucket{le=\"+Inf\"} 1\n"));
}

TEST(Metrics, FollowTotalsThatAreKeptElsewhere) {
  Metrics metrics;
  double total = 5;
  auto counter = metrics.counter("lost_total", "Lost");
  metrics.before_collection([&] { counter.raise_to(total); });
  EXPECT_THAT(metrics.collect(), HasSubstr("lost_total 5\n"));
  total = 3;
  EXPECT_THAT(metrics.collect(), HasSubstr("lost_total 5\n")) << "counters do not fall";
  total = 7;
  EXPECT_THAT(metrics.collect(), HasSubstr("lost_total 7\n"));
}

TEST(Metrics, FollowHistogramsThatAreKeptElsewhere) {
  Metrics metrics;
  auto histogram = metrics.histogram("time_seconds", "Time", {0.1, 1});
  histogram.raise_to({2, 1, 0}, 0.9);
  histogram.raise_to({2, 3, 1}, 8.5);
  EXPECT_THAT(metrics.collect(), HasSubstr("time_seconds_count 6\ntime_seconds_sum 8.5\n"
                                           "time_seconds_bucket{le=\"0.1\"} 2\n"
                                           "time_seconds_bucket{le=\"1\"} 5\n"
                                           "time_seconds_bucket{le=\"+Inf\"} 6\n"));
}

TEST(Metrics, ReadTotalsOnceForAllThatIsReadOffThem) {
  struct Totals {
    double rounds = 0;
    TimeHistogram times;
  };
  int copies = 0;
  Metrics metrics;
  MetricReadings<Totals> add(metrics, [&] {
    ++copies;
    Totals totals{7, {}};
    totals.times.add(0.01);
    totals.times.add(1e6);
    return totals;
  });
  add.counter("rounds_total", "Rounds", {}, [](const Totals& t) { return t.rounds; });
  add.gauge("rounds", "Rounds", {}, [](const Totals& t) { return t.rounds + 1; });
  add.histogram("time_seconds", "Time", {}, [](const Totals& t) { return t.times; });
  const std::string text = metrics.collect();
  EXPECT_EQ(copies, 1);
  EXPECT_THAT(text, HasSubstr("rounds_total 7\n"));
  EXPECT_THAT(text, HasSubstr("rounds 8\n"));
  EXPECT_THAT(text, HasSubstr("time_seconds_bucket{le=\"0.005\"} 0\n"
                              "time_seconds_bucket{le=\"0.01\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("time_seconds_bucket{le=\"5000\"} 1\n"
                              "time_seconds_bucket{le=\"+Inf\"} 2\n"));
}

TEST(TimeHistogram, TakesATimeThatRanBackwardsForNone) {
  TimeHistogram times;
  times.add(-1);
  EXPECT_EQ(times.counts.front(), 1U);
  EXPECT_EQ(times.sum, 0);
}

TEST(ProcessMetrics, AreThoseOfThisProcess) {
  Metrics metrics;
  add_process_metrics(metrics, "1.2.3");
  const std::string text = metrics.collect();
  EXPECT_THAT(text, HasSubstr("accord_build_info{version=\"1.2.3\"} 1\n"));
  EXPECT_THAT(text, ContainsRegex("\nprocess_cpu_seconds_total [0-9]"));  // none yet, maybe
  for (const char* name : {"process_resident_memory_bytes", "process_open_fds", "process_max_fds",
                           "process_start_time_seconds"}) {
    EXPECT_THAT(text, ContainsRegex(std::string("\n") + name + " [1-9]"));
  }
}

TEST(Metrics, RefuseNamesThatPrometheusDoesNotRead) {
  Metrics metrics;
  EXPECT_THROW(metrics.counter("no-name", "No"), std::invalid_argument);
}

TEST(MetricsServer, ServesMetricsAndProbes) {
  Metrics metrics;
  metrics.gauge("busy", "Busy threads").set(4);
  std::atomic<bool> is_ready = false;
  const auto server = MetricsServer::start(metrics, "127.0.0.1", 0,
                                           {[] { return true; }, [&] { return is_ready.load(); }});
  ASSERT_TRUE(server) << server.error();
  const std::uint16_t port = (*server)->port();
  EXPECT_THAT(get(port, "/metrics"), StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(get(port, "/metrics"), HasSubstr("\r\n\r\n# HELP busy"));
  EXPECT_THAT(get(port, "/healthz"), StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(get(port, "/readyz"), StartsWith("HTTP/1.1 503 Service Unavailable\r\n"));
  is_ready = true;
  EXPECT_THAT(get(port, "/readyz"), StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(get(port, "/etc/passwd"), HasSubstr("404 Not Found"));
}

TEST(MetricsServer, SaysWhyItCannotListen) {
  Metrics metrics;
  const auto first = MetricsServer::start(metrics, "127.0.0.1", 0, {});
  ASSERT_TRUE(first);
  const std::uint16_t port = (*first)->port();
  const auto second = MetricsServer::start(metrics, "127.0.0.1", port, {});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error(), "cannot serve metrics: cannot bind to 127.0.0.1:" +
                                std::to_string(port) + ": 98 (Address already in use)");
}

TEST(MetricsServer, FreesItsPortWhenItGoes) {
  Metrics metrics;
  auto server = MetricsServer::start(metrics, "127.0.0.1", 0, {});
  ASSERT_TRUE(server);
  const std::uint16_t port = (*server)->port();
  server->reset();
  EXPECT_EQ(get(port, "/healthz"), "");
}

}  // namespace
}  // namespace accord
