#include "coordinator/journal/sqlite_schema.h"

namespace accord {
namespace {

using Result = tl::expected<void, std::string>;

// "Acrd", in the file's header: whose database it is.
constexpr std::uint64_t kApplication = 0x41637264;
// What the tables mean. A change of them is a new number, with the steps from the one before.
constexpr std::uint64_t kVersion = 1;

// Bytes lie apart from what is looked at often. Hashes are over them, since SQLite does not notice
// what a disk changes in them. AUTOINCREMENT: no sequence number is used twice, even when all
// entries are gone. A partial index a list that is asked for.
constexpr const char* kTables = R"(
  CREATE TABLE requests (
    sequence INTEGER PRIMARY KEY AUTOINCREMENT,
    id TEXT NOT NULL UNIQUE,
    content BLOB NOT NULL CHECK (length(content) = 32),
    accepted_at REAL NOT NULL,
    status TEXT,
    finished_at REAL,
    bytes_hash BLOB NOT NULL CHECK (length(bytes_hash) = 32)
  ) STRICT;
  CREATE INDEX unfinished ON requests (sequence) WHERE status IS NULL;
  CREATE INDEX finished ON requests (finished_at, sequence) WHERE status IS NOT NULL;
  CREATE TABLE record_bytes (sequence INTEGER PRIMARY KEY, bytes BLOB NOT NULL) STRICT;
  CREATE TABLE plan_bytes (sequence INTEGER PRIMARY KEY, bytes BLOB NOT NULL) STRICT;
  PRAGMA application_id = 1097036388;
  PRAGMA user_version = 1;
)";
static_assert(kApplication == 1097036388 && kVersion == 1);

Result create(const SqliteDatabase& database) {
  const auto transaction = SqliteTransaction::begin(database);
  if (!transaction) return tl::unexpected(transaction.error());
  if (Result made = database.execute(kTables); !made) return made;
  return (*transaction)->commit();
}

// The small table and its indices whole; bytes have hashes of their own.
Result check(const SqliteDatabase& database) {
  SqliteQuery query = database.query("PRAGMA integrity_check(requests)");
  const auto row = query.next();
  if (!row) return tl::unexpected(row.error());
  if (*row && query.text(0) == "ok") return {};
  return tl::unexpected(database.about("damaged: " + std::string(query.text(0))));
}

}  // namespace

Result prepare_schema(const SqliteDatabase& database) {
  const auto tables = database.number("SELECT count(*) FROM sqlite_schema");
  if (!tables) return tl::unexpected(tables.error());
  const auto application = database.number("PRAGMA application_id");
  if (!application) return tl::unexpected(application.error());
  const auto version = database.number("PRAGMA user_version");
  if (!version) return tl::unexpected(version.error());
  if (*tables == 0 && *application == 0 && *version == 0) return create(database);
  if (*application != kApplication) {
    return tl::unexpected(database.about("not a journal: it is another program's database"));
  }
  if (*version != kVersion) {
    return tl::unexpected(
        database.about("written by a newer Accord: its format is " + std::to_string(*version) +
                       ", and this one knows formats up to " + std::to_string(kVersion)));
  }
  return check(database);
}

}  // namespace accord
