// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device whose bus is that of a server, which ends and is started again.
#include "tests/hal/host/live_server_rig.hpp"
#include "tests/runtime/node/process.hpp"
#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/verifies.hpp"

#include <memory>

namespace counterpoint::tools::test
{
namespace
{
/// More than the release of a pair takes, less than a person would wait.
constexpr int kQuietMs = 700;

// Given an actuator behind a server, and an output that a person released, when the server ends, then the output
// closes; when the server is there again, the device takes part again without having been restarted, and neither that
// nor a start opens the output, only a person does.
TEST(NodeLostBusTest, ALostServerThatComesBackOpensNothing)
{
    Verifies(req::SRS_LIVE_058);
    Verifies(req::SRS_NODE_020);
    auto server = std::make_unique<host::RunningServer>(OwnBus());
    const std::uint16_t port = server->Port();
    const auto controller = StartNode("emergency_stop/controller.dcf", {});
    const auto actuator = StartNode("emergency_stop/actuator.dcf", {}, server->Address("can0"));
    controller->Type("nmt start");
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    actuator->Type("ack 1");
    ASSERT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    server.reset();
    EXPECT_FALSE(actuator->WaitFor(Event("output", "open", false)).event.is_null());
    actuator->Type("ack 1");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    server = std::make_unique<host::RunningServer>(OwnBus(), port);
    EXPECT_FALSE(actuator->WaitFor(Event("bus", "state", "active")).event.is_null());
    actuator->Type("nmt start");
    EXPECT_FALSE(actuator->Tells(Event("output", "open", true), kQuietMs));
    actuator->Type("state");
    EXPECT_EQ(actuator->WaitFor("state").event["device_fault"], "none");
    actuator->Type("ack 1");
    EXPECT_TRUE(actuator->Tells(Event("output", "open", true), 2000));
    actuator->Type("quit");
    EXPECT_EQ(actuator->End(), 0);
    controller->Type("quit");
    EXPECT_EQ(controller->End(), 0);
}
} // namespace
} // namespace counterpoint::tools::test
