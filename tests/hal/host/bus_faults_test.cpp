// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus_fault.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace counterpoint::host
{
namespace
{

using hal::TransmitStatus;

/// Does what a test tells it, for one receiver or for the confirmations.
class Scripted final : public BusFault
{
  public:
    using Change = std::function<void(ReceptionList&)>;

    SubmitFate OnSubmit(CanFrame& frame, const NodeIndex sender, const BusTime now) override
    {
        static_cast<void>(sender);
        submitted_at = now;
        frame.data[0] = static_cast<std::uint8_t>(frame.data[0] ^ submit_flip);
        frame.length_bytes = static_cast<std::uint8_t>(frame.length_bytes + submit_longer);
        return submit_fate;
    }
    void OnReception(const FrameOnBus& sent, const NodeIndex receiver, ReceptionList& receptions) override
    {
        static_cast<void>(sent);
        if ((receiver == victim) && on_reception)
        {
            on_reception(receptions);
        }
    }
    void OnConfirmation(const FrameOnBus& sent, ReceptionList& receptions) override
    {
        static_cast<void>(sent);
        if (on_confirmation)
        {
            on_confirmation(receptions);
        }
    }

    NodeIndex victim{1U};
    Change on_reception{};
    Change on_confirmation{};
    SubmitFate submit_fate{SubmitFate::kQueued};
    std::uint8_t submit_flip{0U};
    std::uint8_t submit_longer{0U};
    BusTime submitted_at{0};
};

class BusFaults : public ::testing::Test
{
  protected:
    BusFaults()
    {
        rig.bus.Install(fault);
    }
    /// Sends identifier 0 with 00h (56 bits) from node 0 at 0 and waits a millisecond.
    void SendOne()
    {
        ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
        rig.RunTo(kMillisecond);
    }
    [[nodiscard]] const std::vector<Heard>& AtVictim() const
    {
        return rig.listeners[1].received;
    }

    BusRig rig{};
    Scripted fault{};
};

TEST_F(BusFaults, FaultThatChangesNothingLeavesTheFrameAlone)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that does nothing, when a frame is sent, then all hear it
    SendOne();
    EXPECT_EQ(AtVictim().size(), 1U);
    EXPECT_EQ(rig.listeners[2].received.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].receivers, 2U);
}

TEST_F(BusFaults, CorruptionReachesTheChosenReceiverOnly)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that changes a byte for node 1
    fault.on_reception = [](ReceptionList& list) { list[0].frame.data[0] = 0x40U; };
    // When a frame is sent
    SendOne();
    // Then node 1 sees the changed byte, node 2 and the sender the true one
    ASSERT_EQ(AtVictim().size(), 1U);
    EXPECT_EQ(AtVictim()[0].frame.data[0], 0x40U);
    EXPECT_EQ(rig.listeners[2].received[0].frame.data[0], 0x00U);
    EXPECT_EQ(rig.listeners[0].confirmed[0].frame.data[0], 0x00U);
}

TEST_F(BusFaults, IdentifierKindAndLengthCanBeChanged)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that makes another frame of it
    fault.on_reception = [](ReceptionList& list)
    {
        list[0].frame.identifier = 0x155U;
        list[0].frame.kind = FrameKind::kRemote;
        list[0].frame.length_bytes = 7U;
    };
    // When a frame is sent, then node 1 sees that
    SendOne();
    ASSERT_EQ(AtVictim().size(), 1U);
    EXPECT_EQ(AtVictim()[0].frame.identifier, 0x155U);
    EXPECT_EQ(AtVictim()[0].frame.kind, FrameKind::kRemote);
    EXPECT_EQ(AtVictim()[0].frame.length_bytes, 7U);
}

TEST_F(BusFaults, ChangedIdentifierHasToPassTheFilter)
{
    Verifies(req::SRS_BUS_006);
    // Given node 1 accepting 155h only, and a fault that makes 155h of 000h
    rig.bus.AcceptNone(1U);
    rig.bus.AcceptRange(1U, 0x155U, 0x155U);
    SendOne();
    ASSERT_TRUE(AtVictim().empty());
    fault.on_reception = [](ReceptionList& list) { list[0].frame.identifier = 0x155U; };
    // When a frame is sent, then it passes
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    EXPECT_EQ(AtVictim().size(), 1U);
}

