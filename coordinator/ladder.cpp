#include "coordinator/ladder.h"

#include <algorithm>
#include <utility>

namespace accord {

Ladder::Ladder(std::shared_ptr<const Subproblem> subproblem,
               std::vector<std::vector<std::string>> rungs)
    : subproblem_(std::move(subproblem)) {
  for (auto& solvers : rungs) rungs_.push_back({std::move(solvers), Stage::kOpen, 0, {}, {}});
}

std::optional<std::size_t> Ladder::needed() const {
  const auto lowest =
      std::ranges::find_if(rungs_, [](const Rung& rung) { return rung.stage != Stage::kFailed; });
  if (lowest == rungs_.end() || lowest->stage == Stage::kSolved) return std::nullopt;
  return static_cast<std::size_t>(lowest - rungs_.begin());
}

std::optional<std::size_t> Ladder::next_ahead() const {
  const auto lowest = needed();
  if (!lowest) return std::nullopt;
  for (std::size_t rung = *lowest + 1; rung < rungs_.size(); ++rung) {
    if (rungs_[rung].stage == Stage::kSolved) return std::nullopt;
    if (rungs_[rung].stage == Stage::kOpen) return rung;
  }
  return std::nullopt;
}

std::optional<Ticket> Ladder::ticket(std::size_t rung) const {
  if (rungs_[rung].stage != Stage::kBegun) return std::nullopt;
  return rungs_[rung].ticket;
}

void Ladder::begin(std::size_t rung, Ticket ticket) {
  rungs_[rung].stage = Stage::kBegun;
  rungs_[rung].ticket = ticket;
}

std::vector<Ticket> Ladder::end(std::size_t rung, Resolution resolution, Doer doer) {
  const bool solves = resolution.solved || resolution.improves();
  rungs_[rung].stage = solves ? Stage::kSolved : Stage::kFailed;
  rungs_[rung].resolution = std::move(resolution);
  rungs_[rung].doer = std::move(doer);
  std::vector<Ticket> moot;
  for (std::size_t above = rung + 1; solves && above < rungs_.size(); ++above) {
    if (const auto ticket = this->ticket(above)) moot.push_back(*ticket);
  }
  return moot;
}

std::optional<Resolution> Ladder::likely() const {
  const auto solved = std::ranges::find(rungs_, Stage::kSolved, &Rung::stage);
  if (solved != rungs_.end()) {
    Resolution resolution = solved->resolution;
    resolution.effort = {};
    return resolution;
  }
  const auto failed = std::ranges::count(rungs_, Stage::kFailed, &Rung::stage);
  const bool is_about_to_fail = rungs_.size() > 1 && failed + 1 == std::ssize(rungs_);
  if (is_about_to_fail || is_decided()) return Resolution{};
  return std::nullopt;
}

std::vector<Ladder::Climbed> Ladder::climbed() const {
  std::vector<Climbed> out;
  for (const Rung& rung : rungs_) {
    out.push_back({rung.solvers, rung.resolution, rung.doer});
    if (rung.stage == Stage::kSolved) break;
  }
  return out;
}

Resolution Ladder::take() {
  Effort effort;
  for (Rung& rung : rungs_) {
    effort += rung.resolution.effort;
    if (rung.stage != Stage::kSolved) continue;
    rung.resolution.effort = effort;
    return std::move(rung.resolution);
  }
  Resolution exhausted;
  exhausted.effort = effort;
  return exhausted;
}

}  // namespace accord
