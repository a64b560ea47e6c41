// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_VALUE_EDITS_HPP
#define CANOPEN_CIA306_FILE_VALUE_EDITS_HPP

#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// A data element of the file, and the ParameterValue that it is to have.
struct ValueEdit
{
    const Entry* entry;
    std::string value;
};

/// The document with these ParameterValues, those of compact objects in the section of their values; a line that has
/// the text already, and everything else, is kept. The elements are those of the device that was read from it.
/// [SRS_EDS_005]
[[nodiscard]] IniDocument WithParameterValues(const IniDocument& document, const Device& device,
                                              const std::vector<ValueEdit>& values);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_VALUE_EDITS_HPP
