// Writing of what must not be dropped because a link is slow for a moment. For threads that may
// wait.
#pragma once

#include <fastdds/dds/publisher/DataWriter.hpp>

#include "common/transport/dds/fleet/participant.h"

namespace accord::dds {

// How long those who listen are waited for before they miss what is overwritten, and ask for it.
inline const eprosima::fastrtps::Duration_t kPatience{0, 100'000'000};

template <typename Value>
void write_patiently(const Value& value, eprosima::fastdds::dds::DataWriter& writer,
                     FleetTraffic& traffic) {
  constexpr int kTries = 20;  // each of some milliseconds
  for (int i = 0; i < kTries && !write(value, writer, &traffic); ++i) {
  }
}

}  // namespace accord::dds
