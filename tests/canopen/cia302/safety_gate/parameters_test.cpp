// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What 13FFh does not cover: the gate in front of a real kernel device that tells 5F01h to 5F05h as the test wants.
#include "tests/canopen/cia302/safety_gate/rig.hpp"
#include "verification/trace/ids/manager.hpp"

#include <map>

namespace counterpoint::cia302
{
namespace
{

constexpr NodeId kOfParameters{2U};
constexpr std::uint8_t kFourBytes = 0x43U; ///< Expedited, 4 bytes.
constexpr std::uint8_t kOneByte = 0x4FU;   ///< Expedited, 1 byte.

class ParameterTest : public GateRig
{
  protected:
    void SetUp() override
    {
        Start();
        Cycle();
        on_request = [this](CanFrame& request) { return !IsOfParameter(request); };
    }
    /// The configuration of the device, and this behind it.
    void ExpectAlso(const std::vector<ExpectedObject>& more)
    {
        std::vector<ExpectedObject> list = Configuration();
        list.insert(list.end(), more.begin(), more.end());
        Expect(list);
    }
    GateState Verified()
    {
        asked.clear();
        gate.Verify(kOfParameters, Instant{now_us});
        Finish();
        return gate.State(kOfParameters);
    }
    GateState Written()
    {
        asked.clear();
        EXPECT_TRUE(gate.Write(kOfParameters, Instant{now_us}));
        Finish();
        return gate.State(kOfParameters);
    }
    void Tell(const std::uint16_t index, const std::uint8_t sub, const std::vector<std::uint8_t>& bytes)
    {
        told[(std::uint32_t{index} << 8U) | sub] = bytes;
    }

    std::map<std::uint32_t, std::vector<std::uint8_t>> told{};
    std::vector<std::uint32_t> asked{};
    bool was_written{false};

  private:
    void Answer(const std::vector<std::uint8_t>& bytes)
    {
        CanFrame frame{0x582U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
        std::copy(bytes.begin(), bytes.end(), frame.data);
        pool.OnFrame(frame, Instant{now_us});
    }
    bool IsOfParameter(const CanFrame& request)
    {
        const auto low = static_cast<std::uint8_t>(request.data[1]);
        const bool is_segment = (request.data[0] == 0x60U) || (request.data[0] == 0x70U);
        const bool is_parameter = !is_segment && (request.data[2] == 0x5FU);
        if (is_segment)
        {
            AnswerSegment(request.data[0] == 0x70U);
        }
        else if (is_parameter && (request.data[0] == 0x40U))
        {
            const std::uint32_t object = 0x5F0000U | (std::uint32_t{low} << 8U) | request.data[3];
            asked.push_back(object);
            Begin(low, request.data[3], told[object]);
        }
        else
        {
            was_written = was_written || is_parameter;
        }
        return is_segment || is_parameter;
    }
    void Begin(const std::uint8_t low, const std::uint8_t sub, const std::vector<std::uint8_t>& bytes)
    {
        std::vector<std::uint8_t> answer{0x80U, low, 0x5FU, sub, 0x00U, 0x00U, 0x02U, 0x06U}; // No such object.
        if (bytes.size() == 8U)
        {
            rest_ = bytes;
            answer = {0x41U, low, 0x5FU, sub, 8U, 0U, 0U, 0U};
        }
        else if (!bytes.empty())
        {
            answer = {(bytes.size() == 1U) ? kOneByte : kFourBytes, low, 0x5FU, sub};
            answer.insert(answer.end(), bytes.begin(), bytes.end());
        }
        else
        {
            // It has none.
        }
        Answer(answer);
    }
    /// Seven bytes, then the last one.
    void AnswerSegment(const bool is_second)
    {
        std::vector<std::uint8_t> answer{0x00U};
        answer.insert(answer.end(), rest_.begin(), rest_.begin() + 7);
        const std::vector<std::uint8_t> last{0x1DU, rest_[7]};
        Answer(is_second ? last : answer);
    }

    std::vector<std::uint8_t> rest_{};
};

TEST_F(ParameterTest, TheDeviceDigestIsReadBehindTheSignatures)
{
    Verifies(req::SRS_SFS_670);
    ExpectAlso({{{0x5F04U, 0U}, 0xBEE7CE1CU, true}});
    Tell(0x5F04U, 0U, {0x1CU, 0xCEU, 0xE7U, 0xBEU});
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(asked, std::vector<std::uint32_t>{0x5F0400U});
    EXPECT_TRUE(gate.MayStart(kOfParameters));
    // Given a device with the same 1300h to 13FFh that was built from another DCF
    Tell(0x5F04U, 0U, {0x1DU, 0xCEU, 0xE7U, 0xBEU});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F04U);
    EXPECT_EQ(gate.Finding(kOfParameters).object.sub, 0U);
    EXPECT_EQ(gate.Finding(kOfParameters).expected, 0xBEE7CE1CU);
    EXPECT_EQ(gate.Finding(kOfParameters).read, 0xBEE7CE1DU);
    EXPECT_EQ(gate.Finding(kOfParameters).abort, SdoAbort::kNone);
    EXPECT_FALSE(gate.MayStart(kOfParameters));
    EXPECT_FALSE(gate.IsOther(kOfParameters));
    // Or one that expects no digest, or has no such object
    Tell(0x5F04U, 0U, {0U, 0U, 0U, 0U});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    Tell(0x5F04U, 0U, {});
    EXPECT_EQ(Verified(), GateState::kFailed);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F04U);
    EXPECT_EQ(gate.Finding(kOfParameters).abort, SdoAbort::kObjectUnknown);
    EXPECT_FALSE(gate.MayStart(kOfParameters));
}

TEST_F(ParameterTest, OfAnSrdoPolicySafeValueAndDetectionAreComparedInTheirLengths)
{
    Verifies(req::SRS_SFS_670);
    ExpectAlso(
        {{{0x5F01U, 1U}, 0x00U, true}, {{0x5F02U, 1U}, 0x8000000000000102U, true}, {{0x5F05U, 1U}, 0x3CU, true}});
    const std::vector<std::uint8_t> safe{0x02U, 0x01U, 0U, 0U, 0U, 0U, 0U, 0x80U};
    Tell(0x5F01U, 1U, {0x00U});
    Tell(0x5F02U, 1U, safe);
    Tell(0x5F05U, 1U, {0x3CU});
    EXPECT_EQ(Verified(), GateState::kOpen);
    EXPECT_EQ(asked, (std::vector<std::uint32_t>{0x5F0101U, 0x5F0201U, 0x5F0501U}));
    // Given each of them with another value
    Tell(0x5F05U, 1U, {0x00U});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F05U);
    Tell(0x5F02U, 1U, {0x02U, 0x01U, 0U, 0U, 0U, 0U, 0U, 0x00U});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F02U);
    EXPECT_EQ(gate.Finding(kOfParameters).expected, 0x8000000000000102U);
    EXPECT_EQ(gate.Finding(kOfParameters).read, 0x0000000000000102U);
    Tell(0x5F01U, 1U, {0x5AU});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F01U);
    EXPECT_EQ(gate.Finding(kOfParameters).object.sub, 1U);
    EXPECT_EQ(gate.Finding(kOfParameters).read, 0x5AU);
    // And the number in another length
    Tell(0x5F01U, 1U, {0U, 0U, 0U, 0U});
    EXPECT_EQ(Verified(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).abort, SdoAbort::kLengthMismatch);
}

