// Checks the values of a payload one by one and keeps the first fault as a sentence: bytes are
// refused as a whole, so that one is enough. For the decoders' use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "common/io/fields.h"
#include "common/io/wire/payload_path.h"
#include "common/model/shape.h"

// What protobuf calls a repeated double; its header stays inside sources.
namespace google::protobuf {
template <typename T>
class RepeatedField;
}

namespace accord {

using WireDoubles = google::protobuf::RepeatedField<double>;

// Not thread safe. Each check returns whether the value is sound.
class Inspector {
 public:
  const std::optional<std::string>& fault() const { return fault_; }

  // Always false, so that a check can end with it.
  bool fail(const PayloadPath& at, std::string_view text);

  bool number(double value, Range range, const PayloadPath& at);
  // As number(), or plus infinity.
  bool number_or_infinity(double value, Range range, const PayloadPath& at);
  bool count(std::uint64_t value, std::uint64_t least, std::uint64_t most, std::string_view of_what,
             const PayloadPath& at);
  bool index(std::uint64_t value, std::uint64_t size, std::string_view of_what,
             const PayloadPath& at);
  // Not empty, at most `most` bytes, UTF-8 without control characters.
  bool name(std::string_view value, const PayloadPath& at, std::size_t most = limits::kNameBytes);
  // `size` numbers, all of them within the range.
  bool numbers(const WireDoubles& values, std::size_t size, Range range, const PayloadPath& at);

  // Twelve numbers that turn and move. `reach` (m) bounds the translation along each axis.
  bool pose(const WireDoubles& values, double reach, const PayloadPath& at, Pose& out);
  // Three numbers of length 1.
  bool direction(const WireDoubles& values, const PayloadPath& at, Vec3& out);

 private:
  std::optional<std::string> fault_;
};

}  // namespace accord
