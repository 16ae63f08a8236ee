#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace scanfuse {

/// Odd but survivable events, counted and never silent: bad points skipped, clock jumps, damaged
/// chunks. Ordered by name, so that printing it is deterministic.
class Diagnostics {
 public:
  struct Entry {
    std::int64_t count = 0;
    std::string first;    ///< where it happened first, in words
    bool damage = false;  ///< part of the input was lost: the command ends with exit code 3
  };

  /// Counts an oddity that lost nothing ("ego pose extrapolated").
  void note(std::string_view what, std::string_view where = {}, std::int64_t times = 1);
  /// Counts a loss of input ("truncated chunk skipped").
  void damage(std::string_view what, std::string_view where = {}, std::int64_t times = 1);
  void merge(const Diagnostics& other);

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] bool any_damage() const;
  [[nodiscard]] std::int64_t count(std::string_view what) const;
  [[nodiscard]] const std::map<std::string, Entry, std::less<>>& entries() const {
    return entries_;
  }

 private:
  Entry& entry(std::string_view what, std::string_view where, std::int64_t times);
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace scanfuse
