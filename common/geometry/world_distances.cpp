// How far, and how much room a motion takes.
#include <algorithm>

#include "common/geometry/count_on_exit.h"
#include "common/geometry/world_core.h"

namespace accord {

template <int D>
double WorldCore<D>::obstacle_distance(RobotId robot, ConfigurationView q, double cutoff) const {
  Work& work = begin(robot, q, q);
  const CountOnExit<D> counting(work, counter_);
  double best = cutoff;
  sweep_pieces(work);
  for (std::size_t i = 0; i < work.extents.size() && best > 0; ++i) {
    const Placed<D>& piece = work.first.piece(static_cast<int>(i));
    tree_.each_near(work.extents[i], best, [&](int fixed) {
      const Placed<D>& obstacle = fixed_[static_cast<std::size_t>(fixed)];
      if (solids_ && (contains(obstacle, piece) || contains(piece, obstacle))) best = 0;
      const double radii = piece.piece->radius + obstacle.piece->radius + rounding_;
      const double far = best + radii + piece.piece->bound + obstacle.piece->bound;
      if (best <= 0 || (obstacle.frame.t - piece.frame.t).squaredNorm() > far * far) return best;
      ++work.distances;
      const Wanted wanted{best + radii, radii, 1e-8, 0, false};
      const Gap<D> gap = accord::gap(piece, obstacle, wanted, Vec<D>(Vec<D>::Zero()));
      best = std::clamp(gap.distance - radii, 0.0, best);
      return best;
    });
  }
  return best;
}

template <int D>
double WorldCore<D>::separation(RobotId a, ConfigurationView qa, RobotId b, ConfigurationView qb,
                                double cutoff) const {
  Work& work = begin(a, qa, qa);
  const CountOnExit<D> counting(work, counter_);
  work.two = true;
  work.second.start(chains_[b.index()], qb, qb);
  work.move_to(0);
  double best = cutoff;
  for (std::size_t i = 0; i < work.first.chain().pieces().size(); ++i) {
    const Placed<D>& p = work.first.piece(static_cast<int>(i));
    for (std::size_t j = 0; j < work.second.chain().pieces().size(); ++j) {
      const Placed<D>& other = work.second.piece(static_cast<int>(j));
      const double radii = p.piece->radius + other.piece->radius + rounding_;
      const double far = best + radii + p.piece->bound + other.piece->bound;
      if ((other.frame.t - p.frame.t).squaredNorm() > far * far) continue;
      if (solids_ && (contains(p, other) || contains(other, p))) return 0;
      ++work.distances;
      const Wanted wanted{best + radii, radii, 1e-8, 0, false};
      const Gap<D> gap = accord::gap(p, other, wanted, Vec<D>(Vec<D>::Zero()));
      best = std::clamp(gap.distance - radii, 0.0, best);
      if (best <= 0) return 0;
    }
  }
  return best;
}

template <int D>
Extent<D> WorldCore<D>::swept_bounds(RobotId robot, ConfigurationView a,
                                     ConfigurationView b) const {
  const Chain<D>& chain = chains_[robot.index()];
  if (chain.radius() >= 0) return rough_extent(robot, a, b);
  Work& work = begin(robot, a, b);
  sweep_pieces(work);
  Extent<D> all = Extent<D>::nothing();
  for (std::size_t i = 0; i < chain.pieces().size(); ++i) all.merge(work.extents[i]);
  return all;
}

template double WorldCore<2>::obstacle_distance(RobotId, ConfigurationView, double) const;
template double WorldCore<3>::obstacle_distance(RobotId, ConfigurationView, double) const;
template double WorldCore<2>::separation(RobotId, ConfigurationView, RobotId, ConfigurationView,
                                         double) const;
template double WorldCore<3>::separation(RobotId, ConfigurationView, RobotId, ConfigurationView,
                                         double) const;
template Extent<2> WorldCore<2>::swept_bounds(RobotId, ConfigurationView, ConfigurationView) const;
template Extent<3> WorldCore<3>::swept_bounds(RobotId, ConfigurationView, ConfigurationView) const;

}  // namespace accord
