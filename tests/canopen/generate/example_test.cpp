// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/generated_actuator/run.hpp"
#include "examples/host/run.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::examples
{
namespace
{

TEST(GeneratedExample, DoesWhatTheOneWrittenByHandDoes)
{
    Verifies(req::SRS_GEN_009);
    Verifies(req::SRS_GEN_011);
    Verifies(req::SRS_GEN_008);
    EXPECT_EQ(RunGeneratedActuator(),
              "1018h:02 3, SCT 50 ms, heartbeat 100 ms, then 250 ms, and 250 ms in the dictionary\n" + RunActuator());
}

} // namespace
} // namespace counterpoint::examples
