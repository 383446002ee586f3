#include "common/transport/dds/survey/survey_book.h"

#include <fastrtps/utils/IPLocator.h>

#include <algorithm>

namespace accord::dds {
namespace {

using eprosima::fastrtps::rtps::IPLocator;
using eprosima::fastrtps::rtps::Locator_t;

constexpr std::size_t kHostBytes = 4;
constexpr std::size_t kSeenEndpoints = 100'000;

std::string hex(const SurveyBook::GuidPrefix& prefix) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string out;
  for (const auto byte : prefix.value) {
    out += kDigits[byte >> 4U];
    out += kDigits[byte & 0xFU];
  }
  return out;
}

SeenLocator seen(const Locator_t& locator, bool multicast) {
  if (locator.kind == LOCATOR_KIND_SHM) {
    // The first byte of its address tells one listener's port, U, from one of all, M.
    return {SeenLocator::Kind::kSharedMemory, "", locator.port, locator.address[0] == 'M'};
  }
  if (locator.kind != LOCATOR_KIND_UDPv4) {
    return {SeenLocator::Kind::kOther, "", locator.port, multicast};
  }
  return {SeenLocator::Kind::kUdp, IPLocator::toIPv4string(locator), locator.port, multicast};
}

void add(const eprosima::fastrtps::rtps::RemoteLocatorList& list, std::set<SeenLocator>& out) {
  for (const Locator_t& locator : list.unicast) out.insert(seen(locator, false));
  for (const Locator_t& locator : list.multicast) out.insert(seen(locator, true));
}

double seconds(const eprosima::fastrtps::rtps::Time_t& time) {
  return static_cast<double>(time.seconds()) + static_cast<double>(time.nanosec()) * 1e-9;
}

}  // namespace

void SurveyBook::set_own(const GuidPrefix& own) {
  const std::scoped_lock lock(mutex_);
  own_ = own;
  const auto host = hex(own).substr(0, 2 * kHostBytes);
  for (auto& [prefix, known] : entries_) known.is_of_this_host = known.host == host;
  entries_.erase(own);
}

SeenParticipant* SurveyBook::entry(const GuidPrefix& participant) {
  if (own_ == participant) return nullptr;
  const auto known = entries_.find(participant);
  if (known != entries_.end()) return &known->second;
  if (entries_.size() >= kSeenParticipants) return nullptr;
  SeenParticipant& out = entries_[participant];
  out.guid = hex(participant);
  out.host = out.guid.substr(0, 2 * kHostBytes);
  out.is_of_this_host = own_ && hex(*own_).starts_with(out.host);
  const auto server = std::ranges::find(servers_, participant);
  if (server != servers_.end()) out.server = static_cast<std::size_t>(server - servers_.begin());
  return &out;
}

void SurveyBook::discovered(const eprosima::fastrtps::rtps::ParticipantProxyData& data) {
  {
    const std::scoped_lock lock(mutex_);
    SeenParticipant* known = entry(data.m_guid.guidPrefix);
    if (known == nullptr) return;
    known->is_fast_dds = data.m_VendorId == eprosima::fastrtps::rtps::c_VendorId_eProsima;
    known->name = accord_name_in(std::string(data.m_userData.begin(), data.m_userData.end()));
#if HAVE_SECURITY
    known->demands_security = !data.identity_token_.class_id().empty();
#endif
    add(data.metatraffic_locators, known->locators);
    add(data.default_locators, known->locators);
  }
  signal_.raise();
}

void SurveyBook::gone(const GuidPrefix& participant) {
  const std::scoped_lock lock(mutex_);
  entries_.erase(participant);
  std::erase_if(endpoints_,
                [&participant](const Guid& guid) { return guid.guidPrefix == participant; });
}

void SurveyBook::has_endpoint(const Guid& endpoint, const std::string& topic,
                              const eprosima::fastdds::dds::PartitionQosPolicy& partitions) {
  {
    const std::scoped_lock lock(mutex_);
    SeenParticipant* known = entry(endpoint.guidPrefix);
    if (known == nullptr || endpoints_.size() >= kSeenEndpoints) return;
    if (!endpoints_.insert(endpoint).second) return;
    ++known->endpoints;
    if (known->topics.size() < kSeenTopics) known->topics.insert(topic);
    for (const std::string& partition : partitions.names()) {
      if (known->partitions.size() < kSeenTopics) known->partitions.insert(partition);
    }
  }
  signal_.raise();
}

void SurveyBook::matched(const Guid& theirs, int change) {
  const std::scoped_lock lock(mutex_);
  SeenParticipant* known = entry(theirs.guidPrefix);
  if (known != nullptr && change > 0) ++known->matches;
}

void SurveyBook::heard(const eprosima::fastdds::dds::SampleInfo& info, Age age) {
  const auto writer = eprosima::fastrtps::rtps::iHandle2GUID(info.publication_handle);
  const double ahead = seconds(info.source_timestamp) - seconds(info.reception_timestamp);
  const std::scoped_lock lock(mutex_);
  SeenParticipant* known = entry(writer.guidPrefix);
  if (known == nullptr) return;
  ++known->samples;
  const bool is_live = age == Age::kLive || (age == Age::kKept && !heard_.insert(writer).second);
  // Of several, the one that was on its way for the shortest time says most.
  if (is_live) known->clock_ahead = std::max(known->clock_ahead.value_or(ahead), ahead);
}

std::vector<SeenParticipant> SurveyBook::participants() const {
  const std::scoped_lock lock(mutex_);
  std::vector<SeenParticipant> out;
  for (const auto& [prefix, known] : entries_) {
    if (!known.name || known.name->role != AccordName::Role::kDoctor) out.push_back(known);
  }
  return out;
}

}  // namespace accord::dds
