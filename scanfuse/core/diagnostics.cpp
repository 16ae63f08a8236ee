#include "scanfuse/core/diagnostics.hpp"

namespace scanfuse {

Diagnostics::Entry& Diagnostics::entry(std::string_view what, std::string_view where,
                                       std::int64_t times) {
  auto found = entries_.find(what);
  if (found == entries_.end()) {
    found = entries_.emplace(std::string(what), Entry{0, std::string(where), false}).first;
  }
  found->second.count += times;
  return found->second;
}

void Diagnostics::note(std::string_view what, std::string_view where, std::int64_t times) {
  entry(what, where, times);
}

void Diagnostics::damage(std::string_view what, std::string_view where, std::int64_t times) {
  entry(what, where, times).damage = true;
}

void Diagnostics::merge(const Diagnostics& other) {
  for (const auto& [what, theirs] : other.entries_) {
    auto& ours = entry(what, theirs.first, theirs.count);
    ours.damage = ours.damage || theirs.damage;
  }
}

bool Diagnostics::any_damage() const {
  for (const auto& [what, entry] : entries_) {
    if (entry.damage) return true;
  }
  return false;
}

std::int64_t Diagnostics::count(std::string_view what) const {
  const auto found = entries_.find(what);
  return found == entries_.end() ? 0 : found->second.count;
}

}  // namespace scanfuse
