// What the numbers of a configuration may be, wherever they are written: for the readers of scenes
// and of requests. Pure functions; thread safe.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "common/io/fields.h"
#include "common/model/robot.h"

namespace accord {

// What is expected of a configuration as a whole: "[x, y, heading]".
std::string configuration_in_words(const RobotModel& model);

// Of any number in place `dof`; its limits lie within. Requires: dof < model.dof().
Range range_of(const RobotModel& model, std::size_t dof);

// What is wrong with a number beyond its degree of freedom's limits.
std::optional<std::string> limit_fault(const DegreeOfFreedom& dof, double number);

}  // namespace accord
