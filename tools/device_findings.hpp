// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_DEVICE_FINDINGS_HPP
#define TOOLS_DEVICE_FINDINGS_HPP

#include "canopen/cia306/check/check.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::tools
{
/// @brief What `check` finds in a device file, in the order of the lines: its rules and, where these find no error,
/// what the commands that use the file say of it. `text` is the text that `device` was read from. [SRS_CLI_030,
/// SRS_CLI_210, SRS_CLI_211, SRS_CLI_212]
[[nodiscard]] std::vector<cia306::Finding> FindingsOf(const cia306::Device& device, const std::string& text,
                                                      const cia306::CheckOptions& options);

/// @brief Adds to findings in the order of their lines those of other lines and objects, and errors.
void AddOthers(std::vector<cia306::Finding>& findings, const std::vector<cia306::Finding>& others);

/// @brief The warning of a written file with another NodeID than the one that it is signed for; nothing where one of
/// them is not told. [SRS_CLI_037, SRS_NEW_731]
[[nodiscard]] std::optional<cia306::Finding> SignedForAnother(const cia306::Device& device,
                                                              std::optional<std::uint8_t> node_id);

/// Number of errors among the findings.
[[nodiscard]] std::size_t ErrorsIn(const std::vector<cia306::Finding>& findings);

/// The error to tell where one is told: 13FEh only repeats that there are others. Null: there is none.
[[nodiscard]] const cia306::Finding* CauseIn(const std::vector<cia306::Finding>& findings);

/// What FindingsOf says of a file that is not written yet. Commands read files: they get it in a folder of its own,
/// which is gone afterwards.
[[nodiscard]] std::vector<cia306::Finding> FindingsBeforeWriting(const std::string& text,
                                                                 std::optional<std::uint8_t> node_id);
} // namespace counterpoint::tools

#endif // TOOLS_DEVICE_FINDINGS_HPP
