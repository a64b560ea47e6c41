// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What becomes of the calls that a campaign disturbs, call by call.
#include "verification/campaign/calls.hpp"

#include "verification/trace/ids/campaign.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>
#include <gtest/gtest.h>
#include <string>

namespace counterpoint::campaign::test
{
namespace
{
/// Answers 1 to each call, and writes a letter for it: those of ChannelCall are a to k.
class Written final : public Channel
{
  public:
    void Restart(const DeviceConfig& /*config*/) noexcept override
    {
    }
    void Store(const ConfigItem& /*item*/) noexcept override
    {
    }
    [[nodiscard]] ChannelRoom Room() const noexcept override
    {
        return {};
    }
    void SetFields(SlotIndex /*slot*/, const StaticFields& /*fields*/) noexcept override
    {
    }
    [[nodiscard]] DeviceDigest Digest(SlotIndex /*slot*/, DeviceDigest before) const noexcept override
    {
        return before;
    }
    [[nodiscard]] CheckResult Validate(SlotIndex /*slot*/) noexcept override
    {
        return {};
    }
    [[nodiscard]] SrdoView View(SlotIndex /*slot*/) const noexcept override
    {
        return {};
    }
    void OnTransmitFault(SlotIndex /*slot*/, const counterpoint::TransmitFault& /*fault*/) noexcept override
    {
    }

    void OnFrame(const CanFrame& /*frame*/, Instant /*stamp*/) noexcept override
    {
        text += 'a';
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& /*input*/) noexcept override
    {
        text += 'b';
        CycleOutcome outcome{};
        outcome.released = 1U;
        return outcome;
    }
    [[nodiscard]] HeldPair Held(SlotIndex /*slot*/) const noexcept override
    {
        text += 'c';
        return HeldPair{{}, 1U, 0U};
    }
    void Demote(SlotIndex /*slot*/) noexcept override
    {
        text += 'd';
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& /*agreement*/, SrdoMask /*examine*/) noexcept override
    {
        text += 'e';
        return 1U;
    }
    [[nodiscard]] Permit Answer(std::uint32_t /*challenge*/) const noexcept override
    {
        text += 'f';
        return Permit{1U, 0U};
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex /*slot*/) noexcept override
    {
        text += 'g';
        return PreparedPair{{}, PrepareStatus::kReady};
    }
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& /*frame*/, Instant /*stamp*/) noexcept override
    {
        text += 'h';
        return Confirmation{0U, ConfirmStep::kPair};
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex /*slot*/) const noexcept override
    {
        text += 'i';
        CanFrame frame{};
        frame.identifier = 1U;
        return frame;
    }
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        text += 'j';
        return ConfigItem{address, 1U};
    }
    [[nodiscard]] CheckResult Recheck(SlotIndex /*slot*/) noexcept override
    {
        text += 'k';
        return CheckResult{ConfigFault::kNone, 1U};
    }

    mutable std::string text{};
};

/// The call with this letter; whether its answer is the one of Written, where it has one.
bool Call(Channel& channel, const char letter)
{
    switch (letter)
    {
    case 'a':
        channel.OnFrame(CanFrame{}, Instant{0U});
        return true;
    case 'b':
        return channel.OnCycle(CycleInput{}).released == 1U;
    case 'c':
        return channel.Held(0U).ordinal == 1U;
    case 'd':
        channel.Demote(0U);
        return true;
    case 'e':
        return channel.Commit(Agreement{}, 0U) == 1U;
    case 'f':
        return channel.Answer(1U).mask == 1U;
    case 'g':
        return channel.Prepare(0U).status == PrepareStatus::kReady;
    case 'h':
        return channel.OnConfirm(CanFrame{}, Instant{0U}).step == ConfirmStep::kPair;
    case 'i':
        return channel.InverseFrame(0U).identifier == 1U;
    case 'j':
        return channel.Load(ConfigAddress{}).value == 1U;
    default:
        return channel.Recheck(0U).signature == 1U;
    }
}

/// Three cycles of a call X and another one y, of which the second cycle is hit: what the channel sees of it.
std::string Seen(const Part part, const char letter, const FaultKind kind, const std::uint32_t variant,
                 const std::uint32_t turn = 0U)
{
    Experiment fault;
    fault.part = part;
    fault.kind = kind;
    fault.subject = (static_cast<std::size_t>(letter - 'a') * kTurns) + turn;
    fault.variant = variant;
    fault.cycle = 5U;
    Written inner;
    CallFaults faults;
    faults.Set(&fault);
    DisturbedChannel channel(inner, Part::kCallsOfA, faults);
    const char other = (letter == 'b') ? 'c' : 'b';
    std::string seen;
    for (std::size_t cycle = 4U; cycle < 7U; ++cycle)
    {
        faults.BeginCycle(cycle);
        inner.text.clear();
        channel.BeginCycle();
        static_cast<void>(Call(channel, letter));
        static_cast<void>(Call(channel, other));
        for (const char each : inner.text)
        {
            seen += (each == letter) ? 'X' : (each == other) ? 'y' : '?';
        }
        seen += ' ';
    }
    return seen;
}

