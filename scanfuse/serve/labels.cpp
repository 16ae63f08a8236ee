#include "scanfuse/serve/labels.hpp"

#include <algorithm>

#include "scanfuse/io/csv/tables_of_lines.hpp"
#include "scanfuse/io/tables.hpp"

namespace scanfuse::serve {
namespace {

using Action = LabelRequest::Action;
constexpr std::size_t kMostUndo = 100;

/// Where the track was, without the frames at its end in which nothing was seen of it any more.
Result<LabelObject> object_of(const Run& run, std::int64_t track, std::uint32_t first,
                              std::uint32_t last) {
  LabelObject object;
  std::uint32_t last_seen = first;
  for (std::uint32_t frame = first; frame <= last; ++frame) {
    const auto step = run.step(frame);
    if (!step) return tl::unexpected(step.error());
    const auto found = std::ranges::find(step->tracks, track, &Track::id);
    if (found == step->tracks.end()) continue;
    object.boxes[frame] = {found->box, found->z_m, found->height_m};
    object.object_class = found->object_class;
    if (found->status != TrackStatus::kCoasting) last_seen = frame;
  }
  object.boxes.erase(object.boxes.upper_bound(last_seen), object.boxes.end());
  return object;
}

/// The speed between the boxes around a frame.
std::optional<Eigen::Vector2d> velocity(const LabelObject& object, std::uint32_t frame,
                                        const ScanLog& log) {
  const auto here = object.boxes.find(frame);
  const auto before = here == object.boxes.begin() ? here : std::prev(here);
  const auto after = std::next(here) == object.boxes.end() ? here : std::next(here);
  const double dt = to_seconds(log.stamp(after->first) - log.stamp(before->first));
  if (!(dt > 0)) return std::nullopt;
  return Eigen::Vector2d((after->second.box.centre_m - before->second.box.centre_m) / dt);
}

TruthObject truth_of(std::int64_t id, const LabelObject& object, std::uint32_t frame,
                     const ScanLog& log) {
  const LabelBox& label = object.boxes.at(frame);
  TruthObject truth;
  truth.id = id;
  truth.object_class = object.object_class;
  truth.position_m = label.box.centre_m;
  truth.z_m = label.z_m;
  truth.heading_rad = label.box.heading_rad;
  truth.length_m = label.box.length_m;
  truth.width_m = label.box.width_m;
  if (label.height_m > 0) truth.height_m = label.height_m;
  truth.velocity_m_per_s = velocity(object, frame, log);
  return truth;
}

}  // namespace

std::int64_t Labels::free_id(std::int64_t wanted) const {
  if (wanted > 0 && !objects_.contains(wanted)) return wanted;
  return objects_.empty() ? 1 : std::max<std::int64_t>(objects_.rbegin()->first, 0) + 1;
}

void Labels::keep(Before& before, std::int64_t object) const {
  const auto found = objects_.find(object);
  before.emplace_back(object,
                      found == objects_.end() ? std::nullopt : std::optional(found->second));
}

Result<void> Labels::accept(const LabelRequest& request, const Run& run, Before& before) {
  const auto life = run.life(request.track);
  if (!life) return fail(Error::Code::kNotFound, "no track {}", request.track);
  const bool whole = request.action == Action::kAccept;
  auto object = object_of(run, request.track, whole ? life->first : request.frame,
                          whole ? life->second : request.frame);
  if (!object) return tl::unexpected(object.error());
  if (object->boxes.empty()) {
    return fail(Error::Code::kNotFound, "track {} is not in frame {}", request.track,
                request.frame);
  }
  if (whole) {
    const std::int64_t id = free_id(request.track);
    keep(before, id);
    objects_[id] = std::move(*object);
    return {};
  }
  const bool extends = objects_.contains(request.object);
  const std::int64_t id = extends ? request.object : free_id(request.track);
  keep(before, id);
  auto& target = objects_[id];
  if (!extends) target.object_class = object->object_class;
  target.boxes.insert_or_assign(request.frame, object->boxes.begin()->second);
  return {};
}

Result<void> Labels::merge(const LabelRequest& request, Before& before) {
  const auto from = objects_.find(request.object);
  const auto into = objects_.find(request.other);
  if (from == objects_.end() || into == objects_.end() || from == into) {
    return fail(Error::Code::kNotFound, "objects {} and {} cannot be merged", request.object,
                request.other);
  }
  keep(before, request.object);
  keep(before, request.other);
  into->second.boxes.merge(from->second.boxes);  // where both have a box, `other` keeps its own
  objects_.erase(from);
  return {};
}

void Labels::split(const LabelRequest& request, LabelObject& object, Before& before) {
  const std::int64_t id = free_id(0);
  keep(before, id);
  LabelObject later;
  later.object_class = object.object_class;
  const auto from = object.boxes.lower_bound(request.frame);
  later.boxes.insert(from, object.boxes.end());
  object.boxes.erase(from, object.boxes.end());
  objects_[id] = std::move(later);
}

Result<void> Labels::edit(const LabelRequest& request, LabelObject& object, const ScanLog& log,
                          Before& before) {
  switch (request.action) {
    case Action::kClass:
      object.object_class = request.object_class;
      return {};
    case Action::kCorrect: {
      if (request.frame >= log.size()) {
        return fail(Error::Code::kNotFound, "no frame {}", request.frame);
      }
      auto& label = object.boxes[request.frame];
      label.box = request.box;
      label.box.centre_m += log.origin_m().head<2>();
      return {};
    }
    case Action::kRemoveFrame:
      object.boxes.erase(request.frame);
      if (object.boxes.empty()) objects_.erase(request.object);
      return {};
    case Action::kRemove:
      objects_.erase(request.object);
      return {};
    default: {
      const bool both_live = object.boxes.lower_bound(request.frame) != object.boxes.end() &&
                             object.boxes.begin()->first < request.frame;
      if (!both_live) {
        return fail(Error::Code::kOutOfRange, "object {} has no boxes on both sides of frame {}",
                    request.object, request.frame);
      }
      split(request, object, before);
      return {};
    }
  }
}

void Labels::undo() {
  if (undo_.empty()) return;
  for (auto& [id, object] : undo_.back()) {
    if (object) {
      objects_[id] = std::move(*object);
    } else {
      objects_.erase(id);
    }
  }
  undo_.pop_back();
}

Result<void> Labels::apply(const LabelRequest& request, const Run& run, const ScanLog& log) {
  if (request.action == Action::kList) return {};
  if (request.action == Action::kSave) {
    if (!file_.empty()) {
      if (auto done = io::write_truth_csv(file_, truth(log)); !done) return done;
    }
    saved_ = true;
    return {};
  }
  saved_ = false;
  if (request.action == Action::kUndo) {
    undo();
    return {};
  }
  Before before;
  Result<void> done;
  if (request.action == Action::kAccept || request.action == Action::kAcceptFrame) {
    done = accept(request, run, before);
  } else if (request.action == Action::kMerge) {
    done = merge(request, before);
  } else {
    const auto found = objects_.find(request.object);
    if (found == objects_.end()) {
      return fail(Error::Code::kNotFound, "no object {} among the labels", request.object);
    }
    keep(before, request.object);
    done = edit(request, found->second, log, before);
  }
  if (!done) return done;
  undo_.push_back(std::move(before));
  if (undo_.size() > kMostUndo) undo_.pop_front();
  return {};
}

void Labels::load(const std::vector<TruthFrame>& frames, const ScanLog& log) {
  std::map<Time, std::uint32_t> by_time;
  for (std::uint32_t frame = 0; frame < log.size(); ++frame) by_time[log.stamp(frame)] = frame;
  for (const auto& truth : frames) {
    // Times are written to the microsecond.
    const auto found = by_time.lower_bound(truth.stamp - std::chrono::microseconds(2));
    if (found == by_time.end() || found->first > truth.stamp + std::chrono::microseconds(2)) {
      continue;
    }
    for (const auto& object : truth.objects) {
      auto& label = objects_[object.id];
      label.object_class = object.object_class;
      label.boxes[found->second] = {{object.position_m, object.heading_rad.value_or(0),
                                     object.length_m.value_or(0.5), object.width_m.value_or(0.5)},
                                    object.z_m,
                                    object.height_m.value_or(0)};
    }
  }
}

std::vector<TruthFrame> Labels::truth(const ScanLog& log) const {
  std::map<std::uint32_t, TruthFrame> frames;
  for (const auto& [id, object] : objects_) {
    for (const auto& [frame, box] : object.boxes) {
      auto& truth_frame = frames[frame];
      truth_frame.stamp = log.stamp(frame);
      truth_frame.frame = log.number(frame);
      truth_frame.objects.push_back(truth_of(id, object, frame, log));
    }
  }
  std::vector<TruthFrame> in_order;
  for (auto& [frame, truth_frame] : frames) in_order.push_back(std::move(truth_frame));
  return in_order;
}

std::string Labels::csv(const ScanLog& log) const {
  std::string text = io::truth_header();
  for (const auto& frame : truth(log)) text += io::truth_rows(frame);
  return text;
}

}  // namespace scanfuse::serve
