#pragma once

namespace scanfuse::app {

/// What this process holds in memory, MB; 0 where the system does not tell.
[[nodiscard]] double resident_mb();

/// The most it ever held, MB, or since `forget_peak_memory`.
[[nodiscard]] double peak_memory_mb();

/// Gives back what is free and lets the peak start over from what is held now.
void forget_peak_memory();

}  // namespace scanfuse::app
