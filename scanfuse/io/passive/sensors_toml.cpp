#include <toml++/toml.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>

#include "scanfuse/core/options.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/io/text/byte_source.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLargestSensors = std::size_t{1} << 20;
constexpr double kOnePlace_m = 1e-3;
constexpr std::size_t kMostSensors = 64;

/// One table of the file: its numbers by key, and where it stands for messages.
class SensorTable {
 public:
  SensorTable(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  [[nodiscard]] tl::unexpected<Error> wrong(const toml::node& node, std::string_view what) const {
    return fail(Error::Code::kMalformed, "{}:{}:{}: {}", file_, node.source().begin.line,
                node.source().begin.column, what);
  }
  [[nodiscard]] tl::unexpected<Error> wrong(std::string_view what) const {
    return wrong(table_, what);
  }
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  Result<void> only(const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::ranges::find(known, name) != known.end()) continue;
      return wrong(node, fmt::format("unknown key '{}'; did you mean '{}'?", name,
                                     nearest_name(name, known)));
    }
    return {};
  }

  /// A finite number within [low, high]; `fallback` where the key is not there.
  Result<double> number(std::string_view key, double fallback, double low, double high) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return fallback;
    const auto value = node->value<double>();
    if (!value || !(*value >= low && *value <= high)) {
      return wrong(*node, fmt::format("{} needs a number from {} to {}", key, low, high));
    }
    return *value;
  }

  /// `count` finite numbers.
  Result<std::vector<double>> numbers(std::string_view key, std::size_t count) const {
    const toml::node* node = table_.get(key);
    const toml::array* array = node != nullptr ? node->as_array() : nullptr;
    std::vector<double> values;
    if (array != nullptr) {
      for (const toml::node& item : *array) {
        const auto value = item.value<double>();
        if (value && std::abs(*value) <= kFarthestCoordinate_m) values.push_back(*value);
      }
    }
    if (array == nullptr || array->size() != count || values.size() != count) {
      return node != nullptr ? wrong(*node, fmt::format("{} needs {} numbers", key, count))
                             : wrong(fmt::format("a sensor needs {}", key));
    }
    return values;
  }

  [[nodiscard]] const toml::table& table() const { return table_; }

 private:
  const toml::table& table_;
  const std::string& file_;
};

const std::vector<std::string>& sensor_keys() {
  static const std::vector<std::string> keys{"name",
                                             "position_m",
                                             "latitude_deg",
                                             "longitude_deg",
                                             "height_m",
                                             "orientation_rad",
                                             "sigma_azimuth_rad",
                                             "sigma_elevation_rad",
                                             "detection_probability",
                                             "clutter_per_sr",
                                             "clutter_per_rad",
                                             "field_of_view_azimuth_rad",
                                             "field_of_view_elevation_rad"};
  return keys;
}

/// Where geodetic sensors stand: east, north, up at the first of them.
struct GeodeticFrame {
  std::optional<GeographicLib::LocalCartesian> local;
};

Result<void> place_geodetic(const SensorTable& table, GeodeticFrame& frame, PassiveSensor& sensor) {
  if (!table.has("latitude_deg") || !table.has("longitude_deg")) {
    return table.wrong("give both latitude_deg and longitude_deg");
  }
  const auto latitude = table.number("latitude_deg", 0, -90, 90);
  if (!latitude) return tl::unexpected(latitude.error());
  const auto longitude = table.number("longitude_deg", 0, -360, 360);
  if (!longitude) return tl::unexpected(longitude.error());
  const auto height = table.number("height_m", 0, -1e5, 1e8);
  if (!height) return tl::unexpected(height.error());
  if (!frame.local) frame.local.emplace(*latitude, *longitude, *height);
  std::vector<double> turn(9);  // filled only where it has room
  auto& t = sensor.world_from_sensor.translation_m;
  frame.local->Forward(*latitude, *longitude, *height, t.x(), t.y(), t.z(), turn);
  Eigen::Matrix3d rotation;
  rotation << turn[0], turn[1], turn[2], turn[3], turn[4], turn[5], turn[6], turn[7], turn[8];
  sensor.world_from_sensor.rotation = Eigen::Quaterniond(rotation);
  return {};
}

