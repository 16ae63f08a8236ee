#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::pipeline {

struct CaptureOptions {
  std::string device;    ///< scheme of the device in a capture ("sick"); empty: told from ports
  std::string metadata;  ///< Ouster: the sensor's description in JSON
};

/// Opens any recording: as `io::open_recording`, and captures of packets (pcap, pcapng), whose
/// packets the drivers decode. In a capture each sender that speaks from (TCP) or to (UDP) a
/// device's usual port is a sensor, named "sick" or, where there are several, "sick@192.168.0.1".
/// Stamps are told by the device's clock and the capture's times.
[[nodiscard]] Result<std::unique_ptr<io::RecordingReader>> open_any_recording(
    const std::filesystem::path& path, const io::OpenOptions& open = {},
    const CaptureOptions& capture = {});

}  // namespace scanfuse::pipeline
