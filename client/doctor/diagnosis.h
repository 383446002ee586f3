// From what was seen to what is wrong. Pure: no network, no files, no clock.
#pragma once

#include <vector>

#include "client/doctor/finding.h"
#include "client/doctor/observations.h"

namespace accord {

// A finding at least for each concern that the options have to do with; faults first, then
// warnings, each in the order of Concern.
std::vector<Finding> diagnose(const Observations& seen);

// Whether listening longer would say no more: the service has spoken twice, whoever is of the
// cluster has told of its readers and writers, and every address that was told has answered.
bool is_settled(const DdsOptions& options, const DomainSurvey& survey);

}  // namespace accord
