// Who else uses shared memory on this machine. Internal to transport.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace accord::dds {

// Whether Fast DDS of another user than `user` has memory in the folder, /dev/shm on a machine. Two
// processes of different users find each other and would talk by shared memory if both can, but
// neither may write to the other's: nothing would ever arrive. Whoever comes second has to notice.
// What a killed process left counts, too, since nothing tells it from a living one's. Thread safe.
bool others_share_memory(const std::filesystem::path& folder, uid_t user);

}  // namespace accord::dds
