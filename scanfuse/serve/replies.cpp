#include "scanfuse/serve/replies.hpp"

#include <nlohmann/json.hpp>

#include "scanfuse/io/toml.hpp"

namespace scanfuse::serve {
namespace {

using Json = nlohmann::json;

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

template <class T>
Json names() {
  Json all = Json::array();
  for (const auto& [name, choice] : choices(T{})) all.push_back(name);
  return all;
}

Json metrics(const std::optional<evaluate::Evaluation>& evaluation) {
  return evaluation ? Json::parse(evaluate::to_json(*evaluation)) : Json();
}

}  // namespace

std::string hello_json(const Workbench& bench, const Labels& labels) {
  const auto& options = bench.options();
  return text_of({{"op", "hello"},
                  {"protocol", 1},
                  {"title", options.title},
                  {"preset", options.preset},
                  {"presets", pipeline::preset_names()},
                  {"live", bench.is_live()},
                  {"classes", names<ObjectClass>()},
                  {"statuses", names<TrackStatus>()},
                  {"labels_file", labels.file().string()}});
}

std::string status_json(const Workbench& bench) {
  const BenchStatus status = bench.status();
  Json sensors = Json::array();
  for (const auto& sensor : bench.log().sensors()) sensors.push_back(sensor.name);
  Json odd = Json::array();
  const Diagnostics diagnostics = bench.diagnostics();
  for (const auto& [what, entry] : diagnostics.entries()) {
    odd.push_back(
        {{"what", what}, {"count", entry.count}, {"first", entry.first}, {"damage", entry.damage}});
  }
  const auto main = bench.run(RunName::kMain);
  Json json{{"op", "status"},
            {"frames", status.frames},
            {"done", status.done},
            {"problem", status.problem},
            {"has_truth", bench.log().has_truth()},
            {"events", main->event_count()},
            {"confirmed", main->confirmed_count()},
            {"disk_bytes", status.disk_bytes},
            {"sensors", sensors},
            {"origin_m", point(bench.log().origin_m())},
            {"diagnostics", odd},
            {"trial", status.trial},
            {"trial_runs", status.trial_runs}};
  if (const auto trial = bench.run(RunName::kTrial)) {
    json["trial_from"] = status.trial_from;
    json["trial_end"] = status.trial_end;
    json["trial_events"] = trial->event_count();
    json["trial_confirmed"] = trial->confirmed_count();
  }
  return text_of(json);
}

std::string problem_json(std::string_view op, std::string_view what) {
  return text_of({{"op", "problem"}, {"of", op}, {"what", what}});
}

std::string missing_frame_json(const FrameRequest& request) {
  return text_of(
      {{"op", "missing"}, {"run", static_cast<int>(request.run)}, {"frame", request.frame}});
}

std::string options_json(std::string_view preset, const pipeline::PerceptionOptions& options) {
  Json list = Json::array();
  for (const auto& view : pipeline::view_config(options)) {
    if (view.section == "pipeline" && view.name == "frame") continue;  // the view is in the world
    list.push_back({{"section", view.section},
                    {"name", view.name},
                    {"value", view.value},
                    {"fallback", view.fallback},
                    {"range", view.range},
                    {"doc", view.doc},
                    {"text", view.quoted}});
  }
  return text_of({{"op", "options"}, {"preset", preset}, {"options", list}});
}

std::string metrics_json(const Workbench::Comparison& comparison) {
  return text_of({{"op", "metrics"},
                  {"from", comparison.from},
                  {"end", comparison.end},
                  {"main", metrics(comparison.main)},
                  {"trial", metrics(comparison.trial)}});
}

std::string export_json(RunName run, const pipeline::PerceptionOptions& options) {
  return text_of({{"op", "export"},
                  {"run", static_cast<int>(run)},
                  {"toml", io::write_toml(pipeline::view_config(options))}});
}

std::string labels_json(const Labels& labels, const ScanLog& log, const LabelRequest& request) {
  Json objects = Json::array(), boxes = Json::array();
  const Eigen::Vector3d origin = log.origin_m();
  for (const auto& [id, object] : labels.objects()) {
    if (object.boxes.empty()) continue;
    objects.push_back({{"id", id},
                       {"class", to_string(object.object_class)},
                       {"first", object.boxes.begin()->first},
                       {"last", object.boxes.rbegin()->first},
                       {"boxes", object.boxes.size()}});
    const auto here = object.boxes.find(request.frame);
    if (here == object.boxes.end()) continue;
    const auto& [box, z_m, height_m] = here->second;
    boxes.push_back({{"id", id},
                     {"class", to_string(object.object_class)},
                     {"x", box.centre_m.x() - origin.x()},
                     {"y", box.centre_m.y() - origin.y()},
                     {"z", z_m - origin.z()},
                     {"heading", box.heading_rad},
                     {"length", box.length_m},
                     {"width", box.width_m},
                     {"height", height_m}});
  }
  Json json{{"op", "labels"},
            {"frame", request.frame},
            {"objects", objects},
            {"boxes", boxes},
            {"saved", labels.is_saved()},
            {"can_undo", labels.can_undo()},
            {"file", labels.file().string()}};
  if (request.action == LabelRequest::Action::kSave) json["csv"] = labels.csv(log);
  return text_of(json);
}

}  // namespace scanfuse::serve
