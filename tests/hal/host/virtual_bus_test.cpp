// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/bus.hpp"
#include "tests/hal/host/bus_rig.hpp"
#include "verification/trace/ids/hal.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::host
{
namespace
{

using hal::TransmitStatus;

std::vector<std::uint32_t> Identifiers(const std::vector<Heard>& heard)
{
    std::vector<std::uint32_t> identifiers;
    for (const Heard& item : heard)
    {
        identifiers.push_back(item.frame.identifier);
    }
    return identifiers;
}

// t [bit]   7        57   60
// bus       |--50----|int|
TEST(VirtualBus, FrameIsReceivedAndConfirmedAtTheEndOfItsEof)
{
    Verifies(req::SRS_BUS_001);
    Verifies(req::SRS_BUS_006);
    // Given an idle bus at t = 7 bits
    BusRig rig;
    rig.RunTo(7 * BusRig::kBit);
    // When node 1 sends the frame of 50 bits
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    // Then one nanosecond before its end nobody has heard anything
    rig.RunTo((57 * BusRig::kBit) - 1);
    EXPECT_TRUE(rig.listeners[0].received.empty());
    EXPECT_TRUE(rig.listeners[1].confirmed.empty());
    // and at its end all have, each in its role
    rig.RunTo(57 * BusRig::kBit);
    ASSERT_EQ(rig.listeners[0].received.size(), 1U);
    EXPECT_EQ(rig.listeners[0].received[0].at, 57'000);
    ASSERT_EQ(rig.listeners[2].received.size(), 1U);
    EXPECT_EQ(rig.listeners[2].received[0].at, 57'000);
    ASSERT_EQ(rig.listeners[1].confirmed.size(), 1U);
    EXPECT_EQ(rig.listeners[1].confirmed[0].at, 57'000);
    EXPECT_TRUE(rig.listeners[1].received.empty());
    EXPECT_TRUE(rig.listeners[0].confirmed.empty());
}

TEST(VirtualBus, ReceiversHearItInTheOrderOfTheirAttachmentAndThenTheSender)
{
    Verifies(req::SRS_BUS_006);
    // Given nodes that write their names into one list
    class Named final : public BusListener
    {
      public:
        Named(std::string& list, const char name) : list_(list), name_(name)
        {
        }
        void OnReceived(const CanFrame& /*frame*/, const BusTime /*at*/) override
        {
            list_ += name_;
        }
        void OnConfirmed(const CanFrame& /*frame*/, const BusTime /*at*/) override
        {
            list_ += '!';
        }
        void OnBusOff(const BusTime /*at*/) override
        {
        }

      private:
        std::string& list_;
        char name_;
    };
    VirtualBus bus(BitRate::k1M);
    std::string list{};
    Named nodes[]{{list, 'c'}, {list, 'a'}, {list, 'd'}, {list, 'b'}};
    for (Named& node : nodes)
    {
        static_cast<void>(bus.Attach(node, NodeSetup{CanPortId::kFirst, 4U}));
    }
    // When the second one sends
    ASSERT_EQ(bus.Submit(1U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    bus.Advance(kMillisecond);
    // Then the others hear it as they were attached, and it is confirmed behind them
    EXPECT_EQ(list, "cdb!");
}

TEST(VirtualBus, ContentArrivesUnchangedWithTheReceiversPort)
{
    Verifies(req::SRS_BUS_006);
    // Given a receiver whose controller is its second
    VirtualBus bus(BitRate::k250k);
    Listener sender;
    Listener receiver;
    static_cast<void>(bus.Attach(sender, NodeSetup{CanPortId::kFirst, 4U}));
    static_cast<void>(bus.Attach(receiver, NodeSetup{CanPortId::kSecond, 4U}));
    // When a frame of three bytes is sent
    ASSERT_EQ(bus.Submit(0U, MakeFrame(0x17FU, {0x12U, 0x34U, 0x56U})), TransmitStatus::kAccepted);
    bus.Advance(kMillisecond);
    // Then it arrives as it was, marked with the receiver's port
    ASSERT_EQ(receiver.received.size(), 1U);
    const CanFrame& frame = receiver.received[0].frame;
    EXPECT_EQ(frame.identifier, 0x17FU);
    EXPECT_EQ(frame.kind, FrameKind::kData);
    EXPECT_EQ(frame.port, CanPortId::kSecond);
    EXPECT_EQ(frame.length_bytes, 3U);
    EXPECT_EQ(frame.data[0], 0x12U);
    EXPECT_EQ(frame.data[2], 0x56U);
    EXPECT_EQ(sender.confirmed[0].frame.port, CanPortId::kFirst);
}

TEST(VirtualBus, DurationFollowsTheBitRate)
{
    Verifies(req::SRS_BUS_001);
    Verifies(req::SRS_BUS_002);
    struct RateCase
    {
        BitRate rate;
        BusTime end_ns;
    };
    // Given the frame of 50 bits at several rates
    for (const RateCase& known : {RateCase{BitRate::k10k, 5'000'000}, RateCase{BitRate::k125k, 400'000},
                                  RateCase{BitRate::k800k, 62'500}, RateCase{BitRate::k1M, 50'000}})
    {
        VirtualBus bus(known.rate);
        Listener sender;
        Listener receiver;
        static_cast<void>(bus.Attach(sender, NodeSetup{CanPortId::kFirst, 4U}));
        static_cast<void>(bus.Attach(receiver, NodeSetup{CanPortId::kFirst, 4U}));
        // When it is sent at 0
        ASSERT_EQ(bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
        bus.Advance(10 * kMillisecond);
        // Then it ends after 50 bits
        ASSERT_EQ(receiver.received.size(), 1U);
        EXPECT_EQ(receiver.received[0].at, known.end_ns);
    }
}

TEST(VirtualBus, NextFrameStartsAfterThreeBitsOfIntermission)
{
    Verifies(req::SRS_BUS_001);
    // Given two frames of 50 bits in one queue
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    // When they are sent
    rig.RunTo(kMillisecond);
    // Then the second starts at bit 53 and ends at bit 103
    ASSERT_EQ(rig.recorder.records.size(), 2U);
    EXPECT_EQ(rig.recorder.records[0].sent.start, 0);
    EXPECT_EQ(rig.recorder.records[0].end, 50'000);
    EXPECT_EQ(rig.recorder.records[1].sent.start, 53'000);
    EXPECT_EQ(rig.recorder.records[1].end, 103'000);
}

TEST(VirtualBus, LowestIdentifierWins)
{
    Verifies(req::SRS_BUS_003);
    // Given one frame in each node, all waiting at the same instant
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x001U, {})), TransmitStatus::kAccepted);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then they leave in the order of their identifiers
    EXPECT_EQ(rig.recorder.records[0].sent.frame.identifier, 0x001U);
    EXPECT_EQ(rig.recorder.records[1].sent.frame.identifier, 0x101U);
    EXPECT_EQ(rig.recorder.records[2].sent.frame.identifier, 0x102U);
}

TEST(VirtualBus, DataBeforeRemoteBeforeExtendedOfTheSameLeadingBits)
{
    Verifies(req::SRS_BUS_003);
    // Given four frames whose first 11 bits are 101h, submitted in the opposite order
    BusRig rig;
    CanFrame extended_remote = MakeFrame((0x101U << 18U) | 5U, {});
    extended_remote.kind = FrameKind::kExtendedRemote;
    CanFrame extended = MakeFrame((0x101U << 18U) | 5U, {});
    extended.kind = FrameKind::kExtended;
    CanFrame remote = MakeFrame(0x101U, {});
    remote.kind = FrameKind::kRemote;
    ASSERT_EQ(rig.bus.Submit(0U, extended_remote), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, extended), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, remote), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then they leave in the order of the first dominant bit
    ASSERT_EQ(rig.recorder.records.size(), 4U);
    EXPECT_EQ(rig.recorder.records[0].sent.frame.kind, FrameKind::kData);
    EXPECT_EQ(rig.recorder.records[1].sent.frame.kind, FrameKind::kRemote);
    EXPECT_EQ(rig.recorder.records[2].sent.frame.kind, FrameKind::kExtended);
    EXPECT_EQ(rig.recorder.records[3].sent.frame.kind, FrameKind::kExtendedRemote);
}

TEST(VirtualBus, LowerExtensionWinsAndLowerBaseBeatsIt)
{
    Verifies(req::SRS_BUS_003);
    // Given extended frames that differ in the last bit, and one of a higher base
    BusRig rig;
    CanFrame high = MakeFrame((0x101U << 18U) | 3U, {});
    high.kind = FrameKind::kExtended;
    CanFrame low = MakeFrame((0x101U << 18U) | 2U, {});
    low.kind = FrameKind::kExtended;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(1U, high), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, low), TransmitStatus::kAccepted);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then the lowest 29 bits leave first, the 11-bit identifier with the higher leading bits last
    ASSERT_EQ(rig.recorder.records.size(), 3U);
    EXPECT_EQ(rig.recorder.records[0].sent.sender, 2U);
    EXPECT_EQ(rig.recorder.records[1].sent.sender, 1U);
    EXPECT_EQ(rig.recorder.records[2].sent.sender, 0U);
}

TEST(VirtualBus, FrameSubmittedWhenTheBusBecomesIdleTakesPart)
{
    Verifies(req::SRS_BUS_003);
    // Given 102h waiting while a frame is on the bus until bit 50, its intermission until bit 53
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    rig.RunTo(10 * BusRig::kBit);
    ASSERT_EQ(rig.bus.Submit(1U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    // When 101h is submitted at bit 53 sharp
    rig.RunTo(53 * BusRig::kBit);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // Then it goes first
    EXPECT_EQ(rig.recorder.records[1].sent.frame.identifier, 0x101U);
    EXPECT_EQ(rig.recorder.records[1].sent.start, 53'000);
    EXPECT_EQ(rig.recorder.records[2].sent.frame.identifier, 0x102U);
}

TEST(VirtualBus, FrameOnTheBusIsNotDisplaced)
{
    Verifies(req::SRS_BUS_005);
    // Given 7FFh on the bus
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x7FFU, {})), TransmitStatus::kAccepted);
    rig.RunTo(2 * BusRig::kBit);
    // When a higher priority comes to the same node
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x001U, {})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // Then it waits for the end of the frame
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x7FFU, 0x001U}));
}

TEST(VirtualBus, QueueLeavesInOrderOfArbitrationThenOfSubmission)
{
    Verifies(req::SRS_BUS_005);
    // Given a queue filled out of order, with two frames of one identifier
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x103U, {1U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {1U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x102U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {2U})), TransmitStatus::kAccepted);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then the lower identifiers leave first, equal ones in their order
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x101U, 0x101U, 0x102U, 0x103U}));
    EXPECT_EQ(rig.listeners[1].received[0].frame.data[0], 1U);
    EXPECT_EQ(rig.listeners[1].received[1].frame.data[0], 2U);
}

