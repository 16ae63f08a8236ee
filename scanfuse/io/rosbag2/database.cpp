#include "scanfuse/io/rosbag2/database.hpp"

#include <sqlite3.h>

#include <system_error>
#include <utility>

namespace scanfuse::io::rosbag2 {

namespace {

constexpr int kStepsPerCheck = 1000;

/// Called every kStepsPerCheck steps of SQLite's machine; anything but 0 interrupts the query.
int spend(void* budget) { return (*static_cast<std::int64_t*>(budget) -= kStepsPerCheck) < 0; }

/// "file:/bags/a%20b.db3?mode=ro...": characters with a meaning in addresses are escaped.
std::string address_of(const std::filesystem::path& path, const char* mode) {
  std::string address = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const bool plain = c == '/' || c == '.' || c == '-' || c == '_' || (c >= '0' && c <= '9') ||
                       (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    address += plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
  }
  return address + "?" + mode;
}

sqlite3* try_open(const std::string& address) {
  sqlite3* handle = nullptr;
  const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX;
  if (sqlite3_open_v2(address.c_str(), &handle, flags, nullptr) == SQLITE_OK) return handle;
  sqlite3_close(handle);
  return nullptr;
}

bool answers(sqlite3* handle) {
  return sqlite3_exec(handle, "SELECT COUNT(*) FROM sqlite_master", nullptr, nullptr, nullptr) ==
         SQLITE_OK;
}

/// SQLite cannot open an image in memory whose header (bytes 18, 19) asks for a write-ahead log.
void forget_log(std::vector<std::byte>& image) {
  if (image.size() < 100) return;
  for (const std::size_t i : {18, 19}) {
    if (image[i] == std::byte{2}) image[i] = std::byte{1};
  }
}

}  // namespace

void Query::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Query::Step Query::step() {
  const int state = sqlite3_step(statement_.get());
  return state == SQLITE_ROW ? Step::kRow : state == SQLITE_DONE ? Step::kDone : Step::kFailed;
}

void Query::restart_with(std::int64_t argument) {
  sqlite3_reset(statement_.get());
  sqlite3_bind_int64(statement_.get(), 1, argument);
}

std::int64_t Query::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string Query::text(int column) const {
  const auto bytes = blob(column);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::span<const std::byte> Query::blob(int column) const {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  if (data == nullptr) return {};
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::string Query::problem() const { return sqlite3_errmsg(sqlite3_db_handle(statement_.get())); }

Result<Database> Database::open(const std::filesystem::path& path) {
  std::error_code trouble;
  const auto bytes = std::filesystem::file_size(path, trouble);
  if (trouble) return fail(Error::Code::kNotFound, "{}: {}", path.string(), trouble.message());
  Database database;
  database.name_ = path.string();
  const auto log_bytes = std::filesystem::file_size(path.string() + "-wal", trouble);
  const bool has_log = !trouble && log_bytes > 0;
  if (has_log) database.handle_.reset(try_open(address_of(path, "mode=ro")));
  if (!database.handle_ || !answers(database.handle_.get())) {
    database.handle_.reset(try_open(address_of(path, "mode=ro&immutable=1")));
    database.log_ignored_ = has_log;
  }
  const auto ready = database.harden(bytes + (has_log ? log_bytes : 0));
  if (!ready) return tl::unexpected(ready.error());
  return database;
}

Result<Database> Database::open(std::vector<std::byte> image, std::string name) {
  Database database;
  database.name_ = std::move(name);
  database.image_ = std::make_unique<std::vector<std::byte>>(std::move(image));
  forget_log(*database.image_);
  const auto bytes = static_cast<sqlite3_int64>(database.image_->size());
  sqlite3* handle = nullptr;
  if (sqlite3_open_v2(":memory:", &handle, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr) ==
      SQLITE_OK) {
    database.handle_.reset(handle);
    sqlite3_deserialize(handle, "main", reinterpret_cast<unsigned char*>(database.image_->data()),
                        bytes, bytes, SQLITE_DESERIALIZE_READONLY);
  } else {
    sqlite3_close(handle);
  }
  const auto ready = database.harden(database.image_->size());
  if (!ready) return tl::unexpected(ready.error());
  return database;
}

Result<void> Database::harden(std::uint64_t bytes) {
  if (!handle_) return fail(Error::Code::kMalformed, "{}: cannot be opened as a database", name_);
  // A row takes at least 4 bytes and some 30 steps in all; ten times as much is never needed.
  budget_ = std::make_unique<std::int64_t>(10'000'000 + 100 * static_cast<std::int64_t>(bytes));
  sqlite3_progress_handler(handle_.get(), kStepsPerCheck, &spend, budget_.get());
  sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (!answers(handle_.get())) {
    return fail(Error::Code::kMalformed, "{}: no readable SQLite database ({})", name_,
                sqlite3_errmsg(handle_.get()));
  }
  return {};
}

Result<Query> Database::query(const char* sql) {
  Query query;
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(handle_.get(), sql, -1, &statement, nullptr) != SQLITE_OK) {
    return fail(Error::Code::kMalformed, "{}: {}", name_, sqlite3_errmsg(handle_.get()));
  }
  query.statement_.reset(statement);
  return query;
}

}  // namespace scanfuse::io::rosbag2
