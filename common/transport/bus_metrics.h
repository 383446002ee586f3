// What /metrics says of messages between coordinator and workers, at either end.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "common/runtime/metric_readings.h"
#include "common/transport/bus.h"

namespace accord {

inline constexpr const char* kMessagesHelp = "Messages on the topics of a bus, by topic";
inline constexpr const char* kMessageBytesHelp = "Bytes of messages on the topics of a bus, about";
inline constexpr const char* kMessagesDroppedHelp = "Messages that were dropped, by reason";

// Sent and received on one topic.
template <typename Totals>
void add_traffic_metrics(MetricReadings<Totals>& add, const std::string& bus,
                         const std::string& topic,
                         const std::function<Traffic(const Totals&)>& read) {
  const auto way = [&](const char* direction, std::uint64_t Traffic::*messages,
                       std::uint64_t Traffic::*bytes) {
    const Metrics::Labels labels{{"bus", bus}, {"topic", topic}, {"direction", direction}};
    add.counter("accord_messages_total", kMessagesHelp, labels,
                [=](const Totals& totals) { return static_cast<double>(read(totals).*messages); });
    add.counter("accord_message_bytes_total", kMessageBytesHelp, labels,
                [=](const Totals& totals) { return static_cast<double>(read(totals).*bytes); });
  };
  way("sent", &Traffic::sent, &Traffic::sent_bytes);
  way("received", &Traffic::received, &Traffic::received_bytes);
}

// All of a bus between coordinator and workers.
template <typename Totals>
void add_bus_metrics(MetricReadings<Totals>& add,
                     const std::function<BusCounters(const Totals&)>& read) {
  // In the order of Message, as the topics are called.
  constexpr std::array<const char*, kMessageKinds> kKinds{
      "tasks", "commands", "scenes", "announcements", "results", "heartbeats", "scene_requests"};
  const std::string bus = "workers";
  for (std::size_t kind = 0; kind < kMessageKinds; ++kind) {
    add_traffic_metrics<Totals>(add, bus, kKinds[kind],
                                [=](const Totals& totals) { return read(totals).kinds[kind]; });
  }
  const auto dropped = [&](const char* reason, std::uint64_t BusCounters::*count) {
    add.counter("accord_messages_dropped_total", kMessagesDroppedHelp,
                {{"bus", bus}, {"reason", reason}},
                [=](const Totals& totals) { return static_cast<double>(read(totals).*count); });
  };
  dropped("malformed", &BusCounters::malformed);
  dropped("foreign", &BusCounters::foreign);
  dropped("early", &BusCounters::early);
  add.counter("accord_links_full_total",
              "Times that a message had to wait since too much was on its way to a peer", {},
              [=](const Totals& totals) { return static_cast<double>(read(totals).full); });
}

}  // namespace accord
