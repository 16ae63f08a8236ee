#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io {

/// Bytes put aside on disk for as long as the program runs, packed (zstd, level 1), so that what is
/// long need not be held in memory. The file has no name: nothing is left behind, however the
/// program ends. Safe to use from several threads.
class Spool {
 public:
  /// Where something was put.
  struct Place {
    std::uint64_t offset = 0;
    std::uint32_t stored = 0;  ///< bytes on disk; 0: nothing was put
    std::uint32_t size = 0;    ///< bytes unpacked
  };

  /// In the folder that TMPDIR names, else in /var/tmp.
  [[nodiscard]] static Result<Spool> create();
  Spool(Spool&&) noexcept;
  Spool& operator=(Spool&&) noexcept;
  ~Spool();

  /// A full disk is an error of the call that met it; what was put before stays readable.
  [[nodiscard]] Result<Place> put(std::span<const std::byte> bytes);
  [[nodiscard]] Result<Place> put(const std::string& bytes);
  [[nodiscard]] Result<std::string> get(const Place& place) const;
  /// On disk so far.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct State;
  explicit Spool(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace scanfuse::io
