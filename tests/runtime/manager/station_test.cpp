// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The manager as a device: its objects by SDO, and a negotiation by order.
#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/nmt_master.hpp"
#include "verification/trace/verifies.hpp"

#include <array>

namespace counterpoint::tools
{
namespace
{
using cia306::test::ExampleText;
using test::Lines;

constexpr std::uint8_t kOwn = 127U;

using ManagerStationTest = test::ManagerRig;

/// A slave that nobody boots, one that is booted, and a safety slave.
constexpr const char* kNetwork = "manager: {node: 127, heartbeat: 100 ms, inhibit: 1 ms, boot_time: 2 s}\n"
                                 "slaves:\n"
                                 "  - {node: 5, boot: false, mandatory: false, vendor_id: 0xABC, consumer: 300 ms}\n"
                                 "  - {node: 6, mandatory: false, vendor_id: 0x2A}\n"
                                 "  - {node: 33, dcf: actuator.dcf}\n";

TEST_F(ManagerStationTest, AClientReadsTheNetwork)
{
    Verifies(req::SRS_MGR_020);
    Verifies(req::SRS_MGR_151);
    Make(kNetwork);
    Run(2U);
    EXPECT_EQ(Read(0x1000U, 0U), 0U);
    EXPECT_EQ(Read(0x1017U, 0U), 100U);
    EXPECT_EQ(Read(0x1018U, 0U), 4U);
    EXPECT_EQ(Read(0x102AU, 0U), 10U);
    EXPECT_EQ(Read(0x1016U, 1U), (5U << 16U) | 300U);
    EXPECT_EQ(Read(0x1F80U, 0U), 1U);
    EXPECT_EQ(Read(0x1F89U, 0U), 2000U);
    EXPECT_EQ(Read(0x1F81U, 0U), 127U);
    EXPECT_EQ(Read(0x1F81U, 5U), 0x01U);
    EXPECT_EQ(Read(0x1F81U, 33U), 0x0DU);
    EXPECT_EQ(Read(0x1F81U, 34U), 0U);
    EXPECT_EQ(Read(0x1F85U, 5U), 0xABCU);
    EXPECT_EQ(Read(0x1F88U, 33U), 0x21U);
    EXPECT_EQ(Read(0x1F82U, 0U), 0x80U);
    EXPECT_EQ(Read(0x1F82U, 33U), 0U);    // Unknown.
    EXPECT_EQ(Read(0x1F82U, 127U), 127U); // Its own state.
    EXPECT_EQ(Read(0x1016U, 0U), 127U);
    EXPECT_EQ(Read(0x1016U, 127U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 0U);
    EXPECT_EQ(Read(0x1F21U, 33U), 0U);
    EXPECT_EQ(Read(0x1F90U, 3U), 0x06020000U); // No flying master.
    EXPECT_EQ(Read(0x1301U, 1U), 0x06020000U); // And no safety objects of its own.
    EXPECT_EQ(Read(0x1F85U, 128U), 0x06090011U);
    EXPECT_EQ(Read(0x1F20U, 5U), 0x08000024U);
    EXPECT_EQ(Read(0x1F22U, 5U), 0x08000024U);
    EXPECT_EQ(Read(0x1F25U, 5U), 0x06010001U);
    // Domains as they are
    const std::vector<std::uint8_t> concise = ReadDomain(0x1F22U, 33U);
    EXPECT_EQ(concise, net->Find(33U)->concise);
    EXPECT_FALSE(concise.empty());
    const std::vector<std::uint8_t> text = ReadDomain(0x1F20U, 33U);
    EXPECT_EQ(std::string(text.begin(), text.end()), ExampleText("actuator"));
}

// Given a queue that is full of commands to node 5, then a stop of each goes on node by node as one leaves, and is
// answered behind the last one.
TEST_F(ManagerStationTest, ACommandToEachGoesOnWhereTheQueueHeldItUp)
{
    Verifies(req::SRS_NMM_212);
    Make("manager: {node: 127, heartbeat: 100 ms, inhibit: 100 ms, boot_time: 2 s}\n"
         "slaves:\n"
         "  - {node: 5, boot: false, mandatory: false, vendor_id: 0xABC, consumer: 300 ms}\n"
         "  - {node: 6, mandatory: false, vendor_id: 0x2A}\n");
    Run(2U);
    // By two commands in turn, since one that waits is not put behind itself
    int taken = 0;
    std::uint8_t command = 127U;
    while (!Ask({0x2FU, 0x82U, 0x1FU, 5U, command, 0U, 0U, 0U}).empty())
    {
        command = (command == 127U) ? 6U : 127U;
        ASSERT_LT(++taken, 400);
    }
    EXPECT_TRUE(Ask({0x80U, 0x82U, 0x1FU, 5U, 0U, 0U, 4U, 5U}).empty());
    EXPECT_TRUE(Ask({0x2FU, 0x82U, 0x1FU, 0x80U, 0x84U, 0U, 0U, 0U}).empty());
    Run(50000U);
    EXPECT_EQ(Count(0x580U + kOwn), 1U);
    Lines stops;
    for (const std::string& told : Commands())
    {
        if (told.rfind("2 ", 0U) == 0U)
        {
            stops.push_back(told);
        }
    }
    EXPECT_EQ(stops, (Lines{"2 5", "2 6"}));
}

TEST_F(ManagerStationTest, EachObjectOfANetworkManagerIsThere)
{
    Verifies(req::SRS_MGR_020);
    Make("manager: {node: 127, heartbeat: 200 ms, sync: 10 ms, flying: {priority: 1}}\n"
         "slaves: [{node: 6, mandatory: false, device_type: 0x191, vendor_id: 0x2A, product_code: 3, revision: 4, "
         "serial: 5, date: 0x11, time: 0x22}]\n");
    Run(6000U); // It has become the active master meanwhile.
    EXPECT_EQ(Read(0x1001U, 0U), 0U);
    EXPECT_EQ(Read(0x1006U, 0U), 10000U);
    EXPECT_EQ(Read(0x1F26U, 6U), 0x11U);
    EXPECT_EQ(Read(0x1F27U, 6U), 0x22U);
    EXPECT_EQ(Read(0x1F53U, 6U), 0U);
    EXPECT_EQ(Read(0x1F54U, 6U), 0U);
    EXPECT_EQ(Read(0x1F55U, 6U), 0U);
    EXPECT_EQ(Read(0x1F58U, 6U), 0x08000024U);
    EXPECT_EQ(Read(0x1F80U, 0U), 0x21U); // A flying master.
    EXPECT_EQ(Read(0x1F84U, 6U), 0x191U);
    EXPECT_EQ(Read(0x1F85U, 6U), 0x2AU);
    EXPECT_EQ(Read(0x1F86U, 6U), 3U);
    EXPECT_EQ(Read(0x1F87U, 6U), 4U);
    EXPECT_EQ(Read(0x1F88U, 6U), 5U);
    EXPECT_EQ(Read(0x1F8AU, 6U), 0U);
    EXPECT_EQ(Read(0x1F90U, 0U), 6U);
    EXPECT_EQ(Read(0x1F90U, 3U), 1U);
    // A manager without a DCF of its own has no names
    EXPECT_EQ(Read(0x1008U, 0U), 0x06020000U);
}

TEST_F(ManagerStationTest, ARequestCommandsTheNetwork)
{
    Verifies(req::SRS_MGR_020);
    Make(kNetwork);
    Run(2U);
    EXPECT_EQ(Write(0x1F82U, 5U, 4U, 1U), 0U);
    EXPECT_EQ(Commands(), (Lines{"2 5"}));
    Run(2U);
    EXPECT_EQ(Write(0x1F82U, 5U, 6U, 1U), 0U);
    EXPECT_EQ(Commands(), (Lines{"129 5"}));
    EXPECT_EQ(Write(0x1F82U, 9U, 5U, 1U), 0x06090030U); // Not in the network.
    EXPECT_EQ(Write(0x1F82U, 5U, 3U, 1U), 0x06090030U);
    EXPECT_EQ(Write(0x1F82U, 5U, 4U, 4U), 0x06070012U); // Another length.
    EXPECT_EQ(Write(0x1F83U, 5U, 1U, 1U), 0x08000022U); // No times.
    EXPECT_EQ(Write(0x1F25U, 6U, 1U, 4U), 0x08000020U);
    // A start of all is none to node 0, and none of the safety slave
    Run(5U);
    EXPECT_EQ(Write(0x1F82U, 0x80U, 5U, 1U), 0U);
    Run(20U);
    const Lines commands = Commands();
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "1 0"), 0);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "1 33"), 0);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "1 5"), 1);
}

