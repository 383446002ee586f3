// What one robot hears: its own path, on the topic that is its own.
#pragma once

#include <dds/dds.h>
#include <stdbool.h>
#include <stdint.h>

// Waits for the robot's path until `end`, and for a second in which nothing comes; prints it
// (JSON), the latest where there are several. Says on stderr when the service has found the reader,
// and how many pieces have come, of this robot and of others. False, with a line on stderr: there
// was no path, or something came that is not as docs/topics.md says, such as another robot's piece.
bool follow_robot(uint32_t domain, const char* cluster, const char* robot, dds_time_t end);
