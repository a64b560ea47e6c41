// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_TEXT_DCF_HPP
#define CANOPEN_CIA302_NETWORK_TEXT_DCF_HPP

#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What reading an entry came to.
enum class TextState : std::uint8_t
{
    kMalformed = 0U, ///< The value of this object cannot be understood, or does not fit its type.
    kEntry = 1U,
    kEnd = 2U, ///< All entries were read.
};

/// A value that a DCF gives an object. A string stands in the DCF itself, all else is a number.
struct TextReading
{
    TextState state;
    ObjectAddress object;     ///< Not with kEnd.
    std::uint64_t number;     ///< Low `size_bytes`, if `text` is null.
    std::uint32_t size_bytes; ///< 1 to 8, or the length of the string.
    const std::uint8_t* text; ///< Null: a number.
    std::uint32_t next;       ///< Where to go on.
};

/// @brief The next object of a DCF as text (1F20h) from `offset` on, 0 at first: in the order of the file, only objects
/// whose ParameterValue is not empty and whose AccessType lets them be written. Everything else in the DCF is skipped;
/// it was checked when the file was loaded (canopen/cia306). `node` is $NODEID. Reals are accepted as hexadecimal
/// numbers only. O(text) [SRS_BOOT_010]
[[nodiscard]] TextReading ReadTextDcf(const Bytes& dcf, std::uint32_t offset, NodeId node) noexcept;

} // namespace counterpoint::cia302

#endif
