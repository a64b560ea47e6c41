// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_GRANTS_HPP
#define CHANNEL_A_GRANTS_HPP

#include "channel_a/bytes.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// The bytes of a record that can grant something.
enum class Grant : std::uint8_t
{
    kState = 0U,      ///< A State.
    kFirstCause = 1U, ///< A SrdoCause.
    kDirection = 2U,  ///< Of 130xh sub 1.
    kLength = 3U,     ///< Bytes of a frame.
    kPolicy = 4U,     ///< A ReleasePolicy.
    kEdge = 5U,       ///< kYes: an acknowledge edge waits.
    kResolved = 6U,   ///< kYes: the steps are those of the entries.
    kChecked = 7U,    ///< kYes: the last Validate or Recheck found no fault.
};

constexpr std::size_t kGrantCount = 8U;

/// What a grant that is no more than yes or no has to be for yes. Everything else says no.
constexpr std::uint8_t kYes = 0xA6U;
constexpr std::uint8_t kNo = 0U;

constexpr std::uint32_t kAllBits = ~std::uint32_t{0U};

/// Each grant beside its complement. Zeroed memory and every single flipped bit are found. [SRS_CONS_024]
struct Grants
{
    Bytes values;
    Bytes complements;

    void Set(const Grant grant, const std::uint8_t value) noexcept
    {
        values.at[static_cast<std::size_t>(grant)] = value;
        complements.at[static_cast<std::size_t>(grant)] = static_cast<std::uint8_t>(~std::uint32_t{value});
    }

    /// @brief All are 0, which grants nothing.
    void Clear() noexcept
    {
        for (std::size_t grant = 0U; grant < kGrantCount; ++grant)
        {
            Set(static_cast<Grant>(grant), 0U);
        }
    }

    /// @brief The value alone, for what grants nothing by it.
    [[nodiscard]] std::uint8_t Of(const Grant grant) const noexcept
    {
        return values.at[static_cast<std::size_t>(grant)];
    }

    /// @brief Whether the grant has this value and is beside its complement.
    [[nodiscard]] bool Is(const Grant grant, const std::uint8_t value) const noexcept
    {
        return (Of(grant) == value) && IsWhole(grant);
    }

    /// @brief Whether one grant is beside its complement.
    [[nodiscard]] bool IsWhole(const Grant grant) const noexcept
    {
        return (std::uint32_t{Of(grant)} ^ complements.at[static_cast<std::size_t>(grant)]) == kByteMask;
    }

    /// @brief Whether all are.
    [[nodiscard]] bool AreWhole() const noexcept
    {
        const Payload own = PayloadOf(values);
        const Payload beside = PayloadOf(complements);
        return ((own.low ^ beside.low) & (own.high ^ beside.high)) == kAllBits;
    }
};

} // namespace counterpoint::channel_a

#endif
