#include "common/io/configuration_checks.h"

#include "common/io/words.h"

namespace accord {

std::string configuration_in_words(const RobotModel& model) {
  switch (model.kind) {
    case RobotKind::kDisk:
      return "[x, y]";
    case RobotKind::kFootprint:
      return "[x, y, heading]";
    case RobotKind::kBall:
      return "[x, y, z]";
    case RobotKind::kArm:
      return "a list of " + std::to_string(model.dof()) +
             (model.dof() == 1 ? " number" : " numbers") + ", one a movable joint";
  }
  return "";
}

Range range_of(const RobotModel& model, std::size_t dof) {
  return dof < model.translations() ? kCoordinateRange : kAngleRange;
}

std::optional<std::string> limit_fault(const DegreeOfFreedom& dof, double number) {
  const bool below = number < dof.lower;
  if (!below && number <= dof.upper) return std::nullopt;
  return "joint " + in_quotes(dof.name) + " at " + in_words(number) + " is " +
         (below ? "below its lower limit of " : "above its upper limit of ") +
         in_words(below ? dof.lower : dof.upper);
}

}  // namespace accord