TEST_F(ManagerStationTest, WhoCannotBeConfiguredIsLeftAsItIsUnderEachProfile)
{
    Verifies(req::SRS_NMM_150);
    Verifies(req::SRS_NMM_151);
    Verifies(req::SRS_NMM_152);
    constexpr std::uint32_t kConf = 0x666E6F63U;
    const std::pair<const char*, Lines> runs[] = {
        {"cia302", {"128 6"}}, {"el6751", {"128 6", "130 6"}}, {"plc_designer", {"128 6", "129 6"}}};
    for (const auto& [profile, commands] : runs)
    {
        // Given a slave that is started up, then it is not configured beside that
        Make("manager: {node: 127, profile: " + std::string(profile) +
             "}\nslaves: [{node: 6, device_type: 0x191, consumer: 300 ms}]\n");
        Run(1000U);
        EXPECT_EQ(Write(0x1F25U, 6U, kConf, 4U), 0x08000022U) << profile;
        Hear(0x706U, {0U});
        for (int beat = 0; beat < 6; ++beat)
        {
            Answer(6U, {0x43U, 0x00U, 0x10U, 0x00U, 0x91U, 0x01U, 0x00U, 0x00U}, 110);
            Hear(0x706U, {(beat < 5) ? std::uint8_t{0x7FU} : std::uint8_t{0x05U}});
        }
        EXPECT_EQ(Read(0x1F82U, 6U), 5U) << profile;
        // When it is stopped, then nothing is sent to it, whether it is asked for alone or with all
        EXPECT_EQ(Order("stop 6"), "taken") << profile;
        Run(2U);
        Hear(0x706U, {0x04U});
        for (const std::uint8_t sub : {std::uint8_t{6U}, std::uint8_t{0x80U}})
        {
            EXPECT_EQ(Write(0x1F25U, sub, kConf, 4U), 0x08000022U) << profile;
            Run(20U);
            EXPECT_EQ(Commands(), Lines{}) << profile;
            EXPECT_EQ(Read(0x1F82U, 6U), 4U) << profile;
        }
        // When it is PRE-OPERATIONAL, then it is configured: where there is no such thing, started up
        sent.clear();
        EXPECT_EQ(Order("preop 6"), "taken") << profile;
        Run(2U);
        Hear(0x706U, {0x7FU});
        const Lines held = Commands();
        EXPECT_EQ(Write(0x1F25U, 6U, kConf, 4U), 0U) << profile;
        Run(20U);
        Lines all = held;
        const Lines behind = Commands();
        all.insert(all.end(), behind.begin(), behind.end());
        EXPECT_EQ(all, commands) << profile;
    }
}

