// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_VIRTUAL_FRAME_BITS_HPP
#define HAL_HOST_VIRTUAL_FRAME_BITS_HPP

#include "safety_core/contract/can_frame.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace counterpoint::host
{

constexpr std::uint32_t kGreatestStandardIdentifier = 0x7FFU;
constexpr std::uint32_t kGreatestExtendedIdentifier = 0x1FFF'FFFFU;
/// CRC delimiter, ACK slot, ACK delimiter, seven bits of EOF: never stuffed.
constexpr std::uint16_t kTrailerBits = 10U;
constexpr std::uint16_t kIntermissionBits = 3U;
/// Longest frame: 29-bit identifier, 8 bytes, worst stuffing, trailer.
constexpr std::size_t kMaxFrameBits = 157U;

/// Bits of a frame on the wire, SOF to the end of EOF. [SRS_BUS_001]
struct FrameBits
{
    std::uint16_t stuffable; ///< SOF to CRC sequence, without stuff bits.
    std::uint16_t stuff;     ///< Stuff bits among them.
    std::uint16_t crc;       ///< CRC-15 (polynomial 4599h) over SOF to data.

    /// @brief SOF to the end of EOF.
    [[nodiscard]] constexpr std::uint16_t OnWire() const
    {
        return static_cast<std::uint16_t>(stuffable + stuff + kTrailerBits);
    }
    /// @brief SOF to the end of the intermission: the earliest next SOF.
    [[nodiscard]] constexpr std::uint16_t WithIntermission() const
    {
        return static_cast<std::uint16_t>(OnWire() + kIntermissionBits);
    }
};

/// Levels of a frame as a receiver samples them: 0 dominant, 1 recessive; the ACK slot is dominant.
struct WireImage
{
    std::array<std::uint8_t, kMaxFrameBits> level;
    std::uint16_t count;
    std::uint16_t ack_slot; ///< Place of the ACK slot in `level`.
};

/// @brief Whether classical CAN can carry the frame: a kind that it knows, an identifier that fits the kind, 0 to 8
/// bytes.
[[nodiscard]] bool IsClassicalFrame(const CanFrame& frame);
/// @brief Counts by tables, a step a byte. The frame is a classical one.
[[nodiscard]] FrameBits MeasureFrame(const CanFrame& frame);
/// @brief Writes out every bit; slow, for collisions and pictures. The frame is a classical one.
[[nodiscard]] WireImage DrawFrame(const CanFrame& frame);
/// @brief The arbitration field as a number: the lower one wins the bus. The frame is a classical one. [SRS_BUS_003]
[[nodiscard]] std::uint32_t ArbitrationKey(const CanFrame& frame);

} // namespace counterpoint::host

#endif
