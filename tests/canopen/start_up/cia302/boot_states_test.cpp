// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/boot_states.hpp"
#include "tests/canopen/cia302/state_chart.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

const std::string kDocument = std::string{COUNTERPOINT_SOURCE_FOLDER} + "/docs/charts/boot_slave.md";

const std::vector<Named<BootState>> kStates{
    {BootState::kIdle, "kIdle"},
    {BootState::kResetDue, "kResetDue"},
    {BootState::kResetSent, "kResetSent"},
    {BootState::kUnheard, "kUnheard"},
    {BootState::kTypeFirst, "kTypeFirst"},
    {BootState::kTypeAgain, "kTypeAgain"},
    {BootState::kType, "kType"},
    {BootState::kTypePause, "kTypePause"},
    {BootState::kVendorId, "kVendorId"},
    {BootState::kProductCode, "kProductCode"},
    {BootState::kRevisionNumber, "kRevisionNumber"},
    {BootState::kSerialNumber, "kSerialNumber"},
    {BootState::kStateAsk, "kStateAsk"},
    {BootState::kStateSign, "kStateSign"},
    {BootState::kStateReset, "kStateReset"},
    {BootState::kSoftwareId, "kSoftwareId"},
    {BootState::kSoftwareDate, "kSoftwareDate"},
    {BootState::kSoftwareTime, "kSoftwareTime"},
    {BootState::kProgramStop, "kProgramStop"},
    {BootState::kProgramClear, "kProgramClear"},
    {BootState::kClearCheck, "kClearCheck"},
    {BootState::kClearPause, "kClearPause"},
    {BootState::kLoadBlocks, "kLoadBlocks"},
    {BootState::kLoadSegments, "kLoadSegments"},
    {BootState::kProgramCheck, "kProgramCheck"},
    {BootState::kProgramPause, "kProgramPause"},
    {BootState::kProgramStart, "kProgramStart"},
    {BootState::kProgramStarted, "kProgramStarted"},
    {BootState::kConfigurationDate, "kConfigurationDate"},
    {BootState::kConfigurationTime, "kConfigurationTime"},
    {BootState::kRestore, "kRestore"},
    {BootState::kRestoreReset, "kRestoreReset"},
    {BootState::kRestored, "kRestored"},
    {BootState::kText, "kText"},
    {BootState::kConcise, "kConcise"},
    {BootState::kWatch, "kWatch"},
    {BootState::kWatched, "kWatched"},
    {BootState::kGate, "kGate"},
    {BootState::kGateBusy, "kGateBusy"},
    {BootState::kGateClosed, "kGateClosed"},
    {BootState::kStart, "kStart"},
};

/// Of one state each.
const std::vector<Named<BootEvent>> kFindings{
    {BootEvent::kDone, "done"},      {BootEvent::kSkip, "skip"},       {BootEvent::kElse, "else"},
    {BootEvent::kBootUp, "boot-up"}, {BootEvent::kSilence, "silence"},
};

/// Of all states.
const std::vector<Named<BootEvent>> kOrders{
    {BootEvent::kBegin, "begin"},         {BootEvent::kBeginUnasked, "begin unasked"},
    {BootEvent::kAwait, "await"},         {BootEvent::kReset, "reset"},
    {BootEvent::kConfigure, "configure"}, {BootEvent::kVerify, "verify"},
    {BootEvent::kFinished, "finished"},   {BootEvent::kFailed, "failed"},
    {BootEvent::kGivenUp, "given up"},
};

std::string WaitOf(const BootState state)
{
    const char* const kWaits[]{"", "queue", "answer", "time", "sign", "boot-up", "gate", "next call"};
    return kWaits[static_cast<std::size_t>(RowOf(state).wait)];
}

TEST(BootStates, DocumentShowsTheTable)
{
    Verifies(req::SRS_BOOT_024);
    ExpectShown(StateChart{kStates, kFindings, Next}.Lines(WaitOf), kDocument);
}

TEST(BootStates, EachIsReachedAndLeft)
{
    Verifies(req::SRS_BOOT_024);
    std::vector<Named<BootEvent>> events = kFindings;
    events.insert(events.end(), kOrders.begin(), kOrders.end());
    StateChart{kStates, events, Next}.ExpectConnected();
    EXPECT_EQ(kStates.size(), kBootStates);
    EXPECT_EQ(events.size() + 1U, kBootEvents);
}

TEST(BootStates, OrderLeadsToOneStateFromEverywhere)
{
    Verifies(req::SRS_BOOT_024);
    for (const Named<BootState>& state : kStates)
    {
        EXPECT_EQ(Next(state.value, BootEvent::kNone), state.value) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kBegin), BootState::kTypeFirst) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kBeginUnasked), BootState::kWatch) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kAwait), BootState::kResetSent) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kReset), BootState::kResetDue) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kConfigure), BootState::kRestore) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kVerify), BootState::kGate) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kFinished), BootState::kIdle) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kFailed), BootState::kIdle) << state.name;
        EXPECT_EQ(Next(state.value, BootEvent::kGivenUp), BootState::kIdle) << state.name;
    }
}

TEST(BootStates, ValueThatIsNoneIsIdle)
{
    Verifies(req::SRS_BOOT_024);
    EXPECT_EQ(Next(BootState{0x7FU}, BootEvent::kDone), BootState::kIdle);
    EXPECT_EQ(Next(BootState::kType, BootEvent{0x7FU}), BootState::kType); // What is no event changes nothing.
    EXPECT_EQ(RowOf(BootState{41U}).state, BootState::kIdle);
    EXPECT_EQ(RowOf(BootState::kStart).step, StartUpStep::kStart);
}

} // namespace
} // namespace counterpoint::cia302
