// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_REPORTING_HPP
#define SAFETY_CORE_KERNEL_REPORTING_HPP

#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/contract/channel.hpp"
#include "safety_core/kernel/kernel_context.hpp"
#include "safety_core/kernel/srdo_status.hpp"
#include "safety_core/kernel/told_causes.hpp"

#include <cstdint>

namespace counterpoint
{

/// Whether OnFlow is called; the flow monitor works with either. [SRS_FLOW_342]
enum class FlowCallback : std::uint8_t
{
    kOff = 0U,
    kOn = 1U,
};

/// Whether the application must answer in the status byte; the byte signals with either. [SRS_KRN_344]
enum class StatusHandshake : std::uint8_t
{
    kOff = 0U,
    kRequired = 0x69U,
};

/// @brief First cause of an SRDO by what its channels say: as A has it, or B where A has none or was demoted: a demoted
/// channel learned of the fault from the other one, which knows the cause. [SRS_KRN_152]
[[nodiscard]] SrdoCause FirstCauseOf(const SrdoView& a, const SrdoView& b) noexcept;

/// What the application is told, and what it answers by the status bytes. [SRS_KRN_006, SRS_KRN_021, SRS_KRN_022,
/// SRS_KRN_226, SRS_KRN_032, SRS_FLOW_004] What every cycle goes through is inline.
class Reporting
{
  public:
    /// @brief Nothing was told. `flow` and `handshake` are what Kernel::Start was given.
    void Restart(const KernelContext& context, const FlowCallback flow, const StatusHandshake handshake) noexcept
    {
        flow_callback_ = flow;
        handshake_ = handshake;
        gfc_seen_ = false;
        fault_told_ = false;
        status_ = SrdoStatus{};
        told_.Restart(context.parts.windows, context.config->srdo_count);
    }
    /// @brief Status bytes of all SRDOs. [SRS_KRN_021]
    [[nodiscard]] const SrdoStatus& Status() const noexcept
    {
        return status_;
    }
    /// @brief The same, to change them.
    [[nodiscard]] SrdoStatus& Status() noexcept
    {
        return status_;
    }
    /// @brief A GFC was accepted: TellErrors tells it.
    void OnGfc() noexcept
    {
        gfc_seen_ = true;
    }
    /// @brief A new pair was released, or a pair was sent. [SRS_KRN_340]
    void TellEvent(const KernelContext& context, const SlotIndex slot) noexcept
    {
        status_.OnEvent(slot);
        context.parts.application.OnSrdoEvent(IndexOf(*context.config, slot));
    }
    /// @brief Every cause that a channel signals and that was not told within its window, and a GFC. Of one SRDO the
    /// first cause is told first where it is signalled, then the others by number: signals have no order of their own.
    /// O(signalled) [SRS_KRN_032, SRS_KRN_341, SRS_KRN_345, SRS_KRN_570, SRS_CMP_150]
    void TellErrors(const KernelContext& context, const SrdoMask signalled, const Instant now) noexcept
    {
        errors_ = 0U;
        if (told_.Slots() != 0U)
        {
            SweepOne(context, now);
        }
        SlotSet to_report{signalled};
        while (to_report.mask != 0U)
        {
            const SlotIndex slot = TakeLowest(to_report);
            if (slot < context.config->srdo_count)
            {
                TellSlot(context, slot, now);
            }
        }
        if (gfc_seen_)
        {
            context.parts.application.OnGfc();
        }
        gfc_seen_ = false;
    }
    /// @brief New pairs of consumers. O(received)
    void TellReceived(const KernelContext& context, const SrdoMask received) noexcept
    {
        received_ = 0U;
        SlotSet to_report{received};
        while (to_report.mask != 0U)
        {
            ++received_;
            TellEvent(context, TakeLowest(to_report));
        }
    }
    /// @brief Counts of this cycle, if they are wanted. [SRS_FLOW_004, SRS_FLOW_340]
    void TellFlow(const KernelContext& context, const CycleOutcome& outcome, const std::uint8_t transmitted) noexcept
    {
        if (flow_callback_ == FlowCallback::kOn)
        {
            TellCounts(context, outcome, transmitted);
        }
    }
    /// @brief An event that was not answered in time is a device fault. [SRS_KRN_022]
    void ExamineHandshake(KernelContext& context) noexcept
    {
        if (handshake_ != StatusHandshake::kRequired)
        {
            return;
        }
        const SlotIndex overdue = status_.TakeOverdue();
        if (overdue != kNoSlot)
        {
            context.latch.Enter(DeviceFault::kHandshake, overdue);
        }
    }
    /// @brief The device safe state, once. [SRS_KRN_342]
    void TellDevice(KernelContext& context) noexcept
    {
        if ((!context.latch.IsRunning()) && (!fault_told_))
        {
            fault_told_ = true;
            context.parts.application.OnDeviceFault(context.latch.Report());
        }
    }

  private:
    /// @brief Causes of one slot that either channel signals and that were not told within their window, the first
    /// cause before the others.
    void TellSlot(const KernelContext& context, SlotIndex slot, Instant now) noexcept;
    /// @brief One of them, unless it was told within its window.
    void TellCause(const KernelContext& context, SlotIndex slot, SrdoCause cause, const ToldWindow& window) noexcept;
    /// @brief One slot a cycle: forgets windows that are over, before the counter comes round.
    void SweepOne(const KernelContext& context, Instant now) noexcept;
    /// @brief Flow events of the cycle.
    void TellCounts(const KernelContext& context, const CycleOutcome& outcome, std::uint8_t transmitted) noexcept;
    /// @brief One flow event, unless its count is 0. [SRS_FLOW_341]
    static void Deliver(const KernelContext& context, FlowEvent event, std::uint16_t count) noexcept;

    FlowCallback flow_callback_{};
    StatusHandshake handshake_{};
    bool gfc_seen_{};
    bool fault_told_{};
    std::uint8_t received_{};
    std::uint16_t errors_{}; ///< Told in this cycle: more than 255 with many consumers.
    SrdoStatus status_{};
    ToldCauses told_{};
};

} // namespace counterpoint

#endif
