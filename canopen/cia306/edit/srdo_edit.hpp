// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_EDIT_SRDO_EDIT_HPP
#define CANOPEN_CIA306_EDIT_SRDO_EDIT_HPP

#include "canopen/cia306/edit/srdo_plan.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/cia306/text/ini_document.hpp"

#include <cstdint>
#include <optional>

namespace counterpoint::cia306
{
/// The least number, 1 to 64, of which a file has neither communication nor mapping parameters; nothing: all are taken.
[[nodiscard]] std::optional<std::uint8_t> FreeSrdoNumber(const Device& device);

/// The document with one SRDO more, which is on: its parameters, the objects that it maps where they are new, its
/// places in 13FFh and 5F01h to 5F05h, lists and counts, the device digest where there is a node-ID; signed, with A5h
/// in 13FEh. All else is kept byte for byte. Throws InputError where the file cannot have it. Whether the SRDO is right
/// is for the rules of `check` to say. [SRS_NEW_010, SRS_NEW_011, SRS_NEW_012, SRS_NEW_150, SRS_NEW_151, SRS_NEW_152]
[[nodiscard]] IniDocument WithSrdo(const IniDocument& document, const SrdoPlan& plan,
                                   std::optional<std::uint8_t> node_id);

/// The document without this SRDO: its parameters, and their places in the lists. What it mapped stays; its values in
/// 13FFh, 5F01h to 5F03h and 5F05h become 0, and the digest follows. All else is kept byte for byte. Throws InputError
/// where there is no such SRDO. [SRS_NEW_015]
[[nodiscard]] IniDocument WithoutSrdo(const IniDocument& document, std::uint8_t number,
                                      std::optional<std::uint8_t> node_id);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_EDIT_SRDO_EDIT_HPP
