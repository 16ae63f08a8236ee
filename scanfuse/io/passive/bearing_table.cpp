#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/csv/csv_table.hpp"
#include "scanfuse/io/passive/passive.hpp"

namespace scanfuse::io {
namespace {

enum BearingColumn : std::size_t {
  kScan,
  kTime,
  kSensor,
  kMeasurement,
  kAzimuth,
  kElevation,
  kSigmaAzimuth,
  kSigmaElevation,
  kTruth
};

const CsvColumns& bearing_columns() {
  static const CsvColumns columns{
      "bearings",
      {"scan", "time_s", "sensor", "measurement", "azimuth_rad"},
      {"elevation_rad", "sigma_azimuth_rad", "sigma_elevation_rad", "truth_target"}};
  return columns;
}

/// Collects rows into scans.
class BearingCollector {
 public:
  explicit BearingCollector(const PassiveScene& scene) {
    for (std::size_t s = 0; s < scene.sensors.size(); ++s) {
      places_[scene.sensors[s].name] = s;
      tells_elevation_.push_back(scene.sensors[s].tells_elevation());
    }
  }

  void take(CsvTable& table, Diagnostics& diagnostics) {
    const std::int64_t scan = table.whole(kScan);
    const Time stamp = table.time(kTime);
    const Bearing bearing = read_bearing(table);
    if (!table.row_is_good(diagnostics)) return;
    if (!seen_.insert({scan, bearing.sensor, bearing.measurement}).second) {
      diagnostics.damage("measurement given twice, the first counts", table.where());
      return;
    }
    if (!scans_.empty() && scan < last_scan_) {
      diagnostics.note("scans out of order, sorted", table.where());
    }
    last_scan_ = scan;
    BearingScan& of = scans_[scan];
    if (of.bearings.empty()) {
      of.scan = scan;
      of.stamp = stamp;
    }
    of.bearings.push_back(bearing);
  }

  [[nodiscard]] std::vector<BearingScan> finish() {
    std::vector<BearingScan> scans;
    scans.reserve(scans_.size());
    for (auto& [number, scan] : scans_) scans.push_back(std::move(scan));
    return scans;
  }

 private:
  Bearing read_bearing(CsvTable& table) {
    Bearing bearing;
    const auto place = places_.find(table.text(kSensor));
    if (place == places_.end()) {
      table.reject(kSensor, "is no sensor of the scene");
      return bearing;
    }
    bearing.sensor = static_cast<std::int32_t>(place->second);
    bearing.measurement = table.whole(kMeasurement);
    bearing.azimuth_rad = angle(table, kAzimuth, 2 * kPi, "is no azimuth in radians");
    if (tells_elevation_[place->second]) {
      if (table.empty(kElevation)) table.reject(kElevation, "is empty, but its sensor tells one");
      bearing.elevation_rad = angle(table, kElevation, kPi / 2, "is no elevation in radians");
    }
    bearing.sigma_azimuth_rad = sigma(table, kSigmaAzimuth);
    bearing.sigma_elevation_rad = sigma(table, kSigmaElevation);
    if (!table.empty(kTruth)) bearing.truth = table.whole(kTruth);
    return bearing;
  }

  static double angle(CsvTable& table, std::size_t column, double most, std::string_view what) {
    constexpr double kRounding = 1e-6;
    const double value = table.number(column);
    if (!(std::abs(value) <= most + kRounding)) table.reject(column, what);
    return value;
  }

  static std::optional<double> sigma(CsvTable& table, std::size_t column) {
    if (table.empty(column)) return std::nullopt;
    const double value = table.number(column);
    if (!(value >= 1e-9 && value <= kPi)) table.reject(column, "is no standard deviation");
    return value;
  }

