#include "coordinator/journal/sqlite_database.h"

#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "common/io/files.h"

namespace accord {
namespace {

namespace fs = std::filesystem;
using Result = tl::expected<void, std::string>;

// Arguments outlive their query.
constexpr sqlite3_destructor_type kNotCopied = nullptr;

// EXCLUSIVE: one coordinator, and the log's index in memory instead of a file that is shared. FULL:
// a commit waits for the disk. Debian's default, to overwrite what is deleted with zeros, makes
// forgetting a large plan eight times as slow. The log shrinks again to 64 MiB. The rest is for
// files that somebody else may have written.
constexpr const char* kSettings =
    "PRAGMA locking_mode = EXCLUSIVE;"
    "PRAGMA synchronous = FULL;"
    "PRAGMA secure_delete = OFF;"
    "PRAGMA journal_size_limit = 67108864;"
    "PRAGMA cell_size_check = ON;"
    "PRAGMA trusted_schema = OFF;";

// What the operator can be told before SQLite says less.
std::string fault_of_place(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return "it is a folder";
  if (fs::exists(status) && !fs::is_regular_file(status)) return "it is not a regular file";
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder, error)) return "there is no folder " + path_in_quotes(folder);
  // The log lies beside it.
  const bool may_write = access(folder.c_str(), W_OK | X_OK) == 0 &&
                         (!fs::exists(status) || access(path.c_str(), R_OK | W_OK) == 0);
  return may_write ? "" : std::generic_category().message(errno);
}

}  // namespace

// ---- Queries ----

SqliteQuery::~SqliteQuery() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

SqliteQuery& SqliteQuery::bound(int result) {
  if (fault_ == SQLITE_OK) fault_ = result;
  return *this;
}

SqliteQuery& SqliteQuery::with(std::uint64_t value) {
  return bound(sqlite3_bind_int64(statement_, ++arguments_, static_cast<sqlite3_int64>(value)));
}

SqliteQuery& SqliteQuery::with(double value) {
  return bound(sqlite3_bind_double(statement_, ++arguments_, value));
}

SqliteQuery& SqliteQuery::with(std::string_view text) {
  const char* data = text.empty() ? "" : text.data();  // null would be NULL
  return bound(
      sqlite3_bind_text64(statement_, ++arguments_, data, text.size(), kNotCopied, SQLITE_UTF8));
}

SqliteQuery& SqliteQuery::with(BytesView bytes) {
  const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
  return bound(sqlite3_bind_blob64(statement_, ++arguments_, data, bytes.size(), kNotCopied));
}

tl::expected<bool, std::string> SqliteQuery::next() {
  if (fault_ == SQLITE_OK) {
    const int result = sqlite3_step(statement_);
    if (result == SQLITE_ROW) return true;
    if (result == SQLITE_DONE) return false;
    fault_ = result;
  }
  return tl::unexpected(database_.in_words(fault_));
}

tl::expected<void, std::string> SqliteQuery::run() {
  while (true) {
    const auto more = next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
  }
}

std::uint64_t SqliteQuery::number(int column) const {
  return static_cast<std::uint64_t>(sqlite3_column_int64(statement_, column));
}

double SqliteQuery::real(int column) const {
  return sqlite3_column_double(statement_, column);
}

std::string_view SqliteQuery::text(int column) const {
  const BytesView all = bytes(column);
  return {reinterpret_cast<const char*>(all.data()), all.size()};
}

