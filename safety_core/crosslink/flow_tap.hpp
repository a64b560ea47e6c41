// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_FLOW_TAP_HPP
#define SAFETY_CORE_CROSSLINK_FLOW_TAP_HPP

#include "hal/api/watchdog.hpp"

#include <cstdint>

namespace counterpoint
{

/// Takes the flow signature of the last cycle back from the answer that the kernel gave its watchdog. [SRS_LNK_010]
class FlowTap final : public hal::Watchdog
{
  public:
    /// @brief `watchdog` is the real one, outlives this and gets every call.
    explicit FlowTap(hal::Watchdog& watchdog) noexcept;

    /// @brief The question of the real watchdog; it is kept until the answer.
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    /// @brief The signature is computed from question and answer; the answer goes on as it is.
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    /// @brief kFlowReference after an undisturbed cycle. Each call takes it away: without a cycle since, it gives 0.
    [[nodiscard]] std::uint32_t TakeSignature() noexcept;

  private:
    hal::Watchdog& watchdog_;
    hal::WatchdogQuestion asked_{0U};
    std::uint32_t signature_{0U};
};

} // namespace counterpoint

#endif
