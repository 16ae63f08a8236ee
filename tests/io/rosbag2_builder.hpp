#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace scanfuse::io {

/// Makes small `.db3` files for tests.
class Db3Builder {
 public:
  Db3Builder() {
    sqlite3_open(":memory:", &handle_);
    run("PRAGMA page_size = 512");
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp "
        "INTEGER NOT NULL, data BLOB NOT NULL)");
  }
  Db3Builder(const Db3Builder&) = delete;
  Db3Builder& operator=(const Db3Builder&) = delete;
  ~Db3Builder() { sqlite3_close(handle_); }

  void run(const std::string& sql) {
    sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  }

  void topic(int id, const std::string& name, const std::string& type) {
    run("INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + name + "','" + type +
        "','cdr')");
  }
  void message(int topic_id, std::int64_t nanos, const std::vector<std::byte>& bytes) {
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(handle_,
                       "INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)", -1,
                       &insert, nullptr);
    sqlite3_bind_int(insert, 1, topic_id);
    sqlite3_bind_int64(insert, 2, nanos);
    sqlite3_bind_blob(insert, 3, bytes.data(), static_cast<int>(bytes.size()), SQLITE_STATIC);
    sqlite3_step(insert);
    sqlite3_finalize(insert);
  }
  void index_times() { run("CREATE INDEX timestamp_idx ON messages (timestamp ASC)"); }

  [[nodiscard]] std::vector<std::byte> image() const {
    sqlite3_int64 size = 0;
    unsigned char* bytes = sqlite3_serialize(handle_, "main", &size, 0);
    std::vector<std::byte> copy(static_cast<std::size_t>(size));
    std::memcpy(copy.data(), bytes, copy.size());
    sqlite3_free(bytes);
    return copy;
  }

 private:
  sqlite3* handle_ = nullptr;
};

}  // namespace scanfuse::io
