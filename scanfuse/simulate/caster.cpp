#include "scanfuse/simulate/caster.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scanfuse/core/assert.hpp"

namespace scanfuse::simulate {
namespace {

constexpr int kPacket = 8;

RTCScene mesh_scene(RTCDevice device, const Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices.size()));
  auto* triangles = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangles.size()));
  SCANFUSE_ASSERT(vertices != nullptr && triangles != nullptr);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    std::copy_n(mesh.vertices[i].data(), 3, vertices + 3 * i);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::copy_n(mesh.triangles[i].data(), 3, triangles + 3 * i);
  }
  rtcCommitGeometry(geometry);
  RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

void set_transform(RTCGeometry instance, unsigned step, const Pose3& pose) {
  const Eigen::Matrix3f r = pose.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = pose.translation_m.cast<float>();
  float columns[12];
  std::copy_n(r.data(), 9, columns);
  std::copy_n(t.data(), 3, columns + 9);
  rtcSetGeometryTransform(instance, step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
}

}  // namespace

struct Caster::Scene {
  struct Instance {
    RTCGeometry geometry = nullptr;
    std::int32_t actor = -1;
    const Part* part = nullptr;  ///< nullptr: the fixed world
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
  };
  const World* world = nullptr;
  RTCDevice device = nullptr;
  RTCScene top = nullptr;
  std::vector<RTCScene> parts;
  std::vector<Instance> instances;  ///< by Embree's geometry id

  explicit Scene(const World& w) : world(&w), device(rtcNewDevice("threads=1,set_affinity=0")) {
    SCANFUSE_ASSERT(device != nullptr);
    top = rtcNewScene(device);
    rtcSetSceneFlags(top, RTC_SCENE_FLAG_DYNAMIC);
    add(w.fixed, -1, nullptr);
    for (std::size_t a = 0; a < w.actors.size(); ++a) {
      for (const auto& part : w.actors[a].parts) add(part.mesh, static_cast<int>(a), &part);
    }
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene() {
    for (const auto& instance : instances) rtcReleaseGeometry(instance.geometry);
    for (RTCScene part : parts) rtcReleaseScene(part);
    rtcReleaseScene(top);
    rtcReleaseDevice(device);
  }

  void add(const Mesh& mesh, int actor, const Part* part) {
    if (mesh.triangles.empty()) return;
    parts.push_back(mesh_scene(device, mesh));
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, parts.back());
    rtcSetGeometryTimeStepCount(geometry, part != nullptr ? 2 : 1);
    set_transform(geometry, 0, {});
    if (part != nullptr) set_transform(geometry, 1, {});
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(top, geometry);
    instances.push_back({geometry, actor, part, Eigen::Matrix3f::Identity()});
  }

  [[nodiscard]] Pose3 pose_of(const Instance& instance, double t_s) const {
    const auto& actor = world->actors[static_cast<std::size_t>(instance.actor)];
    const Pose3 body = Pose3::from_planar(actor.motion.pose(t_s));
    return instance.part->pose ? body * instance.part->pose(t_s) : body;
  }

  [[nodiscard]] const Mesh& mesh_of(const Instance& instance) const {
    return instance.part != nullptr ? instance.part->mesh : world->fixed;
  }

  void load(std::span<const Ray> rays, float far_m, RTCRayHit8& packet, int* valid) const {
    for (int i = 0; i < kPacket; ++i) {
      const bool used = static_cast<std::size_t>(i) < rays.size();
      const Ray& ray = rays[used ? static_cast<std::size_t>(i) : 0];
      valid[i] = used ? -1 : 0;
      packet.ray.org_x[i] = ray.origin_m.x();
      packet.ray.org_y[i] = ray.origin_m.y();
      packet.ray.org_z[i] = ray.origin_m.z();
      packet.ray.dir_x[i] = ray.direction.x();
      packet.ray.dir_y[i] = ray.direction.y();
      packet.ray.dir_z[i] = ray.direction.z();
      packet.ray.time[i] = ray.time;
      packet.ray.tnear[i] = 0.01F;
      packet.ray.tfar[i] = far_m;
      packet.ray.mask[i] = ~0U;
      packet.ray.flags[i] = 0;
      packet.ray.id[i] = 0;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  [[nodiscard]] Hit hit_of(const RTCRayHit8& packet, int i, const Ray& ray) const {
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) return {};
    const Instance& instance = instances[packet.hit.instID[0][i]];
    const Eigen::Vector3f normal =
        instance.rotation *
        Eigen::Vector3f(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]);
    const float cosine = std::abs(normal.dot(ray.direction)) / std::max(normal.norm(), 1e-12F);
    return {packet.ray.tfar[i], std::min(cosine, 1.0F), instance.actor,
            mesh_of(instance).surfaces[packet.hit.primID[i]]};
  }
};

Caster::Caster(const World& world) : scene_(std::make_unique<Scene>(world)) { move_to(0, 0); }
Caster::~Caster() = default;
Caster::Caster(Caster&&) noexcept = default;
Caster& Caster::operator=(Caster&&) noexcept = default;

void Caster::move_to(double from_s, double to_s) {
  for (auto& instance : scene_->instances) {
    if (instance.part == nullptr) continue;
    const Pose3 begin = scene_->pose_of(instance, from_s);
    instance.rotation = begin.rotation.toRotationMatrix().cast<float>();
    set_transform(instance.geometry, 0, begin);
    set_transform(instance.geometry, 1, scene_->pose_of(instance, to_s));
    rtcCommitGeometry(instance.geometry);
  }
  rtcCommitScene(scene_->top);
}

std::vector<Hit> Caster::cast(std::span<const Ray> rays, double max_range_m) const {
  std::vector<Hit> hits(rays.size());
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (std::size_t first = 0; first < rays.size(); first += kPacket) {
    const auto group = rays.subspan(first, std::min<std::size_t>(kPacket, rays.size() - first));
    RTCRayHit8 packet;
    alignas(32) int valid[kPacket];
    scene_->load(group, static_cast<float>(max_range_m), packet, valid);
    rtcIntersect8(valid, scene_->top, &context, &packet);
    for (std::size_t i = 0; i < group.size(); ++i) {
      hits[first + i] = scene_->hit_of(packet, static_cast<int>(i), group[i]);
    }
  }
  return hits;
}

}  // namespace scanfuse::simulate
