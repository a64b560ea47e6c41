// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/states.hpp"
#include "tests/canopen/cia302/state_chart.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

const std::string kDocument = std::string{COUNTERPOINT_SOURCE_FOLDER} + "/docs/charts/el6751.md";

const std::vector<Named<El6751Phase>> kStates{
    {El6751Phase::kOutside, "kOutside"},
    {El6751Phase::kResetting, "kResetting"},
    {El6751Phase::kRows, "kRows"},
    {El6751Phase::kVerify, "kVerify"},
    {El6751Phase::kStarting, "kStarting"},
    {El6751Phase::kRunning, "kRunning"},
    {El6751Phase::kHeld, "kHeld"},
    {El6751Phase::kFailed, "kFailed"},
    {El6751Phase::kDeactivated, "kDeactivated"},
    {El6751Phase::kStoppingToReset, "kStoppingToReset"},
    {El6751Phase::kStoppingHeld, "kStoppingHeld"},
    {El6751Phase::kStoppingFailed, "kStoppingFailed"},
    {El6751Phase::kStoppingForGood, "kStoppingForGood"},
};

const std::vector<Named<El6751Event>> kEvents{
    {El6751Event::kBegin, "begin"},   {El6751Event::kReset, "reset"},     {El6751Event::kFail, "fail"},
    {El6751Event::kVerify, "verify"}, {El6751Event::kStart, "start"},     {El6751Event::kRun, "run"},
    {El6751Event::kHold, "hold"},     {El6751Event::kRestart, "restart"}, {El6751Event::kDeactivate, "deactivate"},
    {El6751Event::kRefuse, "refuse"}, {El6751Event::kStopped, "stopped"},
};

std::string WaitOf(const El6751Phase phase)
{
    const char* const kWaits[]{"",          "the queue", "answers to SDOs", "the gate",
                               "the queue", "errors",    "a hand",          "a hand or a boot-up message",
                               "a hand",    "the queue", "the queue",       "the queue",
                               "the queue"};
    return kWaits[static_cast<std::size_t>(phase)];
}

TEST(El6751States, DocumentShowsTheTable)
{
    Verifies(req::SRS_ELM_052);
    const auto next = [](const El6751Phase state, const El6751Event event) { return Next(state, event); };
    ExpectShown(StateChart{kStates, kEvents, next}.Lines(WaitOf), kDocument);
}

TEST(El6751States, EachIsReachedAndLeft)
{
    Verifies(req::SRS_ELM_052);
    const auto next = [](const El6751Phase state, const El6751Event event) { return Next(state, event); };
    StateChart{kStates, kEvents, next}.ExpectConnected();
    EXPECT_EQ(kStates.size(), kEl6751Phases);
    EXPECT_EQ(kEvents.size() + 1U, kEl6751Events);
}

TEST(El6751States, RunsByAStartThatWasSentAlone)
{
    Verifies(req::SRS_ELM_052);
    for (const Named<El6751Phase>& state : kStates)
    {
        EXPECT_EQ(Next(state.value, El6751Event::kNone), state.value) << state.name;
        for (const Named<El6751Event>& event : kEvents)
        {
            const bool is_start = (state.value == El6751Phase::kStarting) && (event.value == El6751Event::kRun);
            const bool runs = (Next(state.value, event.value) == El6751Phase::kRunning);
            EXPECT_TRUE(!runs || is_start || (state.value == El6751Phase::kRunning))
                << state.name << ", " << event.name;
        }
    }
    EXPECT_TRUE(IsStopping(El6751Phase::kStoppingHeld));
    EXPECT_FALSE(IsStopping(El6751Phase::kHeld));
}

TEST(El6751States, ValueThatIsNoneIsOutside)
{
    Verifies(req::SRS_ELM_052);
    EXPECT_EQ(Next(El6751Phase{13U}, El6751Event::kRun), El6751Phase::kOutside);
    EXPECT_EQ(Next(El6751Phase::kRunning, El6751Event{12U}), El6751Phase::kRunning);
}

} // namespace
} // namespace counterpoint::cia302
