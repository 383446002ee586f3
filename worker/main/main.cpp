// accord-worker: solves subproblems for a coordinator on the same DDS domain.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <mutex>
#include <new>
#include <string>
#include <thread>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "common/io/limits.h"
#include "common/transport/dds_bus.h"
#include "worker/service/worker_loop.h"

namespace {

enum ExitCode { kEnded = 0, kBug = 1, kUsage = 2, kNoBus = 3 };

struct Options {
  accord::DdsOptions dds;
  unsigned threads = 1;
  spdlog::level::level_enum log = spdlog::level::info;
};

const std::map<std::string, accord::DdsOptions::Transport> kTransports{
    {"shm", accord::DdsOptions::Transport::kSharedMemory},
    {"udp", accord::DdsOptions::Transport::kUdp},
    {"both", accord::DdsOptions::Transport::kBoth}};

const std::map<std::string, spdlog::level::level_enum> kLevels{{"debug", spdlog::level::debug},
                                                               {"info", spdlog::level::info},
                                                               {"warning", spdlog::level::warn},
                                                               {"error", spdlog::level::err},
                                                               {"off", spdlog::level::off}};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--threads", options.threads, "Subproblems solved at once")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--domain", options.dds.domain, "DDS domain")
      ->check(CLI::Range(0, 232))
      ->capture_default_str();
  app.add_option("--cluster", options.dds.cluster, "Only processes of one cluster work together")
      ->capture_default_str();
  app.add_option("--transport", options.dds.transport, "How messages travel")
      ->transform(CLI::CheckedTransformer(kTransports))
      ->default_str("both");
  app.add_option("--interface", options.dds.interfaces,
                 "IPv4 address of this machine to use; all, unless given")
      ->take_all();
  app.add_option("--log", options.log, "Least level of what is logged to stderr")
      ->transform(CLI::CheckedTransformer(kLevels))
      ->default_str("info");
}

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

accord::TaskDesk::Settings settings_of(const Options& options) {
  accord::TaskDesk::Settings settings;
  settings.info.version = ACCORD_VERSION;
  settings.info.host = host_name();
  settings.info.process = static_cast<std::uint32_t>(getpid());
  settings.info.threads = options.threads;
  settings.info.task_bytes = accord::limits::kSubproblemBytes;
  settings.info.scene_bytes = accord::limits::kSceneWireBytes;
  return settings;
}

// Signals that ask the process to end, taken by one thread of their own.
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  return signals;
}

// The loop that is at work now, for the thread that takes signals.
class Present {
 public:
  // nullptr: none. A loop that comes after a signal drains at once.
  void set(accord::WorkerLoop* loop) {
    const std::lock_guard lock(mutex_);
    loop_ = loop;
    if (loop_ != nullptr && is_over_) loop_->drain();
  }
  void drain() {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    if (loop_ != nullptr) loop_->drain();
  }

 private:
  std::mutex mutex_;
  accord::WorkerLoop* loop_ = nullptr;
  bool is_over_ = false;
};

// Joins the bus and works; again, where it has been forgotten.
int work(const Options& options, Present& present) {
  while (true) {
    auto bus = accord::make_dds_bus(accord::Role::kWorker, options.dds);
    if (!bus) {
      std::cerr << "accord-worker: " << bus.error() << "\n";
      return kNoBus;
    }
    spdlog::info("worker {} with {} threads in domain {}, cluster {}", to_string((*bus)->self()),
                 options.threads, options.dds.domain, options.dds.cluster);
    accord::WorkerLoop loop(**bus, settings_of(options));
    present.set(&loop);
    const auto end = loop.run();
    present.set(nullptr);
    if (end == accord::WorkerLoop::End::kDrained) return kEnded;
    spdlog::info("no coordinator answers any more: joins anew");
  }
}

int run(int argc, char** argv) {
  CLI::App app("Solves subproblems for an Accord coordinator.", "accord-worker");
  app.set_version_flag("--version", ACCORD_VERSION);
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kEnded : kUsage;
  }
  spdlog::set_default_logger(spdlog::stderr_color_mt("worker"));
  spdlog::set_level(options.log);

  const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // for all threads to come
  Present present;
  std::thread listener([&] {
    int signal = 0;
    sigwait(&signals, &signal);
    present.drain();
  });
  const int code = work(options, present);
  pthread_kill(listener.native_handle(), SIGTERM);  // where it ended for another reason
  listener.join();
  spdlog::info("ended");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "accord-worker: out of memory\n";
  } catch (const std::exception& error) {
    std::cerr << "accord-worker: internal error: " << error.what()
              << "\nThis is a bug in accord. Please report it.\n";
  }
  return kBug;
}
