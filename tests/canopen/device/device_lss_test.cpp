// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/device/device_rig.hpp"
#include "verification/trace/ids/node.hpp"

namespace counterpoint::device
{
namespace
{

using cia301::NodeState;
using cia305::BitTiming;
using cia305::LssSettings;
using cia305::LssStored;

/// The rig's device with LSS, without a node-ID at first.
class DeviceLssTest : public DeviceRig, public cia305::LssDevice
{
  public:
    DeviceLssTest()
    {
        services.lss = &slave;
    }
    bool IsSupported(BitTiming /*timing*/) noexcept override
    {
        return true;
    }
    LssStored Store(const LssSettings& /*settings*/) noexcept override
    {
        return LssStored::kDone;
    }
    void SwitchTo(BitTiming /*timing*/) noexcept override
    {
    }
    void Lss(const Octets& command)
    {
        Octets bytes = command;
        bytes.resize(8U);
        Frame(0x7E5U, bytes);
        Cycle();
    }

    cia305::LssSlave slave{cia305::LssParts{services.outbox, *this, cia305::Identity{1U, 2U, 3U, 4U},
                                            LssSettings{cia305::kNoNodeId, BitTiming{2U}}}};
};

TEST_F(DeviceLssTest, WithoutANodeIdThereIsOnlyLss)
{
    Verifies(req::SRS_DEV_019);
    Start();
    Command(1U, 0U);
    Remote(0x702U);
    Frame(0x602U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycles(20U);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(node_resets, 1);
    EXPECT_EQ(communication_resets, 0);
    // When somebody looks for devices without a node-ID, it answers
    Lss({0x4CU});
    EXPECT_EQ(Sent(0x7E4U), (std::vector<Octets>{{0x50U, 0U, 0U, 0U, 0U, 0U, 0U, 0U}}));
    // When it gets one and is let go, it boots with it
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    EXPECT_TRUE(Sent(0x705U).empty());
    Lss({0x04U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x705U), (std::vector<Octets>{{0U}}));
    EXPECT_EQ(device.State(), NodeState::kPreOperational);
    EXPECT_EQ(communication_resets, 1);
    // And is a node like others
    Command(1U, 5U);
    Cycle();
    EXPECT_EQ(device.State(), NodeState::kOperational);
    Forget();
    Frame(0x605U, {0x40U, 0x00U, 0x10U, 0U, 0U, 0U, 0U, 0U});
    Cycle();
    EXPECT_EQ(Sent(0x585U), (std::vector<Octets>{{0x43U, 0x00U, 0x10U, 0U, 0x44U, 0x33U, 0x22U, 0x11U}}));
    EXPECT_EQ(dictionary.ReadNumber({0x1014U, 0U}).value, 0x85U);
}

TEST_F(DeviceLssTest, AnotherNodeIdHoldsFromTheNextResetOn)
{
    Verifies(req::SRS_DEV_019);
    Start();
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    Lss({0x04U, 0U});
    Cycle();
    EXPECT_EQ(dictionary.WriteNumber({0x1017U, 0U}, 5U, 2U), cia301::SdoAbort::kNone);
    Lss({0x04U, 1U});
    Lss({0x11U, 9U});
    Lss({0x04U, 0U});
    Forget();
    Cycles(10U);
    EXPECT_FALSE(Sent(0x705U).empty());
    EXPECT_TRUE(Sent(0x709U).empty());
    Command(130U, 5U);
    stored_heartbeat_ms = 5U;
    Forget();
    Cycles(10U);
    EXPECT_TRUE(Sent(0x705U).empty());
    ASSERT_GE(Sent(0x709U).size(), 2U);
    EXPECT_EQ(Sent(0x709U)[0], (Octets{0U}));
    // When the node-ID is taken away, the device falls silent at the next reset
    Lss({0x04U, 1U});
    Lss({0x11U, 0xFFU});
    Lss({0x04U, 0U});
    Command(130U, 9U);
    Cycle();
    Forget();
    Cycles(30U);
    EXPECT_TRUE(Sent(0x709U).empty());
    EXPECT_EQ(device.State(), NodeState::kResetCommunication);
}

TEST_F(DeviceLssTest, NothingIsSentWhileTheBitRateChanges)
{
    Verifies(req::SRS_DEV_019);
    stored_heartbeat_ms = 1U;
    Start();
    Lss({0x04U, 1U});
    Lss({0x11U, 5U});
    Lss({0x04U, 0U});
    Cycles(3U);
    Lss({0x04U, 1U});
    Lss({0x13U, 0U, 4U});
    Forget();
    Lss({0x15U, 10U, 0U}); // Activate after 10 ms, silent until 10 ms later.
    Forget();
    Cycles(15U);
    EXPECT_TRUE(Sent(0x705U).empty());
    Cycles(10U);
    EXPECT_FALSE(Sent(0x705U).empty());
}

} // namespace
} // namespace counterpoint::device
