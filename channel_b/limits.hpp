// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_LIMITS_HPP
#define CHANNEL_B_LIMITS_HPP

#include "channel_b/settings.hpp"
#include "channel_b/slots.hpp"
#include "channel_b/storage.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// The limits of all budgets. They are taken from the image when a slot becomes active, so that a configuration that
/// is stored while OPERATIONAL ends counts for the next one alone; until then they are as the image says. [SRS_CHB_192]
class Limits
{
  public:
    Limits(const PairColumns& columns, const Settings& settings) noexcept
        : x_limit(columns.limit), x_srvt_limit(columns.srvt_limit), x_settings(settings)
    {
    }

    /// @brief The slot becomes active.
    void Take(SlotIndex slot) noexcept
    {
        x_limit[slot] = FirstUs(slot);
        x_srvt_limit[slot] = x_settings.SrvtUs(slot);
        x_taken |= BitOf(slot);
    }

    /// @brief The image was validated anew: it is that of the next OPERATIONAL.
    void Forget(SlotIndex slot) noexcept
    {
        x_taken &= ~BitOf(slot);
    }

    /// @brief Whether what was taken from this image is still as it says. Asked only behind a Validate without fault,
    /// so that there is nothing to be begun anew at Restart.
    [[nodiscard]] bool AreRight(SlotIndex slot) const noexcept
    {
        const std::uint32_t differences =
            (x_limit[slot] ^ FirstUs(slot)) | (x_srvt_limit[slot] ^ x_settings.SrvtUs(slot));
        return (differences == 0U) || (!HasAny(x_taken, BitOf(slot)));
    }

  private:
    /// SCT of a consumer, SRVT of a producer.
    [[nodiscard]] std::uint32_t FirstUs(SlotIndex slot) const noexcept
    {
        const bool is_consumer = x_settings.Direction(slot) == kDirectionConsumer;
        return is_consumer ? x_settings.SctUs(slot) : x_settings.SrvtUs(slot);
    }

    Column<std::uint32_t> x_limit;
    Column<std::uint32_t> x_srvt_limit;
    const Settings& x_settings;
    SrdoMask x_taken{0U}; ///< Slots whose limits are of the image that was validated last.
};

} // namespace counterpoint::channel_b

#endif