TEST_F(ManagerStationTest, WritesObeyRules)
{
    Verifies(req::SRS_MGR_021);
    Verifies(req::SRS_MGR_214);
    Verifies(req::SRS_MGR_215);
    Verifies(req::SRS_MGR_216);
    Verifies(req::SRS_MGR_217);
    Verifies(req::SRS_MGR_220);
    Make(kNetwork);
    EndStartUp();
    // What the manager knows of a slave that is not being started
    EXPECT_EQ(Write(0x1F88U, 5U, 7U, 4U), 0U);
    EXPECT_EQ(Read(0x1F88U, 5U), 7U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00640301U, 4U), 0U);
    EXPECT_EQ(Write(0x1F83U, 5U, 1U, 1U), 0x08000022U); // It has times now, and a heartbeat.
    EXPECT_EQ(Write(0x1016U, 1U, 0U, 4U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 1U); // Without it guarding begins.
    EXPECT_EQ(Write(0x1F83U, 5U, 0U, 1U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 0U);
    EXPECT_EQ(Write(0x1F83U, 5U, 1U, 1U), 0U);
    EXPECT_EQ(Read(0x1F83U, 5U), 1U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00000301U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00640001U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0x00640303U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F81U, 5U, 0U, 4U), 0x08000022U);
    EXPECT_EQ(Write(0x1F81U, 9U, 1U, 4U), 0x08000022U); // Nobody joins,
    EXPECT_EQ(Write(0x1F88U, 6U, 6U, 4U), 0U);          // or is changed while it is started, but who is awaited is.
    Hear(0x706U, {0x00U});
    EXPECT_EQ(Write(0x1F88U, 6U, 7U, 4U), 0U);
    Hear(0x586U, {0x43U, 0x00U, 0x10U, 0x00U, 0U, 0U, 0U, 0U});
    EXPECT_EQ(Write(0x1F88U, 6U, 8U, 4U), 0x08000022U);
    EXPECT_EQ(Write(0x1F22U, 6U, 0U, 4U), 0x08000022U);
    // A safety slave stays what it is
    for (const std::uint16_t index : std::initializer_list<std::uint16_t>{
             0x1F26U, 0x1F27U, 0x1F53U, 0x1F54U, 0x1F55U, 0x1F81U, 0x1F84U, 0x1F85U, 0x1F86U, 0x1F87U, 0x1F88U})
    {
        EXPECT_EQ(Write(index, 33U, 0U, 4U), 0x06010002U) << index;
    }
    EXPECT_EQ(Write(0x1F8AU, 33U, 1U, 1U), 0x06010002U);
    EXPECT_EQ(Write(0x1F22U, 33U, 0U, 4U), 0x06010002U);
    EXPECT_EQ(Order("set 0x1F81:21 0"), "0x1F81:21 (node 33) = 0: 0x06010002 (read only), expected an object that may "
                                        "change, and not of a safety slave");
    // 1F80h: what the device is stays
    EXPECT_EQ(Write(0x1F80U, 0U, 0x21U, 4U), 0x08000022U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x00U, 4U), 0x08000022U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x81U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x09U, 4U), 0U);
    EXPECT_EQ(Read(0x1F80U, 0U), 9U);
    EXPECT_EQ(Write(0x1018U, 1U, 1U, 4U), 0x06010002U);
    EXPECT_EQ(Write(0x1F20U, 5U, 1U, 4U), 0x06010002U);
    // Of this device
    EXPECT_EQ(Write(0x1017U, 0U, 10U, 2U), 0U);
    sent.clear();
    Run(50U);
    EXPECT_EQ(Count(0x77FU), 5U);
}

