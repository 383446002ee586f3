// Serves over HTTP how a process does, for whoever watches over it:
//
//   /metrics   its Metrics, in Prometheus's text format
//   /healthz   200 while it is alive; 503: start it anew
//   /readyz    200 while it can do its work; 503: it cannot just now
//
// Without encryption or passwords: for a trusted network, or this machine alone.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <tl/expected.hpp>

namespace accord {

class Metrics;

class MetricsServer {
 public:
  // Called by the server's threads, several at once. Must not block or throw.
  struct Probes {
    std::function<bool()> is_alive = [] { return true; };
    std::function<bool()> is_ready = [] { return true; };
  };

  // Serves from now on, with threads of its own, which take the signal mask of the caller; until it
  // is destroyed, which takes up to 2 s, as civetweb looks up that seldom. `metrics` and what the
  // probes refer to must outlive it. The process ignores SIGPIPE from then on.
  //
  // `address`: IPv4 of this machine, 0.0.0.0 for all. `port`: 0 for any that is free. Says why it
  // cannot, as in
  // "cannot serve metrics: cannot bind to 127.0.0.1:9464: 98 (Address already in use)".
  static tl::expected<std::unique_ptr<MetricsServer>, std::string> start(Metrics& metrics,
                                                                         const std::string& address,
                                                                         std::uint16_t port,
                                                                         Probes probes);
  ~MetricsServer();
  MetricsServer(const MetricsServer&) = delete;
  MetricsServer& operator=(const MetricsServer&) = delete;

  std::uint16_t port() const;  // that it listens on

 private:
  struct Site;
  explicit MetricsServer(std::unique_ptr<Site> site);
  std::unique_ptr<Site> site_;
};

}  // namespace accord
