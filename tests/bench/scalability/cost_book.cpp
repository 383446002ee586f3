#include "tests/bench/scalability/cost_book.h"

#include "common/io/wire/scene_hash.h"
#include "common/io/wire/subproblem_codec.h"
#include "tests/bench/scalability/cpu_clock.h"

namespace accord::bench {

const Entry& CostBook::of(const Attempt& attempt) {
  const SceneHash hash = hash_of(encode_subproblem(*attempt.subproblem));
  Key key{attempt.solvers, {hash.bytes.begin(), hash.bytes.end()}};
  const auto [place, is_new] = entries_.try_emplace(std::move(key));
  Entry& entry = place->second;
  if (!is_new) return entry;
  const std::atomic<bool> stop{false};
  const double begin = cpu_seconds();
  entry.resolution = worker_.solve(*attempt.subproblem, attempt.solvers, stop);
  entry.seconds = cpu_seconds() - begin;
  return entry;
}

}  // namespace accord::bench