TEST_F(ManagerStationTest, EachObjectOfASlaveIsWrittenWhileItIsAwaitedAndNotWhileItsStartUpRuns)
{
    Verifies(req::SRS_MGR_215);
    constexpr std::array<std::uint16_t, 12> kObjects{0x1F22U, 0x1F26U, 0x1F27U, 0x1F53U, 0x1F54U, 0x1F55U,
                                                     0x1F81U, 0x1F84U, 0x1F85U, 0x1F86U, 0x1F87U, 0x1F88U};
    Make(kNetwork);
    EndStartUp();
    // Given slave 6, whose boot-up message is awaited
    for (const std::uint16_t index : kObjects)
    {
        const bool is_number = index != 0x1F22U && index != 0x1F81U;
        const std::uint32_t value = (index == 0x1F88U) ? 7U : 0U; // A serial number that is asked for.
        EXPECT_EQ(is_number ? Write(index, 6U, value, 4U) : 0U, 0U) << index;
    }
    // When its first answer comes, then none of them is changed, nor of node 9, which is no slave
    Hear(0x706U, {0x00U});
    Hear(0x586U, {0x43U, 0x00U, 0x10U, 0x00U, 0U, 0U, 0U, 0U});
    for (const std::uint16_t index : kObjects)
    {
        EXPECT_EQ(Write(index, 6U, 1U, 4U), 0x08000022U) << index;
        EXPECT_EQ(Write(index, 9U, 1U, 4U), 0x08000022U) << index;
    }
    EXPECT_EQ(Write(0x1F8AU, 6U, 1U, 1U), 0x08000022U);
    EXPECT_EQ(Write(0x1F8AU, 9U, 1U, 1U), 0x08000022U);
}

TEST_F(ManagerStationTest, BitsThatTheProfileDoesNotLookAtStay)
{
    Verifies(req::SRS_MGR_214);
    const std::string slave = "}\nslaves: [{node: 5}]\n";
    Make("manager: {node: 127, profile: plc_designer" + slave);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x0BU, 4U), 0U); // One start of all, and none by itself.
    EXPECT_EQ(Write(0x1F80U, 0U, 0x4BU, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x2BU, 4U), 0x08000022U);
    EXPECT_EQ(Read(0x1F80U, 0U), 0x0BU);
    Make("manager: {node: 127, profile: el6751" + slave);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x03U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x01U, 4U), 0U);
    Make("manager: {node: 127" + slave);
    EXPECT_EQ(Write(0x1F80U, 0U, 0x5FU, 4U), 0U);
}

