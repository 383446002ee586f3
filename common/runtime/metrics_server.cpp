#include "common/runtime/metrics_server.h"

#include <CivetServer.h>

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "common/runtime/metrics.h"

namespace accord {
namespace {

// One address that answers a GET with text that is made when it is asked for.
class Page final : public CivetHandler {
 public:
  struct Answer {
    int status;
    std::string text;
  };
  explicit Page(std::function<Answer()> answer) : answer_(std::move(answer)) {}

  using CivetHandler::handleGet;
  bool handleGet(CivetServer*, mg_connection* connection) override {
    const Answer answer = answer_();
    mg_printf(connection,
              "HTTP/1.1 %d %s\r\nContent-Type: text/plain; version=0.0.4; charset=utf-8\r\n"
              "Content-Length: %zu\r\nConnection: close\r\n\r\n",
              answer.status, answer.status == 200 ? "OK" : "Service Unavailable",
              answer.text.size());
    mg_write(connection, answer.text.data(), answer.text.size());
    return true;
  }

 private:
  std::function<Answer()> answer_;
};

Page::Answer answer_of(bool is_so) {
  return is_so ? Page::Answer{200, "ok\n"} : Page::Answer{503, "no\n"};
}

// The first thing that civetweb had to say while a server was being started by this thread: to an
// exception it gives only that it failed.
thread_local std::string first_message;

int keep_message(const mg_connection*, const char* message) {
  if (first_message.empty()) first_message = message;
  return 1;  // said
}

}  // namespace

struct MetricsServer::Site {
  Page metrics, health, readiness;
  std::optional<CivetServer> server;  // the first to go: it uses the pages

  Site(Metrics& of, Probes probes)
      : metrics([&of] {
          return Page::Answer{200, of.collect()};
        }),
        health([is_alive = std::move(probes.is_alive)] { return answer_of(is_alive()); }),
        readiness([is_ready = std::move(probes.is_ready)] { return answer_of(is_ready()); }) {}
};

tl::expected<std::unique_ptr<MetricsServer>, std::string> MetricsServer::start(
    Metrics& metrics, const std::string& address, std::uint16_t port, Probes probes) {
  const std::vector<std::string> options{
      "listening_ports",    address + ":" + std::to_string(port),
      "num_threads",        "2",
      "request_timeout_ms", "5000"};  // for whoever connects and says nothing
  CivetCallbacks callbacks;
  callbacks.log_message = keep_message;
  auto site = std::make_unique<Site>(metrics, std::move(probes));
  first_message.clear();
  try {
    site->server.emplace(options, &callbacks);
  } catch (const CivetException& error) {
    return tl::unexpected("cannot serve metrics: " +
                          (first_message.empty() ? error.what() : first_message));
  }
  site->server->addHandler("/metrics", site->metrics);
  site->server->addHandler("/healthz", site->health);
  site->server->addHandler("/readyz", site->readiness);
  return std::unique_ptr<MetricsServer>(new MetricsServer(std::move(site)));
}

MetricsServer::MetricsServer(std::unique_ptr<Site> site) : site_(std::move(site)) {}
MetricsServer::~MetricsServer() = default;

std::uint16_t MetricsServer::port() const {
  return static_cast<std::uint16_t>(site_->server->getListeningPorts().front());
}

}  // namespace accord
