// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the faults of the frames of a network make of them, for everybody and for one receiver alone.
#include "verification/campaign/campaign_rig.hpp"

#include "verification/campaign/managed/frame_fault.hpp"
#include "verification/campaign/managed/space.hpp"
#include "verification/campaign/managed/stage.hpp"
#include "verification/campaign/managed/watch.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
using managed::Fault;
using managed::Target;

/// Of the frames 101#10AA, 102#11AA, 101#12AA, 583#13AA, one a millisecond, what receivers 1 and 2 get when the first
/// one is hit: "after/identifier/length/first and second byte", the delay in us.
class FrameFaultTest : public ::testing::Test
{
  protected:
    struct Got
    {
        std::string first;
        std::string second;
    };
    [[nodiscard]] static Got Of(const Fault fault, const std::uint32_t variant,
                                const host::NodeIndex receiver = managed::kEverybody)
    {
        static const std::vector<std::uint32_t> kIdentifiers{0x101U, 0x102U, 0x583U};
        managed::FrameFault hit;
        managed::FrameHit what;
        what.fault = fault;
        what.variant = variant;
        what.start = 1'000'000;
        what.frame = Frame(0U);
        what.receiver = receiver;
        what.drawn = 0xBBCCU;
        hit.Arm(what, kIdentifiers);
        Got got;
        for (std::uint32_t number = 0U; number < 4U; ++number)
        {
            for (const host::NodeIndex node : {1U, 2U})
            {
                host::FrameOnBus sent{};
                sent.frame = Frame(number);
                sent.start = 1'000'000 * (std::int64_t{number} + 1);
                host::ReceptionList receptions;
                EXPECT_TRUE(receptions.Add({sent.frame, 0}));
                hit.OnReception(sent, node, receptions);
                ((node == 1U) ? got.first : got.second) += Text(receptions);
            }
        }
        return got;
    }

  private:
    [[nodiscard]] static CanFrame Frame(const std::uint32_t number)
    {
        constexpr std::uint32_t kSentAs[] = {0x101U, 0x102U, 0x101U, 0x583U};
        return CanFrame{kSentAs[number],
                        FrameKind::kData,
                        CanPortId::kFirst,
                        2U,
                        {static_cast<std::uint8_t>(0x10U + number), 0xAAU}};
    }
    [[nodiscard]] static std::string Text(host::ReceptionList& receptions)
    {
        std::ostringstream text;
        for (const host::Reception& each : receptions)
        {
            text << each.delay / 1000 << "/" << std::hex << each.frame.identifier << "/"
                 << unsigned{each.frame.length_bytes} << "/" << unsigned{each.frame.data[0]} << ","
                 << unsigned{each.frame.data[1]} << ((each.frame.kind == FrameKind::kRemote) ? "r" : "") << std::dec
                 << " ";
        }
        return text.str();
    }
};

constexpr const char* kAll = "0/101/2/10,aa 0/102/2/11,aa 0/101/2/12,aa 0/583/2/13,aa ";
constexpr const char* kOthers = "0/102/2/11,aa 0/101/2/12,aa 0/583/2/13,aa ";

