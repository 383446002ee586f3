#include "common/transport/fleet/path_assembly.h"

#include <utility>

namespace accord {

bool add_waypoints(const PathPiece& piece, Trajectory& out) {
  for (std::size_t i = 0; i < piece.times.size(); ++i) {
    if (!out.empty() && !(piece.times[i] > out.end_time())) return false;
    out.append(piece.times[i],
               ConfigurationView(piece.configurations).subspan(i * piece.dof, piece.dof));
  }
  return true;
}

std::optional<RobotPath> PathAssembly::add(PathPiece piece) {
  if (piece.robot != robot_) {
    ++malformed_;
    return std::nullopt;
  }
  if (!pieces_.empty()) {
    const PathPiece& other = pieces_.begin()->second;
    const bool is_same = piece.id == other.id && piece.version == other.version;
    // The same path in other pieces: of a service that was started since.
    if (!is_same || piece.pieces != other.pieces || piece.dof != other.dof) pieces_.clear();
  }
  const std::uint32_t pieces = piece.pieces;
  pieces_.insert_or_assign(piece.piece, std::move(piece));
  return pieces_.size() == pieces ? joined() : std::nullopt;
}

std::optional<RobotPath> PathAssembly::joined() {
  const auto pieces = std::exchange(pieces_, {});
  const PathPiece& first = pieces.begin()->second;
  RobotPath out{first.id, first.version, first.robot, Trajectory(first.dof), {}};
  for (const auto& [number, piece] : pieces) {
    if (!add_waypoints(piece, out.trajectory)) {
      ++malformed_;
      return std::nullopt;
    }
    out.segments.insert(out.segments.end(), piece.segments.begin(), piece.segments.end());
  }
  return out;
}

}  // namespace accord
