// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_SECOND_NMT_HPP
#define SAFETY_CORE_KERNEL_SECOND_NMT_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint
{

/// The NMT state as channel B is given it; channel A is given the guard's. Kept as complement and changed by statements
/// of its own, so that a state that is lost or changed in one place is a disagreement of the channels. Zero-filled
/// memory is no OPERATIONAL. [SRS_KRN_033]
class SecondNmt
{
  public:
    /// @brief The state from now on, and whether OPERATIONAL was left.
    void Set(const NmtState state) noexcept
    {
        if ((Get() == NmtState::kOperational) && (state != NmtState::kOperational))
        {
            stayed_ = 0U;
        }
        inverse_ = static_cast<std::uint8_t>(~static_cast<std::uint32_t>(state));
    }
    /// @brief What the next OnCycle is given: PRE-OPERATIONAL if OPERATIONAL was left since the last one, even if it
    /// was entered again. [SRS_KRN_010]
    [[nodiscard]] NmtState Take() noexcept
    {
        const NmtState shown = HasStayed() ? Get() : NmtState::kPreOperational;
        stayed_ = kStayed;
        return shown;
    }
    /// @brief OPERATIONAL was not left since the last Take.
    [[nodiscard]] bool HasStayed() const noexcept
    {
        return stayed_ == kStayed;
    }

  private:
    static constexpr std::uint8_t kStayed = 0x96U;

    /// @brief The state that was set last.
    [[nodiscard]] NmtState Get() const noexcept
    {
        return static_cast<NmtState>(static_cast<std::uint8_t>(~std::uint32_t{inverse_}));
    }

    std::uint8_t inverse_{0xFFU}; ///< Complement of the state; at first of kInvalid.
    std::uint8_t stayed_{kStayed};
};

} // namespace counterpoint

#endif