TEST_F(BusFaults, LossIsLossAtOneReceiver)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that loses node 1's frame
    fault.on_reception = [](ReceptionList& list) { list.Clear(); };
    // When a frame is sent
    SendOne();
    // Then node 1 hears nothing, node 2 does, and the sender is confirmed
    EXPECT_TRUE(AtVictim().empty());
    EXPECT_EQ(rig.listeners[2].received.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
    EXPECT_EQ(rig.recorder.records[0].receivers, 1U);
}

TEST_F(BusFaults, DelayedFrameComesLater)
{
    Verifies(req::SRS_BUS_010);
    // Given a delay of 300 us for node 1
    fault.on_reception = [](ReceptionList& list) { list[0].delay = 300 * kMicrosecond; };
    // When a frame of 56 bits is sent
    SendOne();
    // Then node 1 hears it at 356 us, node 2 at 56 us
    ASSERT_EQ(AtVictim().size(), 1U);
    EXPECT_EQ(AtVictim()[0].at, 356'000);
    EXPECT_EQ(rig.listeners[2].received[0].at, 56'000);
}

TEST_F(BusFaults, RepetitionAndInsertionComeInTheirOrder)
{
    Verifies(req::SRS_BUS_010);
    // Given the frame twice at once, once more 10 us later, and a foreign one beside it
    fault.on_reception = [](ReceptionList& list)
    {
        ASSERT_TRUE(list.Add(Reception{list[0].frame, 10 * kMicrosecond}));
        ASSERT_TRUE(list.Add(list[0]));
        ASSERT_TRUE(list.Add(Reception{MakeFrame(0x123U, {}), 0}));
    };
    // When a frame is sent
    SendOne();
    // Then node 1 hears all four
    ASSERT_EQ(AtVictim().size(), 4U);
    EXPECT_EQ(AtVictim()[0].frame.identifier, 0U);
    EXPECT_EQ(AtVictim()[1].frame.identifier, 0U);
    EXPECT_EQ(AtVictim()[1].at, 56'000);
    EXPECT_EQ(AtVictim()[2].frame.identifier, 0x123U);
    EXPECT_EQ(AtVictim()[3].at, 66'000);
}

TEST_F(BusFaults, ListOfReceptionsIsBounded)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that adds until it is refused
    std::size_t added = 0U;
    fault.on_reception = [&added](ReceptionList& list)
    {
        while (list.Add(list[0]))
        {
            ++added;
        }
    };
    // When a frame is sent, then node 1 hears as many as the list holds
    SendOne();
    EXPECT_EQ(added, 15U);
    EXPECT_EQ(AtVictim().size(), 16U);
}

TEST_F(BusFaults, ConfirmationCanBeLostDelayedAndChanged)
{
    Verifies(req::SRS_BUS_010);
    // Given no confirmation, when a frame is sent, then the receivers hear it and the sender nothing
    fault.on_confirmation = [](ReceptionList& list) { list.Clear(); };
    SendOne();
    EXPECT_EQ(AtVictim().size(), 1U);
    EXPECT_TRUE(rig.listeners[0].confirmed.empty());
    // Given a late and false one, then the sender hears that, and the mailbox is free in time
    fault.on_confirmation = [](ReceptionList& list)
    {
        list[0].frame.data[0] = 0x77U;
        list[0].delay = 100 * kMicrosecond;
    };
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond + (56 * BusRig::kBit));
    EXPECT_EQ(rig.bus.Pending(0U), 0U);
    rig.RunTo(2 * kMillisecond);
    ASSERT_EQ(rig.listeners[0].confirmed.size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed[0].frame.data[0], 0x77U);
    EXPECT_EQ(rig.listeners[0].confirmed[0].at, 1'156'000);
}

TEST_F(BusFaults, FrameCanBeChangedSwallowedOrRefusedBeforeItIsSent)
{
    Verifies(req::SRS_BUS_010);
    // Given a controller that changes the frame before its CRC, then all see the change, the sender too
    fault.submit_flip = 0x10U;
    SendOne();
    EXPECT_EQ(AtVictim()[0].frame.data[0], 0x10U);
    EXPECT_EQ(rig.listeners[2].received[0].frame.data[0], 0x10U);
    EXPECT_EQ(rig.listeners[0].confirmed[0].frame.data[0], 0x10U);
    // Given one that swallows it, then it is accepted and never sent
    fault.submit_fate = SubmitFate::kSwallowed;
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    EXPECT_EQ(fault.submitted_at, kMillisecond);
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
    // Given one that is stuck full, then it is refused
    fault.submit_fate = SubmitFate::kQueueFull;
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kQueueFull);
    // Given one that makes no frame of it, then it is refused as such
    fault.submit_fate = SubmitFate::kQueued;
    fault.submit_longer = 9U;
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kRefused);
}

