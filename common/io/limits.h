// Every limit on what a file may hold, in one place. They bound the memory and the time that any
// file, however hostile, can cost; they are far above what real scenes need. Reaching one is a
// fault like any other: reported with its line, never a crash and never a silent cut.
#pragma once

#include <cstddef>

namespace accord::limits {

// Files
inline constexpr std::size_t kSceneBytes = std::size_t{4}
                                           << 20;  // yaml-cpp takes up to 100 times as much
inline constexpr std::size_t kUrdfBytes = std::size_t{4} << 20;
inline constexpr std::size_t kMeshBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMapBytes = std::size_t{64} << 20;
inline constexpr std::size_t kPlanBytes = std::size_t{512} << 20;
inline constexpr std::size_t kSettingsBytes = std::size_t{64} << 10;

// Text
inline constexpr std::size_t kNesting = 32;            // levels of lists and maps
inline constexpr std::size_t kOpenBrackets = 1'000;    // in YAML, quoted and commented ones too
inline constexpr std::size_t kSceneNodes = 2'000'000;  // keys and values of a scene
inline constexpr std::size_t kPlanNodes = 32'000'000;  // keys and values of a plan
inline constexpr std::size_t kSettingsNodes = 10'000;  // keys and values of a configuration
inline constexpr std::size_t kNameBytes = 200;
inline constexpr std::size_t kXmlAttributes = 20'000;  // tinyxml2 takes time quadratic in them
inline constexpr std::size_t kFaults = 200;            // listed at once
inline constexpr std::size_t kLineFaults = 20;         // of them, of one mesh or map

// Counts of a scene
inline constexpr std::size_t kRobots = 10'000;
inline constexpr std::size_t kModels = 1'000;
inline constexpr std::size_t kObstacles = 250'000;      // shapes, those made from maps included
inline constexpr std::size_t kPolygonVertices = 1'000;  // of one polygon
inline constexpr std::size_t kVertices = 200'000;       // of all polygons of a scene
inline constexpr std::size_t kTriangles = 500'000;      // of one mesh
inline constexpr std::size_t kSceneTriangles = 2'000'000;
inline constexpr std::size_t kMapSide = 16'384;  // cells
inline constexpr std::size_t kMapCells = 16'777'216;
inline constexpr std::size_t kLinks = 200;            // of one arm
inline constexpr std::size_t kBodies = 1'000;         // of one arm
inline constexpr std::size_t kSceneBodies = 200'000;  // of all robots of a scene
inline constexpr std::size_t kSrdfPairs = 20'000;

// Numbers. Within these, doubles keep rounding well below the planner's margins (tolerances.h).
inline constexpr double kCoordinate = 1e5;  // m: largest distance from the origin, along each axis
inline constexpr double kSize = 1e5;        // m: largest extent of a shape
inline constexpr double kMinSize = 1e-5;    // m: smallest extent of a shape
inline constexpr double kAngle = 1e4;       // rad
inline constexpr double kRate = 1e5;        // m/s or rad/s
inline constexpr double kMinRate = 1e-6;    // m/s or rad/s
inline constexpr double kTimestep = 1e3;    // s
inline constexpr double kMinTimestep = 1e-6;  // s

// On the wire: payloads (io/wire/), far above what scenes within the limits above need
inline constexpr std::size_t kSceneWireBytes = std::size_t{256} << 20;
inline constexpr std::size_t kSceneWireParts = 3'000'000;  // messages and names in them
inline constexpr std::size_t kSubproblemBytes = std::size_t{16} << 20;
inline constexpr std::size_t kResolutionBytes = std::size_t{16} << 20;
inline constexpr std::size_t kSolvers = 16;  // of one hierarchy
inline constexpr std::size_t kSolverNameBytes = 64;
inline constexpr std::size_t kWhyBytes = 4096;  // of what is said of a task to people
inline constexpr std::size_t kTaskRecordBytes =
    kSceneWireBytes + kSubproblemBytes + kWhyBytes + (std::size_t{1} << 16);

// Requests
inline constexpr std::size_t kRequestIdBytes = 128;
inline constexpr std::size_t kAttachments = 1'000;
inline constexpr std::size_t kAttachmentBytes = std::size_t{64} << 20;  // of one request together
inline constexpr double kDeadline = 1e7;                                // s
inline constexpr std::size_t kFaultFieldBytes = 256;                    // of what is said of one
inline constexpr std::size_t kFaultTextBytes = 900;
// As the journal keeps them: a scene's text, attachments, and 4 MiB for the rest.
inline constexpr std::size_t kRequestBytes = std::size_t{72} << 20;
inline constexpr std::size_t kRequestParts = 50'000;  // four a query, three an attachment

// Plans
inline constexpr double kPlanTime = 1e9;  // s

}  // namespace accord::limits