BytesView SqliteQuery::bytes(int column) const {
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  if (data == nullptr) return {};
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

bool SqliteQuery::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

// ---- The database ----

void SqliteDatabase::Closer::operator()(sqlite3* handle) const {
  sqlite3_close(handle);
}

void SqliteDatabase::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SqliteDatabase::~SqliteDatabase() = default;

tl::expected<std::unique_ptr<SqliteDatabase>, std::string> SqliteDatabase::open(
    const fs::path& path) {
  std::unique_ptr<SqliteDatabase> database(new SqliteDatabase(path));
  if (const std::string fault = fault_of_place(path); !fault.empty()) {
    return tl::unexpected(database->about("cannot be opened: " + fault));
  }
  sqlite3* handle = nullptr;
  constexpr int kFlags =
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  // "./": a name that begins with "file:" is no URI, and ":memory:" a file like any other.
  const fs::path plain = path.is_absolute() ? path : "." / path;
  const int result = sqlite3_open_v2(plain.c_str(), &handle, kFlags, nullptr);
  database->handle_.reset(handle);
  if (result != SQLITE_OK) return tl::unexpected(database->in_words(result));
  if (const Result done = database->set_up(); !done) return tl::unexpected(done.error());
  return database;
}

Result SqliteDatabase::set_up() {
  if (sqlite3_db_readonly(handle_.get(), "main") == 1) {
    return tl::unexpected(in_words(SQLITE_READONLY));
  }
  if (Result done = execute(kSettings); !done) return done;
  // Looks at the file for the first time, and locks it.
  SqliteQuery mode = query("PRAGMA journal_mode = WAL");
  const auto answered = mode.next();
  if (!answered) return tl::unexpected(answered.error());
  if (*answered && mode.text(0) == "wal") return {};
  return tl::unexpected(about("cannot have a write-ahead log on this file system"));
}

SqliteQuery SqliteDatabase::query(const char* sql) const {
  auto& statement = statements_[sql];
  int result = SQLITE_OK;
  if (!statement) {
    sqlite3_stmt* prepared = nullptr;
    result =
        sqlite3_prepare_v3(handle_.get(), sql, -1, SQLITE_PREPARE_PERSISTENT, &prepared, nullptr);
    statement.reset(prepared);
  }
  return {*this, statement.get(), result};
}

Result SqliteDatabase::execute(const char* sql) const {
  const int result = sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  if (result != SQLITE_OK) return tl::unexpected(in_words(result));
  return {};
}

tl::expected<std::uint64_t, std::string> SqliteDatabase::number(const char* sql) const {
  SqliteQuery one = query(sql);
  const auto row = one.next();
  if (!row) return tl::unexpected(row.error());
  return *row ? one.number(0) : 0;
}

std::uint64_t SqliteDatabase::last_inserted() const {
  return static_cast<std::uint64_t>(sqlite3_last_insert_rowid(handle_.get()));
}

bool SqliteDatabase::in_transaction() const {
  return sqlite3_get_autocommit(handle_.get()) == 0;
}

std::string SqliteDatabase::about(std::string_view what) const {
  return "journal " + path_in_quotes(path_) + ": " + std::string(what);
}

std::string SqliteDatabase::in_words(int code) const {
  constexpr int kPrimary = 0xff;
  switch (code & kPrimary) {
    case SQLITE_FULL:
      return about("no room: the disk is full, or the journal as large as it may be");
    case SQLITE_BUSY:
      return about("in use by another coordinator");
    case SQLITE_NOTADB:
      return about("not a journal: the file is no SQLite database");
    case SQLITE_CORRUPT:
      return about("damaged; move it away to begin a new one, or bring back a copy");
    case SQLITE_READONLY:
      return about("cannot be written");
    case SQLITE_NOMEM:
      return about("not enough memory");
    case SQLITE_TOOBIG:
      return about("an entry larger than SQLite takes");
    case SQLITE_IOERR:
      return about("the disk fails, or takes no larger files");
    case SQLITE_CANTOPEN:
      return about("cannot be opened: " +
                   std::generic_category().message(sqlite3_system_errno(handle_.get())));
    default:
      return about(sqlite3_errmsg(handle_.get()));
  }
}

// ---- Transactions ----

tl::expected<std::unique_ptr<SqliteTransaction>, std::string> SqliteTransaction::begin(
    const SqliteDatabase& database) {
  if (Result begun = database.execute("BEGIN IMMEDIATE"); !begun) {
    return tl::unexpected(begun.error());
  }
  return std::unique_ptr<SqliteTransaction>(new SqliteTransaction(database));
}

SqliteTransaction::~SqliteTransaction() {
  // Some failures have undone it already, and a second attempt would say so.
  if (database_.in_transaction()) static_cast<void>(database_.execute("ROLLBACK"));
}

Result SqliteTransaction::commit() {
  return database_.execute("COMMIT");
}

}  // namespace accord
