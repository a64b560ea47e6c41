// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_SAFETY_SIGNATURE_HPP
#define CANOPEN_CIA306_SAFETY_SIGNATURE_HPP

#include "canopen/cia306/safety/safety_configuration.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::cia306
{
/// One number that goes into the signature.
struct SignedField
{
    std::string object;              ///< "0x1301:02"
    std::string meaning;             ///< "SCT 50 ms"
    std::vector<std::uint8_t> bytes; ///< Low byte first.
};

/// `count` bytes, low byte first.
[[nodiscard]] std::vector<std::uint8_t> LittleEndian(std::uint64_t value, std::uint32_t count);

/// The numbers that are signed, in their order. The SRDO must have no signature problems. [SRS_EDS_021]
[[nodiscard]] std::vector<SignedField> SignedFields(const SrdoConfiguration& srdo);

/// The bytes of SignedFields one after the other: 13 + 5 n for n mapping entries.
[[nodiscard]] std::vector<std::uint8_t> CanonicalBytes(const SrdoConfiguration& srdo);

/// The bytes of fields one after the other.
[[nodiscard]] std::vector<std::uint8_t> BytesOf(const std::vector<SignedField>& fields);

/// CRC-16, polynomial 1021h, start 0000h, as computed by Boost: neither channel's code. [SRS_EDS_022]
[[nodiscard]] std::uint16_t SignatureOf(const std::vector<std::uint8_t>& bytes);
/// The signature of an SRDO, which must have no signature problems.
[[nodiscard]] std::uint16_t SignatureOf(const SrdoConfiguration& srdo);
/// The signature of an SRDO with another node-ID than that of its file, of which `of_file` and `of_node` are the
/// readings; nothing where the file's own is not that of its parameters: nobody agreed to them. [SRS_GEN_016,
/// SRS_NODE_551]
[[nodiscard]] std::optional<std::uint16_t> SignatureWithNode(const SrdoConfiguration& of_file,
                                                             const SrdoConfiguration& of_node);

/// "02 32 00"
[[nodiscard]] std::string HexBytes(const std::vector<std::uint8_t>& bytes);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_SAFETY_SIGNATURE_HPP
