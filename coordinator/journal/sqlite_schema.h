// The tables of SqliteJournal, and whether a file's are ours.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "coordinator/journal/sqlite_database.h"

namespace accord {

// Makes the tables in a new database, or says why those of an old one cannot be used: another
// program's, a newer Accord's, damaged.
tl::expected<void, std::string> prepare_schema(const SqliteDatabase& database);

}  // namespace accord
