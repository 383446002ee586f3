// How the verifier, and the checks of resolutions, say numbers, places and gaps to people.
#pragma once

#include <string>

#include "common/model/scene.h"

namespace accord::verification {

std::string quoted(const std::string& name);               // "agv3"
std::string number(double value);                          // 0.05, up to six digits
std::string seconds(double t);                             // t = 3.200 s
std::string metres(double length);                         // 0.0490 m
std::string place(const Scene& scene, const Vec3& where);  // (1.00, 2.00), z in spatial scenes

// What a gap is against the distance that has to be kept: "overlap by 0.1200 m" or
// "come within 0.0490 m of each other (the clearance is 0.0500 m)".
std::string closeness(double gap, double clearance);

}  // namespace accord::verification
