// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Lines that are orders of a manager, and those that are none; answers to orders that it cannot carry out.
#include "runtime/manager/order.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

namespace counterpoint::tools
{
namespace
{
using runtime::ManagerOrderKind;
using runtime::ParseManagerOrder;
using test::Lines;

using ManagerOrderCarriedTest = test::ManagerRig;

TEST(ManagerOrderTest, OrdersAreReadStrictly)
{
    Verifies(req::SRS_MGR_006);
    Verifies(req::SRS_MGR_134);
    Verifies(req::SRS_MGR_135);
    EXPECT_EQ(ParseManagerOrder("start 33").command, cia302::NmtCommand::kStart);
    EXPECT_EQ(ParseManagerOrder("start 33").node, 33U);
    EXPECT_EQ(ParseManagerOrder("reset-comm all").node, 0U);
    EXPECT_EQ(ParseManagerOrder("boot 5").kind, ManagerOrderKind::kBoot);
    EXPECT_EQ(ParseManagerOrder("write-safety 5 # now").kind, ManagerOrderKind::kWriteSafety);
    EXPECT_EQ(ParseManagerOrder("  ").kind, ManagerOrderKind::kNothing);
    EXPECT_EQ(ParseManagerOrder("boot all").problem, "boot: 'all', expected a node-ID from 1 to 127");
    EXPECT_EQ(ParseManagerOrder("stop").problem, "stop: no node, expected a node-ID from 1 to 127, or all");
    EXPECT_EQ(ParseManagerOrder("stop 128").problem, "stop: '128', expected a node-ID from 1 to 127, or all");
    EXPECT_EQ(ParseManagerOrder("stop 010").problem, "stop: '010', expected a node-ID from 1 to 127, or all");
    for (const char* const number : {"1.5", "-1", "1e1", "5x", "0x", "0x80", "0"})
    {
        EXPECT_EQ(ParseManagerOrder(std::string("stop ") + number).problem,
                  std::string("stop: '") + number + "', expected a node-ID from 1 to 127, or all");
    }
    EXPECT_EQ(ParseManagerOrder("stop 0x0A").node, 10U);
    EXPECT_EQ(ParseManagerOrder("fly").problem,
              "order 'fly', expected status, start, stop, preop, reset, reset-comm, "
              "boot, write-safety, control, output, get, set, negotiate, help or quit");
}

TEST(ManagerOrderTest, EachWordIsAnOrderOfItsKind)
{
    Verifies(req::SRS_MGR_006);
    const std::pair<const char*, ManagerOrderKind> kinds[] = {{"status", ManagerOrderKind::kStatus},
                                                              {"start 5", ManagerOrderKind::kCommand},
                                                              {"boot 5", ManagerOrderKind::kBoot},
                                                              {"write-safety 5", ManagerOrderKind::kWriteSafety},
                                                              {"control 5 6 0", ManagerOrderKind::kControl},
                                                              {"output 5 1 01 FF", ManagerOrderKind::kOutput},
                                                              {"get 0x1F80:00", ManagerOrderKind::kGet},
                                                              {"set 0x1F90:03 1", ManagerOrderKind::kSet},
                                                              {"negotiate", ManagerOrderKind::kNegotiate},
                                                              {"help", ManagerOrderKind::kHelp},
                                                              {"quit", ManagerOrderKind::kQuit},
                                                              {"# quit", ManagerOrderKind::kNothing}};
    for (const auto& [line, kind] : kinds)
    {
        EXPECT_EQ(ParseManagerOrder(line).kind, kind) << line;
    }
    EXPECT_EQ(ParseManagerOrder("status now").problem, "status: too many words, expected it alone");
    EXPECT_EQ(ParseManagerOrder("status # now").kind, ManagerOrderKind::kStatus);
    EXPECT_EQ(ParseManagerOrder("stop 5 6").problem, "stop: too many words, expected a node-ID from 1 to 127, or all");
    EXPECT_EQ(ParseManagerOrder("boot 5 6").problem, "boot: too many words, expected a node-ID from 1 to 127");
    // A line of 1024 bytes may be one, a longer one is none
    EXPECT_EQ(ParseManagerOrder("quit" + std::string(1020U, ' ')).kind, ManagerOrderKind::kQuit);
    EXPECT_EQ(ParseManagerOrder("quit" + std::string(1021U, ' ')).problem,
              "an order of more than 1024 bytes, expected at most so many in one line");
}

TEST(ManagerOrderTest, EachNumberOfAnOrderIsInItsRange)
{
    Verifies(req::SRS_MGR_134);
    const std::string expected = ", expected a node-ID from 1 to 127, ADS state and device state from 0 to 65535";
    const runtime::ManagerOrder control = ParseManagerOrder("control 127 65535 0xFFFF");
    EXPECT_EQ(control.node, 127U);
    EXPECT_EQ(control.ads_state, 0xFFFFU);
    EXPECT_EQ(control.device_state, 0xFFFFU);
    EXPECT_EQ(ParseManagerOrder("control 5 6").problem, "control: 2 numbers" + expected);
    EXPECT_EQ(ParseManagerOrder("control 5 6 0 0").problem, "control: 4 numbers" + expected);
    EXPECT_EQ(ParseManagerOrder("control all 6 0").problem, "control: 'all'" + expected);
    EXPECT_EQ(ParseManagerOrder("control 5 65536 0").problem, "control: '65536'" + expected);
    EXPECT_EQ(ParseManagerOrder("control 5 6 x").problem, "control: 'x'" + expected);
    const std::string output =
        "'output' with something else than a node-ID, an RxPDO and 1 to 8 bytes, expected output 10 1 01 FF";
    EXPECT_EQ(ParseManagerOrder("output 5 512 01 FF").pdo, 512U);
    EXPECT_EQ(ParseManagerOrder("output 5 512 01 FF").bytes, (std::vector<std::uint8_t>{0x01U, 0xFFU}));
    for (const char* const wrong : {"output 128 1 01", "output all 1 01", "output 5 0 01", "output 5 x 01"})
    {
        EXPECT_EQ(ParseManagerOrder(wrong).problem, output) << wrong;
    }
    EXPECT_EQ(ParseManagerOrder("set 0x1F90:03 4294967295").value, 4294967295U);
    EXPECT_EQ(ParseManagerOrder("set 0x1F90:03 1 2").problem,
              "'set' with something else than an object and a number, expected set 0x1F90:03 1");
}

TEST_F(ManagerOrderCarriedTest, WhatTheOwnerOfTheManagerCarriesOutHasNoAnswerOfIt)
{
    Verifies(req::SRS_MGR_540);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}]\n");
    EndStartUp();
    sent.clear();
    for (const char* const line : {"status", "help", "quit", "", "fly"})
    {
        EXPECT_EQ(Order(line), "") << line;
    }
    Run(20U);
    EXPECT_EQ(Commands(), Lines{});
    // An order of its own has one
    EXPECT_EQ(Order("stop 5"), "taken");
}

