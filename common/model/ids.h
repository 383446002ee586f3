// Strong ids: an index that cannot be mistaken for another kind of index.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace accord {

// A robot's place in Scene::robots, from 0.
struct RobotId {
  std::uint32_t value = 0;

  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(RobotId, RobotId) = default;
};

}  // namespace accord

template <>
struct std::hash<accord::RobotId> {
  std::size_t operator()(accord::RobotId id) const noexcept { return id.value; }
};
