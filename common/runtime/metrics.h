// What a process counts and measures, for Prometheus: named counters, gauges and histograms, with
// labels. MetricsServer (metrics_server.h) serves them.
//
// Thread safe. Handles are cheap to copy and to use; they must not outlive the Metrics they are of.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace accord {

class Metrics {
 public:
  // {"outcome", "solved"}. Few values each: every combination is kept for good.
  using Labels = std::map<std::string, std::string>;

  class Counter {
   public:
    void add(double amount = 1);  // requires: amount >= 0
    // For totals that are kept elsewhere; one below the last is left out. From one thread at a
    // time.
    void raise_to(double total);

   private:
    friend class Metrics;
    explicit Counter(void* metric) : metric_(metric) {}
    void* metric_;
  };

  class Gauge {
   public:
    void set(double value);
    void add(double amount);

   private:
    friend class Metrics;
    explicit Gauge(void* metric) : metric_(metric) {}
    void* metric_;
  };

  class Histogram {
   public:
    void observe(double value);
    // For counts that are kept elsewhere: by bucket, one more than there are bounds, and the sum of
    // what was observed. Buckets that have fewer than before are left out. From one thread at a
    // time.
    void raise_to(const std::vector<std::uint64_t>& counts, double sum);

   private:
    friend class Metrics;
    explicit Histogram(void* metric) : metric_(metric) {}
    void* metric_;
  };

  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  // Asked again for the same name and labels, they return the same one. Names are Prometheus's: of
  // letters, digits and '_', with the unit at the end, and "_total" for counters:
  // accord_tasks_total, accord_planning_seconds. `help`: a sentence. Requires: a name has one type,
  // one help and, as a histogram, one set of buckets; throws std::invalid_argument for a name or a
  // label that is none.
  Counter counter(const std::string& name, const std::string& help, const Labels& labels = {});
  Gauge gauge(const std::string& name, const std::string& help, const Labels& labels = {});
  // `bounds`: upper ones of the buckets, ascending; beyond the last one there is one more.
  Histogram histogram(const std::string& name, const std::string& help,
                      const std::vector<double>& bounds, const Labels& labels = {});

  // Called before every collection, by one thread at a time: for what is rather read off now than
  // kept up to date. Must not call collect() or before_collection().
  void before_collection(std::function<void()> update);

  // All of it, as Prometheus reads it.
  std::string collect();

 private:
  struct Registry;
  std::unique_ptr<Registry> registry_;
};

}  // namespace accord
