// A robot model from its payload. For scene_decoder.cpp.
#pragma once

#include "common/io/wire/shape_decoder.h"
#include "common/model/robot.h"

namespace accord::payload {
class Model;
}

namespace accord {

// A sound model: a tree of links, parents first, each degree of freedom a joint's; mobile kinds as
// io makes them.
bool take_model(const payload::Model& from, bool planar, const PayloadPath& at,
                ShapeDecoder& shapes, Inspector& inspector, RobotModel& out);

}  // namespace accord
