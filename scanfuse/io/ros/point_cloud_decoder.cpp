#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "scanfuse/io/ros/beam_fit.hpp"
#include "scanfuse/io/ros/message_decoders.hpp"

namespace scanfuse::io::ros {

namespace {

constexpr std::int64_t kLongestSweepNs = 10'000'000'000;
constexpr std::uint32_t kMostLayerRows = 128;  ///< organised clouds with more rows are images

constexpr std::int64_t kMostBeams = 1'000'000;

/// PointField.datatype, as sensor_msgs defines the numbers.
enum class Datatype : std::uint8_t { kI8 = 1, kU8, kI16, kU16, kI32, kU32, kF32, kF64 };

std::size_t size_of(Datatype type) {
  constexpr std::array<std::size_t, 9> sizes{0, 1, 1, 2, 2, 4, 4, 4, 8};
  const auto index = static_cast<std::size_t>(type);
  return index < sizes.size() ? sizes[index] : 0;
}

struct CloudColumn {
  std::uint32_t offset = 0;
  Datatype datatype = Datatype::kF32;
};

/// The layout of a cloud and its bytes.
struct Cloud {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
  bool swap = false;
  std::span<const std::byte> data;
  std::optional<CloudColumn> x, y, z, intensity, layer, beam, echo, time;
};

/// Keeps the column where its name is wanted; the first name of `names` found wins.
void take_column(std::optional<CloudColumn>& place, std::string_view name, CloudColumn column,
                 std::initializer_list<std::string_view> names) {
  for (const auto wanted : names) {
    if (name == wanted && !place) place = column;
  }
}

void read_fields(WireReader& reader, Cloud& cloud) {
  const auto count = reader.read_count(13);
  for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
    const auto name = reader.read_string();
    CloudColumn column;
    column.offset = reader.read<std::uint32_t>();
    column.datatype = static_cast<Datatype>(reader.read<std::uint8_t>());
    (void)reader.read<std::uint32_t>();  // count: the first of several is taken
    take_column(cloud.x, name, column, {"x"});
    take_column(cloud.y, name, column, {"y"});
    take_column(cloud.z, name, column, {"z"});
    take_column(cloud.intensity, name, column, {"intensity", "i", "reflectivity"});
    take_column(cloud.layer, name, column, {"ring", "layer", "channel"});
    take_column(cloud.beam, name, column, {"beam"});
    take_column(cloud.echo, name, column, {"echo", "return"});
    take_column(cloud.time, name, column,
                {"t", "time", "timestamp", "time_offset", "offset_time", "time_stamp"});
  }
}

void check_columns(const Cloud& cloud, WireReader& reader) {
  if (!cloud.x || !cloud.y || !cloud.z) reader.refuse("a cloud without the fields x, y and z");
  for (const auto* column : {&cloud.x, &cloud.y, &cloud.z, &cloud.intensity, &cloud.layer,
                             &cloud.beam, &cloud.echo, &cloud.time}) {
    if (!*column) continue;
    const auto size = size_of((*column)->datatype);
    if (size == 0) {
      reader.refuse(fmt::format("field datatype {}", static_cast<int>((*column)->datatype)));
    } else if (std::uint64_t{(*column)->offset} + size > cloud.point_step) {
      reader.refuse(fmt::format("a field at {} reaches over the point's {} bytes",
                                (*column)->offset, cloud.point_step));
    }
  }
}

void check_sizes(Cloud& cloud, WireReader& reader) {
  if (cloud.width == 0 || cloud.height == 0) {
    cloud.width = cloud.height = 0;
    return;
  }
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if (cloud.height > 1 && row > cloud.row_step) {
    reader.refuse(fmt::format("{} points of {} bytes in a row of {} bytes", cloud.width,
                              cloud.point_step, cloud.row_step));
    return;
  }
  const std::uint64_t above = std::uint64_t{cloud.height - 1} * cloud.row_step;
  if (row > cloud.data.size() || above > cloud.data.size() - row) {
    reader.refuse(fmt::format("{} x {} points of {} bytes need more than the {} bytes of data",
                              cloud.height, cloud.width, cloud.point_step, cloud.data.size()));
  }
}

Cloud read_cloud(WireReader& reader) {
  Cloud cloud;
  cloud.height = reader.read<std::uint32_t>();
  cloud.width = reader.read<std::uint32_t>();
  read_fields(reader, cloud);
  const bool big_endian = reader.read<std::uint8_t>() != 0;
  cloud.swap = big_endian != (std::endian::native == std::endian::big);
  cloud.point_step = reader.read<std::uint32_t>();
  cloud.row_step = reader.read<std::uint32_t>();
  cloud.data = reader.read_bytes(reader.read_count(1));
  (void)reader.read<std::uint8_t>();  // is_dense: points are checked one by one anyway
  if (reader.ok()) check_columns(cloud, reader);
  if (reader.ok()) check_sizes(cloud, reader);
  return cloud;
}

/// Calls `use` with the column's number at `point`, in its own type.
template <class Use>
auto with_value(const Cloud& cloud, const CloudColumn& column, const std::byte* point, Use use) {
  const std::byte* at = point + column.offset;
  switch (column.datatype) {
    case Datatype::kI8:
      return use(WireReader::load<std::int8_t>(at, cloud.swap));
    case Datatype::kU8:
      return use(WireReader::load<std::uint8_t>(at, cloud.swap));
    case Datatype::kI16:
      return use(WireReader::load<std::int16_t>(at, cloud.swap));
    case Datatype::kU16:
      return use(WireReader::load<std::uint16_t>(at, cloud.swap));
    case Datatype::kI32:
      return use(WireReader::load<std::int32_t>(at, cloud.swap));
    case Datatype::kU32:
      return use(WireReader::load<std::uint32_t>(at, cloud.swap));
    case Datatype::kF32:
      return use(WireReader::load<float>(at, cloud.swap));
    case Datatype::kF64:
      break;
  }
  return use(WireReader::load<double>(at, cloud.swap));
}

double number_at(const Cloud& cloud, const CloudColumn& column, const std::byte* point) {
  return with_value(cloud, column, point, [](auto value) { return static_cast<double>(value); });
}

/// A whole number within [low, high], else `otherwise`.
template <class T>
T whole_at(const Cloud& cloud, const std::optional<CloudColumn>& column, const std::byte* point,
           T low, T otherwise) {
  if (!column) return otherwise;
  const double value = number_at(cloud, *column, point);
  const bool fits = value >= low && value <= std::numeric_limits<T>::max();
  return fits ? static_cast<T>(value) : otherwise;
}

constexpr std::int64_t kNoTime = std::numeric_limits<std::int64_t>::min();

/// The point's time in nanoseconds; kNoTime where it says nothing sensible.
std::int64_t nanos_at(const Cloud& cloud, const std::byte* point) {
  return with_value(cloud, *cloud.time, point, [](auto value) -> std::int64_t {
    if constexpr (std::is_floating_point_v<decltype(value)>) {
      const double seconds = std::abs(value) > 1e12 ? value * 1e-9 : double{value};
      return std::abs(seconds) < 9e9 ? duration_from_seconds(seconds).count() : kNoTime;
    } else {
      return value;
    }
  });
}

float finite_or_zero(double value) {
  const auto narrow = static_cast<float>(value);
  return std::isfinite(narrow) ? narrow : 0.0F;
}

/// Nothing where the point is no echo.
std::optional<Return> return_at(const Cloud& cloud, const std::byte* point, std::uint32_t row) {
  Return echo;
  // Through float first: doubles beyond its range become infinite, and fail the test below.
  const auto narrow = [&](const CloudColumn& column) {
    const double value = number_at(cloud, column, point);
    return std::abs(value) < kFarthestM ? static_cast<float>(value) : kFarthestM;
  };
  echo.x_m = narrow(*cloud.x);
  echo.y_m = narrow(*cloud.y);
  echo.z_m = narrow(*cloud.z);
  const float reach = std::max({std::abs(echo.x_m), std::abs(echo.y_m), std::abs(echo.z_m)});
  if (reach >= kFarthestM || reach == 0) return std::nullopt;
  if (cloud.intensity) echo.intensity = finite_or_zero(number_at(cloud, *cloud.intensity, point));
  const bool rows_are_layers = cloud.height <= kMostLayerRows;
  echo.layer = whole_at<std::int16_t>(cloud, cloud.layer, point, 0,
                                      rows_are_layers ? static_cast<std::int16_t>(row) : 0);
  echo.beam = whole_at<std::int32_t>(cloud, cloud.beam, point, -1, -1);
  echo.echo = whole_at<std::uint8_t>(cloud, cloud.echo, point, 0, 0);
  return echo;
}

/// Turns the raw times into offsets from the stamp, if they are offsets or instants.
void set_times(Scan& scan, const std::vector<std::int64_t>& nanos, Diagnostics& diagnostics) {
  std::int64_t largest = 0;
  for (const auto time : nanos) {
    if (time != kNoTime && std::abs(time) > std::abs(largest)) largest = time;
  }
  const std::int64_t stamp = to_nanos(scan.stamp);
  const auto within = [](std::int64_t a, std::int64_t b) {
    return static_cast<double>(a) - static_cast<double>(b) <= 1.0 * kLongestSweepNs &&
           static_cast<double>(b) - static_cast<double>(a) <= 1.0 * kLongestSweepNs;
  };
  if (!within(largest, 0) && !within(largest, stamp)) {
    diagnostics.note("point times left out: neither near 0 nor near the stamp");
    return;
  }
  const std::int64_t origin = within(largest, 0) ? 0 : stamp;
  for (std::size_t i = 0; i < nanos.size(); ++i) {
    if (nanos[i] == kNoTime || !within(nanos[i], origin)) continue;
    scan.returns[i].time_offset_s = static_cast<float>(to_seconds(Duration{nanos[i] - origin}));
  }
}

}  // namespace

