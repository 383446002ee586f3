// Sine and cosine that are the same bits on every machine: glibc picks its own by what the
// processor offers, and the same request must give the same plan everywhere.
//
// Cody and Waite's reduction by a pi/2 in three parts, then the polynomials of fdlibm (Sun
// Microsystems, 1993). Absolute error below 1e-15 for |x| < 1e5; the library's functions beyond,
// and for what is not finite.
#pragma once

#include <cmath>
#include <cstdint>

namespace accord {

struct SinCos {
  double sin;
  double cos;
};

namespace sincos_detail {

// On [-pi/4, pi/4].
inline double sin_kernel(double x) {
  const double z = x * x;
  const double r = 8.33333333332248946124e-03 +
                   z * (-1.98412698298579493134e-04 +
                        z * (2.75573137070700676789e-06 +
                             z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x + z * x * (-1.66666666666666324348e-01 + z * r);
}

inline double cos_kernel(double x) {
  const double z = x * x;
  const double r =
      z * (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 +
                          z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z;
  const double w = 1.0 - half;
  return w + (((1.0 - w) - half) + z * r);
}

}  // namespace sincos_detail

inline SinCos sincos(double x) {
  constexpr double kLargest = 1e5;
  if (!(std::abs(x) < kLargest)) return {std::sin(x), std::cos(x)};
  // Adding and taking away 1.5 * 2^52 rounds to the nearest integer.
  constexpr double kRounder = 6755399441055744.0;
  constexpr double kTwoOverPi = 6.36619772367581382433e-01;
  // pi/2 in parts of 33 bits, so that their products with the quadrant's number are exact.
  constexpr double kPart1 = 1.57079632673412561417e+00;
  constexpr double kPart2 = 6.07710050630396597660e-11;
  constexpr double kPart3 = 2.02226624871116645580e-21;
  const double quadrants = (x * kTwoOverPi + kRounder) - kRounder;
  const double r = ((x - quadrants * kPart1) - quadrants * kPart2) - quadrants * kPart3;
  const double s = sincos_detail::sin_kernel(r);
  const double c = sincos_detail::cos_kernel(r);
  const auto quadrant = static_cast<std::int64_t>(quadrants);
  const bool swapped = (quadrant & 1) != 0;
  const double sine = swapped ? c : s;
  const double cosine = swapped ? s : c;
  return {(quadrant & 2) != 0 ? -sine : sine, ((quadrant + 1) & 2) != 0 ? -cosine : cosine};
}

}  // namespace accord