TEST_F(ParameterTest, NoneIsEverWritten)
{
    Verifies(req::SRS_SFS_671);
    ExpectAlso({{{0x5F04U, 0U}, 0xBEE7CE1CU, true}});
    Tell(0x5F04U, 0U, {0x1CU, 0xCEU, 0xE7U, 0xBEU});
    EXPECT_EQ(Written(), GateState::kOpen);
    EXPECT_EQ(asked, std::vector<std::uint32_t>{0x5F0400U});
    EXPECT_EQ(Has(0x13FEU, 0U), 0xA5U);
    // A device that differs in it is not declared valid
    Tell(0x5F04U, 0U, {0U, 0U, 0U, 0U});
    EXPECT_EQ(Written(), GateState::kDiffers);
    EXPECT_EQ(gate.Finding(kOfParameters).object.index, 0x5F04U);
    EXPECT_EQ(Has(0x13FEU, 0U), 0U);
    EXPECT_FALSE(was_written);
}

TEST_F(ParameterTest, WhatAnExpectationMayHoldOfThem)
{
    Verifies(req::SRS_SFS_007);
    struct Case
    {
        ExpectedObject object;
        std::uint8_t size;
        bool is_usable;
    };
    const Case cases[] = {
        {{{0x5F00U, 1U}, 0U, true}, 0U, false},         {{{0x5F01U, 0U}, 0U, true}, 0U, false},
        {{{0x5F01U, 1U}, 0xFFU, true}, 1U, true},       {{{0x5F01U, 1U}, 0x100U, true}, 1U, false},
        {{{0x5F01U, 64U}, 0U, true}, 1U, true},         {{{0x5F01U, 65U}, 0U, true}, 0U, false},
        {{{0x5F02U, 1U}, ~0ULL, true}, 8U, true},       {{{0x5F02U, 0U}, 0U, true}, 0U, false},
        {{{0x5F02U, 65U}, 0U, true}, 0U, false},        {{{0x5F03U, 1U}, 0U, true}, 0U, false},
        {{{0x5F04U, 0U}, 0xFFFFFFFFU, true}, 4U, true}, {{{0x5F04U, 0U}, 0x100000000U, true}, 4U, false},
        {{{0x5F04U, 0U}, 1U, false}, 4U, false},        {{{0x5F04U, 1U}, 1U, true}, 0U, false},
        {{{0x5F05U, 64U}, 0x3CU, true}, 1U, true},      {{{0x5F05U, 1U}, 0x3CU, false}, 1U, false},
        {{{0x5F06U, 0U}, 0U, true}, 0U, false},         {{{0x1400U, 1U}, 0U, true}, 0U, false},
    };
    for (const Case& one : cases)
    {
        EXPECT_EQ(SizeOf(one.object.address), one.size) << std::hex << one.object.address.index;
        ExpectAlso({one.object});
        EXPECT_EQ(IsUsable(expectation), one.is_usable)
            << std::hex << one.object.address.index << ':' << int{one.object.address.sub} << '=' << one.object.value;
    }
    // It makes no SRDO
    Expect({ExpectedObject{{0x5F04U, 0U}, 1U, true}});
    EXPECT_FALSE(IsUsable(expectation));
}

} // namespace
} // namespace counterpoint::cia302
