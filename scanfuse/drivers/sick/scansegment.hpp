#pragma once

#include <cstdint>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/bytes.hpp"
#include "scanfuse/drivers/stream.hpp"

namespace scanfuse::drivers::sick {

/// One beam of a line: its azimuth, and its echoes, 0 metres where there is none.
struct SegmentBeam {
  float azimuth_rad = 0;
  std::uint8_t properties = 0;  ///< bit 0: reflector
  std::vector<float> ranges_m;
  std::vector<std::uint16_t> strengths;
};

/// The beams of one layer in a segment, in the order they were fired.
struct SegmentLine {
  std::uint64_t start_us = 0;  ///< of the first beam, by the device's clock
  std::uint64_t stop_us = 0;   ///< of the last
  float elevation_rad = 0;     ///< positive upwards
  std::vector<SegmentBeam> beams;
};

/// A part of a revolution of a multiScan or picoScan [SickScanSegment2023].
struct Segment {
  std::uint64_t telegram = 0;     ///< counts telegrams
  std::uint64_t transmit_us = 0;  ///< when it was sent
  std::uint64_t frame = 0;        ///< counts revolutions
  std::uint64_t number = 0;       ///< within its revolution
  std::uint32_t sender = 0;
  std::vector<SegmentLine> lines;
};

/// The front of a stream of segments in either format, and of telegrams of the inertial unit.
[[nodiscard]] Cut cut_scansegment(ByteView bytes);

/// Whether a whole telegram holds a segment; the inertial unit's do not.
[[nodiscard]] bool is_segment(ByteView telegram);

/// Decodes a whole telegram, of either format. Errors say at which byte.
[[nodiscard]] Result<Segment> parse_segment(ByteView telegram);
/// The content of a msgpack telegram, as it stands between its length and its checksum.
[[nodiscard]] Result<Segment> parse_msgpack_segment(ByteView content);

/// The compact format: ranges in millimetres, azimuths to 1/5215 rad. Lines of one module must have
/// equally many beams and echoes: each run of such lines makes one.
[[nodiscard]] Bytes encode_compact(const Segment& segment);
/// The msgpack format: ranges and azimuths as floats.
[[nodiscard]] Bytes encode_msgpack(const Segment& segment);

}  // namespace scanfuse::drivers::sick