TEST_F(BusFaults, FaultsAreAskedInOrderAndNoMoreAfterRemoval)
{
    Verifies(req::SRS_BUS_010);
    // Given a second fault that sees what the first left
    Scripted second;
    rig.bus.Install(second);
    fault.on_reception = [](ReceptionList& list) { list[0].frame.data[0] = 0x01U; };
    second.on_reception = [](ReceptionList& list)
    { list[0].frame.data[0] = static_cast<std::uint8_t>((list[0].frame.data[0] * 2U) + 1U); };
    SendOne();
    EXPECT_EQ(AtVictim()[0].frame.data[0], 0x03U);
    // When the first is removed
    rig.bus.Remove(fault);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x10U})), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    // Then only the second acts
    EXPECT_EQ(AtVictim()[1].frame.data[0], 0x21U);
}

TEST_F(BusFaults, FaultsWithoutOverridesAreHarmless)
{
    Verifies(req::SRS_BUS_010);
    // Given a fault that overrides nothing, when a frame is sent, then all is as without it
    BusFault nothing;
    rig.bus.Install(nothing);
    SendOne();
    EXPECT_EQ(AtVictim().size(), 1U);
    EXPECT_EQ(rig.listeners[0].confirmed.size(), 1U);
    EXPECT_EQ(rig.recorder.records.size(), 1U);
}

TEST_F(BusFaults, PlannedReceptionNeedsNoFrameOnTheBus)
{
    Verifies(req::SRS_BUS_011);
    // Given a reception planned for node 1 at 500 us and one for now
    rig.bus.Plan(1U, MakeFrame(0x111U, {1U}), 500 * kMicrosecond);
    rig.bus.Plan(1U, MakeFrame(0x222U, {}), 0);
    EXPECT_EQ(rig.bus.NextEvent(), 0);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then node 1 alone hears them then, and no frame was on the bus
    ASSERT_EQ(AtVictim().size(), 2U);
    EXPECT_EQ(AtVictim()[0].frame.identifier, 0x222U);
    EXPECT_EQ(AtVictim()[0].at, 0);
    EXPECT_EQ(AtVictim()[1].frame.identifier, 0x111U);
    EXPECT_EQ(AtVictim()[1].at, 500'000);
    EXPECT_TRUE(rig.listeners[2].received.empty());
    EXPECT_TRUE(rig.recorder.records.empty());
}

TEST_F(BusFaults, DelayedFrameDoesNotReachANodeThatIsGoneByThen)
{
    Verifies(req::SRS_BUS_006);
    // Given a frame that reaches node 1 at 356 us
    fault.on_reception = [](ReceptionList& list) { list[0].delay = 300 * kMicrosecond; };
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {0x00U})), TransmitStatus::kAccepted);
    rig.RunTo(200 * kMicrosecond);
    // When node 1 goes bus-off before
    rig.bus.ForceBusOff(1U);
    rig.RunTo(kMillisecond);
    // Then it does not hear it
    EXPECT_TRUE(AtVictim().empty());
}

TEST_F(BusFaults, IdentifierThatNoElevenBitsHoldDoesNotPassAnyFilter)
{
    Verifies(req::SRS_BUS_006);
    // Given a fault that makes an impossible 11-bit frame, when a frame is sent, then no filter lets it through
    fault.on_reception = [](ReceptionList& list) { list[0].frame.identifier = 0x800U; };
    SendOne();
    EXPECT_TRUE(AtVictim().empty());
    EXPECT_EQ(rig.listeners[2].received.size(), 1U);
}

TEST_F(BusFaults, PlannedReceptionsOfOneInstantComeInOrderAndBeforeTheFrame)
{
    Verifies(req::SRS_BUS_011);
    // Given a frame that ends at 56 us and two receptions planned for that instant
    rig.bus.Plan(1U, MakeFrame(0x111U, {}), 56 * kMicrosecond);
    rig.bus.Plan(1U, MakeFrame(0x110U, {}), 56 * kMicrosecond);
    // When the bus runs
    SendOne();
    // Then they come in order of planning, then the frame
    ASSERT_EQ(AtVictim().size(), 3U);
    EXPECT_EQ(AtVictim()[0].frame.identifier, 0x111U);
    EXPECT_EQ(AtVictim()[1].frame.identifier, 0x110U);
    EXPECT_EQ(AtVictim()[2].frame.identifier, 0U);
    EXPECT_EQ(AtVictim()[2].at, 56'000);
}

} // namespace
} // namespace counterpoint::host
