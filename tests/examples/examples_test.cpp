// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/host/bench.hpp"
#include "examples/host/run.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/verification.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::examples
{
namespace
{

TEST(Examples, SensorSendsWhatItsContactsSayAndNothingWhileTheyContradict)
{
    Verifies(req::SRS_VER_018);
    // Given a sensor whose button 1 is pressed from 200 to 300 ms and whose button 2 has a broken contact from 500 to
    // 600 ms When it runs for a second Then the controller gets four pairs in 100 ms, with the values of the buttons,
    // and none with a broken contact (cause not_inverse)
    EXPECT_EQ(RunSensor(), " 100 ms pairs 4, buttons 1 1\n"
                           " 200 ms pairs 8, buttons 1 1\n"
                           " 300 ms pairs 12, buttons 0 1\n"
                           " 400 ms pairs 16, buttons 1 1\n"
                           " 500 ms pairs 20, buttons 1 1\n"
                           " 600 ms pairs 20, buttons 1 1, cause not_inverse\n"
                           " 700 ms pairs 24, buttons 1 1\n"
                           " 800 ms pairs 28, buttons 1 1\n"
                           " 900 ms pairs 32, buttons 1 1\n"
                           "1000 ms pairs 36, buttons 1 1\n"
                           "running, wrong pairs 0\n");
}

TEST(Examples, ActuatorMovesOnlyWithPairsCommandsAndAnAcknowledgement)
{
    Verifies(req::SRS_VER_018);
    // Given commands every 25 ms that stop from 300 to 400 ms and stay away from 500 to 600 ms
    // When a person acknowledges at 150 and at 750 ms
    // Then the drive moves from the first acknowledgement, stops for the command, stops for SCT and waits for the
    // person
    EXPECT_EQ(RunActuator(), "   1 ms off, gate closed, drive stands\n"
                             "  10 ms waiting, gate closed, drive stands\n"
                             " 151 ms released, gate open, drive moves\n"
                             " 300 ms released, gate open, drive stands\n"
                             " 400 ms released, gate open, drive moves\n"
                             " 525 ms faulted, gate closed, drive stands\n"
                             " 751 ms released, gate open, drive moves\n"
                             "running\n");
}

TEST(Examples, ControllerOfTwoCpusSendsUntilTheWireIsCut)
{
    Verifies(req::SRS_VER_018);
    // Given two CPUs with one channel each, a button that is pressed from 300 to 400 ms
    // When the wire between them is cut at 600 ms
    // Then both are in the device safe state (13: cross link) within the time-out of 10 ms, and no wrong pair was sent
    EXPECT_EQ(RunController(),
              "   1 ms CPU A running, CPU B running, buttons off, commands 0 0\n"
              "  50 ms CPU A running, CPU B running, buttons faulted, commands 0 0\n"
              "  51 ms CPU A running, CPU B running, buttons waiting, commands 0 0\n"
              "  75 ms CPU A running, CPU B running, buttons faulted, commands 0 0\n"
              "  76 ms CPU A running, CPU B running, buttons released, commands 0 0\n"
              "  78 ms CPU A running, CPU B running, buttons released, commands 1 1\n"
              " 303 ms CPU A running, CPU B running, buttons released, commands 0 1\n"
              " 403 ms CPU A running, CPU B running, buttons released, commands 1 1\n"
              " 609 ms CPU A running, CPU B device fault cross_link, buttons released, commands 1 1\n"
              " 610 ms CPU A device fault cross_link, CPU B device fault cross_link, buttons faulted, commands 1 1\n"
              "pairs 22, wrong pairs 0\n");
}

TEST(Examples, ADeviceThatDoesNotStartSaysWhy)
{
    Verifies(req::SRS_EASE_007);
    EXPECT_EQ(RefusalOf(StartResult::kTiming, AbortCode::kNone), "start refused: timing, A time outside its range.\n");
    EXPECT_EQ(RefusalOf(StartResult::kStarted, static_cast<AbortCode>(0x06040043U)),
              "configuration refused, abort code 06040043\n");
}

} // namespace
} // namespace counterpoint::examples
