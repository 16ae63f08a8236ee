#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace scanfuse::io::rosbag2 {

/// One SQL query, stepped row by row.
class Query {
 public:
  enum class Step { kRow, kDone, kFailed };
  [[nodiscard]] Step step();
  void restart_with(std::int64_t argument);  ///< binds ?1
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::span<const std::byte> blob(int column) const;  ///< until the next step
  [[nodiscard]] std::string problem() const;

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A SQLite database that is only read. Files from strangers: views and triggers are off, and a
/// budget of work in proportion to the file's size keeps crafted page loops from running forever.
class Database {
 public:
  /// Opened as immutable, so that nothing beside the file is needed; if an unmerged write-ahead
  /// log stands beside it, with the log.
  [[nodiscard]] static Result<Database> open(const std::filesystem::path& path);
  /// A database in memory; `name` stands for it in messages.
  [[nodiscard]] static Result<Database> open(std::vector<std::byte> image, std::string name);

  [[nodiscard]] Result<Query> query(const char* sql);
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The write-ahead log beside the file could not be used: its messages are lost.
  [[nodiscard]] bool log_ignored() const { return log_ignored_; }

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  Result<void> harden(std::uint64_t bytes);

  std::string name_;
  std::unique_ptr<std::vector<std::byte>> image_;  ///< outlives the handle below
  std::unique_ptr<std::int64_t> budget_;
  std::unique_ptr<sqlite3, Close> handle_;
  bool log_ignored_ = false;
};

}  // namespace scanfuse::io::rosbag2
