#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <set>

#include "scanfuse/drivers/ros2/blob_type.hpp"
#include "scanfuse/drivers/ros2/ros2_bus.hpp"

namespace scanfuse::drivers {
namespace {

/// Messages of a topic that may wait inside the middleware, deep enough for clouds in a burst.
constexpr int kHistory = 32;
constexpr dds_duration_t kBlocked = DDS_MSECS(10);  ///< a writer waits at most so long
constexpr std::size_t kAtOnce = 16;

/// Loopback alone, found without multicast, as ROS 2 does it with ROS_LOCALHOST_ONLY.
constexpr const char* kLocalhostOnly =
    "<General><Interfaces><NetworkInterface address=\"127.0.0.1\"/></Interfaces>"
    "<AllowMulticast>false</AllowMulticast></General>"
    "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
    "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>";

bool is_set_to(const char* variable, std::string_view value) {
  const char* text = std::getenv(variable);
  return text != nullptr && text == value;
}

bool is_localhost_only() {
  return is_set_to("ROS_LOCALHOST_ONLY", "1") ||
         is_set_to("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST");
}

struct QosDelete {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using QosPtr = std::unique_ptr<dds_qos_t, QosDelete>;

QosPtr make_qos(Ros2Qos profile, bool reads) {
  QosPtr qos(dds_create_qos());
  const bool reliable = profile != Ros2Qos::kSensorData;
  dds_qset_reliability(qos.get(), reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       kBlocked);
  const bool latched = profile == Ros2Qos::kLatched;
  dds_qset_durability(qos.get(),
                      latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  // A latched writer keeps its last message; a reader hears several such writers.
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, latched && !reads ? 1 : kHistory);
  const dds_data_representation_id_t xcdr1 = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &xcdr1);
  dds_qset_ignorelocal(qos.get(), DDS_IGNORELOCAL_PARTICIPANT);
  return qos;
}

/// What a subscription hands on, at an address that its listener knows.
struct Subscription {
  TakeMessage take;
  std::mutex mutex;  ///< one message at a time
};

void take_all(dds_entity_t reader, void* argument) {
  auto& subscription = *static_cast<Subscription*>(argument);
  const std::lock_guard lock(subscription.mutex);
  std::array<ddsi_serdata*, kAtOnce> messages{};
  std::array<dds_sample_info_t, kAtOnce> infos{};
  while (true) {
    const auto count = dds_takecdr(reader, messages.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (infos[i].valid_data) subscription.take(bytes_of(messages[i]));
      ddsi_serdata_unref(messages[i]);
    }
  }
}

class CycloneBus final : public Ros2Bus {
 public:
  CycloneBus(dds_entity_t domain, dds_entity_t participant, dds_entity_t publications)
      : domain_(domain), participant_(participant), publications_(publications) {
    (void)dds_get_guid(participant_, &own_);
  }
  CycloneBus(const CycloneBus&) = delete;
  CycloneBus& operator=(const CycloneBus&) = delete;
  ~CycloneBus() override {
    (void)dds_delete(participant_);  // waits for listeners that run
    if (domain_ > 0) (void)dds_delete(domain_);
  }

  [[nodiscard]] std::vector<std::string> types_of(const std::string& name) const override {
    constexpr std::size_t kMost = 4096;
    std::vector<void*> samples(kMost, nullptr);
    std::vector<dds_sample_info_t> infos(kMost);
    const auto count = dds_read(publications_, samples.data(), infos.data(), kMost, kMost);
    std::set<std::string> types;
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(count, 0)); ++i) {
      const auto& endpoint = *static_cast<const dds_builtintopic_endpoint_t*>(samples[i]);
      const bool is_own = std::ranges::equal(endpoint.participant_key.v, own_.v);
      if (!infos[i].valid_data || infos[i].instance_state != DDS_IST_ALIVE || is_own) continue;
      if (endpoint.topic_name == "rt" + name) types.insert(ros2_type_name(endpoint.type_name));
    }
    if (count > 0) (void)dds_return_loan(publications_, samples.data(), count);
    return {types.begin(), types.end()};
  }

