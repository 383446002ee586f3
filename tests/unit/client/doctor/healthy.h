// A machine and a domain in which all is well, for tests to break one thing of.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/doctor/diagnosis.h"

namespace accord::testing {

inline SeenParticipant member(AccordName::Role role, const std::string& guid) {
  SeenParticipant out;
  out.guid = guid;
  out.host = guid.substr(0, 8);
  out.is_fast_dds = true;
  out.name = AccordName{role, "default", 1, role == AccordName::Role::kWorker ? 0x77U : 0U};
  out.locators = {{SeenLocator::Kind::kUdp, "10.0.0.2", 7410, false},
                  {SeenLocator::Kind::kUdp, "10.0.0.2", 7411, false}};
  out.endpoints = 7;
  out.samples = 3;
  return out;
}

// A service and a worker on another machine.
inline Observations healthy() {
  Observations seen;
  seen.version = "0.1.0";
  seen.user = 1000;
  seen.listened = 2.5;
  seen.memory = {true, std::uint64_t{1} << 30, std::uint64_t{1} << 30, 0, {}, 0, false};
  seen.buffers = {4U << 20, 4U << 20};
  seen.interfaces = {{"lo", "127.0.0.1", true, true, false, std::nullopt},
                     {"eth0", "10.0.0.1", true, false, true, std::nullopt}};
  auto& survey = seen.as_told.survey;
  survey.participants = {member(AccordName::Role::kService, "010f00020000000000000001"),
                         member(AccordName::Role::kWorker, "010f00020000000000000002")};
  survey.participants[0].clock_ahead = -0.0002;
  ServiceStatus service;
  service.version = "0.1.0";
  service.host = "box";
  service.workers = 1;
  service.threads = 4;
  survey.service = service;
  WorkerStatus worker;
  worker.worker = 0x77;
  worker.host = "box";
  worker.version = "0.1.0";
  worker.standing = "welcome";
  survey.workers = {worker};
  seen.by_udp = Look{"", survey};
  seen.by_memory = Look{};
  return seen;
}

inline SeenParticipant& worker_of(Observations& seen) {
  return seen.as_told.survey.participants[1];
}

// Whatever is not fine: "fault peer-unreachable", in order.
inline std::vector<std::string> complaints(const Observations& seen) {
  std::vector<std::string> out;
  for (const Finding& finding : diagnose(seen)) {
    if (finding.severity == Severity::kFine) continue;
    EXPECT_FALSE(finding.why.empty()) << finding.seen;
    EXPECT_FALSE(finding.mend.empty()) << finding.seen;
    out.push_back(std::string(name_of(finding.severity)) + " " + name_of(finding.concern));
  }
  return out;
}

inline Finding finding_of(const Observations& seen, Concern concern) {
  const auto all = diagnose(seen);
  const auto found = std::ranges::find(all, concern, &Finding::concern);
  return found == all.end() ? Finding{} : *found;
}

inline bool mends_with(const Finding& finding, const std::string& command) {
  return std::ranges::any_of(finding.mend, [&command](const std::string& text) {
    return text.find(command) != std::string::npos;
  });
}

using Complaints = std::vector<std::string>;

}  // namespace accord::testing
