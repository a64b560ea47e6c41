// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/kernel/flow_monitor.hpp"

#include "verification/trace/ids/kernel.hpp"
#include "verification/trace/verifies.hpp"

#include <cstdint>

namespace counterpoint
{
namespace
{

constexpr FlowEvidence kRight{7U, 7U};
constexpr hal::WatchdogQuestion kQuestion{0x00C0FFEEU};
// (5EC0DE27h + 00C0FFEEh) * 01000193h modulo 2^32, worked out by hand: 5F81DE15h * 01000193h.
constexpr std::uint32_t kRightAnswer = static_cast<std::uint32_t>(0x5F81DE15ULL * 0x01000193ULL);

void MarkAll(FlowMonitor& flow)
{
    for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
    {
        flow.Mark(static_cast<FlowStep>(step), kRight);
    }
}

TEST(FlowMonitor, UndisturbedCycleAnswersRight)
{
    Verifies(req::SRS_FLOW_001);
    Verifies(req::SRS_FLOW_002);
    FlowMonitor flow{};
    for (std::uint32_t cycle = 0U; cycle < 3U; ++cycle)
    {
        flow.Begin();
        MarkAll(flow);
        EXPECT_EQ(flow.End(kQuestion).value, kRightAnswer);
        EXPECT_EQ(flow.Finding(), DeviceFault::kNone);
    }
}

TEST(FlowMonitor, ZeroFilledMonitorHasFoundAFault)
{
    Verifies(req::SRS_FLOW_003);
    const FlowMonitor flow{};
    EXPECT_EQ(flow.Finding(), DeviceFault::kFlow);
}

TEST(FlowMonitor, EachSkippedStepSpoilsTheAnswer)
{
    Verifies(req::SRS_FLOW_001);
    Verifies(req::SRS_FLOW_003);
    for (std::uint8_t skipped = 1U; skipped <= kFlowStepCount; ++skipped)
    {
        FlowMonitor flow{};
        flow.Begin();
        for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
        {
            if (step != skipped)
            {
                flow.Mark(static_cast<FlowStep>(step), kRight);
            }
        }
        EXPECT_NE(flow.End(kQuestion).value, kRightAnswer) << "step " << static_cast<int>(skipped);
        EXPECT_EQ(flow.Finding(), DeviceFault::kFlow) << "step " << static_cast<int>(skipped);
    }
}

TEST(FlowMonitor, EachDoubledOrSwappedStepSpoilsTheAnswer)
{
    Verifies(req::SRS_FLOW_001);
    for (std::uint8_t chosen = 1U; chosen <= kFlowStepCount; ++chosen)
    {
        FlowMonitor doubled{};
        doubled.Begin();
        FlowMonitor swapped{};
        swapped.Begin();
        for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
        {
            doubled.Mark(static_cast<FlowStep>(step), kRight);
            if (step == chosen)
            {
                doubled.Mark(static_cast<FlowStep>(step), kRight);
            }
            const std::uint8_t other = static_cast<std::uint8_t>((chosen % kFlowStepCount) + 1U);
            const std::uint8_t shown = (step == chosen) ? other : ((step == other) ? chosen : step);
            swapped.Mark(static_cast<FlowStep>(shown), kRight);
        }
        EXPECT_NE(doubled.End(kQuestion).value, kRightAnswer) << "step " << static_cast<int>(chosen);
        EXPECT_NE(swapped.End(kQuestion).value, kRightAnswer) << "step " << static_cast<int>(chosen);
    }
}

TEST(FlowMonitor, WrongEvidenceOfAnyStepSpoilsTheAnswer)
{
    Verifies(req::SRS_FLOW_001);
    for (std::uint8_t chosen = 1U; chosen <= kFlowStepCount; ++chosen)
    {
        FlowMonitor flow{};
        flow.Begin();
        for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
        {
            flow.Mark(static_cast<FlowStep>(step), (step == chosen) ? FlowEvidence{8U, 7U} : kRight);
        }
        EXPECT_NE(flow.End(kQuestion).value, kRightAnswer) << "step " << static_cast<int>(chosen);
    }
}

TEST(FlowMonitor, WrongEvidenceInAnyBitOfAnyStepSpoilsTheAnswer)
{
    Verifies(req::SRS_FLOW_001);
    Verifies(req::SRS_FLOW_003);
    for (std::uint32_t chosen = 0U; chosen < (32U * kFlowStepCount); ++chosen)
    {
        FlowMonitor flow{};
        flow.Begin();
        for (std::uint8_t step = 1U; step <= kFlowStepCount; ++step)
        {
            const bool is_chosen = (step - 1U) == (chosen / 32U);
            flow.Mark(static_cast<FlowStep>(step), is_chosen ? FlowEvidence{1U << (chosen % 32U), 0U} : kRight);
        }
        EXPECT_NE(flow.End(kQuestion).value, kRightAnswer) << chosen;
        EXPECT_EQ(flow.Finding(), DeviceFault::kFlow) << chosen;
    }
}

TEST(FlowMonitor, MissingBeginAndOldAnswerAreWrong)
{
    Verifies(req::SRS_FLOW_001);
    Verifies(req::SRS_FLOW_002);
    FlowMonitor flow{};
    flow.Begin();
    MarkAll(flow);
    const std::uint32_t first = flow.End(kQuestion).value;
    // When the next cycle does not begin, its signature goes on from the last one
    MarkAll(flow);
    EXPECT_NE(flow.End(kQuestion).value, kRightAnswer);
    // And the answer to one question never fits the next
    flow.Begin();
    MarkAll(flow);
    EXPECT_NE(flow.End(hal::WatchdogQuestion{0x00C0FFEFU}).value, first);
}

TEST(FlowMonitor, AnswerOfAWrongSignatureIsThatOfTheFormulaToo)
{
    Verifies(req::SRS_FLOW_002);
    FlowMonitor flow{};
    flow.Begin();
    for (std::uint8_t step = 1U; step < kFlowStepCount; ++step)
    {
        flow.Mark(static_cast<FlowStep>(step), kRight);
    }
    // Given one too many in the last step: 5EC0DE27h + 9E3779B9h, worked out by hand
    flow.Mark(static_cast<FlowStep>(kFlowStepCount), FlowEvidence{8U, 7U});
    EXPECT_EQ(flow.End(kQuestion).value, static_cast<std::uint32_t>(0xFDB957CEULL * 0x01000193ULL));
    EXPECT_EQ(flow.End(hal::WatchdogQuestion{0U}).value, static_cast<std::uint32_t>(0xFCF857E0ULL * 0x01000193ULL));
    EXPECT_EQ(flow.Finding(), DeviceFault::kFlow);
}

} // namespace
} // namespace counterpoint
