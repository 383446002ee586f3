#include "worker/main/worker_settings.h"

#include "common/transport/dds_settings.h"

namespace accord {

Settings worker_table(WorkerSettings& settings) {
  Settings table;
  table
      .add("threads", "--threads", settings.threads, whole_number(1U, 1024U),
           "Subproblems solved at once")
      .initial = kOneForEachCore;
  add_dds_settings(table, settings.dds);
  add_log_settings(table, settings.log);
  add_metrics_settings(table, settings.metrics);
  return table;
}

}  // namespace accord
