// Where discs and balls are when: their linear motions, filed by the places that they come near, so
// that a question about one place costs what happens there, not what happens anywhere.
// Not thread safe (holds scratch); one per thread.
#pragma once

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "common/model/shape.h"
#include "common/model/trajectory.h"

namespace accord {

// Where the centre of a disc or ball is in a configuration of its robot.
Vec3 to_point(ConfigurationView q);

class PointTraffic {
 public:
  // A robot's centre on a linear motion. t1 is infinite where it has parked for good.
  struct Piece {
    double t0, t1;  // s
    Vec3 position;  // m, at t0
    Vec3 velocity;  // m/s
    double radius;  // m
  };

  // Questions will be about places up to `room` (m, > 0) from where a robot's body is.
  explicit PointTraffic(double room);

  // Files a robot's path from `from` (s) until `until`; it parks at the path's end. `owner` names
  // it. Requires: `owner` is not there.
  void add(std::uint32_t owner, const Trajectory& path, double radius, double from = 0,
           double until = std::numeric_limits<double>::infinity());
  // Nothing happens when `owner` is not there.
  void remove(std::uint32_t owner);

  bool empty() const { return by_owner_.empty(); }

  // Appends all pieces that come within `room` of the segment from a to b between `since` and
  // `until` (s), and some that do not, each once, in an order that depends on nothing but what was
  // added and removed; with `only` those of owners o that only[o] holds for. Valid until the next
  // change.
  void near(const Vec3& a, const Vec3& b, double since, double until, const std::vector<char>* only,
            std::vector<const Piece*>& out) const;

 private:
  using Id = std::uint32_t;
  using Key = std::uint64_t;
  // A piece in a cell, with its times, so that most are passed over without a look at them. Those
  // of cells that share a bucket are one list.
  struct Entry {
    Key cell;
    double t0, t1;  // s
    Id id;
    std::uint32_t owner;
    std::uint32_t next;  // in the bucket
  };

  template <class Visit>
  void for_each_cell(const Vec3& a, const Vec3& b, double margin, const Visit& visit) const;
  void file(Id id, std::uint32_t owner);
  void file(const Entry& entry);
  void take_out(Id id);
  std::size_t bucket_of(Key cell) const;
  void widen();

  static constexpr double kCellsPerRoom = 2;

  double room_;
  double cell_;
  std::vector<Piece> pieces_;
  std::vector<Id> free_;  // of pieces_
  std::unordered_map<std::uint32_t, std::vector<Id>> by_owner_;
  std::vector<Entry> entries_;
  std::uint32_t spare_entries_;         // a list of them
  std::vector<std::uint32_t> buckets_;  // a power of two of them: the first entry of each
  unsigned bucket_bits_ = 0;
  mutable std::vector<std::uint32_t> seen_in_;  // by piece: the last call of near() that met it
  mutable std::uint32_t call_ = 0;
};

}  // namespace accord
