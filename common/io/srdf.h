// Which links of an arm need not be checked against each other, from SRDF.
#pragma once

#include <string>
#include <string_view>

#include "common/io/diagnostic.h"
#include "common/model/robot.h"

namespace accord {

// Adds the pairs that <disable_collisions link1= link2=> lists to model.may_touch. Unknown links
// are faults; what else SRDF may hold is passed over.
void apply_srdf(std::string_view text, const std::string& file, RobotModel& model, Faults& faults);

}  // namespace accord
