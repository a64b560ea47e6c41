// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: what each call signals.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace counterpoint
{
namespace
{

constexpr std::uint32_t kNormalTwiceBit = 8U;

TEST(ChannelBSignals, EveryFaultIsSignalledByTheCallThatReportsIt)
{
    Verifies(req::SRS_CONS_021);
    static_assert((1U << static_cast<std::uint32_t>(SrdoCause::kNormalTwice)) == kNormalTwiceBit, "bit of the cause");
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    for (std::uint32_t fault = 1U; fault <= 3U; ++fault)
    {
        // When the same fault comes again within SCT, then it is signalled again, by the call that reports it
        rig->Normal(0U, 1U);
        rig->Normal(0U, 1U);
        EXPECT_EQ(rig->Voice().View(0U).signals, 0U) << fault;
        const CycleOutcome outcome = rig->Cycle();
        EXPECT_EQ(outcome.signalled, 1U) << fault;
        EXPECT_EQ(outcome.new_fault, 1U) << fault;
        EXPECT_EQ(rig->Voice().View(0U).signals, kNormalTwiceBit) << fault;
        EXPECT_EQ(rig->Voice().View(0U).error_count, fault);
        // and the next call signals nothing.
        EXPECT_EQ(rig->Cycle().signalled, 0U) << fault;
        EXPECT_EQ(rig->Voice().View(0U).signals, 0U) << fault;
    }
}

TEST(ChannelBSignals, FaultsOfAProducerAreSignalledEachTime)
{
    Verifies(req::SRS_PROD_009);
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    for (std::uint32_t fault = 1U; fault <= 3U; ++fault)
    {
        // When two transmissions in a row fail, each within the refresh time of the other
        rig->Request();
        EXPECT_EQ(rig->Cycle().due, 2U) << fault;
        EXPECT_EQ(rig->Voice().Prepare(1U).status, PrepareStatus::kReady) << fault;
        rig->Voice().OnTransmitFault(1U, TransmitFault{SrdoCause::kBusOff});
        EXPECT_EQ(rig->Cycle().signalled, 2U) << fault;
        EXPECT_EQ(rig->Voice().View(1U).signals, 1U << static_cast<std::uint32_t>(SrdoCause::kBusOff)) << fault;
        EXPECT_EQ(rig->Voice().View(1U).first_cause, SrdoCause::kBusOff) << fault;
    }
}

TEST(ChannelBSignals, WaitingPastSctIsSignalledOnce)
{
    Verifies(req::SRS_CONS_022);
    // Given two consumers without a pair, when SCT of 50 ms goes by again and again
    const auto rig = std::make_unique<Rig>();
    rig->Start();
    static_cast<void>(rig->Enter());
    std::uint32_t first = 0U;
    std::uint32_t signals = 0U;
    for (std::uint32_t call = 1U; call <= 200U; ++call)
    {
        const CycleOutcome outcome = rig->Cycle();
        if ((outcome.signalled & 5U) != 0U)
        {
            first = (first == 0U) ? call : first;
            ++signals;
            EXPECT_EQ(outcome.signalled & 5U, 5U);
            EXPECT_EQ(outcome.new_fault, 0U);
            EXPECT_EQ(rig->Voice().View(0U).signals, 1U << static_cast<std::uint32_t>(SrdoCause::kWaitingPastSct));
        }
    }
    // then it is told once, by the first call past it
    EXPECT_EQ(first, 51U);
    EXPECT_EQ(signals, 1U);
    EXPECT_EQ(rig->Voice().View(0U).error_count, 0U);
}

} // namespace
} // namespace counterpoint
