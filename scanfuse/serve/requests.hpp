#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/object_class.hpp"

/// What the page asks for, one JSON object a message; docs/viewer-protocol.md lists them.
namespace scanfuse::serve {

/// The results shown first, and those of the options being tried beside them.
enum class RunName : std::uint8_t { kMain = 0, kTrial = 1 };

struct IndexRequest {
  RunName run = RunName::kMain;
  std::uint32_t from = 0;
};
struct FrameRequest {
  RunName run = RunName::kMain;
  std::uint32_t frame = 0;
};
struct EventsRequest {
  RunName run = RunName::kMain;
  std::uint32_t from = 0;  ///< place in the list of events
};
struct HistoryRequest {
  RunName run = RunName::kMain;
  std::int64_t track = 0;
};
struct TrailsRequest {
  RunName run = RunName::kMain;
  std::uint32_t frame = 0;
  std::uint32_t length = 0;  ///< frames before it, at most 200
};
struct OptionsRequest {
  std::string preset;  ///< empty: those of the main run
};
struct TuneRequest {
  std::uint32_t from = 0;            ///< frame
  std::string preset;                ///< empty: start from the options of the main run
  std::vector<std::string> changes;  ///< "section.name=value"
};
struct StopTuneRequest {};
struct MetricsRequest {};
struct ExportRequest {
  RunName run = RunName::kMain;
};

/// A change of the labels.
struct LabelRequest {
  enum class Action {
    kAccept,       ///< a track, over its whole life, becomes an object
    kAcceptFrame,  ///< of one frame only
    kCorrect,      ///< another box at one frame
    kClass,        ///< of an object
    kMerge,        ///< object becomes part of `other`
    kSplit,        ///< from `frame` on the object is another
    kRemove,       ///< a whole object
    kRemoveFrame,  ///< its box of one frame
    kUndo,
    kList,  ///< changes nothing
    kSave,
  };
  Action action = Action::kList;
  std::int64_t track = 0;
  std::int64_t object = 0;
  std::int64_t other = 0;
  std::uint32_t frame = 0;
  ObjectClass object_class = ObjectClass::kUnknown;
  Box2 box;  ///< in the scene's coordinates
};

constexpr auto choices(LabelRequest::Action) {
  using enum LabelRequest::Action;
  return std::array{std::pair{"accept", kAccept},   std::pair{"accept_frame", kAcceptFrame},
                    std::pair{"correct", kCorrect}, std::pair{"class", kClass},
                    std::pair{"merge", kMerge},     std::pair{"split", kSplit},
                    std::pair{"remove", kRemove},   std::pair{"remove_frame", kRemoveFrame},
                    std::pair{"undo", kUndo},       std::pair{"list", kList},
                    std::pair{"save", kSave}};
}

using ViewerRequest = std::variant<IndexRequest, FrameRequest, EventsRequest, HistoryRequest,
                                   TrailsRequest, OptionsRequest, TuneRequest, StopTuneRequest,
                                   MetricsRequest, ExportRequest, LabelRequest>;

/// Never crashes, whatever the text; what is wrong is said in words for the page to show.
[[nodiscard]] Result<ViewerRequest> parse_request(std::string_view text);

}  // namespace scanfuse::serve
