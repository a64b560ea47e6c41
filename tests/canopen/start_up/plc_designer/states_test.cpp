// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/plc_designer/states.hpp"
#include "tests/canopen/cia302/state_chart.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

const std::string kDocument = std::string{COUNTERPOINT_SOURCE_FOLDER} + "/docs/charts/plc_designer.md";

const std::vector<Named<std::int16_t>> kStates{
    {kPlcOutside, "kPlcOutside"}, {kPlcReset, "kPlcReset"},   {kPlcBootUp, "kPlcBootUp"},
    {kPlcSettles, "kPlcSettles"}, {kPlcSdos, "kPlcSdos"},     {kPlcConfigured, "kPlcConfigured"},
    {kPlcStarted, "kPlcStarted"}, {kPlcAbsent, "kPlcAbsent"}, {kPlcWrongType, "kPlcWrongType"},
    {kPlcLost, "kPlcLost"},
};

const std::vector<Named<PlcEvent>> kEvents{
    {PlcEvent::kBegin, "begin"},
    {PlcEvent::kResetSent, "reset sent"},
    {PlcEvent::kSettle, "settle"},
    {PlcEvent::kTimeOver, "time over"},
    {PlcEvent::kAnswered, "answered"},
    {PlcEvent::kOther, "other"},
    {PlcEvent::kSilence, "silence"},
    {PlcEvent::kStarted, "started"},
    {PlcEvent::kStartAgain, "start again"},
    {PlcEvent::kHold, "hold"},
    {PlcEvent::kLost, "lost"},
};

std::string WaitOf(const std::int16_t state)
{
    return "nStatus " + std::to_string(state);
}

TEST(PlcStates, DocumentShowsTheTable)
{
    Verifies(req::SRS_PLC_022);
    const auto next = [](const std::int16_t state, const PlcEvent event) { return Next(state, event); };
    ExpectShown(StateChart{kStates, kEvents, next}.Lines(WaitOf), kDocument);
}

TEST(PlcStates, EachIsReachedAndLeft)
{
    Verifies(req::SRS_PLC_022);
    const auto next = [](const std::int16_t state, const PlcEvent event) { return Next(state, event); };
    StateChart{kStates, kEvents, next}.ExpectConnected();
    EXPECT_EQ(kEvents.size() + 1U, kPlcEvents);
}

TEST(PlcStates, StartedFromConfiguredAlone)
{
    Verifies(req::SRS_PLC_022);
    for (const Named<std::int16_t>& state : kStates)
    {
        EXPECT_EQ(Next(state.value, PlcEvent::kNone), state.value) << state.name;
        for (const Named<PlcEvent>& event : kEvents)
        {
            const bool is_start = (state.value == kPlcConfigured) && (event.value == PlcEvent::kStarted);
            const bool runs = (Next(state.value, event.value) == kPlcStarted);
            EXPECT_TRUE(!runs || is_start || (state.value == kPlcStarted)) << state.name << ", " << event.name;
        }
    }
}

TEST(PlcStates, ValueThatIsNoneStays)
{
    Verifies(req::SRS_PLC_022);
    EXPECT_EQ(Next(std::int16_t{50}, PlcEvent::kBegin), 50);
    EXPECT_EQ(Next(kPlcStarted, PlcEvent{12U}), kPlcStarted);
}

} // namespace
} // namespace counterpoint::cia302
