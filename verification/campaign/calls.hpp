// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_CALLS_HPP
#define VERIFICATION_CAMPAIGN_CALLS_HPP

#include "verification/campaign/members.hpp"
#include "verification/campaign/variants.hpp"
#include "verification/conformance/forwarding.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

/// Calls that do not come, come twice, behind the next one or with the next cycle. [SRS_CMG_022]
namespace counterpoint::campaign
{
/// What is to be done with one call.
enum class Turn : std::uint8_t
{
    kAsItIs = 0U,
    kSkip = 1U,
    kSkipToZero = 2U, ///< And answer 0.
    kTwice = 3U,
    kDefer = 4U,
};

/// Counts the calls of a cycle and says which one is disturbed. Outside of the region.
class CallFaults
{
  public:
    /// @brief Null: none.
    void Set(const Experiment* const fault) noexcept
    {
        fault_ = fault;
    }
    void BeginCycle(const std::size_t cycle) noexcept
    {
        cycle_ = cycle;
        turns_.fill(0U);
    }
    /// @brief `call` is a ChannelCall or KernelCall, by the part.
    [[nodiscard]] Turn Next(Part part, std::uint32_t call) noexcept;
    /// @brief Whether a call that is deferred waits for the next cycle, and not for the next call.
    [[nodiscard]] bool IsLate() const noexcept
    {
        return fault_ != nullptr && fault_->kind == FaultKind::kLate;
    }

  private:
    const Experiment* fault_{nullptr};
    std::size_t cycle_{0U};
    std::array<std::uint32_t, kChannelCalls> turns_{};
};

/// Stands in front of a shipped channel. Plain memory in the region.
class DisturbedChannel final : public conformance::Forwarding
{
  public:
    DisturbedChannel(Channel& inner, const Part part, CallFaults& faults) noexcept
        : Forwarding(inner), inner_(inner), part_(part), faults_(faults)
    {
    }

    /// @brief What was late comes before the next cycle.
    void BeginCycle() noexcept
    {
        Catch();
    }
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        Do(ChannelCall::kOnFrame, nothing_,
           [this, frame, stamp]()
           {
               inner_.OnFrame(frame, stamp);
               return Nothing{};
           });
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        return Do(ChannelCall::kOnCycle, outcome_, [this, input]() { return inner_.OnCycle(input); });
    }
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override
    {
        return Self().Do(ChannelCall::kHeld, Self().held_, [this, slot]() { return inner_.Held(slot); });
    }
    void Demote(SlotIndex slot) noexcept override
    {
        Do(ChannelCall::kDemote, nothing_,
           [this, slot]()
           {
               inner_.Demote(slot);
               return Nothing{};
           });
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        return Do(ChannelCall::kCommit, mask_,
                  [this, agreement, examine]() { return inner_.Commit(agreement, examine); });
    }
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override
    {
        return Self().Do(ChannelCall::kAnswer, Self().permit_,
                         [this, challenge]() { return inner_.Answer(challenge); });
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        return Do(ChannelCall::kPrepare, prepared_, [this, slot]() { return inner_.Prepare(slot); });
    }
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        return Do(ChannelCall::kOnConfirm, confirmation_,
                  [this, frame, stamp]() { return inner_.OnConfirm(frame, stamp); });
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        return Self().Do(ChannelCall::kInverseFrame, Self().inverse_,
                         [this, slot]() { return inner_.InverseFrame(slot); });
    }
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        return Self().Do(ChannelCall::kLoad, Self().item_, [this, address]() { return inner_.Load(address); });
    }
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override
    {
        return Do(ChannelCall::kRecheck, check_, [this, slot]() { return inner_.Recheck(slot); });
    }

  private:
    struct Nothing
    {
    };

    template <typename Answer, typename Work> Answer Do(const ChannelCall call, Answer& last, const Work& work) noexcept
    {
        const Turn turn = faults_.Next(part_, static_cast<std::uint32_t>(call));
        if (turn == Turn::kSkip || turn == Turn::kSkipToZero)
        {
            return (turn == Turn::kSkip) ? last : Answer{};
        }
        if (turn == Turn::kDefer)
        {
            Keep(work);
            return last;
        }
        if (turn == Turn::kTwice)
        {
            static_cast<void>(work());
        }
        KeepMembers(last, work());
        if (!faults_.IsLate())
        {
            Catch();
        }
        return last;
    }
    /// To be done later; the answer is for nobody then.
    template <typename Work> void Keep(const Work& work) noexcept
    {
        static_assert(sizeof(Work) <= kRoom && std::is_trivially_copyable_v<Work>, "plain memory");
        ::new (static_cast<void*>(room_.data())) Work(work);
        later_ = [](void* const kept) { static_cast<void>((*static_cast<Work*>(kept))()); };
    }
    void Catch() noexcept
    {
        if (later_ != nullptr)
        {
            void (*const later)(void*) = later_;
            later_ = nullptr;
            later(room_.data());
            room_.fill(0U);
        }
    }
    /// A query is a call like others: what it answered last is kept.
    [[nodiscard]] DisturbedChannel& Self() const noexcept
    {
        return const_cast<DisturbedChannel&>(*this);
    }

    static constexpr std::size_t kRoom = 96U;

    Channel& inner_;
    Part part_;
    CallFaults& faults_;
    alignas(std::max_align_t) std::array<std::uint8_t, kRoom> room_{};
    void (*later_)(void*){nullptr};
    Nothing nothing_{};
    CycleOutcome outcome_{};
    HeldPair held_{};
    SrdoMask mask_{};
    Permit permit_{};
    PreparedPair prepared_{};
    Confirmation confirmation_{};
    CanFrame inverse_{};
    ConfigItem item_{};
    CheckResult check_{};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_CALLS_HPP
