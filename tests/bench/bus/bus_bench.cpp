// What the bus costs over DDS: discovery, round trips, tasks a second, between this process and a
// worker process of its own. Prints a table.
//
//   bus_bench [ROUNDS]
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "tests/contract/dds_world.h"

namespace {

using namespace accord;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Transport = DdsOptions::Transport;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

pid_t start_peer(const DdsOptions& options) {
  const pid_t child = fork();
  if (child != 0) return child;
  const std::string domain = std::to_string(options.domain);
  const char* transport = options.transport == Transport::kUdp ? "udp" : "shm";
  execl(ACCORD_BUS_PEER, ACCORD_BUS_PEER, domain.c_str(), options.cluster.c_str(), transport,
        nullptr);
  _exit(127);
}

class Session {
 public:
  explicit Session(const DdsOptions& options) {
    auto bus = make_dds_bus(Role::kCoordinator, options);
    if (!bus) {
      std::cerr << bus.error() << '\n';
      std::exit(1);
    }
    bus_ = std::move(*bus);
    const auto begin = Clock::now();
    child_ = start_peer(options);
    while (bus_->peers().empty()) step();
    discovery_ = seconds_since(begin);
    peer_ = bus_->peers().front();
  }
  ~Session() {
    bus_->publish(peer_, Command{Command::Kind::kForget, {}, {}, {}});
    for (int i = 0; i < 200 && !bus_->peers().empty(); ++i) step();
    if (!bus_->peers().empty()) kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  double discovery() const { return discovery_; }

  // Sends when there is room; takes what comes.
  void send(const TaskBatch& batch) {
    while (bus_->publish(peer_, batch) != Published::kSent) step();
  }
  void step() {
    bus_->wait_for_event(1ms);
    while (auto event = bus_->take()) {
      if (std::holds_alternative<Message>(event->what)) ++answers_;
    }
  }
  std::size_t answers() const { return answers_; }

 private:
  std::unique_ptr<Bus> bus_;
  EndpointId peer_;
  pid_t child_ = 0;
  double discovery_ = 0;
  std::size_t answers_ = 0;
};

TaskBatch batch_of(std::size_t bytes) {
  return {1, {}, {}, {{{1, 0}, Bytes(bytes, 3)}}};
}

std::vector<double> round_trips(Session& session, std::size_t bytes, int rounds) {
  const TaskBatch batch = batch_of(bytes);
  std::vector<double> out;
  for (int i = 0; i < rounds; ++i) {
    const std::size_t before = session.answers();
    const auto begin = Clock::now();
    session.send(batch);
    while (session.answers() == before) session.step();
    out.push_back(seconds_since(begin));
  }
  std::ranges::sort(out);
  return out;
}

double tasks_a_second(Session& session, std::size_t bytes, std::size_t count) {
  const TaskBatch batch = batch_of(bytes);
  const std::size_t before = session.answers();
  const auto begin = Clock::now();
  for (std::size_t i = 0; i < count; ++i) {
    session.send(batch);
    // So many in flight: a coordinator keeps a few ahead of each worker.
    while (i + 1 - (session.answers() - before) >= 16) session.step();
  }
  while (session.answers() - before < count) session.step();
  return static_cast<double>(count) / seconds_since(begin);
}

void measure(const char* name, Transport transport, int rounds) {
  DdsOptions options = local_dds(transport);
  options.segment_bytes = std::size_t{64} << 20;
  options.announcement = 200ms;
  Session session(options);
  std::printf("%-14s discovery with the process's start %.0f ms\n", name,
              1e3 * session.discovery());
  for (const std::size_t bytes : {1UL << 10, 1UL << 16, 1UL << 20, 1UL << 23}) {
    const int count = bytes > (1UL << 16) ? std::max(rounds / 20, 5) : rounds;
    const auto times = round_trips(session, bytes, count);
    std::printf("%-14s round trip of %5zu KiB: median %7.3f ms, p99 %7.3f ms, most %7.3f ms\n",
                name, bytes >> 10, 1e3 * times[times.size() / 2],
                1e3 * times[times.size() * 99 / 100], 1e3 * times.back());
  }
  for (const std::size_t bytes : {1UL << 10, 1UL << 14}) {
    std::printf("%-14s tasks of %3zu KiB, there and back: %.0f a second\n", name, bytes >> 10,
                tasks_a_second(session, bytes, static_cast<std::size_t>(10 * rounds)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 1000;
  measure("shared memory", Transport::kSharedMemory, rounds);
  measure("UDP", Transport::kUdp, rounds);
}