TEST(VirtualBus, FullQueueRefusesUntilAFrameIsConfirmed)
{
    Verifies(req::SRS_BUS_005);
    // Given a node with two mailboxes, both taken, one frame of them on the bus
    BusRig rig(2U);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kQueueFull);
    rig.RunTo(49 * BusRig::kBit);
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kQueueFull);
    EXPECT_EQ(rig.bus.Pending(0U), 2U);
    // When the first is confirmed at bit 50
    rig.RunTo(50 * BusRig::kBit);
    // Then there is room for one
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    EXPECT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kQueueFull);
    // and another node's queue is its own
    EXPECT_EQ(rig.bus.Submit(1U, MakeFrame(1U, {})), TransmitStatus::kAccepted);
}

TEST(VirtualBus, WhatIsNoClassicalFrameIsRefused)
{
    Verifies(req::SRS_BUS_001);
    // Given frames that CAN cannot carry, when submitted, then they are refused
    BusRig rig;
    CanFrame long_frame = MakeFrame(0x101U, {});
    long_frame.length_bytes = 9U;
    EXPECT_EQ(rig.bus.Submit(0U, long_frame), TransmitStatus::kRefused);
    CanFrame flexible = MakeFrame(0x101U, {});
    flexible.kind = FrameKind::kFlexibleDataRate;
    EXPECT_EQ(rig.bus.Submit(0U, flexible), TransmitStatus::kRefused);
    EXPECT_EQ(rig.bus.NextEvent(), kNever);
}

