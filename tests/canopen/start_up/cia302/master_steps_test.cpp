// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/cia302/master_steps.hpp"
#include "tests/canopen/cia302/state_chart.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::cia302
{
namespace
{

const std::string kDocument = std::string{COUNTERPOINT_SOURCE_FOLDER} + "/docs/charts/master.md";

const std::vector<Named<MasterStep>> kSteps{
    {MasterStep::kIdle, "kIdle"},       {MasterStep::kReset, "kReset"}, {MasterStep::kBooting, "kBooting"},
    {MasterStep::kHalted, "kHalted"},   {MasterStep::kReady, "kReady"}, {MasterStep::kOperational, "kOperational"},
    {MasterStep::kStopped, "kStopped"},
};

const std::vector<Named<MasterEvent>> kEvents{
    {MasterEvent::kReset, "reset"},   {MasterEvent::kBoot, "boot"},   {MasterEvent::kFailed, "failed"},
    {MasterEvent::kBooted, "booted"}, {MasterEvent::kAgain, "again"}, {MasterEvent::kStart, "start"},
    {MasterEvent::kLeave, "leave"},   {MasterEvent::kStop, "stop"},   {MasterEvent::kEnd, "end"},
};

MasterStep After(const MasterStep step, const MasterEvent event)
{
    return Next(step, event);
}

std::string NumberOf(const MasterStep step)
{
    return std::to_string(static_cast<int>(step));
}

TEST(MasterSteps, DocumentShowsTheTable)
{
    Verifies(req::SRS_BOOT_025);
    ExpectShown(StateChart{kSteps, kEvents, After}.Lines(NumberOf), kDocument);
}

TEST(MasterSteps, EachIsReachedAndLeft)
{
    Verifies(req::SRS_BOOT_025);
    StateChart{kSteps, kEvents, After}.ExpectConnected();
    EXPECT_EQ(kSteps.size(), kMasterSteps);
    EXPECT_EQ(kEvents.size() + 1U, kMasterEvents);
}

TEST(MasterSteps, EndIsIdleAndNothingStays)
{
    Verifies(req::SRS_BOOT_025);
    for (const Named<MasterStep>& step : kSteps)
    {
        EXPECT_EQ(Next(step.value, MasterEvent::kEnd), MasterStep::kIdle) << step.name;
        EXPECT_EQ(Next(step.value, MasterEvent::kNone), step.value) << step.name;
    }
    EXPECT_EQ(Next(MasterStep{7}, MasterEvent::kStart), MasterStep{7});
}

} // namespace
} // namespace counterpoint::cia302
