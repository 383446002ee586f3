#include "common/runtime/metrics_endpoint.h"

#include <civetweb.h>
#include <spdlog/spdlog.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <utility>

#include "common/io/files.h"

namespace accord {
namespace {

constexpr std::size_t kPortFileBytes = 16;
constexpr std::size_t kAnswerBytes = 4096;

// Whole or not at all: whoever reads it may do so at any time.
tl::expected<void, std::string> write_port(const std::string& path, std::uint16_t port) {
  const std::string draft = path + ".new";
  std::error_code fault;
  {
    std::ofstream file(draft, std::ios::trunc);
    file << port << "\n";
    if (!file.flush()) return tl::unexpected("cannot write " + path_in_quotes(draft));
  }
  std::filesystem::rename(draft, path, fault);
  if (!fault) return {};
  return tl::unexpected("cannot write " + path_in_quotes(path) + ": " + fault.message());
}

class Connection {
 public:
  explicit Connection(mg_connection* connection) : connection_(connection) {}
  ~Connection() {
    if (connection_ != nullptr) mg_close_connection(connection_);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  mg_connection* get() const { return connection_; }

 private:
  mg_connection* connection_;
};

std::string body_of(mg_connection* connection) {
  std::string body;
  std::array<char, 512> part{};
  while (body.size() < kAnswerBytes) {
    const int size = mg_read(connection, part.data(), part.size());
    if (size <= 0) break;
    body.append(part.data(), static_cast<std::size_t>(size));
  }
  if (body.ends_with('\n')) body.pop_back();
  return body;
}

}  // namespace

tl::expected<std::unique_ptr<MetricsServer>, std::string> serve_metrics(
    const MetricsOptions& options, Metrics& metrics, MetricsServer::Probes probes) {
  if (!options.port) return nullptr;
  auto server = MetricsServer::start(metrics, options.address, *options.port, std::move(probes));
  if (!server) return server;
  const std::uint16_t port = (*server)->port();
  if (!options.port_file.empty()) {
    const auto written = write_port(options.port_file, port);
    if (!written) return tl::unexpected(written.error());
  }
  spdlog::info("metrics at http://{}:{}/metrics", options.address, port);
  return server;
}

tl::expected<std::uint16_t, std::string> metrics_port_of(const MetricsOptions& options) {
  if (options.port.value_or(0) > 0) return *options.port;
  if (options.port_file.empty()) {
    return tl::unexpected(
        std::string("expected the port of its metrics, or the file where it is written"));
  }
  const auto text = read_file(options.port_file, kPortFileBytes);
  if (!text) return tl::unexpected(text.error());
  std::uint16_t port = 0;
  const auto [end, fault] = std::from_chars(text->data(), text->data() + text->size(), port);
  const bool is_whole = std::string_view(end, text->data() + text->size()) == "\n";
  if (fault == std::errc() && is_whole && port > 0) return port;
  return tl::unexpected(path_in_quotes(options.port_file) + " holds no port");
}

tl::expected<HealthAnswer, std::string> ask_health(const std::string& address, std::uint16_t port,
                                                   const std::string& path,
                                                   std::chrono::milliseconds patience) {
  const std::string place = address + ":" + std::to_string(port);
  std::array<char, 256> why{};
  const Connection connection(mg_connect_client(address.c_str(), port, 0, why.data(), why.size()));
  if (connection.get() == nullptr) {
    return tl::unexpected("nobody answers at " + place + ": " + why.data());
  }
  mg_printf(connection.get(), "GET %s HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n\r\n",
            path.c_str(), place.c_str());
  const int timeout = static_cast<int>(patience.count());
  if (mg_get_response(connection.get(), why.data(), why.size(), timeout) < 0) {
    return tl::unexpected("no answer from " + place + ": " + why.data());
  }
  const mg_response_info* answer = mg_get_response_info(connection.get());
  if (answer->status_code != 200 && answer->status_code != 503) {
    return tl::unexpected(place + " answers with " + std::to_string(answer->status_code) +
                          "; expected a service of Accord there");
  }
  return HealthAnswer{answer->status_code == 200, body_of(connection.get())};
}

}  // namespace accord
