#include "common/planning/verifier_words.h"

#include <array>
#include <cstdio>

namespace accord::verification {
namespace {

template <typename... Numbers>
std::string print(const char* format, Numbers... numbers) {
  std::array<char, 128> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, numbers...);
  return buffer.data();
}

}  // namespace

std::string quoted(const std::string& name) {
  return '"' + name + '"';
}

std::string number(double value) {
  return print("%.6g", value);
}

std::string seconds(double t) {
  return print("t = %.3f s", t);
}

std::string metres(double length) {
  return print("%.4f m", length);
}

std::string place(const Scene& scene, const Vec3& where) {
  return scene.planar ? print("(%.2f, %.2f)", where.x(), where.y())
                      : print("(%.2f, %.2f, %.2f)", where.x(), where.y(), where.z());
}

std::string closeness(double gap, double clearance) {
  if (gap < 0) return "overlap by " + metres(-gap);
  if (clearance > 0) {
    // More digits where four would show a gap as wide as the clearance.
    const std::string apart = clearance - gap < 1e-4 ? print("%.9f m", gap) : metres(gap);
    return "come within " + apart + " of each other (the clearance is " + metres(clearance) + ")";
  }
  return "touch";
}

}  // namespace accord::verification
