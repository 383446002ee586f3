// What serialises generated types, made safe against hostile bytes. For dds/'s own use.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>
#include <fastdds/rtps/common/SerializedPayload.h>

#include <cstdint>

namespace accord::dds {

// The generated type of a value of ours, and its Support.
template <typename Value>
struct Wire;

// Whether what comes states no more elements than a value may have: generated code allocates for
// as many as there are bytes, a hundred bytes and more each, before it looks at the first. Types
// with sequences of anything but numbers have an overload beside them.
inline bool counts_are_sound(const void*, eprosima::fastcdr::Cdr&) {
  return true;
}

// Generated support that refuses such bytes.
template <typename Type, typename Generated>
class Support final : public Generated {
 public:
  // Counts in `refused` what it refuses, on the thread that takes.
  explicit Support(std::uint64_t* refused = nullptr) : refused_(refused) {}

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* out) override {
    if (is_deserialized(payload, out)) return true;
    if (refused_ != nullptr) ++*refused_;
    return false;
  }

 private:
  bool is_deserialized(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* out) {
    // Generated code lets some exceptions through, such as of a bool that is neither 0 nor 1.
    try {
      return has_sound_counts(*payload) && Generated::deserialize(payload, out);
    } catch (const eprosima::fastcdr::exception::Exception&) {
      return false;
    }
  }

  static bool has_sound_counts(eprosima::fastrtps::rtps::SerializedPayload_t& payload) {
    eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(payload.data), payload.length);
    eprosima::fastcdr::Cdr in(buffer, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                              eprosima::fastcdr::Cdr::DDS_CDR);
    in.read_encapsulation();
    return counts_are_sound(static_cast<const Type*>(nullptr), in);
  }

  std::uint64_t* refused_;
};

}  // namespace accord::dds
