// What SqliteJournal needs of SQLite, with outcomes as values: a database of its own, queries,
// transactions. sqlite3.h stays in the source.
//
// Failure is a sentence that names the file. Not thread safe. Nothing throws but std::bad_alloc.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "common/io/wire/bytes.h"

struct sqlite3;
struct sqlite3_stmt;

namespace accord {

class SqliteDatabase;

// One run of a statement. Arguments are not copied: they live as long as it does.
class SqliteQuery {
 public:
  // `statement` is null where it could not be prepared, for the reason that `fault` is.
  SqliteQuery(const SqliteDatabase& database, sqlite3_stmt* statement, int fault)
      : database_(database), statement_(statement), fault_(fault) {}
  ~SqliteQuery();
  SqliteQuery(const SqliteQuery&) = delete;
  SqliteQuery& operator=(const SqliteQuery&) = delete;

  // The statement's arguments, in their order.
  SqliteQuery& with(std::uint64_t value);  // Requires: less than 2^63
  SqliteQuery& with(double value);
  SqliteQuery& with(std::string_view text);
  SqliteQuery& with(BytesView bytes);

  // Whether there is another row.
  tl::expected<bool, std::string> next();
  // To the end, whatever rows there are.
  tl::expected<void, std::string> run();

  // Of the row at hand; columns from 0. Views live until the next call of next().
  std::uint64_t number(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;
  BytesView bytes(int column) const;
  bool is_null(int column) const;

 private:
  SqliteQuery& bound(int result);

  const SqliteDatabase& database_;
  sqlite3_stmt* statement_;
  int arguments_ = 0;
  int fault_;  // SQLite's result code; 0: none
};

class SqliteDatabase {
 public:
  // Opens or creates it. Nobody else can have it open then, in this process or another, until this
  // is destroyed or the process ends, however it ends. What is committed is on disk
  // (write-ahead log, synchronous).
  static tl::expected<std::unique_ptr<SqliteDatabase>, std::string> open(
      const std::filesystem::path& path);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  // Requires: `sql` is a literal, one statement, of which no other query is under way.
  SqliteQuery query(const char* sql) const;
  // Several statements, without arguments or rows.
  tl::expected<void, std::string> execute(const char* sql) const;
  // The number that is a statement's only result.
  tl::expected<std::uint64_t, std::string> number(const char* sql) const;
  std::uint64_t last_inserted() const;
  bool in_transaction() const;

  // `journal "accord.db": what`.
  std::string about(std::string_view what) const;
  // As about(), with what SQLite's result code means to the operator.
  std::string in_words(int code) const;

 private:
  explicit SqliteDatabase(const std::filesystem::path& path) : path_(path) {}
  tl::expected<void, std::string> set_up();

  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Closer> handle_;
  // Prepared once. By the address of the literal: one that is there twice is prepared twice.
  mutable std::map<const char*, std::unique_ptr<sqlite3_stmt, Finalizer>> statements_;
};

// All that is done during its life is done at commit(), or undone.
class SqliteTransaction {
 public:
  static tl::expected<std::unique_ptr<SqliteTransaction>, std::string> begin(
      const SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  tl::expected<void, std::string> commit();

 private:
  explicit SqliteTransaction(const SqliteDatabase& database) : database_(database) {}
  const SqliteDatabase& database_;
};

}  // namespace accord