TEST(VirtualBus, AbortEmptiesTheQueueButNotTheBus)
{
    Verifies(req::SRS_BUS_005);
    // Given a frame on the bus and one waiting
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(1U, {})), TransmitStatus::kAccepted);
    rig.RunTo(10 * BusRig::kBit);
    // When all is aborted
    rig.bus.AbortAll(0U);
    rig.RunTo(kMillisecond);
    // Then only the one on the bus arrives
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0U}));
    EXPECT_EQ(rig.bus.Pending(0U), 0U);
}

TEST(VirtualBus, AcceptanceFilterLetsThroughItsIdentifiersOnly)
{
    Verifies(req::SRS_BUS_006);
    // Given node 1 accepting 101h to 102h, node 2 accepting everything
    BusRig rig;
    rig.bus.AcceptNone(1U);
    rig.bus.AcceptRange(1U, 0x101U, 0x102U);
    CanFrame extended = MakeFrame(0x101U, {});
    extended.kind = FrameKind::kExtended;
    // When identifiers around the range and a 29-bit one are sent
    for (const std::uint32_t identifier : {0x100U, 0x101U, 0x102U, 0x103U})
    {
        ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(identifier, {})), TransmitStatus::kAccepted);
    }
    ASSERT_EQ(rig.bus.Submit(0U, extended), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // Then node 1 hears two of them and node 2 all
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x101U, 0x102U}));
    EXPECT_EQ(rig.listeners[2].received.size(), 5U);
    // and after AcceptAll node 1 hears everything again
    rig.bus.AcceptAll(1U);
    ASSERT_EQ(rig.bus.Submit(0U, extended), TransmitStatus::kAccepted);
    rig.RunTo(2 * kMillisecond);
    EXPECT_EQ(rig.listeners[1].received.size(), 3U);
}

