#include "scanfuse/pipeline/frame_tree.hpp"

#include <algorithm>

namespace scanfuse::pipeline {

std::string plain_frame(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

void FrameTree::add(const TransformSample& sample) {
  Edge& edge = edges_[plain_frame(sample.child)];
  edge.parent = plain_frame(sample.parent);
  edge.is_static = sample.is_static;
  if (sample.is_static) edge.poses = {};
  edge.poses.add(sample.stamp, sample.parent_from_child);
}

std::vector<std::string> FrameTree::ancestry(const std::string& frame) const {
  std::vector<std::string> names{plain_frame(frame)};
  for (auto edge = edges_.find(names.back()); edge != edges_.end();
       edge = edges_.find(names.back())) {
    if (std::find(names.begin(), names.end(), edge->second.parent) != names.end()) break;
    names.push_back(edge->second.parent);
  }
  return names;
}

std::vector<const FrameTree::Edge*> FrameTree::path(const std::string& ancestor,
                                                    const std::string& frame) const {
  std::vector<const Edge*> edges;
  for (const auto& name : ancestry(frame)) {
    if (name == ancestor) return edges;
    const auto found = edges_.find(name);
    if (found == edges_.end()) break;
    edges.push_back(&found->second);
  }
  return {};
}

std::optional<PoseBuffer::Found> FrameTree::lookup(const std::string& ancestor,
                                                   const std::string& frame, Time stamp) const {
  const std::string target = plain_frame(ancestor);
  if (target == plain_frame(frame)) return PoseBuffer::Found{};
  const auto edges = path(target, frame);
  if (edges.empty()) return std::nullopt;
  PoseBuffer::Found total;
  for (const Edge* edge : edges) {
    const auto step = edge->poses.at(stamp);
    total.pose = step->pose * total.pose;
    total.extrapolated = total.extrapolated || (!edge->is_static && step->extrapolated);
  }
  return total;
}

bool FrameTree::covers(const std::string& ancestor, const std::string& frame, Time stamp) const {
  const auto edges = path(plain_frame(ancestor), frame);
  return std::all_of(edges.begin(), edges.end(), [&](const Edge* edge) {
    return edge->is_static || edge->poses.covers(stamp);
  });
}

bool FrameTree::moves(const std::string& ancestor, const std::string& frame) const {
  const auto edges = path(plain_frame(ancestor), frame);
  return std::any_of(edges.begin(), edges.end(), [](const Edge* edge) { return !edge->is_static; });
}

void FrameTree::forget_before(Time stamp) {
  for (auto& [child, edge] : edges_) edge.poses.forget_before(stamp);
}

}  // namespace scanfuse::pipeline
