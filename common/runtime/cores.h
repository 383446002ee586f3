// How many threads this process may run at once.
#pragma once

#include <filesystem>

namespace accord {

// At least 1: the machine's cores that the process may use, or as many as its share of their time
// makes, rounded up: containers and services are given such shares (cgroup v2, cpu.max).
unsigned cores();

// The same for a share that is told otherwise: `cgroup`, as in /proc/self/cgroup, and `root`, where
// its file system is mounted. Never more than `machine`; as many where nothing limits it or nothing
// can be read.
unsigned cores_within(const std::filesystem::path& cgroup, const std::filesystem::path& root,
                      unsigned machine);

}  // namespace accord