TEST_F(FrameFaultTest, OneReceiverAloneIsHitOrEverybody)
{
    Verifies(req::SRS_CMG_071);
    EXPECT_EQ(Of(Fault::kLost, 0U).first, kOthers);
    EXPECT_EQ(Of(Fault::kLost, 0U).second, kOthers);
    EXPECT_EQ(Of(Fault::kLost, 0U, 2U).first, kAll);
    EXPECT_EQ(Of(Fault::kLost, 0U, 2U).second, kOthers);
    EXPECT_EQ(Of(Fault::kCorrupted, 0U, 1U).first, std::string("0/101/2/11,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kCorrupted, 0U, 1U).second, kAll);
}

TEST_F(FrameFaultTest, LossesAreOneToFourInARowAllOfAnIdentifierAndAll)
{
    Verifies(req::SRS_CMG_071);
    EXPECT_EQ(Of(Fault::kLost, 1U).first, "0/101/2/12,aa 0/583/2/13,aa ");
    EXPECT_EQ(Of(Fault::kLost, 2U).first, "0/583/2/13,aa ");
    EXPECT_EQ(Of(Fault::kLost, 3U).first, "");
    EXPECT_EQ(Of(Fault::kLost, 4U).first, "0/102/2/11,aa 0/583/2/13,aa ");
    EXPECT_EQ(Of(Fault::kLost, 5U).first, "");
}

TEST_F(FrameFaultTest, MovedFramesAreLaterOnAGridOf50Microseconds)
{
    Verifies(req::SRS_CMG_071);
    EXPECT_EQ(Of(Fault::kRepeated, 0U).first, std::string("0/101/2/10,aa 50/101/2/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kRepeated, 19U).first, std::string("0/101/2/10,aa 1000/101/2/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kDelayed, 2U).first, std::string("150/101/2/10,aa ") + kOthers);
    // Drawn: BBCCh, low byte first
    EXPECT_EQ(Of(Fault::kInserted, 1U).first, std::string("0/101/2/10,aa 100/101/2/cc,bb ") + kOthers);
    // Behind each of the next ones; the fifth is not there
    EXPECT_EQ(Of(Fault::kWrongOrder, 0U).first, "0/102/2/11,aa 0/101/2/10,aa 0/101/2/12,aa 0/583/2/13,aa ");
    EXPECT_EQ(Of(Fault::kWrongOrder, 2U).first, "0/102/2/11,aa 0/101/2/12,aa 0/583/2/13,aa 0/101/2/10,aa ");
    EXPECT_EQ(Of(Fault::kWrongOrder, 3U).first, kOthers);
}

TEST_F(FrameFaultTest, ContentLengthAndIdentifierAreWrongInEachWay)
{
    Verifies(req::SRS_CMG_071);
    // Bit 7 of the first byte, bit 0 of the second; byte 0 xor 01h and FFh, byte 1 xor 01h
    EXPECT_EQ(Of(Fault::kCorrupted, 7U).first, std::string("0/101/2/90,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kCorrupted, 8U).first, std::string("0/101/2/10,ab ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongByte, 0U).first, std::string("0/101/2/11,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongByte, 254U).first, std::string("0/101/2/ef,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongByte, 255U).first, std::string("0/101/2/10,ab ") + kOthers);
    // Lengths 0, 1, 3 to 8
    EXPECT_EQ(Of(Fault::kWrongLength, 0U).first, std::string("0/101/0/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongLength, 1U).first, std::string("0/101/1/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongLength, 2U).first, std::string("0/101/3/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongLength, 7U).first, std::string("0/101/8/10,aa ") + kOthers);
    // Each bit of 11, a remote frame, then each other identifier of the run
    EXPECT_EQ(Of(Fault::kWrongIdentifier, 0U).first, std::string("0/100/2/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongIdentifier, 10U).first, std::string("0/501/2/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongIdentifier, 11U).first, std::string("0/101/2/10,aar ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongIdentifier, 12U).first, std::string("0/102/2/10,aa ") + kOthers);
    EXPECT_EQ(Of(Fault::kWrongIdentifier, 13U).first, std::string("0/583/2/10,aa ") + kOthers);
}

class ServicesOfFramesTest : public CampaignTest
{
};

TEST_F(ServicesOfFramesTest, AreThoseOfTheirIdentifiers)
{
    Verifies(req::SRS_CMG_071);
    // Given the start of a network whose managers negotiate, what it sends then, and a GFC
    static_cast<void>(File("gfc.yaml", "extends: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/flying.yaml\n"
                                       "gfc: [{at: 1450 ms, node: sensor}]\n"));
    const managed::Plan plan = managed::ReadManagedPlan(
        File("plan.yaml", "title: A test\nnetwork: gfc.yaml\nfrom: 100 ms\nuntil: 1500 ms\nkinds: [lost]\n"));
    managed::Stage stage(plan);
    managed::Watch watch(stage, plan);
    stage.World().RunUntil(1'600'000'000);
    const managed::Reference reference = watch.TakeReference();
    const managed::Space space(plan, stage, reference);
    const std::map<Target, std::function<bool(std::uint32_t)>> services{
        {Target::kNmt, [](const std::uint32_t id) { return id == 0U; }},
        {Target::kElection, [](const std::uint32_t id) { return id >= 0x71U && id <= 0x76U; }},
        {Target::kSdo, [](const std::uint32_t id) { return id >= 0x581U && id <= 0x67FU; }},
        {Target::kLife, [](const std::uint32_t id) { return id >= 0x701U && id <= 0x77FU; }},
        {Target::kSrdo, [](const std::uint32_t id) { return id >= 0x101U && id <= 0x180U; }},
        {Target::kOther, [](const std::uint32_t id) { return id == 1U; }}};
    // When each frame is hit, then it is one of its service, none of those is one of the others, and it is sent between
    // the two instants
    std::map<Target, std::uint64_t> count;
    for (std::uint64_t number = 0U; number < space.Size(); ++number)
    {
        const managed::Trial trial = space.At(number);
        ++count[trial.target];
        for (const auto& [target, is_one] : services)
        {
            ASSERT_EQ(is_one(trial.hit.frame.identifier), target == trial.target)
                << std::hex << trial.hit.frame.identifier;
        }
        ASSERT_TRUE(trial.hit.start >= 100'000'000 && trial.hit.start < 1'500'000'000) << trial.hit.start;
    }
    EXPECT_GT(reference.frames.size(), 0U);
    EXPECT_LT(reference.frames.front().start, 100'000'000);
    EXPECT_GE(reference.frames.back().start, 1'500'000'000);
    for (const auto& [target, is_one] : services)
    {
        EXPECT_GT(count[target], 0U) << static_cast<int>(target);
    }
}
} // namespace
} // namespace counterpoint::campaign::test
