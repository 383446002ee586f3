// Metrics that are read off totals which somebody keeps, all of them off the same copy at each
// collection.
//
//     MetricReadings<Totals> add(metrics, [&tally] { return tally.totals(); });
//     add.counter("accord_rounds_total", "Rounds", {}, [](const Totals& t) { return t.rounds; });
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/runtime/metrics.h"
#include "common/runtime/time_histogram.h"

namespace accord {

// Not thread safe; what it has added is read as Metrics says.
template <typename Totals>
class MetricReadings {
 public:
  using Labels = Metrics::Labels;
  template <typename Value>
  using Read = std::function<Value(const Totals&)>;

  // What `read` refers to must outlive `metrics`.
  MetricReadings(Metrics& metrics, std::function<Totals()> read)
      : metrics_(metrics), updates_(std::make_shared<Updates>()) {
    metrics.before_collection([updates = updates_, read = std::move(read)] {
      const Totals totals = read();
      for (const auto& update : *updates) update(totals);
    });
  }

  // As Metrics'. A total that has fallen stays as it was.
  void counter(const std::string& name, const std::string& help, const Labels& labels,
               Read<double> read) {
    updates_->push_back([counter = metrics_.counter(name, help, labels), read = std::move(read)](
                            const Totals& totals) mutable { counter.raise_to(read(totals)); });
  }
  void gauge(const std::string& name, const std::string& help, const Labels& labels,
             Read<double> read) {
    updates_->push_back([gauge = metrics_.gauge(name, help, labels), read = std::move(read)](
                            const Totals& totals) mutable { gauge.set(read(totals)); });
  }
  void histogram(const std::string& name, const std::string& help, const Labels& labels,
                 Read<TimeHistogram> read) {
    const std::vector<double> bounds(TimeHistogram::kBounds.begin(), TimeHistogram::kBounds.end());
    updates_->push_back([histogram = metrics_.histogram(name, help, bounds, labels),
                         read = std::move(read)](const Totals& totals) mutable {
      const TimeHistogram times = read(totals);
      histogram.raise_to({times.counts.begin(), times.counts.end()}, times.sum);
    });
  }

 private:
  using Updates = std::vector<std::function<void(const Totals&)>>;

  Metrics& metrics_;
  std::shared_ptr<Updates> updates_;
};

}  // namespace accord