TEST_F(ManagerStationTest, HeartbeatConsumersAreWrittenAsInAnyDevice)
{
    Verifies(req::SRS_MGR_221);
    Verifies(req::SRS_MGR_222);
    Make(kNetwork);
    Run(2U);
    Hear(0x705U, {0x00U});
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 500U, 4U), 0x08000022U); // While it is started.
    EndStartUp();
    const auto count = [this](const std::string& kind, const std::uint8_t node)
    {
        return std::count_if(events.begin(), events.end(), [&](const runtime::ManagerEvent& event)
                             { return event.kind == kind && event.node == node; });
    };
    // Rules of CiA 301, and of this manager
    EXPECT_EQ(Read(0x1016U, 2U), (33U << 16U) | 200U);
    EXPECT_EQ(Write(0x1016U, 3U, (5U << 16U) | 100U, 4U), 0x06040043U);
    EXPECT_EQ(Write(0x1016U, 3U, (127U << 16U) | 100U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1016U, 3U, 0x01050064U, 4U), 0x06090030U);
    EXPECT_EQ(Write(0x1016U, 2U, 0U, 4U), 0x06010002U); // A safety slave,
    EXPECT_EQ(Write(0x1016U, 2U, (9U << 16U) | 100U, 4U), 0x06010002U);
    EXPECT_EQ(Write(0x1016U, 2U, (33U << 16U) | 200U, 4U), 0U);  // but the value that it has.
    EXPECT_EQ(Write(0x1016U, 3U, (200U << 16U) | 100U, 4U), 0U); // Nobody.
    EXPECT_EQ(Write(0x1016U, 4U, (5U << 16U), 4U), 0U);          // Off.
    EXPECT_EQ(Write(0x1016U, 0U, 3U, 1U), 0x06010002U);
    EXPECT_EQ(Read(0x1016U, 3U), (200U << 16U) | 100U);
    // A longer time counts at once
    EXPECT_EQ(Write(0x1016U, 1U, (5U << 16U) | 1000U, 4U), 0U);
    Hear(0x705U, {0x7FU});
    Run(990U);
    EXPECT_EQ(count("heartbeat_lost", 5U), 0);
    Run(20U);
    EXPECT_EQ(count("heartbeat_lost", 5U), 1);
    // Somebody who is no slave
    EXPECT_EQ(Write(0x1016U, 3U, (9U << 16U) | 50U, 4U), 0U);
    Hear(0x709U, {0x05U});
    Run(60U);
    EXPECT_EQ(count("heartbeat_lost", 9U), 1);
    // And nobody any more
    EXPECT_EQ(Write(0x1016U, 3U, 0U, 4U), 0U);
    Hear(0x709U, {0x05U});
    Run(60U);
    EXPECT_EQ(count("heartbeat_lost", 9U), 1);
    // The place of an entry does not matter
    EXPECT_EQ(Write(0x1016U, 127U, (9U << 16U) | 50U, 4U), 0U);
    EXPECT_EQ(Read(0x1016U, 127U), (9U << 16U) | 50U);
    EXPECT_EQ(Read(0x1016U, 0U), 127U);
    EXPECT_EQ(Write(0x1016U, 128U, (9U << 16U) | 50U, 4U), 0x06090011U);
}