TEST_F(ManagerOrderCarriedTest, BeforeTheStartUpOfTheNetworkNobodyIsBooted)
{
    Verifies(req::SRS_MGR_135);
    // Given a bus that takes nothing, so that not even the first reset has left
    room = 0U;
    Make("manager: {node: 127, profile: plc_designer}\nslaves: [{node: 6}]\n");
    EXPECT_EQ(Order("boot 6"), "the start-up of the network has not begun, expected the order later");
    // When it takes frames again, and all were reset
    room = 100U;
    Run(1000U);
    EXPECT_EQ(Order("boot 6"), "taken");
}

TEST_F(ManagerOrderCarriedTest, ASafetySlaveThatIsAnotherDeviceIsNotWritten)
{
    Verifies(req::SRS_MGR_135);
    // Given a safety slave that says that it is another device
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, device_type: 0x191}]\n");
    Run(2U);
    Hear(0x721U, {0U});
    Answer(33U, {0x43U, 0x00U, 0x10U, 0x00U, 0x92U, 0x01U, 0x00U, 0x00U}, 20);
    EXPECT_EQ(Order("write-safety 33"),
              "node 33 is not known to be the expected device, expected that one, and boot NODE");
    EXPECT_EQ(Order("start 33"),
              "the start-up did not find the expected device at this node-ID, expected that one, and "
              "boot NODE");
}
} // namespace
} // namespace counterpoint::tools
