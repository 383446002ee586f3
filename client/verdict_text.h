// What a verdict says, in words.
#pragma once

#include <string>

#include "client/table.h"
#include "common/planning/verifier.h"

namespace accord {

// Adds the smallest separations. Requires: the verdict is a proof.
void add_separations(Table& table, const Verdict& verdict);

}  // namespace accord