  std::map<std::string, std::size_t, std::less<>> places_;
  std::vector<bool> tells_elevation_;
  std::map<std::int64_t, BearingScan> scans_;
  std::set<std::tuple<std::int64_t, std::int32_t, std::int64_t>> seen_;
  std::int64_t last_scan_ = 0;
};

std::string bearing_rows(const BearingScan& scan, const PassiveScene& scene) {
  const auto cell = [](const std::optional<double>& value) {
    return value ? print_number(*value) : std::string();
  };
  std::string rows;
  for (const Bearing& b : scan.bearings) {
    const PassiveSensor& sensor = scene.sensors[static_cast<std::size_t>(b.sensor)];
    rows += fmt::format("{},{},{},{},{},{},{},{},{}\n", scan.scan, print_seconds(scan.stamp),
                        sensor.name, b.measurement, print_number(b.azimuth_rad),
                        sensor.tells_elevation() ? print_number(b.elevation_rad) : "",
                        cell(b.sigma_azimuth_rad), cell(b.sigma_elevation_rad),
                        b.truth ? std::to_string(*b.truth) : "");
  }
  return rows;
}

}  // namespace

Result<std::vector<BearingScan>> read_bearings(const std::filesystem::path& path,
                                               const PassiveScene& scene,
                                               Diagnostics* diagnostics) {
  Diagnostics unasked;
  Diagnostics& notes = diagnostics != nullptr ? *diagnostics : unasked;
  auto lines = LineReader::open(path);
  if (!lines) return tl::unexpected(lines.error());
  auto table = CsvTable::open(std::move(*lines), bearing_columns(), notes);
  if (!table) return tl::unexpected(table.error());
  BearingCollector collector(scene);
  while (table->next_row(notes)) collector.take(*table, notes);
  auto scans = collector.finish();
  if (scans.empty()) return table->nothing_found("bearings");
  return scans;
}

Result<void> write_bearings(const std::filesystem::path& path, std::span<const BearingScan> scans,
                            const PassiveScene& scene) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  auto wrote = file->write(
      std::string_view("scan,time_s,sensor,measurement,azimuth_rad,elevation_rad,sigma_azimuth_rad,"
                       "sigma_elevation_rad,truth_target\n"));
  for (std::size_t k = 0; wrote && k < scans.size(); ++k) {
    wrote = file->write(bearing_rows(scans[k], scene));
  }
  if (!wrote) return wrote;
  return file->commit();
}

std::string fix_header() {
  return "scan,time_s,target,x_m,y_m,z_m,cov_xx_m2,cov_xy_m2,cov_xz_m2,cov_yy_m2,cov_yz_m2,"
         "cov_zz_m2,existence_probability,chi2,sensors\n";
}

std::string fix_rows(const BearingScan& scan, std::span<const Fix> fixes,
                     const PassiveScene& scene) {
  std::string rows;
  for (const Fix& fix : fixes) {
    std::string sensors;
    for (const std::int32_t place : fix.bearings) {
      const auto s =
          static_cast<std::size_t>(scan.bearings[static_cast<std::size_t>(place)].sensor);
      sensors += (sensors.empty() ? "" : "+") + scene.sensors[s].name;
    }
    const auto& p = fix.position_m;
    const auto& c = fix.covariance_m2;
    rows += fmt::format("{},{},{},{},{},{}", scan.scan, print_seconds(scan.stamp), fix.target,
                        print_number(p.x()), print_number(p.y()), print_number(p.z()));
    for (const double value : {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2),
                               fix.existence_probability, fix.chi2}) {
      rows += "," + print_number(value);
    }
    rows += "," + sensors + "\n";
  }
  return rows;
}

std::string assignment_header() { return "scan,sensor,measurement,target,probability\n"; }

std::string assignment_rows(const BearingScan& scan,
                            std::span<const std::int64_t> target_of_bearing,
                            std::span<const double> probability_of_bearing,
                            const PassiveScene& scene) {
  std::string rows;
  for (std::size_t i = 0; i < scan.bearings.size(); ++i) {
    const Bearing& b = scan.bearings[i];
    rows += fmt::format("{},{},{},{},{}\n", scan.scan,
                        scene.sensors[static_cast<std::size_t>(b.sensor)].name, b.measurement,
                        target_of_bearing[i] >= 0 ? std::to_string(target_of_bearing[i]) : "",
                        print_number(probability_of_bearing[i]));
  }
  return rows;
}

}  // namespace scanfuse::io