TEST(VirtualBus, DisconnectedNodeHearsNothingAndKeepsItsQueue)
{
    Verifies(req::SRS_BUS_006);
    // Given node 2 without its cable, with a frame to send
    BusRig rig;
    rig.bus.Disconnect(2U);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x050U, {})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    // When the bus runs
    rig.RunTo(kMillisecond);
    // Then it hears nothing and sends nothing
    EXPECT_TRUE(rig.listeners[2].received.empty());
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x101U}));
    // and with the cable back its frame leaves
    rig.bus.Connect(2U);
    rig.RunTo(2 * kMillisecond);
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x101U, 0x050U}));
    EXPECT_EQ(rig.recorder.records[1].sent.start, kMillisecond);
}

TEST(VirtualBus, StatusWaitsOnce)
{
    Verifies(req::SRS_BUS_017);
    // Given node 2 without its cable, whose frames 702h wait once
    BusRig rig;
    rig.bus.WaitOnce(2U, 0x702U);
    rig.bus.Disconnect(2U);
    // When it sends a boot-up, two states twice each and another frame twice
    for (const CanFrame& frame : {MakeFrame(0x702U, {0x00U}), MakeFrame(0x702U, {0x7FU}), MakeFrame(0x702U, {0x05U}),
                                  MakeFrame(0x702U, {0x7FU}), MakeFrame(0x702U, {0x05U}), MakeFrame(0x703U, {0x05U}),
                                  MakeFrame(0x703U, {0x05U})})
    {
        ASSERT_EQ(rig.bus.Submit(2U, frame), TransmitStatus::kAccepted);
    }
    rig.bus.Connect(2U);
    rig.RunTo(2 * kMillisecond);
    // Then each state leaves once, the newest one last; other frames as often as they were sent
    std::vector<std::uint8_t> bytes;
    for (const Heard& heard : rig.listeners[1].received)
    {
        bytes.push_back(heard.frame.data[0]);
    }
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x00U, 0x7FU, 0x05U, 0x05U, 0x05U}));
    EXPECT_EQ(Identifiers(rig.listeners[1].received),
              (std::vector<std::uint32_t>{0x702U, 0x702U, 0x702U, 0x703U, 0x703U}));
}

