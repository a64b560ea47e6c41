// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_DEVICE_CHECK_HPP
#define TOOLS_DEVICE_CHECK_HPP

#include "canopen/cia306/check/check.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::tools
{
/// What the rules find in a device and, where they find no error, what the commands that use its file say of it, in the
/// order of the lines. `text` is the text of the file. [SRS_CLI_030]
[[nodiscard]] std::vector<cia306::Finding> FindingsOf(const cia306::Device& device, const std::string& text,
                                                      const cia306::CheckOptions& options);

/// The error to tell where one is told: 13FEh only repeats that there are others. Null: there is none.
[[nodiscard]] const cia306::Finding* CauseIn(const std::vector<cia306::Finding>& findings);

/// What FindingsOf says of a file that is not written yet. Commands read files: they get it in a folder of its own,
/// which is gone afterwards.
[[nodiscard]] std::vector<cia306::Finding> FindingsBeforeWriting(const std::string& text,
                                                                 std::optional<std::uint8_t> node_id);
} // namespace counterpoint::tools

#endif // TOOLS_DEVICE_CHECK_HPP
