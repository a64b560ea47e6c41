// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ZYNQMP_LINK_SHARED_LINK_HPP
#define HAL_ZYNQMP_LINK_SHARED_LINK_HPP

#include "hal/api/cross_link.hpp"
#include "hal/tms570/chip/shared.hpp"

#include <cstdint>

namespace counterpoint::zynqmp
{

constexpr std::uint32_t kLinkWords = 47U; ///< Of a LinkFrame.
constexpr std::uint32_t kLinkSlots = 4U;
static_assert((kLinkWords * 4U) == hal::kLinkFrameBytes, "a frame in words");

/// One frame on its way. It is whole while `begun` and `ended` have the same number.
struct LinkSlot
{
    tms570::Shared<std::uint32_t> begun;
    tms570::Shared<std::uint32_t> length;
    tms570::Shared<std::uint32_t> words[kLinkWords]; // MISRA D-001
    tms570::Shared<std::uint32_t> ended;
};

/// One direction: written by one processor, read by the other one. Frame n lies in slot n modulo kLinkSlots.
struct LinkMailbox
{
    tms570::Shared<std::uint32_t> newest; ///< Number of the newest whole frame.
    LinkSlot slots[kLinkSlots];           // MISRA D-001
};

/// What became of frames that were not handed over.
struct LinkLosses
{
    std::uint32_t torn;        ///< Overwritten while they were read, or of no length.
    std::uint32_t overwritten; ///< Not read in time.
};

/// The link to the other processor by memory that both see uncached (OCM). Nobody waits for anybody: a writer
/// overwrites the oldest frame, a reader that is disturbed gives up the frame and counts it. Memory that nobody has
/// written, or that a fault changed, is at worst a frame that the CRC-32 of the message refuses. [SRS_ZYN_010,
/// SRS_ZYN_011, SRS_ZYN_012]
class SharedLink final : public hal::CrossLink
{
  public:
    /// @brief Writes `to`, reads `from`; both outlive it. What was in `from` before is old and not received.
    SharedLink(LinkMailbox& to, LinkMailbox& from) noexcept;

    [[nodiscard]] hal::LinkStatus Send(const hal::LinkFrame& frame) noexcept override;
    /// @brief Looks at kLinkSlots frames at the most.
    [[nodiscard]] hal::LinkStatus Receive(hal::LinkFrame& frame) noexcept override;
    /// @brief Since the start; each stays at 2^32 - 1.
    [[nodiscard]] LinkLosses Losses() const noexcept;

  private:
    [[nodiscard]] bool Copy(std::uint32_t number, hal::LinkFrame& frame) noexcept;

    LinkMailbox& to_;
    LinkMailbox& from_;
    std::uint32_t sent_;
    std::uint32_t taken_;
    LinkLosses losses_{0U, 0U};
};

} // namespace counterpoint::zynqmp

#endif