TEST(VirtualBus, AFrameOfAnotherIdentifierOrLengthIsNotTheSameContent)
{
    Verifies(req::SRS_BUS_017);
    // Given node 2 without its cable, whose frames 702h wait once, and another frame with the same byte that waits
    BusRig rig;
    rig.bus.WaitOnce(2U, 0x702U);
    rig.bus.Disconnect(2U);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x703U, {0x05U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x702U, {0x05U})), TransmitStatus::kAccepted);
    // When it sends that byte and one more, and then the byte alone again
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x702U, {0x05U, 0x00U})), TransmitStatus::kAccepted);
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x702U, {0x05U})), TransmitStatus::kAccepted);
    rig.bus.Connect(2U);
    rig.RunTo(2 * kMillisecond);
    // Then only the frame with this byte alone has given up its place
    std::vector<std::uint8_t> lengths;
    for (const Heard& heard : rig.listeners[1].received)
    {
        lengths.push_back(heard.frame.length_bytes);
    }
    EXPECT_EQ(lengths, (std::vector<std::uint8_t>{2U, 1U, 1U}));
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x702U, 0x702U, 0x703U}));
}

TEST(VirtualBus, ANodeThatIsDetachedIsNotToldThatItIsOffTheBus)
{
    Verifies(req::SRS_BUS_008);
    BusRig rig;
    rig.bus.Detach(2U);
    rig.bus.ForceBusOff(2U);
    rig.bus.ForceBusOff(1U);
    EXPECT_TRUE(rig.listeners[2].bus_off.empty());
    EXPECT_EQ(rig.listeners[1].bus_off, (std::vector<BusTime>{0}));
}

TEST(VirtualBus, TellsHowLongABitIs)
{
    Verifies(req::SRS_BUS_002);
    EXPECT_EQ(VirtualBus(BitRate::k10k).BitDuration(), 100'000);
    EXPECT_EQ(VirtualBus(BitRate::k125k).BitDuration(), 8'000);
    EXPECT_EQ(VirtualBus(BitRate::k1M).BitDuration(), 1'000);
}

TEST(VirtualBus, DetachedNodeIsGoneForGood)
{
    Verifies(req::SRS_BUS_006);
    // Given node 2 detached with a frame waiting
    BusRig rig;
    ASSERT_EQ(rig.bus.Submit(2U, MakeFrame(0x050U, {})), TransmitStatus::kAccepted);
    rig.bus.Detach(2U);
    rig.bus.Connect(2U);
    // When node 0 sends
    ASSERT_EQ(rig.bus.Submit(0U, MakeFrame(0x101U, {})), TransmitStatus::kAccepted);
    rig.RunTo(kMillisecond);
    // Then node 2 neither sends nor hears, and the others keep their numbers
    EXPECT_TRUE(rig.listeners[2].received.empty());
    EXPECT_EQ(Identifiers(rig.listeners[1].received), (std::vector<std::uint32_t>{0x101U}));
    EXPECT_EQ(rig.bus.NodeCount(), 3U);
}

} // namespace
} // namespace counterpoint::host