TEST(DisturbedCalls, EachCallOfAChannelIsLeftOutDoubledAndDeferred)
{
    Verifies(req::SRS_CMG_022);
    for (char letter = 'a'; letter <= 'k'; ++letter)
    {
        const auto seen = [letter](const FaultKind kind, const std::uint32_t variant)
        { return Seen(Part::kCallsOfA, letter, kind, variant); };
        // Once, and in each cycle from then on
        EXPECT_EQ(seen(FaultKind::kSkipped, 0U), "Xy y Xy ") << letter;
        EXPECT_EQ(seen(FaultKind::kSkipped, kAlways), "Xy y y ") << letter;
        EXPECT_EQ(seen(FaultKind::kDoubled, 0U), "Xy XXy Xy ") << letter;
        EXPECT_EQ(seen(FaultKind::kDoubled, kAlways), "Xy XXy XXy ") << letter;
        // Behind the next one, and with the next cycle
        EXPECT_EQ(seen(FaultKind::kReordered, 0U), "Xy yX Xy ") << letter;
        EXPECT_EQ(seen(FaultKind::kReordered, kAlways), "Xy yX yX ") << letter;
        EXPECT_EQ(seen(FaultKind::kLate, 0U), "Xy y XXy ") << letter;
        EXPECT_EQ(seen(FaultKind::kLate, kAlways), "Xy y Xy ") << letter;
        // The second one of a cycle does not come, and the other channel is not hit
        EXPECT_EQ(Seen(Part::kCallsOfA, letter, FaultKind::kSkipped, 0U, 1U), "Xy Xy Xy ") << letter;
        EXPECT_EQ(Seen(Part::kCallsOfB, letter, FaultKind::kSkipped, 0U), "Xy Xy Xy ") << letter;
    }
}

TEST(DisturbedCalls, OneThatIsLeftOutAnswersWhatItAnsweredLastOrNothing)
{
    Verifies(req::SRS_CMG_022);
    for (const char letter : {'b', 'c', 'e', 'f', 'g', 'h', 'i', 'j', 'k'})
    {
        for (const std::uint32_t variant : {0U, kNothingLeft})
        {
            Experiment fault;
            fault.part = Part::kCallsOfA;
            fault.kind = FaultKind::kSkipped;
            fault.subject = static_cast<std::size_t>(letter - 'a') * kTurns;
            fault.variant = variant;
            fault.cycle = 5U;
            Written inner;
            CallFaults faults;
            faults.Set(&fault);
            DisturbedChannel channel(inner, Part::kCallsOfA, faults);
            faults.BeginCycle(4U);
            EXPECT_TRUE(Call(channel, letter)) << letter;
            faults.BeginCycle(5U);
            EXPECT_EQ(Call(channel, letter), variant == 0U) << letter;
        }
    }
}

TEST(DisturbedCalls, ReceptionAndConfirmationOfTheKernelAreHitAlike)
{
    Verifies(req::SRS_CMG_022);
    for (const KernelCall call : {KernelCall::kOnFrame, KernelCall::kOnConfirm})
    {
        const auto turns = [call](const FaultKind kind, const std::uint32_t variant)
        {
            Experiment fault;
            fault.part = Part::kKernelCalls;
            fault.kind = kind;
            fault.subject = static_cast<std::size_t>(call) * kTurns;
            fault.variant = variant;
            fault.cycle = 5U;
            CallFaults faults;
            faults.Set(&fault);
            std::string text;
            for (std::size_t cycle = 4U; cycle < 7U; ++cycle)
            {
                faults.BeginCycle(cycle);
                const Turn turn = faults.Next(Part::kKernelCalls, static_cast<std::uint32_t>(call));
                text += (turn == Turn::kAsItIs)  ? "- "
                        : (turn == Turn::kSkip)  ? "skip "
                        : (turn == Turn::kTwice) ? "twice "
                        : (turn == Turn::kDefer) ? (faults.IsLate() ? "late " : "behind ")
                                                 : "? ";
            }
            return text;
        };
        EXPECT_EQ(turns(FaultKind::kSkipped, 0U), "- skip - ");
        EXPECT_EQ(turns(FaultKind::kSkipped, kAlways), "- skip skip ");
        EXPECT_EQ(turns(FaultKind::kDoubled, 0U), "- twice - ");
        EXPECT_EQ(turns(FaultKind::kDoubled, kAlways), "- twice twice ");
        EXPECT_EQ(turns(FaultKind::kReordered, 0U), "- behind - ");
        EXPECT_EQ(turns(FaultKind::kReordered, kAlways), "- behind behind ");
        EXPECT_EQ(turns(FaultKind::kLate, 0U), "- late - ");
        EXPECT_EQ(turns(FaultKind::kLate, kAlways), "- late late ");
    }
}
} // namespace
} // namespace counterpoint::campaign::test
