#include "common/runtime/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include <mutex>
#include <sstream>
#include <utility>

namespace accord {

struct Metrics::Registry {
  prometheus::Registry metrics;
  std::mutex collecting;
  std::vector<std::function<void()>> updates;
};

void Metrics::Counter::add(double amount) {
  static_cast<prometheus::Counter*>(metric_)->Increment(amount);
}

void Metrics::Counter::raise_to(double total) {
  auto* counter = static_cast<prometheus::Counter*>(metric_);
  const double missing = total - counter->Value();
  if (missing > 0) counter->Increment(missing);
}

void Metrics::Gauge::set(double value) {
  static_cast<prometheus::Gauge*>(metric_)->Set(value);
}

void Metrics::Gauge::add(double amount) {
  static_cast<prometheus::Gauge*>(metric_)->Increment(amount);
}

void Metrics::Histogram::observe(double value) {
  static_cast<prometheus::Histogram*>(metric_)->Observe(value);
}

void Metrics::Histogram::raise_to(const std::vector<std::uint64_t>& counts, double sum) {
  auto* histogram = static_cast<prometheus::Histogram*>(metric_);
  const prometheus::ClientMetric::Histogram now = histogram->Collect().histogram;
  std::vector<double> missing;
  std::uint64_t below = 0;  // buckets there count what is in those below them, too
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::uint64_t there = now.bucket.at(i).cumulative_count - below;
    below += there;
    missing.push_back(counts[i] > there ? static_cast<double>(counts[i] - there) : 0);
  }
  histogram->ObserveMultiple(missing, sum - now.sample_sum);
}

Metrics::Metrics() : registry_(std::make_unique<Registry>()) {}
Metrics::~Metrics() = default;

Metrics::Counter Metrics::counter(const std::string& name, const std::string& help,
                                  const Labels& labels) {
  auto& family = prometheus::BuildCounter().Name(name).Help(help).Register(registry_->metrics);
  return Counter(&family.Add(labels));
}

Metrics::Gauge Metrics::gauge(const std::string& name, const std::string& help,
                              const Labels& labels) {
  auto& family = prometheus::BuildGauge().Name(name).Help(help).Register(registry_->metrics);
  return Gauge(&family.Add(labels));
}

Metrics::Histogram Metrics::histogram(const std::string& name, const std::string& help,
                                      const std::vector<double>& bounds, const Labels& labels) {
  auto& family = prometheus::BuildHistogram().Name(name).Help(help).Register(registry_->metrics);
  return Histogram(&family.Add(labels, bounds));
}

void Metrics::before_collection(std::function<void()> update) {
  const std::lock_guard lock(registry_->collecting);
  registry_->updates.push_back(std::move(update));
}

std::string Metrics::collect() {
  const std::lock_guard lock(registry_->collecting);
  for (const auto& update : registry_->updates) update();
  std::ostringstream text;
  prometheus::TextSerializer().Serialize(text, registry_->metrics.Collect());
  return text.str();
}

}  // namespace accord
