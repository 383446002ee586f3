// The few lengths that decide what counts as contact, in one place.
#pragma once

namespace accord {

// A gap that conservative advancement takes for contact: below it steps would shrink without end.
inline constexpr double kContactResolution = 1e-7;  // m

// Room that planning keeps beyond the scene's clearance, so that whatever is planned can be proved
// afterwards in spite of rounding.
inline constexpr double kPlanningMargin = 1e-6;  // m

// Room that is asked of what was planned: where conflicts are looked for, and where a resolution is
// checked. Half of planning's, so that what planning avoids is not found again for rounding.
inline constexpr double kDetectionMargin = 0.5 * kPlanningMargin;  // m

// Room that the verifier asks for beyond the clearance: only what rounding needs.
inline constexpr double kProofMargin = 1e-9;  // m

}  // namespace accord
