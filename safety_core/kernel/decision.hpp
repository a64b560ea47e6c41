// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_KERNEL_DECISION_HPP
#define SAFETY_CORE_KERNEL_DECISION_HPP

#include "safety_core/comparator/comparator.hpp"
#include "safety_core/comparator/comparator_self_test.hpp"
#include "safety_core/comparator/slot_mask.hpp"
#include "safety_core/kernel/kernel_context.hpp"

#include <cstdint>

namespace counterpoint
{

/// What the device does with what both channels say: from the comparison of a cycle to demotion, commit and permits, in
/// this order. Short and inline, since every cycle goes through all of it.
class Decision
{
  public:
    /// @brief Begins with nothing released; Stop was called before.
    void Restart(const DeviceConfig& config) noexcept
    {
        comparator_.Restart(ComparatorSetup{config.discrepancy_us, config.acknowledge_window_us, config.srdo_count});
        self_test_.Restart(config);
    }
    /// @brief Nothing is committed, and no channel was demoted.
    void Stop() noexcept
    {
        committed_ = 0U;
        demotions_ = 0U;
    }
    /// @brief Nothing is released any more: all objects of consumers take the safe value. While the channels still know
    /// the mapping that they wrote by. [SRS_KRN_029]
    void Withdraw(KernelContext& context) noexcept
    {
        static_cast<void>(WriteObjects(context, Agreement{0U, 0U}));
        committed_ = 0U;
    }
    /// @brief The verdict on this cycle; before it, when its turn has come, the comparator's own test. Faults enter the
    /// latch. [SRS_CMP_001, SRS_CMP_009]
    void Compare(KernelContext& context, const Comparison& comparison) noexcept
    {
        if (self_test_.TakeTurn(comparison.now))
        {
            context.latch.Take(self_test_.Run(comparator_, comparison), kNoSlot);
        }
        verdict_ = comparator_.Compare(comparison);
        context.latch.Take(verdict_.fault, verdict_.slot);
        if (verdict_.echo != comparison.challenge)
        {
            context.latch.Enter(DeviceFault::kComparator, kNoSlot);
        }
    }
    /// @brief Both channels are told of slots whose release differed for too long. [SRS_CMP_340]
    void Demote(const KernelContext& context) noexcept
    {
        SlotSet to_demote{verdict_.demote};
        while (to_demote.mask != 0U)
        {
            const SlotIndex slot = TakeLowest(to_demote);
            context.parts.channel_a.Demote(slot);
            context.parts.channel_b.Demote(slot);
            if (demotions_ != kMostDemotions)
            {
                ++demotions_;
            }
        }
    }
    /// @brief Both channels write what is agreed and read it back. Consumers whose new pair was released.
    [[nodiscard]] SrdoMask Commit(KernelContext& context) noexcept
    {
        // Looked at here, where it is used; what is demoted is not agreed. [SRS_CMP_011, SRS_CMP_360, SRS_CMP_361]
        const SrdoMask unmatched = (verdict_.agreement.matched ^ comparator_.Matched()) | verdict_.demote;
        const SrdoMask unlike =
            (unmatched & verdict_.agreement.agreed) | (verdict_.agreement.agreed ^ comparator_.Agreed());
        if (unlike != 0U)
        {
            context.latch.Enter(DeviceFault::kComparator, kNoSlot);
        }
        const SrdoMask agreed = verdict_.agreement.agreed & context.latch.Gate();
        const SrdoMask written = agreed & verdict_.agreement.matched;
        const SrdoMask sound = ~WriteObjects(context, Agreement{agreed, verdict_.agreement.matched});
        const SrdoMask received = written & (verdict_.newly_matched | ~committed_);
        committed_ = (written | (committed_ & agreed)) & sound;
        return received & sound;
    }
    /// @brief The kernel's own permit is computed from the comparator's echo and spoiled by a latch that is not
    /// running; no branch decides about it. What would close an output without anybody being told, and open it again
    /// when it is right once more, is a device fault. [SRS_KRN_005, SRS_KRN_250]
    void GivePermits(KernelContext& context, const std::uint32_t challenge) const noexcept
    {
        const Permit permit_a = context.parts.channel_a.Answer(challenge);
        const Permit permit_b = context.parts.channel_b.Answer(challenge);
        const SlotSet unlike{(permit_a.mask ^ committed_) | (permit_b.mask ^ committed_)};
        if (unlike.mask != 0U)
        {
            context.latch.Enter(DeviceFault::kDisagreement, LowestOf(unlike));
        }
        if (verdict_.echo != challenge)
        {
            context.latch.Enter(DeviceFault::kComparator, kNoSlot);
        }
        const std::uint32_t low = static_cast<std::uint32_t>(committed_);
        const std::uint32_t high = static_cast<std::uint32_t>(committed_ >> kWordBits);
        const std::uint32_t rotated = (high << kPermitRotation) | (high >> (kWordBits - kPermitRotation));
        const std::uint32_t response =
            ((verdict_.echo + context.latch.Spoiler() + low) ^ rotated) * kPermitConstantKernel;
        context.parts.output.Drive(hal::PermitSet{permit_a, permit_b, Permit{committed_, response}});
    }
    /// @brief How often a channel was demoted since Start; stays at 65535. [SRS_CMP_340]
    [[nodiscard]] std::uint16_t Demotions() const noexcept
    {
        return demotions_;
    }
    /// @brief What the last Compare said.
    [[nodiscard]] const Verdict& LastVerdict() const noexcept
    {
        return verdict_;
    }

  private:
    /// @brief Slots of which a channel reads something else than it wrote; they are a fault of the device.
    /// [SRS_KRN_037, SRS_KRN_038]
    [[nodiscard]] static SrdoMask WriteObjects(KernelContext& context, const Agreement& agreement) noexcept
    {
        const SrdoMask examined = context.guard.Examined();
        const SrdoMask found_a = context.parts.channel_a.Commit(agreement, examined);
        const SlotSet found{found_a | context.parts.channel_b.Commit(agreement, examined)};
        if (found.mask != 0U)
        {
            context.latch.Enter(DeviceFault::kDisagreement, LowestOf(found));
        }
        return found.mask;
    }

    static constexpr std::uint16_t kMostDemotions = 65535U;
    static constexpr std::uint32_t kPermitRotation = 16U;
    static constexpr std::uint32_t kWordBits = 32U;

    SrdoMask committed_{};
    std::uint16_t demotions_{};
    Verdict verdict_{};
    ComparatorSelfTest self_test_{};
    Comparator comparator_{};
};

} // namespace counterpoint

#endif
