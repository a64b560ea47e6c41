// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: when there is an inverse frame, and what it holds.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace counterpoint
{
namespace
{

void ExpectFrame(const CanFrame& frame, const std::vector<std::uint8_t>& data, std::uint32_t identifier)
{
    EXPECT_EQ(frame.identifier, identifier);
    EXPECT_EQ(frame.kind, FrameKind::kData);
    EXPECT_EQ(frame.port, CanPortId::kSecond);
    EXPECT_EQ(frame.length_bytes, data.size());
    for (std::size_t at = 0U; at < 8U; ++at)
    {
        EXPECT_EQ(frame.data[at], (at < data.size()) ? data[at] : 0U) << at;
    }
}

void ExpectNoFrame(const CanFrame& frame)
{
    EXPECT_EQ(frame.identifier, 0U);
    EXPECT_EQ(frame.kind, FrameKind::kInvalid);
    EXPECT_EQ(frame.port, CanPortId::kInvalid);
    EXPECT_EQ(frame.length_bytes, 0U);
    for (const std::uint8_t byte : frame.data)
    {
        EXPECT_EQ(byte, 0U);
    }
}

/// The normal frame of the producer, prepared; inverse frames leave through the second controller.
CanFrame Prepared(Rig& rig)
{
    rig.Request();
    EXPECT_EQ(rig.Cycle().due, 2U);
    const PreparedPair pair = rig.Voice().Prepare(1U);
    EXPECT_EQ(pair.status, PrepareStatus::kReady);
    return pair.normal;
}

TEST(ChannelBInverseFrame, IsThereWhileItIsAwaited)
{
    Verifies(req::SRS_PROD_006);
    const auto rig = std::make_unique<Rig>();
    rig->Config().inverse_port = CanPortId::kSecond;
    rig->Start();
    rig->Put(6U, 0x44332211U);
    rig->Put(7U, 0x88776655U);
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    static_cast<void>(rig->Enter());
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    // Given a pair in flight, when its normal frame was not confirmed, then there is none
    const CanFrame normal = Prepared(*rig);
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    // when it was, then there is one as often as it is asked for, of what was read before
    rig->Confirm(normal);
    rig->Put(6U, 0U);
    const std::vector<std::uint8_t> data = {0x11U, 0x22U, 0x33U, 0x44U, 0x55U, 0x66U, 0x77U, 0x88U};
    for (std::uint32_t call = 0U; call < 3U; ++call)
    {
        ExpectFrame(rig->Voice().InverseFrame(1U), data, 0x104U);
        EXPECT_EQ(rig->Cycle().due, 0U);
    }
    ExpectNoFrame(rig->Voice().InverseFrame(0U));
    // and none once the pair is over
    const CanFrame inverse = rig->Voice().InverseFrame(1U);
    rig->Confirm(inverse);
    EXPECT_EQ(rig->Voice().View(1U).ordinal, 1U);
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
}

TEST(ChannelBInverseFrame, EndsWithAFaultAndWithOperational)
{
    Verifies(req::SRS_PROD_006);
    Verifies(req::SRS_PROD_011);
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Confirm(Prepared(*rig));
    EXPECT_EQ(rig->Voice().InverseFrame(1U).identifier, 0x104U);
    rig->Voice().OnTransmitFault(1U, TransmitFault{SrdoCause::kTransmitQueue});
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    rig->Confirm(Prepared(*rig));
    EXPECT_EQ(rig->Voice().InverseFrame(1U).identifier, 0x104U);
    // No confirmation for more than SRVT of 20 ms.
    EXPECT_EQ(rig->Cycle(20011U).signalled & 2U, 2U);
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    rig->Confirm(Prepared(*rig));
    EXPECT_EQ(rig->Voice().InverseFrame(1U).identifier, 0x104U);
    static_cast<void>(rig->Leave());
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
    static_cast<void>(rig->Enter());
    ExpectNoFrame(rig->Voice().InverseFrame(1U));
}

TEST(ChannelBInverseFrame, HasOnesAboveTheMappedLength)
{
    Verifies(req::SRS_PROD_006);
    Verifies(req::SRS_CFG_036);
    // Given a producer of 12 bits, whose inverse object reads ABCh with bits above
    const auto rig = std::make_unique<Rig>();
    rig->Config().inverse_port = CanPortId::kSecond;
    rig->Config().granularity_bits = 1U;
    rig->SetFree(12U, MapAccess::kProducer);
    rig->Start();
    ASSERT_EQ(rig->Map(1U, {0x6300010CU, 0x6301010CU}), ConfigFault::kNone);
    rig->Put(11U, 0x5ABCU);
    static_cast<void>(rig->Enter());
    const CanFrame normal = Prepared(*rig);
    EXPECT_EQ(normal.data[0U], 0x43U);
    EXPECT_EQ(normal.data[1U], 0x05U);
    rig->Confirm(normal);
    ExpectFrame(rig->Voice().InverseFrame(1U), {0xBCU, 0xFAU}, 0x104U);
}

} // namespace
} // namespace counterpoint