DecodedMessage decode_point_cloud(WireReader& reader) {
  DecodedMessage decoded;
  auto scan = read_stamped<Scan>(reader);
  const Cloud cloud = read_cloud(reader);
  if (!reader.ok()) return decoded;
  std::vector<std::int64_t> nanos;
  std::int64_t columns = 0;
  int layers = 0;
  scan.returns.reserve(std::size_t{cloud.width} * cloud.height);
  for (std::uint32_t row = 0; row < cloud.height; ++row) {
    const std::byte* begin = cloud.data.data() + std::size_t{row} * cloud.row_step;
    for (std::uint32_t column = 0; column < cloud.width; ++column) {
      const std::byte* point = begin + std::size_t{column} * cloud.point_step;
      if (cloud.beam) {  // beams without a return count: they tell how wide the view is
        columns = std::max(
            columns, whole_at<std::int32_t>(cloud, cloud.beam, point, 0, 0) + std::int64_t{1});
        layers = std::max(layers, whole_at<std::int16_t>(cloud, cloud.layer, point, 0, 0) + 1);
      }
      const auto echo = return_at(cloud, point, row);
      if (!echo) continue;
      scan.returns.push_back(*echo);
      if (cloud.time) nanos.push_back(nanos_at(cloud, point));
    }
  }
  if (cloud.time) set_times(scan, nanos, decoded.diagnostics);
  if (columns <= kMostBeams)
    scan.beams = fit_beams(scan.returns, static_cast<int>(columns), layers);
  decoded.payload = std::move(scan);
  return decoded;
}

}  // namespace scanfuse::io::ros