  [[nodiscard]] Result<std::size_t> subscribe(const Ros2Topic& topic, Ros2Qos qos,
                                              TakeMessage take) override {
    const std::lock_guard lock(mutex_);
    const auto handle = make_topic(topic);
    if (!handle) return tl::unexpected(handle.error());
    auto& subscription = subscriptions_.emplace_back();
    subscription.take = std::move(take);
    dds_listener_t* listener = dds_create_listener(&subscription);
    dds_lset_data_available(listener, &take_all);
    const auto entity =
        dds_create_reader(participant_, *handle, make_qos(qos, true).get(), listener);
    dds_delete_listener(listener);
    return keep(topic, entity, true);
  }

  [[nodiscard]] Result<std::size_t> advertise(const Ros2Topic& topic, Ros2Qos qos) override {
    const std::lock_guard lock(mutex_);
    const auto handle = make_topic(topic);
    if (!handle) return tl::unexpected(handle.error());
    return keep(topic,
                dds_create_writer(participant_, *handle, make_qos(qos, false).get(), nullptr),
                false);
  }

  [[nodiscard]] Result<void> publish(std::size_t topic, ByteView bytes) override {
    const auto done = dds_write(endpoint(topic).entity, &bytes);
    if (done == DDS_RETCODE_OK) return {};
    return fail(Error::Code::kUnsupported, "ROS 2: a message of {} bytes was not sent: {}",
                bytes.size(), dds_strretcode(done));
  }

  [[nodiscard]] int matched(std::size_t topic) const override {
    const Endpoint at = endpoint(topic);
    std::array<dds_instance_handle_t, 64> others{};
    const auto count = at.reads
                           ? dds_get_matched_publications(at.entity, others.data(), others.size())
                           : dds_get_matched_subscriptions(at.entity, others.data(), others.size());
    return std::max<int>(count, 0);
  }

 private:
  struct Endpoint {
    dds_entity_t entity = 0;
    bool reads = false;
  };

  [[nodiscard]] Endpoint endpoint(std::size_t number) const {
    const std::lock_guard lock(mutex_);
    return endpoints_.at(number);
  }

  [[nodiscard]] Result<dds_entity_t> make_topic(const Ros2Topic& topic) {
    ddsi_sertype* type = make_blob_type(dds_type_name(topic.type));
    const auto entity = dds_create_topic_sertype(participant_, ("rt" + topic.name).c_str(), &type,
                                                 nullptr, nullptr, nullptr);
    if (entity > 0) return entity;
    ddsi_sertype_unref(type);
    return fail(Error::Code::kUnsupported, "ROS 2 topic {} of {}: {}", topic.name, topic.type,
                dds_strretcode(entity));
  }

  [[nodiscard]] Result<std::size_t> keep(const Ros2Topic& topic, dds_entity_t entity, bool reads) {
    if (entity <= 0) {
      return fail(Error::Code::kUnsupported, "ROS 2 topic {}: {}", topic.name,
                  dds_strretcode(entity));
    }
    endpoints_.push_back({entity, reads});
    return endpoints_.size() - 1;
  }

  dds_entity_t domain_;
  dds_entity_t participant_;
  dds_entity_t publications_;
  dds_guid_t own_{};
  mutable std::mutex mutex_;  ///< of what follows
  std::vector<Endpoint> endpoints_;
  std::deque<Subscription> subscriptions_;
};

}  // namespace

Result<std::unique_ptr<Ros2Bus>> Ros2Bus::join(const Ros2Options& options) {
  auto number = options.domain ? Result<int>(*options.domain) : ros2_domain();
  if (!number) return tl::unexpected(number.error());
  const auto id = static_cast<dds_domainid_t>(*number);
  // A second participant of this process finds the domain there already, and joins it.
  dds_entity_t domain = 0;
  if (is_localhost_only()) domain = dds_create_domain(id, kLocalhostOnly);
  const auto participant = dds_create_participant(id, nullptr, nullptr);
  if (participant < 0) {
    if (domain > 0) (void)dds_delete(domain);
    return fail(Error::Code::kNotFound,
                "ROS 2: cannot join domain {}: {}; is there a network interface, and is "
                "CYCLONEDDS_URI as Cyclone DDS 0.10 wants it?",
                *number, dds_strretcode(participant));
  }
  const auto publications =
      dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
  return std::make_unique<CycloneBus>(domain, participant, publications);
}

}  // namespace scanfuse::drivers
