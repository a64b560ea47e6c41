// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/flying_master/states.hpp"
#include "tests/canopen/cia302/state_chart.hpp"
#include "verification/trace/ids/flying_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

const std::string kDocument = std::string{COUNTERPOINT_SOURCE_FOLDER} + "/docs/charts/flying_master.md";

const std::vector<Named<FlyingState>> kStates{
    {FlyingState::kInitialising, "kInitialising"},
    {FlyingState::kDelay, "kDelay"},
    {FlyingState::kDetect, "kDetect"},
    {FlyingState::kRace, "kRace"},
    {FlyingState::kForcing, "kForcing"},
    {FlyingState::kResetting, "kResetting"},
    {FlyingState::kSlave, "kSlave"},
    {FlyingState::kHalted, "kHalted"},
    {FlyingState::kMaster, "kMaster"},
};

const std::vector<Named<FlyingInput>> kInputs{
    {FlyingInput::kStart, "start"},        {FlyingInput::kSent, "sent"},          {FlyingInput::kRestart, "restart"},
    {FlyingInput::kResetAll, "reset all"}, {FlyingInput::kRaceAnew, "race anew"}, {FlyingInput::kJoin, "join"},
    {FlyingInput::kForce, "force"},        {FlyingInput::kFollow, "follow"},      {FlyingInput::kReset, "reset"},
    {FlyingInput::kSameNode, "same node"},
};

std::string WaitOf(const FlyingState state)
{
    const char* const kWaits[]{
        "",          "the application",         "1F90h:02", "071h for 1F90h:01", "the own slot", "the queue",
        "the queue", "a failure of the master", "a reset"};
    return (state == FlyingState::kMaster) ? "another master" : kWaits[static_cast<std::size_t>(state)];
}

TEST(FlyingStates, DocumentShowsTheTable)
{
    Verifies(req::SRS_FLY_031);
    ExpectShown(StateChart{kStates, kInputs, Next}.Lines(WaitOf), kDocument);
}

TEST(FlyingStates, EachIsReachedAndLeft)
{
    Verifies(req::SRS_FLY_031);
    StateChart{kStates, kInputs, Next}.ExpectConnected();
    EXPECT_EQ(kInputs.size() + 1U, kFlyingInputs);
}

TEST(FlyingStates, NobodyIsMasterButAfterARace)
{
    Verifies(req::SRS_FLY_031);
    for (const Named<FlyingState>& state : kStates)
    {
        EXPECT_EQ(Next(state.value, FlyingInput::kNone), state.value) << state.name;
        EXPECT_EQ(Next(state.value, FlyingInput::kReset), FlyingState::kInitialising) << state.name;
        for (const Named<FlyingInput>& input : kInputs)
        {
            const bool is_end_of_race = (state.value == FlyingState::kRace) && (input.value == FlyingInput::kSent);
            const bool was_master = (state.value == FlyingState::kMaster);
            const bool is_master = (Next(state.value, input.value) == FlyingState::kMaster);
            EXPECT_TRUE(!is_master || was_master || is_end_of_race) << state.name << ", " << input.name;
        }
    }
}

TEST(FlyingStates, ValueThatIsNoneWaitsForAReset)
{
    Verifies(req::SRS_FLY_031);
    EXPECT_EQ(Next(FlyingState::kInvalid, FlyingInput::kSent), FlyingState::kInvalid);
    EXPECT_EQ(Next(FlyingState{0x95U}, FlyingInput::kStart), FlyingState{0x95U});
    EXPECT_EQ(Next(FlyingState{0x95U}, FlyingInput::kReset), FlyingState::kInitialising);
    EXPECT_EQ(Next(FlyingState::kRace, FlyingInput{11U}), FlyingState::kRace);
}

} // namespace
} // namespace counterpoint::cia302
