#include "worker/path_shortening.h"

#include <algorithm>

#include "common/planning/random.h"
#include "worker/timed_shortcuts.h"

namespace accord {
namespace {

constexpr std::size_t kMostPlaces = 14;
constexpr int kRounds = 2;

// The path's places, with the middles of its longest motions while there is room.
std::vector<Configuration> places_of(const Team& team, const Trajectory& path) {
  std::vector<Configuration> places;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ConfigurationView q = path.configuration(i);
    if (!places.empty() && std::ranges::equal(places.back(), q)) continue;
    places.emplace_back(q.begin(), q.end());
  }
  const std::size_t bends = places.size();
  for (std::size_t i = 1; i < bends && places.size() < kMostPlaces; ++i) {
    Configuration middle(team.dof());
    for (std::size_t k = 0; k < middle.size(); ++k) {
      middle[k] = 0.5 * (places[i - 1][k] + places[i][k]);
    }
    places.push_back(std::move(middle));
  }
  return places;
}

}  // namespace

void shorten(Team& team, const SearchRequest& request, Trajectory& path,
             const std::atomic<bool>& stop, Effort& effort) {
  if (stop) return;
  if (path.size() > 3) {
    cut_corners(team, request.hold_until, combine({path.size(), team.size()}), path, effort);
  }
  for (int round = 0; round < kRounds; ++round) {
    if (path.size() < 3) return;  // one motion, at once
    const std::vector<Configuration> places = places_of(team, path);
    if (places.size() < 3 || places.size() > kMostPlaces) return;
    LocalRoadmap roadmap(team);
    roadmap.add(team, path.configuration(0), false);
    roadmap.add(team, path.configuration(path.size() - 1), false);
    for (const Configuration& place : places) roadmap.add(team, place);
    for (LocalRoadmap::Node a = 0; a < roadmap.size(); ++a) {
      for (LocalRoadmap::Node b = 0; b < a; ++b) roadmap.connect(team, a, b);
    }
    SearchRequest again = request;
    again.start = 0;
    again.goal = 1;
    ++effort.searches;
    auto found = safe_interval_search(team, roadmap, again, stop, effort.expansions);
    effort.motion_checks += roadmap.motion_checks();
    if (!found || found->end_time() >= path.end_time() - 1e-6) return;
    path = std::move(*found);
  }
}

}  // namespace accord
