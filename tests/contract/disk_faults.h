// SQLite's way to the disk, watched and made to fail: one for all of a process.
#pragma once

#include <cstddef>

namespace accord::testing::disk {

// The first `writes` succeed from now on, and then none: there is no room (ENOSPC). Nothing else is
// wrong with what is there.
void fail_after_writes(std::size_t writes);
// Likewise, that of which the drive says that it could not keep it (EIO).
void fail_after_syncs(std::size_t syncs);
void heal();

// Since the last call of this: whether all files that were written to have been synced after it.
// Requires: something was written.
bool all_synced();

}  // namespace accord::testing::disk
