#include "scanfuse/serve/requests.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace scanfuse::serve {
namespace {

using Json = nlohmann::json;
constexpr std::size_t kMostChanges = 256;

/// Reads members of one object; the first that is wrong is kept.
class Members {
 public:
  explicit Members(const Json& json) : json_(json) {}

  /// A whole number within [low, high]; `low` when it is absent.
  std::int64_t whole(const char* name, std::int64_t low, std::int64_t high) {
    const auto found = json_.find(name);
    if (found == json_.end()) return low;
    const double value = found->is_number() ? found->get<double>() : std::nan("");
    if (!(std::abs(value) < 9e15) || value != std::floor(value) ||
        value < static_cast<double>(low) || value > static_cast<double>(high)) {
      refuse(name, "a whole number");
      return low;
    }
    return static_cast<std::int64_t>(value);
  }
  std::uint32_t frame(const char* name) {
    return static_cast<std::uint32_t>(whole(name, 0, 0xffffffffLL));
  }
  std::int64_t id(const char* name) {
    return json_.contains(name) ? whole(name, -9'000'000'000'000'000, 9'000'000'000'000'000) : 0;
  }
  double number(const char* name) {
    const auto found = json_.find(name);
    const double value =
        found != json_.end() && found->is_number() ? found->get<double>() : std::nan("");
    if (std::abs(value) < 1e7) return value;
    refuse(name, "a number");
    return 0;
  }
  std::string text(const char* name) {
    const auto found = json_.find(name);
    if (found == json_.end()) return {};
    if (found->is_string() && found->get_ref<const std::string&>().size() <= 200) {
      return found->get<std::string>();
    }
    refuse(name, "a short text");
    return {};
  }
  std::vector<std::string> texts(const char* name) {
    std::vector<std::string> all;
    const auto found = json_.find(name);
    if (found == json_.end()) return all;
    if (!found->is_array() || found->size() > kMostChanges) {
      refuse(name, "a list of texts");
      return all;
    }
    for (const Json& one : *found) {
      if (one.is_string()) {
        all.push_back(one.get<std::string>());
      } else {
        refuse(name, "a list of texts");
      }
    }
    return all;
  }
  RunName run() { return whole("run", 0, 1) == 1 ? RunName::kTrial : RunName::kMain; }
  void refuse(std::string_view name, std::string_view wanted) {
    if (problem.empty()) problem = fmt::format("'{}' must be {}", name, wanted);
  }

  std::string problem;

 private:
  const Json& json_;
};

LabelRequest read_label(Members& members) {
  LabelRequest label;
  const std::string action = members.text("action");
  bool known = false;
  for (const auto& [name, choice] : choices(LabelRequest::Action{})) {
    if (action != name) continue;
    label.action = choice;
    known = true;
  }
  if (!known) members.refuse("action", "the name of a change of labels");
  label.track = members.id("track");
  label.object = members.id("object");
  label.other = members.id("other");
  label.frame = members.frame("frame");
  if (label.action == LabelRequest::Action::kClass) {
    const auto found = object_class_from(members.text("class"));
    if (!found) members.refuse("class", "the name of a class");
    label.object_class = found.value_or(ObjectClass::kUnknown);
  }
  if (label.action == LabelRequest::Action::kCorrect) {
    label.box = Box2{{members.number("x_m"), members.number("y_m")},
                     members.number("heading_rad"),
                     members.number("length_m"),
                     members.number("width_m")};
    if (!(label.box.length_m > 0 && label.box.width_m > 0)) {
      members.refuse("length_m", "positive, and width_m too");
    }
  }
  return label;
}

using Reader = ViewerRequest (*)(Members& members);

const std::map<std::string_view, Reader>& readers() {
  static const std::map<std::string_view, Reader> known{
      {"index", [](Members& m) -> ViewerRequest { return IndexRequest{m.run(), m.frame("from")}; }},
      {"frame",
       [](Members& m) -> ViewerRequest { return FrameRequest{m.run(), m.frame("frame")}; }},
      {"events",
       [](Members& m) -> ViewerRequest { return EventsRequest{m.run(), m.frame("from")}; }},
      {"history",
       [](Members& m) -> ViewerRequest { return HistoryRequest{m.run(), m.id("track")}; }},
      {"trails",
       [](Members& m) -> ViewerRequest {
         return TrailsRequest{m.run(), m.frame("frame"),
                              static_cast<std::uint32_t>(m.whole("length", 0, 200))};
       }},
      {"options", [](Members& m) -> ViewerRequest { return OptionsRequest{m.text("preset")}; }},
      {"tune",
       [](Members& m) -> ViewerRequest {
         return TuneRequest{m.frame("from"), m.text("preset"), m.texts("changes")};
       }},
      {"stop_tune", [](Members&) -> ViewerRequest { return StopTuneRequest{}; }},
      {"metrics", [](Members&) -> ViewerRequest { return MetricsRequest{}; }},
      {"export", [](Members& m) -> ViewerRequest { return ExportRequest{m.run()}; }},
      {"label", [](Members& m) -> ViewerRequest { return read_label(m); }},
  };
  return known;
}

}  // namespace

Result<ViewerRequest> parse_request(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return fail(Error::Code::kMalformed, "not a JSON object");
  Members members(json);
  const std::string op = members.text("op");
  const auto found = readers().find(op);
  if (found == readers().end()) {
    return fail(Error::Code::kUnsupported, "no request '{}'", op);
  }
  ViewerRequest request = found->second(members);
  if (!members.problem.empty()) {
    return fail(Error::Code::kMalformed, "{}: {}", op, members.problem);
  }
  return request;
}

}  // namespace scanfuse::serve
