// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_DEVICE_READER_HPP
#define CANOPEN_CIA306_FILE_DEVICE_READER_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <string>

namespace counterpoint::cia306
{
/// What the sections of the document mean. Throws InputError. [SRS_EDS_001, SRS_EDS_009, SRS_EDS_010, SRS_EDS_011,
/// SRS_EDS_012, SRS_EDS_013, SRS_EDS_014, SRS_EDS_015, SRS_EDS_016]
[[nodiscard]] Device ReadDevice(const IniDocument& document);

/// Reads the file, its lines and their meaning. Throws InputError.
[[nodiscard]] Device ReadDeviceFile(const std::string& path);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_DEVICE_READER_HPP
