// Says that something has come to a reader. Does nothing else: it runs on Fast DDS's threads.
#pragma once

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <functional>
#include <utility>

namespace accord::dds {

class WakingListener final : public eprosima::fastdds::dds::DataReaderListener {
 public:
  explicit WakingListener(std::function<void()> wake) : wake_(std::move(wake)) {}
  void on_data_available(eprosima::fastdds::dds::DataReader*) override { wake_(); }

 private:
  std::function<void()> wake_;
};

}  // namespace accord::dds
