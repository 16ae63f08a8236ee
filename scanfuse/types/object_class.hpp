#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace scanfuse {

/// What a detection or track is. Files spell it in lower case.
enum class ObjectClass { kUnknown, kVehicle, kPedestrian, kCyclist, kOther };

/// A number for each ObjectClass, in its order.
inline constexpr std::size_t kObjectClasses = 5;
using ClassProbabilities = std::array<double, kObjectClasses>;

constexpr auto choices(ObjectClass) {
  using enum ObjectClass;
  return std::array{std::pair{"unknown", kUnknown}, std::pair{"vehicle", kVehicle},
                    std::pair{"pedestrian", kPedestrian}, std::pair{"cyclist", kCyclist},
                    std::pair{"other", kOther}};
}

[[nodiscard]] constexpr std::string_view to_string(ObjectClass value) {
  for (const auto& [name, choice] : choices(value)) {
    if (choice == value) return name;
  }
  return "unknown";
}

[[nodiscard]] constexpr std::optional<ObjectClass> object_class_from(std::string_view text) {
  for (const auto& [name, choice] : choices(ObjectClass{})) {
    if (text == name) return choice;
  }
  return std::nullopt;
}

}  // namespace scanfuse
