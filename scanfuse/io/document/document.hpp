#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scanfuse/core/result.hpp"

/// TOML and JSON files that hold more than options: one tree for both, and checked access to it.
namespace scanfuse::io {

struct DocumentMember;

/// A value of a document and where it stands ("rig.toml:3:7", "features.json: positions[4].scan").
struct DocumentNode {
  using Array = std::vector<DocumentNode>;
  using Table = std::vector<DocumentMember>;

  /// Nothing (JSON null), or a value. Whole numbers are doubles too.
  std::variant<std::monostate, bool, double, std::string, Array, Table> value;
  std::int32_t line = 0;  ///< 0: not known (JSON)
  std::int32_t column = 0;

  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&value); }
  [[nodiscard]] const double* number() const { return std::get_if<double>(&value); }
};

/// A member of a table.
struct DocumentMember {
  std::string name;
  DocumentNode node;
};

/// Errors name line and column (TOML) or byte (JSON). Numbers that are not finite are nothing.
[[nodiscard]] Result<DocumentNode> parse_toml_document(std::string_view text,
                                                       const std::string& name);
[[nodiscard]] Result<DocumentNode> parse_json_document(std::string_view text,
                                                       const std::string& name);

/// The text of a file of at most `limit` bytes; a larger one is refused as no `what`.
[[nodiscard]] Result<std::string> read_document_text(const std::filesystem::path& path,
                                                     std::size_t limit, std::string_view what);

/// A table of a document with its place, for reading it key by key. Holds views: the document and
/// the file's name must outlive it.
class DocumentTable {
 public:
  /// The outermost table.
  [[nodiscard]] static Result<DocumentTable> root(const DocumentNode& node,
                                                  const std::string& file);

  [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
  [[nodiscard]] const DocumentNode* find(std::string_view key) const;

  /// An error that names the place of `key` (of the table itself where the key is not there).
  [[nodiscard]] tl::unexpected<Error> wrong(std::string_view key, std::string_view what) const;

  /// An error naming the nearest known key where another one is there.
  [[nodiscard]] Result<void> only(const std::vector<std::string>& known) const;

  /// A number within [low, high]. The first form needs the key.
  [[nodiscard]] Result<double> number(std::string_view key, double low, double high) const;
  [[nodiscard]] Result<double> number_or(std::string_view key, double fallback, double low,
                                         double high) const;
  [[nodiscard]] Result<int> whole(std::string_view key, int low, int high) const;
  [[nodiscard]] Result<bool> flag_or(std::string_view key, bool fallback) const;
  [[nodiscard]] Result<std::string> text_or(std::string_view key, std::string fallback) const;
  /// One of `known`; an error lists them.
  [[nodiscard]] Result<std::string> choice_or(std::string_view key, std::string fallback,
                                              const std::vector<std::string>& known) const;

  /// Finite numbers; `count` of them, any number where it is 0. With `gaps`, JSON null is NaN.
  [[nodiscard]] Result<std::vector<double>> numbers(std::string_view key, std::size_t count = 0,
                                                    bool gaps = false) const;
  /// A matrix as an array of rows of equal length, row by row.
  [[nodiscard]] Result<std::vector<double>> rows(std::string_view key, std::size_t rows,
                                                 std::size_t columns) const;

  /// A table within; nothing where the key is not there.
  [[nodiscard]] Result<std::optional<DocumentTable>> table(std::string_view key) const;
  /// The tables of an array; none where the key is not there.
  [[nodiscard]] Result<std::vector<DocumentTable>> tables(std::string_view key) const;

 private:
  DocumentTable(const DocumentNode& node, const std::string& file, std::string path)
      : node_(&node), file_(&file), path_(std::move(path)) {}
  [[nodiscard]] std::string place(std::string_view key) const;

  const DocumentNode* node_;
  const std::string* file_;
  std::string path_;  ///< from the root: "lidar", "board[1]"
};

}  // namespace scanfuse::io