Result<void> place(const SensorTable& table, GeodeticFrame& frame, PassiveSensor& sensor) {
  const bool geodetic = table.has("latitude_deg") || table.has("longitude_deg");
  if (geodetic && table.has("position_m")) {
    return table.wrong("give position_m or latitude_deg and longitude_deg, not both");
  }
  if (geodetic) {
    if (auto done = place_geodetic(table, frame, sensor); !done) return done;
  } else {
    const auto position = table.numbers("position_m", 3);
    if (!position) return tl::unexpected(position.error());
    sensor.world_from_sensor.translation_m = Eigen::Map<const Eigen::Vector3d>(position->data());
  }
  if (!table.has("orientation_rad")) return {};
  const auto angles = table.numbers("orientation_rad", 3);
  if (!angles) return tl::unexpected(angles.error());
  sensor.world_from_sensor.rotation = sensor.world_from_sensor.rotation *
                                      Eigen::AngleAxisd((*angles)[0], Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd((*angles)[1], Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd((*angles)[2], Eigen::Vector3d::UnitX());
  return {};
}

Result<void> read_figures(const SensorTable& table, PassiveSensor& sensor) {
  const auto take = [&](std::string_view key, double& value, double low, double high) {
    const auto read = table.number(key, value, low, high);
    if (read) value = *read;
    return read.map([](double) {});
  };
  if (!table.has("sigma_azimuth_rad")) return table.wrong("a sensor needs sigma_azimuth_rad");
  if (auto r = take("sigma_azimuth_rad", sensor.sigma_azimuth_rad, 1e-9, kPi); !r) return r;
  if (table.has("sigma_elevation_rad")) {
    double sigma = 0;
    if (auto r = take("sigma_elevation_rad", sigma, 1e-9, kPi); !r) return r;
    sensor.sigma_elevation_rad = sigma;
  }
  const bool full = sensor.tells_elevation();
  if (table.has(full ? "clutter_per_rad" : "clutter_per_sr")) {
    return table.wrong(full ? "this sensor tells elevation: give clutter_per_sr"
                            : "this sensor tells azimuth only: give clutter_per_rad");
  }
  for (auto r :
       {take("detection_probability", sensor.detection_probability, 0, 1),
        take(full ? "clutter_per_sr" : "clutter_per_rad", sensor.clutter_density, 0, 1e12),
        take("field_of_view_azimuth_rad", sensor.field_of_view_azimuth_rad, 1e-6, 2 * kPi),
        take("field_of_view_elevation_rad", sensor.field_of_view_elevation_rad, 1e-6, kPi)}) {
    if (!r) return r;
  }
  return {};
}

Result<PassiveSensor> read_sensor(const SensorTable& table, GeodeticFrame& frame) {
  if (auto known = table.only(sensor_keys()); !known) return tl::unexpected(known.error());
  PassiveSensor sensor;
  sensor.name = table.table()["name"].value_or(std::string());
  if (sensor.name.empty()) return table.wrong("a sensor needs a name");
  if (sensor.name.find_first_of(",+\"\n") != std::string::npos) {
    return table.wrong("a sensor's name may hold no comma, plus or quote");
  }
  if (auto done = place(table, frame, sensor); !done) return tl::unexpected(done.error());
  if (auto done = read_figures(table, sensor); !done) return tl::unexpected(done.error());
  return sensor;
}

Result<void> read_scene(const SensorTable& table, PassiveScene& scene) {
  if (auto known = table.only({"volume_m", "expected_targets"}); !known) return known;
  if (const toml::node* node = table.table().get("volume_m")) {
    const toml::array* axes = node->as_array();
    PassiveScene::Volume volume{};
    bool good = axes != nullptr && axes->size() == 3;
    for (std::size_t k = 0; good && k < 3; ++k) {
      const toml::array* ends = axes->get(k)->as_array();
      good = ends != nullptr && ends->size() == 2;
      for (std::size_t e = 0; good && e < 2; ++e) {
        const auto value = ends->get(e)->value<double>();
        good = value && std::abs(*value) <= kFarthestCoordinate_m;
        if (good) volume[k][e] = *value;
      }
      good = good && volume[k][0] < volume[k][1];
    }
    if (!good) {
      return table.wrong(*node, "volume_m needs [[x0, x1], [y0, y1], [z0, z1]], each ascending");
    }
    scene.volume_m = volume;
  }
  if (table.has("expected_targets")) {
    const auto targets = table.number("expected_targets", 1, 1e-9, 1e9);
    if (!targets) return tl::unexpected(targets.error());
    scene.expected_targets = *targets;
  }
  return {};
}

Result<void> check_scene(const PassiveScene& scene, const std::string& file) {
  if (scene.sensors.size() < 2 || scene.sensors.size() > kMostSensors) {
    return fail(Error::Code::kOutOfRange, "{}: {} [[sensor]]; association needs 2 to {}", file,
                scene.sensors.size(), kMostSensors);
  }
  const auto& first = scene.sensors.front().world_from_sensor.translation_m;
  const bool apart = std::ranges::any_of(scene.sensors, [&](const PassiveSensor& sensor) {
    return (sensor.world_from_sensor.translation_m - first).norm() > kOnePlace_m;
  });
  if (apart) return {};
  return fail(Error::Code::kOutOfRange,
              "{}: all sensors stand at one place: their lines of sight never cross", file);
}

Result<PassiveScene> read_root(const toml::table& root, const std::string& file) {
  const SensorTable whole(root, file);
  if (auto known = whole.only({"sensor", "scene"}); !known) return tl::unexpected(known.error());
  PassiveScene scene;
  GeodeticFrame frame;
  const toml::array* list = root["sensor"].as_array();
  for (std::size_t k = 0; list != nullptr && k < list->size(); ++k) {
    const toml::table* entry = list->get(k)->as_table();
    if (entry == nullptr) return whole.wrong(*list->get(k), "sensor needs tables: [[sensor]]");
    const SensorTable table(*entry, file);
    auto sensor = read_sensor(table, frame);
    if (!sensor) return tl::unexpected(sensor.error());
    if (frame.local && table.has("position_m")) {
      return table.wrong("sensors are placed by position_m or by latitude, not mixed");
    }
    for (const PassiveSensor& other : scene.sensors) {
      if (other.name == sensor->name) {
        return table.wrong(fmt::format("sensor '{}' is there twice", other.name));
      }
    }
    scene.sensors.push_back(std::move(*sensor));
  }
  if (const toml::table* about = root["scene"].as_table()) {
    if (auto done = read_scene(SensorTable(*about, file), scene); !done) {
      return tl::unexpected(done.error());
    }
  }
  if (auto good = check_scene(scene, file); !good) return tl::unexpected(good.error());
  return scene;
}

std::string sensor_toml(const PassiveSensor& sensor) {
  const auto& t = sensor.world_from_sensor.translation_m;
  const Eigen::Vector3d angles =
      sensor.world_from_sensor.rotation.toRotationMatrix().eulerAngles(2, 1, 0);
  std::string text = fmt::format(
      "[[sensor]]\nname = \"{}\"\nposition_m = [{}, {}, {}]\norientation_rad = [{}, {}, {}]\n"
      "sigma_azimuth_rad = {}\n",
      sensor.name, print_number(t.x()), print_number(t.y()), print_number(t.z()),
      print_number(angles[0]), print_number(angles[1]), print_number(angles[2]),
      print_number(sensor.sigma_azimuth_rad));
  if (sensor.tells_elevation()) {
    text += fmt::format("sigma_elevation_rad = {}\n", print_number(*sensor.sigma_elevation_rad));
  }
  return text + fmt::format(
                    "detection_probability = {}\n{} = {}\nfield_of_view_azimuth_rad = {}\n"
                    "field_of_view_elevation_rad = {}\n\n",
                    print_number(sensor.detection_probability),
                    sensor.tells_elevation() ? "clutter_per_sr" : "clutter_per_rad",
                    print_number(sensor.clutter_density),
                    print_number(sensor.field_of_view_azimuth_rad),
                    print_number(sensor.field_of_view_elevation_rad));
}

}  // namespace

Result<PassiveScene> parse_sensors(std::string_view text, const std::string& name) {
  try {
    const toml::table root = toml::parse(text, std::string_view(name));
    return read_root(root, name);
  } catch (const toml::parse_error& error) {
    const auto begin = error.source().begin;
    return fail(Error::Code::kMalformed, "{}:{}:{}: {}", name, begin.line, begin.column,
                error.description());
  }
}

Result<PassiveScene> read_sensors(const std::filesystem::path& path) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  const auto text = read_start(**source, kLargestSensors + 1);
  if (!text) return tl::unexpected(text.error());
  if (text->size() > kLargestSensors) {
    return fail(Error::Code::kUnsupported, "{}: more than 1 MiB is no list of sensors",
                path.string());
  }
  return parse_sensors(*text, path.string());
}

Result<void> write_sensors(const std::filesystem::path& path, const PassiveScene& scene) {
  std::string text;
  for (const PassiveSensor& sensor : scene.sensors) text += sensor_toml(sensor);
  if (scene.volume_m || scene.expected_targets) text += "[scene]\n";
  if (scene.volume_m) {
    const auto& v = *scene.volume_m;
    text += fmt::format("volume_m = [[{}, {}], [{}, {}], [{}, {}]]\n", v[0][0], v[0][1], v[1][0],
                        v[1][1], v[2][0], v[2][1]);
  }
  if (scene.expected_targets) {
    text += fmt::format("expected_targets = {}\n", *scene.expected_targets);
  }
  return write_whole(path, text);
}

}  // namespace scanfuse::io