TEST_F(ManagerStationTest, TheLastEmergencyOfAStormIsTold)
{
    Verifies(req::SRS_MGR_011);
    Make(kNetwork);
    // Given an error, another one and both gone again within some milliseconds
    Hear(0x085U, {0x30U, 0x81U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Run(2U);
    Hear(0x085U, {0x10U, 0x82U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Run(2U);
    Hear(0x085U, {0x00U, 0x00U, 0x00U, 0U, 0U, 0U, 0U, 0U});
    Run(200U);
    Hear(0x085U, {0x10U, 0x82U, 0x11U, 0U, 0U, 0U, 0U, 0U});
    Run(200U);
    Lines told;
    for (const runtime::ManagerEvent& event : events)
    {
        if (event.kind == "emergency")
        {
            told.push_back(std::to_string(event.at_us) + " " + event.text);
        }
    }
    EXPECT_EQ(told, (Lines{"0 emergency 0x8130, register 0x11",
                           "100000 emergency 0x0000, register 0x00, and 1 before it in a storm",
                           "204000 emergency 0x8210, register 0x11"}));
}

TEST_F(ManagerStationTest, AConciseDcfIsTakenWholeOrNotAtAll)
{
    Verifies(req::SRS_MGR_218);
    Make(kNetwork);
    EndStartUp();
    // Given no entries, in one frame; then a damaged count
    EXPECT_EQ(Write(0x1F22U, 5U, 0U, 4U), 0U);
    EXPECT_EQ(Read(0x1F22U, 5U), 0U);
    EXPECT_EQ(Write(0x1F22U, 5U, 1U, 4U), 0x06090030U);
    // An object of the safety configuration is never part of one, be it the second entry
    const std::vector<std::uint8_t> plain{1U, 0U, 0U, 0U, 0x00U, 0x20U, 0U, 1U, 0U, 0U, 0U, 0xA5U};
    EXPECT_EQ(WriteDomain(0x1F22U, 5U, plain), 0U);
    EXPECT_EQ(WriteDomain(0x1F22U, 5U, {1U, 0U, 0U, 0U, 0xFEU, 0x13U, 0U, 1U, 0U, 0U, 0U, 0xA5U}), 0x06090030U);
    EXPECT_EQ(WriteDomain(0x1F22U, 5U, {1U, 0U, 0U, 0U, 0x00U, 0x13U, 0U, 1U, 0U, 0U, 0U, 1U}), 0x06090030U);
    EXPECT_EQ(WriteDomain(0x1F22U, 5U, {2U,    0U,    0U, 0U, 0x00U, 0x20U, 0U, 1U, 0U, 0U, 0U, 7U, //
                                        0x01U, 0x13U, 2U, 1U, 0U,    0U,    0U, 9U}),
              0x06090030U);
    // Nor is one taken whose last entry is cut
    EXPECT_EQ(WriteDomain(0x1F22U, 5U, {1U, 0U, 0U, 0U, 0x00U, 0x20U, 0U, 2U, 0U, 0U, 0U, 7U}), 0x06090030U);
    EXPECT_EQ(ReadDomain(0x1F22U, 5U), plain);
    EXPECT_FALSE(net->ReplaceConcise(9U, {plain.data(), 12U}));
}

TEST_F(ManagerStationTest, WhatIsWrittenByTheActiveMasterOrBeforeTheNegotiationAlone)
{
    Verifies(req::SRS_MGR_213);
    Verifies(req::SRS_MGR_219);
    // Given a manager that waits for the start of its negotiation
    Make("manager: {node: 127, heartbeat: 200 ms, flying: {start: by_order}}\nslaves: [{node: 5, boot: false}]\n");
    Run(2U);
    // Then it commands nobody by its objects, and its times may change
    for (const std::string order : {"set 0x1F82:05 5", "set 0x1F83:05 1", "set 0x1F25:05 0x666E6F63"})
    {
        EXPECT_NE(Order(order).find(": 0x08000022 "), std::string::npos) << order << " " << Order(order);
    }
    static_cast<void>(Order("set 0x1F90:02 300"));
    EXPECT_EQ(Order("get 0x1F90:02"), "0x1F90:02 = 300 (0x12C)");
    // When it negotiates, then they may not
    static_cast<void>(Order("negotiate"));
    Run(10U);
    EXPECT_NE(Order("set 0x1F90:02 400").find(": 0x08000022 "), std::string::npos);
    EXPECT_EQ(Order("get 0x1F90:02"), "0x1F90:02 = 300 (0x12C)");
    // And when it leads, it commands
    Run(30000U);
    ASSERT_TRUE(station->Assembly().Core().IsActive());
    EXPECT_EQ(Order("set 0x1F82:05 4").find("0x08000022"), std::string::npos);
}

TEST_F(ManagerStationTest, ThereIsNoServerInStopped)
{
    Verifies(req::SRS_MGR_020);
    Make(kNetwork);
    Run(2U);
    EXPECT_EQ(Write(0x1F82U, kOwn, 4U, 1U), 0U);
    Run(200U);
    EXPECT_TRUE(Ask({0x40U, 0x80U, 0x1FU, 0U, 0U, 0U, 0U, 0U}).empty());
    EXPECT_EQ(Order("get 0x1F80:00"), "0x1F80:00 = 1 (0x1)"); // The application itself always may.
}

TEST_F(ManagerStationTest, DeviceTypeAndNamesOfItsOwnDcf)
{
    Verifies(req::SRS_MGR_150);
    // Given a DCF of the manager with a device type and three names
    std::string dcf = cia306::test::Changed(
        ExampleText("controller"),
        {{"NodeID=2\n", "NodeID=127\n"},
         {"DefaultValue=0x00000000\nPDOMapping=0\n\n[1001]", "DefaultValue=0x00000191\nPDOMapping=0\n\n[1001]"},
         {"=Vendor-ID\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x00000000",
          "=Vendor-ID\nObjectType=0x7\nDataType=0x0007\nAccessType=ro\nDefaultValue=0x00000123"}});
    for (const auto& [section, name] :
         {std::pair("1008", "Control cabinet"), {"1009", "Rev. 3"}, {"100A", "Release 12"}})
    {
        dcf += "\n[" + std::string(section) + "]\nParameterName=A name\nObjectType=0x7\nDataType=0x0009\n" +
               "AccessType=const\nDefaultValue=" + name + "\nPDOMapping=0\n";
    }
    static_cast<void>(File("manager.dcf", dcf));
    Make("manager: {node: 127, dcf: manager.dcf}\nslaves: [{node: 5}]\n");
    Run(2U);
    EXPECT_EQ(Read(0x1000U, 0U), 0x191U);
    const auto text = [this](const std::uint16_t index)
    {
        const std::vector<std::uint8_t> bytes = ReadDomain(index, 0U);
        return std::string(bytes.begin(), bytes.end());
    };
    EXPECT_EQ(text(0x1008U), "Control cabinet");
    EXPECT_EQ(text(0x1009U), "Rev. 3");
    EXPECT_EQ(text(0x100AU), "Release 12");
    EXPECT_EQ(Read(0x1018U, 1U), 0x123U);
    EXPECT_EQ(Read(0x1018U, 4U), 2U);
}

TEST_F(ManagerStationTest, IdentityAndNetworkOfItsOwnDcf)
{
    Verifies(req::SRS_MGR_150);
    Verifies(req::SRS_NET_004);
    static_cast<void>(File("controller.dcf", ExampleText("controller")));
    Make("manager: {node: 2, dcf: controller.dcf}\nslaves: [{node: 5}]\n");
    EXPECT_EQ(Order("get 0x1018:02"), "0x1018:02 = 2 (0x2)");
    EXPECT_EQ(Order("get 0x1018:03"), "0x1018:03 = 65536 (0x10000)");
    EXPECT_EQ(Order("get 0x1F81:05"), "0x1F81:05 (node 5) = 13 (0xD)");
    EXPECT_EQ(Order("get 0x6000:01"), "no object 0x6000:01, expected one of the manager");
    // A DCF for another node is no one of the manager
    try
    {
        Make("manager: {node: 3,\n  dcf: controller.dcf}\nslaves: [{node: 5}]\n");
        ADD_FAILURE();
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_EQ(std::string(error.what()), Path("net.yaml") + ":1:10: error: '" + Path("controller.dcf") +
                                                 "' is for node-ID 2, expected the DCF of the manager, node 3");
    }
}

TEST_F(ManagerStationTest, TheNegotiationWaitsForItsOrder)
{
    Verifies(req::SRS_MGR_023);
    Make("manager: {node: 127, heartbeat: 100 ms, flying: {priority: 2, start: by_order}}\nslaves: [{node: 5}]\n");
    // Given a flying master that says nothing, and no SDO server
    Run(2000U);
    EXPECT_TRUE(sent.empty());
    EXPECT_TRUE(Ask({0x40U, 0x90U, 0x1FU, 3U, 0U, 0U, 0U, 0U}).empty());
    // Then its objects may be set, in their range
    EXPECT_EQ(Order("set 0x1F90:03 1"), "taken");
    EXPECT_EQ(Order("set 0x1F90:03 3"),
              "0x1F90:03 = 3: 0x06090030 (value out of range), expected another value, or another node");
    EXPECT_EQ(Order("get 0x1F90:03"), "0x1F90:03 = 1 (0x1)");
    EXPECT_EQ(Order("set 0x1F90:04 1270"), "taken");
    EXPECT_EQ(Order("negotiate"),
              "level slot 1270 ms with node slot 10 ms, expected a level slot above 127 node slots, which are above 0");
    EXPECT_EQ(Order("set 0x1F90:04 1271"), "taken");
    // And the negotiation begins with them: 1 x 1271 ms + 127 x 10 ms behind 072h
    EXPECT_EQ(Order("negotiate"), "taken");
    EXPECT_NE(Order("negotiate"), "taken");
    Run(8000U);
    EXPECT_TRUE(station->Assembly().Core().IsActive());
    EXPECT_EQ(station->Assembly().Core().Role().Flying()->Master().level, 1U);
    EXPECT_EQ(Write(0x1F90U, 3U, 0U, 2U), 0x08000022U); // Not any more.
    EXPECT_EQ(Read(0x1F90U, 3U), 1U);
}

TEST_F(ManagerStationTest, ASlaveThatIsOperationalIsNotWritten)
{
    Verifies(req::SRS_SFS_212);
    Make(kNetwork);
    Run(2U);
    Hear(0x721U, {0x05U});
    EXPECT_NE(Order("write-safety 33"), "taken");
    EXPECT_EQ(Order("write-safety 5"), "node 5 is no safety slave, expected one");
}

TEST_F(ManagerStationTest, ASlaveThatWasToldToStopAndHasNotSpokenOfItIsNotCalledOperational)
{
    Verifies(req::SRS_SFS_212);
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf, arming: immediately}]\n");
    Run(2U);
    Hear(0x721U, {0x05U});
    EXPECT_EQ(Order("write-safety 33"), "node 33 is OPERATIONAL, expected it stopped or PRE-OPERATIONAL");
    EXPECT_EQ(Order("stop 33"), "taken");
    EXPECT_EQ(Order("write-safety 33"), "the start-up of the slave runs, expected it later");
}

TEST_F(ManagerStationTest, AStandbyTellsWhoIsToBeAskedToWrite)
{
    Verifies(req::SRS_MGR_135);
    Make("manager: {node: 127, heartbeat: 200 ms, flying: {start: by_order}}\nslaves: [{node: 33, dcf: "
         "actuator.dcf}]\n");
    Run(2U);
    EXPECT_EQ(Order("write-safety 33"), "the manager is not the active master, expected the order at that one");
}

TEST_F(ManagerStationTest, ACommandToAllMakesNoAbsentSlaveAStartedOne)
{
    Verifies(req::SRS_MGR_122);
    for (const char* const profile : {"cia302", "el6751", "plc_designer"})
    {
        // Given a mandatory slave that is not there
        Make("manager: {node: 127, boot_time: 1 s, profile: " + std::string(profile) + "}\nslaves: [{node: 16}]\n");
        Run(5000U);
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        // When everybody is commanded
        for (const char* const order : {"preop all", "start all", "stop all", "start all", "start 16"})
        {
            static_cast<void>(Order(order));
            Run(20U);
        }
        // Then it has not been started
        EXPECT_FALSE(station->Assembly().HasStarted()) << profile;
        EXPECT_EQ(events.back().text.find("all started"), std::string::npos) << profile;
    }
}

TEST_F(ManagerStationTest, WithoutAFlyingMasterThereIsNothingToNegotiate)
{
    Verifies(req::SRS_MGR_023);
    Make(kNetwork);
    EXPECT_EQ(Order("negotiate"), "no negotiation waits for an order, expected flying: {start: by_order}");
    EXPECT_EQ(runtime::ParseManagerOrder("get 1F80").problem,
              "'get' with something else than an object, expected get 0x1F80:00");
    EXPECT_EQ(runtime::ParseManagerOrder("set 0x1F90:03").kind, runtime::ManagerOrderKind::kProblem);
    EXPECT_EQ(runtime::ParseManagerOrder("set 0x1F90:03 010").kind, runtime::ManagerOrderKind::kProblem);
    EXPECT_EQ(runtime::ParseManagerOrder("get 01F90:03").kind, runtime::ManagerOrderKind::kProblem);
    EXPECT_EQ(runtime::ParseManagerOrder("set 0x1F90:03 x").kind, runtime::ManagerOrderKind::kProblem);
    EXPECT_EQ(runtime::ParseManagerOrder("set 0x1F90:03 4294967296").kind, runtime::ManagerOrderKind::kProblem);
    EXPECT_EQ(Order("set 0x1017:00 65536"), "0x1017:00 = 65536, expected at most 2 bytes");
}
} // namespace
} // namespace counterpoint::tools
