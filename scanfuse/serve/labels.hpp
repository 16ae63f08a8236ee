#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/serve/requests.hpp"
#include "scanfuse/serve/run.hpp"

namespace scanfuse::serve {

/// A box that somebody looked at, world frame.
struct LabelBox {
  Box2 box;
  double z_m = 0;
  double height_m = 0;
};

/// An object that somebody looked at: where it is, frame by frame.
struct LabelObject {
  ObjectClass object_class = ObjectClass::kUnknown;
  std::map<std::uint32_t, LabelBox> boxes;  ///< by frame of the viewer
};

/// Truth made by hand: tracks are accepted as objects, then corrected, merged and split. Every
/// change can be undone, up to 100 of them. Used by one thread.
class Labels {
 public:
  /// `file`: where `save` writes, as a truth CSV; empty: it only gives the text.
  explicit Labels(std::filesystem::path file = {}) : file_(std::move(file)) {}

  /// Does what the request asks; an error says why it cannot. `run` is what tracks are taken from.
  [[nodiscard]] Result<void> apply(const LabelRequest& request, const Run& run, const ScanLog& log);
  /// Labels of an earlier sitting, matched to frames by time.
  void load(const std::vector<TruthFrame>& frames, const ScanLog& log);

  [[nodiscard]] const std::map<std::int64_t, LabelObject>& objects() const { return objects_; }
  [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
  [[nodiscard]] bool is_saved() const { return saved_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// As truth, frame by frame; velocities are differences of neighbouring boxes.
  [[nodiscard]] std::vector<TruthFrame> truth(const ScanLog& log) const;
  /// The same as a truth CSV.
  [[nodiscard]] std::string csv(const ScanLog& log) const;

 private:
  using Before = std::vector<std::pair<std::int64_t, std::optional<LabelObject>>>;
  [[nodiscard]] std::int64_t free_id(std::int64_t wanted) const;
  void keep(Before& before, std::int64_t object) const;
  [[nodiscard]] Result<void> accept(const LabelRequest& request, const Run& run, Before& before);
  [[nodiscard]] Result<void> edit(const LabelRequest& request, LabelObject& object,
                                  const ScanLog& log, Before& before);
  [[nodiscard]] Result<void> merge(const LabelRequest& request, Before& before);
  void split(const LabelRequest& request, LabelObject& object, Before& before);
  void undo();

  std::filesystem::path file_;
  std::map<std::int64_t, LabelObject> objects_;
  std::deque<Before> undo_;
  bool saved_ = true;
};

}  // namespace scanfuse::serve
