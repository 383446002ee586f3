// What a verdict says, in words.
#pragma once

#include <string>

#include "client/table.h"
#include "common/model/scene.h"
#include "common/planning/verifier.h"

namespace accord {

// Adds the smallest separations between what is there. Requires: the verdict is a proof.
void add_separations(Table& table, const Scene& scene, const Verdict& verdict);

}  // namespace accord
