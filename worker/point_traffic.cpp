#include "worker/point_traffic.h"

#include <algorithm>
#include <cmath>

namespace accord {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr unsigned kFirstBucketBits = 8;

std::uint64_t key_of(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(x) << 32U) ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
}

Vec3 end_of(const PointTraffic::Piece& piece) {
  if (std::isinf(piece.t1)) return piece.position;
  return piece.position + (piece.t1 - piece.t0) * piece.velocity;
}

}  // namespace

PointTraffic::PointTraffic(double room)
    : room_(room),
      cell_(kCellsPerRoom * room),
      spare_entries_(kNone),
      buckets_(std::size_t{1} << kFirstBucketBits, kNone),
      bucket_bits_(kFirstBucketBits) {}

Vec3 to_point(ConfigurationView q) {
  return {q[0], q[1], q.size() > 2 ? q[2] : 0.0};
}

// The cells (in x and y) that a segment comes within `margin` of, and some more.
template <class Visit>
void PointTraffic::for_each_cell(const Vec3& a, const Vec3& b, double margin,
                                 const Visit& visit) const {
  const auto index = [this](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
  const Vec3& low = a[1] <= b[1] ? a : b;
  const Vec3& high = a[1] <= b[1] ? b : a;
  const double rise = high[1] - low[1];
  for (std::int64_t row = index(low[1] - margin); row <= index(high[1] + margin); ++row) {
    // The part of the segment that comes near this row.
    const double bottom = static_cast<double>(row) * cell_ - margin;
    const double top = static_cast<double>(row + 1) * cell_ + margin;
    double s0 = 0, s1 = 1;
    if (rise > 0) {
      s0 = std::clamp((bottom - low[1]) / rise, 0.0, 1.0);
      s1 = std::clamp((top - low[1]) / rise, 0.0, 1.0);
    }
    const double x0 = low[0] + s0 * (high[0] - low[0]), x1 = low[0] + s1 * (high[0] - low[0]);
    const std::int64_t last = index(std::max(x0, x1) + margin);
    for (std::int64_t column = index(std::min(x0, x1) - margin); column <= last; ++column) {
      visit(key_of(column, row));
    }
  }
}

void PointTraffic::add(std::uint32_t owner, const Trajectory& path, double radius, double from,
                       double until) {
  std::vector<Id>& mine = by_owner_[owner];
  for (std::size_t i = path.segment_at(from); i < path.size(); ++i) {
    if (path.time(i) >= until) continue;
    const bool last = i + 1 == path.size();
    Piece piece{path.time(i), until, to_point(path.configuration(i)), Vec3::Zero(), radius};
    if (!last) {
      piece.velocity =
          (to_point(path.configuration(i + 1)) - piece.position) / (path.time(i + 1) - piece.t0);
      piece.t1 = std::min(until, path.time(i + 1));
    }
    Id id = static_cast<Id>(pieces_.size());
    if (free_.empty()) {
      pieces_.push_back(piece);
    } else {
      id = free_.back();
      free_.pop_back();
      pieces_[id] = piece;
    }
    mine.push_back(id);
    file(id, owner);
  }
}

// Fibonacci hashing (Knuth, vol. 3, 6.4).
std::size_t PointTraffic::bucket_of(Key cell) const {
  return (cell * 0x9e3779b97f4a7c15U) >> (64U - bucket_bits_);
}

void PointTraffic::file(Id id, std::uint32_t owner) {
  const Piece& piece = pieces_[id];
  for_each_cell(piece.position, end_of(piece), piece.radius + room_, [&](Key cell) {
    file({cell, piece.t0, piece.t1, id, owner, kNone});
  });
}

void PointTraffic::file(const Entry& entry) {
  std::uint32_t index = spare_entries_;
  if (index != kNone) {
    spare_entries_ = entries_[index].next;
    entries_[index] = entry;
  } else {
    if (entries_.size() == buckets_.size()) widen();
    index = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back(entry);
  }
  std::uint32_t& first = buckets_[bucket_of(entry.cell)];
  entries_[index].next = first;
  first = index;
}

void PointTraffic::take_out(Id id) {
  const Piece& piece = pieces_[id];
  for_each_cell(piece.position, end_of(piece), piece.radius + room_, [&](Key cell) {
    std::uint32_t* link = &buckets_[bucket_of(cell)];
    while (entries_[*link].id != id || entries_[*link].cell != cell) link = &entries_[*link].next;
    const std::uint32_t index = *link;
    *link = entries_[index].next;
    entries_[index].next = spare_entries_;
    spare_entries_ = index;
  });
}

// Requires: no entry is spare.
void PointTraffic::widen() {
  bucket_bits_ += 2;
  buckets_.assign(std::size_t{1} << bucket_bits_, kNone);
  for (std::uint32_t index = 0; index < entries_.size(); ++index) {
    std::uint32_t& first = buckets_[bucket_of(entries_[index].cell)];
    entries_[index].next = first;
    first = index;
  }
}

void PointTraffic::remove(std::uint32_t owner) {
  const auto found = by_owner_.find(owner);
  if (found == by_owner_.end()) return;
  for (const Id id : found->second) {
    take_out(id);
    free_.push_back(id);
  }
  by_owner_.erase(found);
}

void PointTraffic::near(const Vec3& a, const Vec3& b, double since, double until,
                        const std::vector<char>* only, std::vector<const Piece*>& out) const {
  seen_in_.resize(pieces_.size(), call_);
  ++call_;
  for_each_cell(a, b, 0, [&](Key key) {
    for (std::uint32_t i = buckets_[bucket_of(key)]; i != kNone; i = entries_[i].next) {
      const Entry& entry = entries_[i];
      if (entry.t1 <= since || entry.t0 >= until || entry.cell != key) continue;
      if (seen_in_[entry.id] == call_ || (only && !(*only)[entry.owner])) continue;
      seen_in_[entry.id] = call_;
      out.push_back(&pieces_[entry.id]);
    }
  });
}

}  // namespace accord
