// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Channel B alone: what each call signals.
#include "tests/channel_b/rig.hpp"
#include "verification/trace/ids/channel.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>
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

TEST(ChannelBSignals, SrvtStaysOverHoweverLateTheInverseFrame)
{
    Verifies(req::SRS_TIME_001);
    Verifies(req::SRS_TIME_006);
    // Given late detection and a normal frame whose SRVT of 20 ms is over in the last of 25 calls
    const auto rig = std::make_unique<Rig>(ReleasePolicy::kAutomatic);
    rig->Setup(0U).detection = SrvtDetection::kLate;
    rig->Start();
    static_cast<void>(rig->Enter());
    rig->Normal(0U, 1U);
    for (std::uint32_t call = 0U; call < 25U; ++call)
    {
        EXPECT_EQ(rig->Cycle().signalled, 0U) << call;
    }
    // when its inverse frame comes 2^30 us after the last call, which was at FFFF6982h, and no call in between
    rig->Voice().OnFrame(Rig::Frame(0x102U, ~std::uint64_t{1U}, 8U), Instant{0x3FFF6982U});
    // then it is too late
    EXPECT_EQ(rig->Voice().View(0U).first_cause, SrdoCause::kSrvt);
    EXPECT_EQ(rig->Voice().View(0U).holds_pair, 0U);
}

TEST(ChannelBSignals, RefreshIsDueHoweverLateTheCall)
{
    Verifies(req::SRS_PROD_001);
    Verifies(req::SRS_PROD_002);
    // Given a provider that may send 500 us after OPERATIONAL, when the next call comes 2^32 - 2^27 us after 499 us
    const auto rig = std::make_unique<Rig>();
    rig->Setup(1U).form = ProducerForm::kProviderCalled;
    rig->Start();
    EXPECT_EQ(rig->Enter().due, 0U);
    EXPECT_EQ(rig->Cycle(0xF80001F3U).due, 2U);
}

} // namespace
} // namespace counterpoint
