// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_PRODUCTION_HPP
#define SAFETY_CORE_KERNEL_PRODUCTION_HPP

#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/kernel_context.hpp"
#include "safety_core/kernel/result.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the device sends: SRDOs by both channels, and the GFC. [SRS_KRN_004, SRS_KRN_011, SRS_KRN_012, SRS_KRN_013,
/// SRS_KRN_014, SRS_KRN_017, SRS_KRN_145, SRS_KRN_146, SRS_KRN_147, SRS_KRN_148, SRS_KRN_213, SRS_KRN_214,
/// SRS_KRN_215, SRS_KRN_216]
class Production
{
  public:
    /// @brief OPERATIONAL was entered with a valid configuration: directions and times stay as they are until Cease.
    /// O(srdo_count)
    void Begin(const KernelContext& context) noexcept;
    /// @brief Nothing is produced from now on, and what was asked for is forgotten: at each change of the NMT state.
    void Cease() noexcept
    {
        producers_ = 0U;
        requests_ = 0U;
    }

    /// @brief Asks for the transmission of those of `asked` that are producers. One alone is `wanted`; kNoSlot stands
    /// for all. [SRS_KRN_011]
    [[nodiscard]] Result Request(KernelContext& context, const SlotIndex wanted, const SrdoMask asked) noexcept
    {
        const SrdoMask to_send = producers_ & asked;
        if ((to_send == 0U) || (!context.latch.IsRunning()))
        {
            return WhyNotSent(context, wanted);
        }
        requests_ |= to_send;
        return Result::kSuccessful;
    }
    /// @brief Sends the GFC, composed here and compared with a constant; an SRDO must follow within the shortest
    /// refresh time. [SRS_KRN_013, SRS_KRN_042, SRS_KRN_225]
    [[nodiscard]] Result SendGfc(KernelContext& context) noexcept;

    /// @brief A cycle begins at this instant of counter A. A GFC that was sent before the first one counts from where a
    /// cycle before that would have been. [SRS_KRN_225]
    void OnCycle(const Instant now, const std::uint32_t cycle_us) noexcept
    {
        if (!has_now_)
        {
            has_now_ = true;
            gfc_until_.us += now.us - cycle_us;
        }
        now_ = now;
    }
    /// @brief All producers in the device safe state, in which nothing is sent; else none. The channels then let their
    /// refresh times stand still, so that no missed refresh is told. [SRS_KRN_004]
    [[nodiscard]] SrdoMask Halted(KernelContext& context) const noexcept
    {
        return producers_ & ~context.latch.Gate();
    }
    /// @brief What was asked for since the last cycle.
    [[nodiscard]] SrdoMask TakeRequests() noexcept
    {
        const SrdoMask requests = requests_;
        requests_ = 0U;
        return requests;
    }
    /// @brief Producers whose refresh stands still in one channel, since it is ahead of the other one.
    [[nodiscard]] SrdoMask StandOfA() const noexcept
    {
        return stand_a_;
    }
    /// @brief The same in channel B.
    [[nodiscard]] SrdoMask StandOfB() const noexcept
    {
        return stand_b_;
    }
    /// @brief Each channel's refresh runs by its own counter. Where it waits in one channel alone, or one channel alone
    /// missed the next one so far, that channel is ahead: it stands, and the other one's slot does not count as due, so
    /// that a request of the same producer waits, too. So a pair always is the refresh of both channels or of none.
    /// O(1), with a cause of a producer O(slots with one) [SRS_KRN_017, SRS_KRN_145, SRS_KRN_146, SRS_KRN_148,
    /// SRS_KRN_310]
    void Await(const KernelContext& context, CycleOutcome& a, CycleOutcome& b) noexcept;
    /// @brief Sends the pairs of producers that both channels call due. O(start)
    void Produce(KernelContext& context, SrdoMask start) noexcept;
    /// @brief Pairs that were sent between the last two cycles.
    [[nodiscard]] std::uint8_t Transmitted() const noexcept
    {
        return transmitted_told_;
    }
    /// @brief The normal frame of an SRDO was on the bus: its inverse frame follows, if this device may still send
    /// and both channels give the same one. [SRS_KRN_214]
    static void SendInverse(KernelContext& context, SlotIndex slot) noexcept;
    /// @brief A normal frame that one channel has seen confirmed and the other one has not: at the very limit that one
    /// had given the pair up. Both give it up; it would be on its way in one channel for another SRVT. [SRS_KRN_147]
    static void OnHalfConfirmed(const KernelContext& context, const Confirmation& one,
                                const Confirmation& other) noexcept
    {
        const bool is_half = (one.step == ConfirmStep::kNormal) && (other.step == ConfirmStep::kNone);
        if (is_half && (one.slot < context.config->srdo_count))
        {
            GiveUp(context, one.slot, SrdoCause::kNoConfirmation);
        }
    }
    /// @brief The pair of an SRDO was sent.
    void OnSent() noexcept
    {
        ++transmitted_;
    }
    /// @brief Hands a frame to the HAL; an SRDO whose frame is not taken is given up in both channels. A channel that
    /// has no frame to send gives one of kind kInvalid, which the HAL does not take; one that should have been there is
    /// missed as kNoConfirmation.
    [[nodiscard]] static hal::TransmitStatus HandOver(const KernelContext& context, const SlotIndex slot,
                                                      const CanFrame& frame) noexcept
    {
        const hal::TransmitStatus status = context.parts.can.Transmit(frame);
        if ((status != hal::TransmitStatus::kAccepted) && (frame.kind == FrameKind::kData))
        {
            GiveUp(context, slot,
                   (status == hal::TransmitStatus::kBusOff) ? SrdoCause::kBusOff : SrdoCause::kTransmitQueue);
        }
        return status;
    }

  private:
    // Used in one source file alone: `inline` leaves it to the compiler whether they are called or put in place.
    [[nodiscard]] static Result Readiness(KernelContext& context) noexcept;
    /// @brief Those of `told` of which this channel signals a missed refresh.
    [[nodiscard]] static SrdoMask MissedOf(const Channel& channel, SlotSet told) noexcept;
    /// @brief Why a request has no effect; `wanted` as in Request.
    [[nodiscard]] static Result WhyNotSent(KernelContext& context, SlotIndex wanted) noexcept;
    /// @brief Asks the provider if there is one, has both channels prepare the pair, and sends the normal frame if both
    /// gave the same.
    inline void ProduceSlot(KernelContext& context, SlotIndex slot) noexcept;
    /// @brief Both channels give up what they prepared for this slot.
    static void GiveUp(const KernelContext& context, SlotIndex slot, SrdoCause cause) noexcept;
    /// @brief Tells the application once when no SRDO followed the GFC in time.
    inline void FollowGfc(const KernelContext& context) noexcept;

    std::uint8_t transmitted_{};
    std::uint8_t transmitted_told_{};
    bool gfc_open_{};
    bool has_now_{};                      ///< There was a cycle since the start.
    std::uint32_t shortest_refresh_us_{}; ///< Of the producers; 0 without one.
    Instant gfc_until_{};                 ///< When an SRDO must have followed the GFC.
    Instant now_{};                       ///< By counter A.
    SrdoMask producers_{}; ///< What may be asked for; none outside OPERATIONAL and without a valid configuration.
    SrdoMask requests_{};  ///< Told to the channels by the next cycle, as the two below.
    SrdoMask stand_a_{};   ///< Producers whose refresh channel A has first.
    SrdoMask stand_b_{};
    SrdoMask missed_{}; ///< Of those that stand, the ones of which only this channel has missed a refresh so far.
};

} // namespace counterpoint

#endif
