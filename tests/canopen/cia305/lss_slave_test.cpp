// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia305/lss_slave.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/lss.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::cia305
{
namespace
{

using cia301::KeepingSink;
using cia301::NmtSlave;
using cia301::NodeState;
using cia301::Octets;
using cia301::StartUp;

constexpr Identity kIdentity{0x00000123U, 0x80000001U, 0x00010002U, 0xCAFE0007U};

/// A slave without a node-ID, in RESET COMMUNICATION.
class LssSlaveTest : public ::testing::Test, public LssDevice
{
  public:
    bool IsSupported(BitTiming timing) noexcept override
    {
        return timing.index <= 4U;
    }
    LssStored Store(const LssSettings& settings) noexcept override
    {
        stored = settings;
        ++store_calls;
        return answer;
    }
    void SwitchTo(BitTiming timing) noexcept override
    {
        rate = timing.index;
    }
    Octets Send(const Octets& command)
    {
        CanFrame frame{0x7E5U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(command.begin(), command.end(), frame.data);
        slave.OnFrame(frame, Moment{state, Instant{now_us}});
        return sink.Next();
    }
    Octets Send(std::uint8_t command, std::uint32_t value)
    {
        return Send({command, static_cast<std::uint8_t>(value & 0xFFU),
                     static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
                     static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)});
    }
    Octets Scan(std::uint32_t value, std::uint8_t bit, std::uint8_t part, std::uint8_t next)
    {
        return Send({0x51U, static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
                     static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U), bit,
                     part, next});
    }
    Octets Cycle()
    {
        slave.OnCycle(Moment{state, Instant{now_us}});
        return sink.Next();
    }
    static Octets Reply(std::uint8_t command, std::uint8_t error = 0U)
    {
        return {command, error, 0U, 0U, 0U, 0U, 0U, 0U};
    }

    std::uint32_t now_us{0xFFFFFF00U};
    NodeState state{NodeState::kResetCommunication};
    LssStored answer{LssStored::kDone};
    LssSettings stored{0U, {9U}};
    int store_calls{0};
    int rate{-1};
    KeepingSink sink{};
    LssSlave slave{LssParts{sink, *this, kIdentity, LssSettings{kNoNodeId, {2U}}}};
};

TEST_F(LssSlaveTest, OnlyFramesOfEightBytesOnItsIdentifierCount)
{
    Verifies(req::SRS_LSS_001);
    Verifies(req::SRS_LSS_008);
    EXPECT_EQ(Send({0x4CU}), Reply(0x50U));
    EXPECT_EQ(sink.identifier, 0x7E4U);
    CanFrame frame{0x7E5U, FrameKind::kData, CanPortId::kFirst, 7U, {0x4CU}};
    slave.OnFrame(frame, Moment{state, Instant{now_us}});
    frame.length_bytes = 8U;
    frame.identifier = 0x7E4U;
    slave.OnFrame(frame, Moment{state, Instant{now_us}});
    frame.identifier = 0x7E5U;
    frame.kind = FrameKind::kRemote;
    slave.OnFrame(frame, Moment{state, Instant{now_us}});
    EXPECT_TRUE(sink.frames.empty());
    // Unknown commands, and those of the configuration state while waiting
    for (std::uint32_t command = 0U; command < 256U; ++command)
    {
        const bool is_known = (command == 0x04U) || ((command >= 0x40U) && (command <= 0x43U)) ||
                              ((command >= 0x46U) && (command <= 0x4CU)) || (command == 0x51U);
        EXPECT_TRUE(is_known || Send({static_cast<std::uint8_t>(command)}).empty()) << command;
    }
    // and unknown ones in configuration
    for (std::uint32_t command = 0U; command < 256U; ++command)
    {
        EXPECT_TRUE(Send({0x04U, 1U}).empty());
        const bool is_known = (command == 0x04U) || (command == 0x11U) || (command == 0x13U) || (command == 0x15U) ||
                              (command == 0x17U) || ((command >= 0x40U) && (command <= 0x43U)) ||
                              ((command >= 0x46U) && (command <= 0x4CU)) || (command == 0x51U) ||
                              ((command >= 0x5AU) && (command <= 0x5EU));
        EXPECT_TRUE(is_known || Send({static_cast<std::uint8_t>(command)}).empty()) << command;
        EXPECT_EQ(slave.State(), LssState::kConfiguration) << command;
    }
    EXPECT_TRUE(Send({0x04U, 0U}).empty());
    // An answer without room is sent later
    sink.room = 0;
    EXPECT_TRUE(Send({0x4CU}).empty());
    sink.room = 9;
    EXPECT_EQ(Cycle(), Reply(0x50U));
    EXPECT_TRUE(Cycle().empty());
}

TEST_F(LssSlaveTest, AllSlavesSwitchTogether)
{
    Verifies(req::SRS_LSS_002);
    EXPECT_TRUE(Send({0x04U, 2U}).empty());
    EXPECT_EQ(slave.State(), LssState::kWaiting);
    EXPECT_TRUE(Send({0x04U, 1U}).empty());
    EXPECT_EQ(slave.State(), LssState::kConfiguration);
    EXPECT_TRUE(Send({0x04U, 2U}).empty());
    EXPECT_EQ(slave.State(), LssState::kConfiguration);
    EXPECT_TRUE(Send({0x04U, 0U}).empty());
    EXPECT_EQ(slave.State(), LssState::kWaiting);
}

TEST_F(LssSlaveTest, OneSlaveIsSelectedByItsWholeAddress)
{
    Verifies(req::SRS_LSS_003);
    EXPECT_TRUE(Send(0x40U, 0x00000123U).empty());
    EXPECT_TRUE(Send(0x41U, 0x80000001U).empty());
    EXPECT_TRUE(Send(0x42U, 0x00010002U).empty());
    EXPECT_EQ(Send(0x43U, 0xCAFE0007U), Reply(0x44U));
    EXPECT_EQ(slave.State(), LssState::kConfiguration);
    // Who is in configuration is not selected again, and a switch to waiting forgets what matched
    EXPECT_TRUE(Send(0x40U, 0x00000123U).empty());
    EXPECT_TRUE(Send(0x41U, 0x80000001U).empty());
    EXPECT_TRUE(Send(0x42U, 0x00010002U).empty());
    EXPECT_TRUE(Send(0x43U, 0xCAFE0007U).empty());
    EXPECT_TRUE(Send({0x04U, 0U}).empty());
    EXPECT_TRUE(Send(0x40U, 0x00000123U).empty());
    EXPECT_TRUE(Send(0x41U, 0x80000001U).empty());
    EXPECT_TRUE(Send(0x42U, 0x00010002U).empty());
    EXPECT_TRUE(Send({0x04U, 0U}).empty());
    EXPECT_TRUE(Send(0x43U, 0xCAFE0007U).empty());
    // A part that differs, is missing or comes in another order starts anew
    const std::uint32_t right[] = {0x00000123U, 0x80000001U, 0x00010002U, 0xCAFE0007U};
    for (std::uint8_t wrong = 0U; wrong < 4U; ++wrong)
    {
        static_cast<void>(Send({0x04U, 0U}));
        for (std::uint8_t part = 0U; part < 4U; ++part)
        {
            const std::uint32_t value = (part == wrong) ? (right[part] ^ 0x00010000U) : right[part];
            EXPECT_TRUE(Send(static_cast<std::uint8_t>(0x40U + part), value).empty());
        }
        EXPECT_EQ(slave.State(), LssState::kWaiting);
        for (std::uint8_t part = 0U; part < 4U; ++part)
        {
            if (part != wrong)
            {
                EXPECT_TRUE(Send(static_cast<std::uint8_t>(0x40U + part), right[part]).empty());
            }
        }
        EXPECT_EQ(slave.State(), LssState::kWaiting);
    }
}

TEST_F(LssSlaveTest, ANodeIdIsConfiguredAndBecomesActiveWithAReset)
{
    Verifies(req::SRS_LSS_004);
    Verifies(req::SRS_LSS_007);
    static_cast<void>(Send({0x04U, 1U}));
    for (const std::uint8_t wrong : Octets{0U, 128U, 200U, 254U})
    {
        EXPECT_EQ(Send({0x11U, wrong}), Reply(0x11U, 1U));
    }
    EXPECT_EQ(slave.Settings().node_id, 0xFFU);
    for (const std::uint8_t right : Octets{1U, 255U, 127U, 42U})
    {
        EXPECT_EQ(Send({0x11U, right}), Reply(0x11U));
        EXPECT_EQ(slave.Settings().node_id, right);
    }
    EXPECT_EQ(Send({0x5EU}), Reply(0x5EU, 0xFFU));
    EXPECT_EQ(slave.TakeNodeId().value, 42U);
    EXPECT_EQ(Send({0x5EU}).size(), 0U); // RESET COMMUNICATION with a node-ID: no LSS
    state = NodeState::kPreOperational;
    EXPECT_EQ(Send({0x5EU}), Reply(0x5EU, 42U));
    EXPECT_EQ(Send({0x11U, 43U}), Reply(0x11U));
    EXPECT_EQ(slave.ActiveNodeId(), 42U);
}

// t [ms]     0       10          20
//           15h     SwitchTo    sends again       delay 10 ms
TEST_F(LssSlaveTest, TheBitRateChangesInSilence)
{
    Verifies(req::SRS_LSS_005);
    static_cast<void>(Send({0x04U, 1U}));
    EXPECT_EQ(Send({0x13U, 1U, 3U}), Reply(0x13U, 1U)); // another table
    EXPECT_EQ(Send({0x13U, 0U, 5U}), Reply(0x13U, 1U)); // not supported
    EXPECT_EQ(slave.Settings().timing.index, 2U);
    EXPECT_EQ(Send({0x13U, 0U, 4U}), Reply(0x13U));
    EXPECT_EQ(slave.Settings().timing.index, 4U);
    EXPECT_FALSE(slave.IsSilent());
    EXPECT_TRUE(Send({0x15U, 10U, 0U}).empty());
    EXPECT_TRUE(slave.IsSilent());
    now_us += 9999U;
    static_cast<void>(Cycle());
    EXPECT_EQ(rate, -1);
    EXPECT_TRUE(Send({0x5EU}).empty());
    now_us += 1U;
    static_cast<void>(Cycle());
    EXPECT_EQ(rate, 4);
    now_us += 9999U;
    static_cast<void>(Cycle());
    EXPECT_TRUE(slave.IsSilent());
    now_us += 1U;
    EXPECT_TRUE(Cycle().empty()); // what was asked in between is not answered
    EXPECT_FALSE(slave.IsSilent());
    EXPECT_EQ(Send({0x5EU}), Reply(0x5EU, 0xFFU));
}

TEST_F(LssSlaveTest, AnAnswerThatWaitsForTheControllerWaitsForTheEndOfTheSilence)
{
    Verifies(req::SRS_LSS_005);
    static_cast<void>(Send({0x04U, 1U}));
    EXPECT_EQ(Send({0x13U, 0U, 4U}), Reply(0x13U));
    // Given an answer that found no room, and then the change of the bit rate
    sink.room = 0;
    EXPECT_TRUE(Send({0x5EU}).empty());
    EXPECT_TRUE(Send({0x15U, 10U, 0U}).empty());
    sink.room = 9;
    // When there is room again in the silence, before the switch and behind it, then nothing is sent
    EXPECT_TRUE(Cycle().empty());
    now_us += 10000U;
    EXPECT_TRUE(Cycle().empty());
    EXPECT_EQ(rate, 4);
    now_us += 9999U;
    EXPECT_TRUE(Cycle().empty());
    // and it is, once the device sends again
    now_us += 1U;
    EXPECT_EQ(Cycle(), Reply(0x5EU, 0xFFU));
}

TEST_F(LssSlaveTest, AStoredNodeIdOfZeroIsNone)
{
    Verifies(req::SRS_LSS_009);
    // Given settings with node-ID 0, and with 1 next to it
    LssSlave zero{LssParts{sink, *this, kIdentity, LssSettings{0U, {2U}}}};
    LssSlave one{LssParts{sink, *this, kIdentity, LssSettings{1U, {2U}}}};
    // When the device starts, then the first has no node-ID, and does not boot
    EXPECT_EQ(zero.TakeNodeId().value, 0xFFU);
    EXPECT_EQ(zero.ActiveNodeId(), 0xFFU);
    EXPECT_EQ(one.TakeNodeId().value, 1U);
}

// In OPERATIONAL the kernel sends SRDOs, which no silence of the services holds
TEST_F(LssSlaveTest, NoBitRateChangesInOperationalNorToOneThatIsNotSupported)
{
    Verifies(req::SRS_LSS_005);
    static_cast<void>(Send({0x04U, 1U}));
    state = NodeState::kOperational;
    EXPECT_TRUE(Send({0x15U, 10U, 0U}).empty());
    EXPECT_FALSE(slave.IsSilent());
    EXPECT_EQ(Send({0x5EU}), Reply(0x5EU, 0xFFU));
    // A start in the silence ends it: before the change there is none
    state = NodeState::kPreOperational;
    EXPECT_TRUE(Send({0x15U, 10U, 0U}).empty());
    EXPECT_TRUE(slave.IsSilent());
    state = NodeState::kOperational;
    now_us += 10000U;
    static_cast<void>(Cycle());
    EXPECT_FALSE(slave.IsSilent());
    EXPECT_EQ(rate, -1);
    // and behind the change the silence ends, too
    state = NodeState::kPreOperational;
    EXPECT_TRUE(Send({0x15U, 10U, 0U}).empty());
    now_us += 10000U;
    static_cast<void>(Cycle());
    EXPECT_EQ(rate, 2);
    EXPECT_TRUE(slave.IsSilent());
    state = NodeState::kOperational;
    now_us += 1U;
    static_cast<void>(Cycle());
    EXPECT_FALSE(slave.IsSilent());
    // The rate that was stored is none of this controller, and 13h gave no other one
    state = NodeState::kPreOperational;
    LssSlave other{LssParts{sink, *this, kIdentity, LssSettings{5U, {8U}}}};
    CanFrame frame{0x7E5U, FrameKind::kData, CanPortId::kFirst, 8U, {0x04U, 1U}};
    static_cast<void>(other.TakeNodeId());
    other.OnFrame(frame, Moment{state, Instant{now_us}});
    frame.data[0] = 0x15U;
    other.OnFrame(frame, Moment{state, Instant{now_us}});
    EXPECT_FALSE(other.IsSilent());
}

TEST_F(LssSlaveTest, StoreIsAnsweredWhenItHasEnded)
{
    Verifies(req::SRS_LSS_006);
    static_cast<void>(Send({0x04U, 1U}));
    static_cast<void>(Send({0x11U, 42U}));
    answer = LssStored::kPending;
    EXPECT_TRUE(Send({0x17U}).empty());
    EXPECT_TRUE(Cycle().empty());
    answer = LssStored::kDone;
    EXPECT_EQ(Cycle(), Reply(0x17U));
    EXPECT_EQ(stored.node_id, 42U);
    EXPECT_EQ(stored.timing.index, 2U);
    EXPECT_EQ(store_calls, 3);
    EXPECT_TRUE(Cycle().empty());
    answer = LssStored::kUnsupported;
    EXPECT_EQ(Send({0x17U}), Reply(0x17U, 1U));
    answer = LssStored::kFailed;
    EXPECT_EQ(Send({0x17U}), Reply(0x17U, 2U));
    answer = LssStored::kInvalid;
    EXPECT_EQ(Send({0x17U}), Reply(0x17U, 2U));
}

// 17h of 42, then 11h 43 alone; 17h again: both have one answer, when 43 is kept
TEST_F(LssSlaveTest, WhatIsStoredIsWhatWasConfiguredWhenTheLastStoreCame)
{
    Verifies(req::SRS_LSS_013);
    static_cast<void>(Send({0x04U, 1U}));
    static_cast<void>(Send({0x11U, 42U}));
    answer = LssStored::kPending;
    EXPECT_TRUE(Send({0x17U}).empty());
    EXPECT_EQ(Send({0x11U, 43U}), Reply(0x11U));
    EXPECT_TRUE(Cycle().empty());
    EXPECT_EQ(stored.node_id, 42U);
    EXPECT_TRUE(Send({0x17U}).empty());
    EXPECT_EQ(stored.node_id, 43U);
    answer = LssStored::kDone;
    EXPECT_EQ(Cycle(), Reply(0x17U));
    EXPECT_EQ(stored.node_id, 43U);
    EXPECT_TRUE(Cycle().empty());
}

TEST_F(LssSlaveTest, TheAddressIsInquired)
{
    Verifies(req::SRS_LSS_007);
    static_cast<void>(Send({0x04U, 1U}));
    EXPECT_EQ(Send({0x5AU}), (Octets{0x5AU, 0x23U, 0x01U, 0U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x5BU}), (Octets{0x5BU, 0x01U, 0U, 0U, 0x80U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x5CU}), (Octets{0x5CU, 0x02U, 0U, 0x01U, 0U, 0U, 0U, 0U}));
    EXPECT_EQ(Send({0x5DU}), (Octets{0x5DU, 0x07U, 0U, 0xFEU, 0xCAU, 0U, 0U, 0U}));
}

TEST_F(LssSlaveTest, RangesInAnotherOrderIdentifyNobody)
{
    Verifies(req::SRS_LSS_008);
    const std::uint32_t right[] = {0x123U, 0x80000001U, 0x00010002U, 0x00010002U, 0xCAFE0007U, 0xCAFE0007U};
    const auto send = [this, &right](const std::size_t part)
    { return Send(static_cast<std::uint8_t>(0x46U + part), right[part]); };
    // Given two neighbours that change places, or a part that is missing, then there is no answer
    for (std::size_t first = 0U; first < 5U; ++first)
    {
        std::vector<std::size_t> order{0U, 1U, 2U, 3U, 4U, 5U};
        std::swap(order[first], order[first + 1U]);
        for (const std::size_t part : order)
        {
            EXPECT_TRUE(send(part).empty()) << first;
        }
        for (std::size_t part = 0U; part < 6U; ++part)
        {
            EXPECT_TRUE((part == first) || send(part).empty()) << first;
        }
    }
    // In order there is one
    for (std::size_t part = 0U; part < 5U; ++part)
    {
        EXPECT_TRUE(send(part).empty());
    }
    EXPECT_EQ(send(5U), Reply(0x4FU));
}

TEST_F(LssSlaveTest, ARangeHoldsWhatLiesBetweenItsEnds)
{
    Verifies(req::SRS_LSS_008);
    // Given ranges around revision 00010002h and serial number CAFE0007h, wide ones among them
    struct Range
    {
        std::uint32_t revision_low;
        std::uint32_t revision_high;
        std::uint32_t serial_low;
        std::uint32_t serial_high;
    };
    for (const Range& range : {Range{0x00010001U, 0x00010003U, 0xCAFE0006U, 0xCAFE0008U},
                               Range{0x00000000U, 0xFFFFFFFFU, 0x00000000U, 0xFFFFFFFFU},
                               Range{0x00010002U, 0x7FFFFFFFU, 0x7FFFFFFFU, 0xCAFE0007U}})
    {
        const std::uint32_t parts[] = {0x123U,           0x80000001U,      range.revision_low, range.revision_high,
                                       range.serial_low, range.serial_high};
        for (std::uint8_t part = 0U; part < 5U; ++part)
        {
            EXPECT_TRUE(Send(static_cast<std::uint8_t>(0x46U + part), parts[part]).empty()) << int{part};
        }
        EXPECT_EQ(Send(0x4BU, range.serial_high), Reply(0x4FU)) << range.serial_high;
    }
}

TEST_F(LssSlaveTest, RangesIdentifyASlave)
{
    Verifies(req::SRS_LSS_008);
    const std::uint32_t inside[] = {0x123U, 0x80000001U, 0x00010002U, 0x00010002U, 0xCAFE0007U, 0xCAFE0007U};
    const std::uint32_t outside[] = {0x124U, 0x80000000U, 0x00010003U, 0x00010001U, 0xCAFE0008U, 0xCAFE0006U};
    for (std::uint8_t wrong = 0U; wrong <= 6U; ++wrong)
    {
        Octets last{};
        for (std::uint8_t part = 0U; part < 6U; ++part)
        {
            EXPECT_TRUE(last.empty());
            last = Send(static_cast<std::uint8_t>(0x46U + part), (part == wrong) ? outside[part] : inside[part]);
        }
        EXPECT_EQ(last, (wrong == 6U) ? Reply(0x4FU) : Octets{}) << int{wrong};
    }
    static_cast<void>(slave.TakeNodeId());
    static_cast<void>(Send({0x04U, 1U}));
    static_cast<void>(Send({0x11U, 42U}));
    static_cast<void>(slave.TakeNodeId());
    state = NodeState::kPreOperational;
    EXPECT_TRUE(Send({0x4CU}).empty()); // it has a node-ID
}

TEST_F(LssSlaveTest, WithoutANodeIdThereIsNoBootUpUntilLssHasGivenOne)
{
    Verifies(req::SRS_LSS_009);
    Verifies(req::SRS_NMT_009);
    NmtSlave nmt{NodeId{kNoNodeId}, StartUp{false, 0U}};
    for (int i = 0; i < 10; ++i)
    {
        nmt.SetNodeId(slave.TakeNodeId());
        EXPECT_FALSE(nmt.Advance().is_present);
    }
    EXPECT_EQ(nmt.State(), NodeState::kResetCommunication);
    EXPECT_FALSE(slave.MayBoot());
    static_cast<void>(Send({0x04U, 1U}));
    static_cast<void>(Send({0x11U, 42U}));
    EXPECT_FALSE(slave.MayBoot()); // still in configuration
    static_cast<void>(Send({0x04U, 0U}));
    EXPECT_TRUE(slave.MayBoot());
    nmt.SetNodeId(slave.TakeNodeId());
    const cia301::FrameToSend boot_up = nmt.Advance();
    EXPECT_TRUE(boot_up.is_present);
    EXPECT_EQ(boot_up.frame.identifier, 0x72AU);
    EXPECT_FALSE(slave.MayBoot());
    // 0 and 128 are none either
    for (const std::uint8_t none : Octets{0U, 128U})
    {
        NmtSlave other{NodeId{none}, StartUp{false, 0U}};
        static_cast<void>(other.Advance());
        static_cast<void>(other.Advance());
        EXPECT_FALSE(other.Advance().is_present);
    }
}

TEST_F(LssSlaveTest, AFastscanFindsTheAddressBitByBit)
{
    Verifies(req::SRS_LSS_010);
    EXPECT_EQ(Scan(0U, 0x80U, 0U, 0U), Reply(0x4FU));
    std::uint32_t found[4] = {};
    for (std::uint8_t part = 0U; part < 4U; ++part)
    {
        for (int bit = 31; bit >= 0; --bit)
        {
            if (Scan(found[part], static_cast<std::uint8_t>(bit), part, part).empty())
            {
                found[part] |= 1U << bit;
            }
        }
        // The confirmation goes on with the next part, after the last with the first
        EXPECT_EQ(Scan(found[part], 0U, part, static_cast<std::uint8_t>((part + 1U) % 4U)), Reply(0x4FU));
    }
    EXPECT_EQ(found[0], kIdentity.vendor);
    EXPECT_EQ(found[1], kIdentity.product);
    EXPECT_EQ(found[2], kIdentity.revision);
    EXPECT_EQ(found[3], kIdentity.serial);
    EXPECT_EQ(slave.State(), LssState::kConfiguration);
    EXPECT_TRUE(Scan(0U, 0x80U, 0U, 0U).empty()); // only while waiting
}

TEST_F(LssSlaveTest, AFastscanOfOtherSlavesIsNotAnswered)
{
    Verifies(req::SRS_LSS_010);
    EXPECT_EQ(Scan(0U, 0x80U, 0U, 0U), Reply(0x4FU));
    EXPECT_TRUE(Scan(0x123U, 0U, 1U, 1U).empty());  // another part is under scan
    EXPECT_TRUE(Scan(0x123U, 32U, 0U, 0U).empty()); // no bit
    EXPECT_TRUE(Scan(0x123U, 0U, 0U, 4U).empty());  // no part
    EXPECT_TRUE(Scan(0x123U, 0U, 4U, 0U).empty());  // no part either
    EXPECT_TRUE(Scan(0x122U, 0U, 0U, 0U).empty());
    EXPECT_EQ(Scan(0x122U, 1U, 0U, 0U), Reply(0x4FU));
    // With a node-ID there is none
    static_cast<void>(Send({0x04U, 1U}));
    static_cast<void>(Send({0x11U, 42U}));
    static_cast<void>(Send({0x04U, 0U}));
    static_cast<void>(slave.TakeNodeId());
    state = NodeState::kPreOperational;
    EXPECT_TRUE(Scan(0U, 0x80U, 0U, 0U).empty());
}

TEST_F(LssSlaveTest, TheStatesInWhichLssIsServed)
{
    Verifies(req::SRS_LSS_011);
    Verifies(req::SRS_NMT_010);
    const NodeState served[] = {NodeState::kPreOperational, NodeState::kOperational, NodeState::kStopped,
                                NodeState::kResetCommunication};
    const NodeState silent[] = {NodeState::kInvalid, NodeState::kInitialising, NodeState::kResetApplication};
    static_cast<void>(Send({0x04U, 1U}));
    for (const NodeState one : served)
    {
        state = one;
        EXPECT_EQ(Send({0x5EU}), Reply(0x5EU, 0xFFU));
    }
    for (const NodeState one : silent)
    {
        state = one;
        EXPECT_TRUE(Send({0x5EU}).empty());
    }
    EXPECT_EQ(Send({0x11U, 42U}).size(), 0U);
    state = NodeState::kPreOperational;
    EXPECT_EQ(Send({0x11U, 42U}), Reply(0x11U));
    static_cast<void>(slave.TakeNodeId());
    state = NodeState::kResetCommunication;
    EXPECT_TRUE(Send({0x5EU}).empty());
}

} // namespace
} // namespace counterpoint::cia305
