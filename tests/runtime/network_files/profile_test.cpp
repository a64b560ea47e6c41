// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the EL6751 and PLC Designer profiles learn from network files and DCFs.
#include "runtime/manager/station.hpp"
#include "tests/runtime/network_files/profile_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::tools
{
namespace
{

TEST_F(NetworkProfileTest, El6751TakesPdosThatAreOnAndTheTimesOfTheHeartbeat)
{
    Verifies(req::SRS_ELM_051);
    Verifies(req::SRS_ELM_210);
    Verifies(req::SRS_ELM_212);
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", "    consumer: 250 ms\n"), 0U));
    const cia302::SlaveSetup& setup = net.Setup().slaves[5];
    ASSERT_NE(setup.el6751, nullptr);
    const cia302::El6751Slave& slave = *setup.el6751;
    ASSERT_EQ(slave.rx_count, 1U);
    EXPECT_EQ(slave.rx_pdos[0].number, 1U);
    EXPECT_EQ(slave.rx_pdos[0].cob_id, 0x205U);
    EXPECT_EQ(slave.rx_pdos[0].type, 1U);
    EXPECT_EQ(slave.rx_pdos[0].length_bytes, 3U);
    ASSERT_EQ(slave.tx_count, 1U);
    EXPECT_EQ(slave.tx_pdos[0].cob_id, 0x185U);
    EXPECT_EQ(slave.tx_pdos[0].event_ms, 20U);
    // 250 ms are three times of 100 ms, rounded up
    EXPECT_EQ(slave.guard_time_ms, 100U);
    EXPECT_EQ(slave.life_time_factor, 3U);
    // What the rows write is left out; PDOs that are off are switched off as ever
    EXPECT_EQ(Keys(setup.concise_dcf),
              (std::vector<std::uint32_t>{0x140101U, 0x140102U, 0x140105U, 0x140101U, 0x180101U, 0x180102U, 0x180105U,
                                          0x180101U, 0x200000U}));
    EXPECT_TRUE(cia302::NeedsSync(net.Setup()));
}

TEST_F(NetworkProfileTest, WithoutA1016hTheHeartbeatIsAFurtherObjectAndSupervisedAllTheSame)
{
    Verifies(req::SRS_ELM_210);
    const std::string text = kDcf;
    const std::size_t begin = text.find("[1016]");
    std::string without = text.substr(0U, begin) + text.substr(text.find("[1017]"));
    without.replace(without.find("SupportedObjects=11\n11=0x1016"), 29U, "SupportedObjects=2");
    without.erase(without.find("3=0x1400"), without.find("[ManufacturerObjects]") - without.find("3=0x1400"));
    static_cast<void>(File("io.dcf", without));
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", "    consumer: 250 ms\n"), 0U));
    const cia302::SlaveSetup& setup = net.Setup().slaves[5];
    EXPECT_EQ(setup.el6751->guard_time_ms, 0U);
    EXPECT_EQ(setup.heartbeat.consumer_ms, 250U);
    EXPECT_EQ(Keys(setup.concise_dcf), (std::vector<std::uint32_t>{0x100600U, 0x101700U, 0x200000U}));
}

TEST_F(NetworkProfileTest, APdoWhoseMappingChangesKeepsItsWholeSequence)
{
    Verifies(req::SRS_ELM_212);
    Device("ParameterValue");
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", ""), 0U));
    const std::vector<std::uint32_t> keys = Keys(net.Setup().slaves[5].concise_dcf);
    const std::vector<std::uint32_t> first(keys.begin(), keys.begin() + 8);
    EXPECT_EQ(first, (std::vector<std::uint32_t>{0x140001U, 0x140002U, 0x140005U, 0x160000U, 0x160001U, 0x160002U,
                                                 0x160000U, 0x140001U}));
}

TEST_F(NetworkProfileTest, ASynchronousPdoWithoutASyncPeriodIsRefused)
{
    Verifies(req::SRS_NET_152);
    const std::string file =
        File("net.yaml", "manager: {node: 127, profile: el6751}\nslaves:\n  - {node: 4}\n  - {node: 5, dcf: io.dcf}\n");
    try
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
        ADD_FAILURE() << "accepted";
    }
    catch (const std::exception& error)
    {
        EXPECT_EQ(std::string(error.what()),
                  file + ":4:5: error: PDO 1 of node 5 is synchronous (type 1) and there is no SYNC, expected a period "
                         "under manager, sync");
    }
}

TEST_F(NetworkProfileTest, El6751OptionsOfManagerAndSlave)
{
    Verifies(req::SRS_ELM_211);
    const LoadedNetwork net(runtime::ReadNetworkFile(
        Net("  profile: el6751\n  el6751: {window: last_rx_pdo, sync_multiplier: 4, input_shift: 300 us}\n",
            "    guard_time: 50 ms\n    retry_factor: 4\n    el6751:\n      kind: bk51x0\n      start: false\n"
            "      check_device_type: false\n      write_sync_period: false\n      write_cob_ids: false\n"
            "      write_types: false\n      restart_without_pdos: true\n      literal_consumer: true\n"
            "      reaction: none\n      restart: by_hand\n      network_reaction: stop_all\n"
            "      coupler_pdos: 0x102\n      coupler_inhibit: 1.5 ms\n      coupler_event: 30 ms\n"),
        0U));
    const cia302::El6751Slave& slave = *net.Setup().slaves[5].el6751;
    EXPECT_EQ(slave.kind, cia302::El6751Kind::kBusCoupler);
    EXPECT_FALSE(slave.is_started || slave.is_device_type_checked || slave.is_sync_period_written ||
                 slave.is_cob_id_written || slave.is_type_written);
    EXPECT_TRUE(slave.is_restarted_without_pdos && slave.is_consumer_literal);
    EXPECT_EQ(slave.node_reaction, cia302::El6751NodeReaction::kNone);
    EXPECT_EQ(slave.restart, cia302::El6751Restart::kByHand);
    EXPECT_EQ(slave.network_reaction, cia302::El6751NetworkReaction::kStopAll);
    EXPECT_EQ(slave.coupler_pdos, 0x102U);
    EXPECT_EQ(slave.coupler_inhibit_100us, 15U);
    EXPECT_EQ(slave.coupler_event_ms, 30U);
    EXPECT_EQ(slave.guard_time_ms, 50U);
    EXPECT_EQ(slave.life_time_factor, 4U);
    EXPECT_EQ(net.Plan().manager.el6751->window, cia302::El6751Window::kLastRxPdo);
    EXPECT_EQ(net.Plan().manager.el6751->sync_multiplier, 4U);
    EXPECT_EQ(net.Plan().manager.el6751->input_shift_us, 300U);
}

// The defaults of the EL6751's property pages.
TEST_F(NetworkProfileTest, El6751OptionsThatNobodyNamesAreThoseOfTheText)
{
    Verifies(req::SRS_ELM_211);
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", ""), 0U));
    const cia302::El6751Slave& slave = *net.Setup().slaves[5].el6751;
    EXPECT_EQ(slave.kind, cia302::El6751Kind::kGeneral);
    EXPECT_TRUE(slave.is_started);
    EXPECT_TRUE(slave.is_device_type_checked);
    EXPECT_TRUE(slave.is_sync_period_written);
    EXPECT_TRUE(slave.is_cob_id_written);
    EXPECT_TRUE(slave.is_type_written);
    EXPECT_FALSE(slave.is_restarted_without_pdos);
    EXPECT_FALSE(slave.is_consumer_literal);
    EXPECT_EQ(slave.node_reaction, cia302::El6751NodeReaction::kStop);
    EXPECT_EQ(slave.restart, cia302::El6751Restart::kAutomatic);
    EXPECT_EQ(slave.network_reaction, cia302::El6751NetworkReaction::kNone);
    EXPECT_EQ(slave.coupler_pdos, 0U);
    EXPECT_EQ(slave.coupler_inhibit_100us, 0U);
    EXPECT_EQ(slave.coupler_event_ms, 0U);
    const cia302::El6751Times times = net.Plan().manager.el6751.value_or(cia302::El6751Times{});
    EXPECT_EQ(times.window, cia302::El6751Window::kInputShift);
    EXPECT_EQ(times.sync_multiplier, 1U);
    EXPECT_EQ(times.input_shift_us, 500U);
}

TEST_F(NetworkProfileTest, ABusCouplersPdosAreMadeBy5500hAlone)
{
    Verifies(req::SRS_ELM_212);
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", "    el6751: {kind: bk51x0}\n"), 0U));
    const std::vector<std::uint32_t> keys = Keys(net.Setup().slaves[5].concise_dcf);
    EXPECT_EQ(keys, (std::vector<std::uint32_t>{0x200000U}));
}

TEST_F(NetworkProfileTest, PlcDesignerTakesOptionalAndResetNode)
{
    Verifies(req::SRS_PLC_021);
    const LoadedNetwork plain(runtime::ReadNetworkFile(Net("  profile: plc_designer\n", ""), 0U));
    EXPECT_FALSE(plain.Setup().slaves[5].plc->is_optional);
    EXPECT_FALSE(plain.Setup().slaves[5].plc->is_reset);
    const LoadedNetwork spare(runtime::ReadNetworkFile(Net("  profile: plc_designer\n", "    mandatory: false\n"), 0U));
    EXPECT_TRUE(spare.Setup().slaves[5].plc->is_optional);
    const LoadedNetwork reset(runtime::ReadNetworkFile(
        Net("  profile: plc_designer\n", "    mandatory: false\n    plc_designer: {reset_node: true}\n"), 0U));
    EXPECT_TRUE(reset.Setup().slaves[5].plc->is_optional);
    EXPECT_TRUE(reset.Setup().slaves[5].plc->is_reset);
    const LoadedNetwork both(runtime::ReadNetworkFile(
        Net("  profile: plc_designer\n", "    mandatory: false\n    plc_designer: {optional: false}\n"), 0U));
    EXPECT_FALSE(both.Setup().slaves[5].plc->is_optional);
    const LoadedNetwork said(runtime::ReadNetworkFile(
        Net("  profile: plc_designer\n", "    plc_designer: {optional: true, reset_node: true}\n"), 0U));
    EXPECT_TRUE(said.Setup().slaves[5].plc->is_optional);
    EXPECT_TRUE(said.Setup().slaves[5].plc->is_reset);
    EXPECT_EQ(said.Setup().slaves[5].el6751, nullptr);
}

TEST_F(NetworkProfileTest, WrongOptionsAreRefusedWithTheirLine)
{
    Verifies(req::SRS_ELM_211);
    Verifies(req::SRS_PLC_021);
    const auto problem = [this](const std::string& manager, const std::string& slave)
    {
        std::string text;
        try
        {
            static_cast<void>(runtime::ReadNetworkFile(Net(manager, slave), 0U));
        }
        catch (const std::exception& error)
        {
            text = error.what();
        }
        return text;
    };
    EXPECT_NE(problem("", "    el6751: {kind: bk5120}\n").find("net.yaml:8"), std::string::npos);
    EXPECT_NE(problem("", "    el6751: {kinds: general}\n").find("unknown key"), std::string::npos);
    EXPECT_NE(problem("", "    el6751: {coupler_event: 1.5 ms}\n").find("whole milliseconds"), std::string::npos);
    EXPECT_NE(problem("  el6751: {sync_multiplier: 0}\n", "").find("net.yaml:5"), std::string::npos);
    EXPECT_NE(problem("", "    plc_designer: {optional: maybe}\n").find("true, false"), std::string::npos);
    EXPECT_NE(problem("", "    plc_designer: yes\n").find("a map with optional, reset_node"), std::string::npos);
}

TEST_F(NetworkProfileTest, ManualNetworkManagementIsAnOrder)
{
    Verifies(req::SRS_ELM_046);
    Verifies(req::SRS_ELM_047);
    // Given a slave that nothing is to be asked of: it is started at once
    const std::string file =
        File("net.yaml", "name: n\nmanager:\n  node: 127\n  profile: el6751\nslaves:\n  - node: 5\n"
                         "    el6751: {check_device_type: false}\n");
    LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    std::vector<std::string> commands;
    runtime::ManagerStation station(
        net,
        [&commands](const CanFrame& frame)
        {
            if (frame.identifier == 0U)
            {
                commands.push_back(std::to_string(frame.data[0]) + " " + std::to_string(frame.data[1]));
            }
            return true;
        },
        [](const runtime::ManagerEvent&) {});
    station.Begin(0U);
    for (std::uint64_t us = 1000U; us <= 5000U; us += 1000U)
    {
        station.OnCycle(us);
    }
    EXPECT_EQ(commands, (std::vector<std::string>{"130 0", "1 5", "1 0"}));
    // When it is made PRE-OPERATIONAL, started, and what the table does not have is asked for
    EXPECT_EQ(station.Carry(runtime::ParseManagerOrder("control 5 5 0"), 6000U), "taken");
    EXPECT_NE(station.Carry(runtime::ParseManagerOrder("control 5 5 3"), 7000U), "taken");
    EXPECT_EQ(station.Carry(runtime::ParseManagerOrder("control 5 5 1"), 8000U), "taken");
    EXPECT_NE(station.Carry(runtime::ParseManagerOrder("control 6 5 1"), 9000U), "taken");
    EXPECT_EQ(commands, (std::vector<std::string>{"130 0", "1 5", "1 0", "128 5", "1 5"}));
    for (const char* const wrong :
         {"control", "control 5 5", "control 0 5 1", "control 5 x 1", "control 5 010 1", "control 5 5 65536"})
    {
        EXPECT_EQ(runtime::ParseManagerOrder(wrong).kind, runtime::ManagerOrderKind::kProblem) << wrong;
    }
}

TEST_F(NetworkProfileTest, OutputsAreWhatRxPdosCarryAtFirst)
{
    Verifies(req::SRS_NET_002);
    Verifies(req::SRS_NET_004);
    Verifies(req::SRS_NET_342);
    const LoadedNetwork net(
        runtime::ReadNetworkFile(Net("  profile: el6751\n", "    outputs: [{pdo: 1, data: 01 FF 02}]\n"), 0U));
    const cia302::El6751Pdo& pdo = net.Setup().slaves[5].el6751->rx_pdos[0];
    ASSERT_EQ(pdo.length_bytes, 3U);
    EXPECT_EQ(std::vector<std::uint8_t>(pdo.data_bytes, pdo.data_bytes + 3U),
              (std::vector<std::uint8_t>{0x01U, 0xFFU, 0x02U}));
    for (const std::string data : {"1", "01 F", "01 GG", "00 01 02 03 04 05 06 07 08"})
    {
        const std::string file = Net("  profile: el6751\n", "    outputs: [{pdo: 1, data: " + data + "}]\n");
        try
        {
            static_cast<void>(runtime::ReadNetworkFile(file, 0U));
            ADD_FAILURE() << data;
        }
        catch (const std::exception& error)
        {
            EXPECT_EQ(error.what(), file + ":9:30: error: '" + data +
                                        "', expected 1 to 8 bytes as hexadecimal digits, such as 01 FF");
        }
    }
}

// The command line, or a scenario, may name another manager and another profile than the file.
TEST_F(NetworkProfileTest, ManagerAndProfileMayBeChosenBesideTheFile)
{
    Verifies(req::SRS_NET_002);
    const std::string file = Net("  profile: el6751\n", "");
    const network_plan::NetworkPlan plain = runtime::ReadNetworkFile(file, 0U);
    EXPECT_EQ(plain.manager.node, std::uint8_t{127U});
    EXPECT_EQ(plain.manager.profile, network_plan::StartProfile::kEl6751);
    EXPECT_FALSE(plain.manager.is_profile_chosen);
    const network_plan::NetworkPlan chosen = runtime::ReadNetworkFile(file, 100U, "plc_designer");
    EXPECT_EQ(chosen.manager.node, std::uint8_t{100U});
    EXPECT_EQ(chosen.manager.profile, network_plan::StartProfile::kPlcDesigner);
    EXPECT_TRUE(chosen.manager.is_profile_chosen);
}

TEST_F(NetworkProfileTest, WhatNoRowWritesStaysAFurtherObject)
{
    Verifies(req::SRS_ELM_212);
    Verifies(req::SRS_ELM_213);
    // Given a TPDO with an event time of its own that the DCF switches off, and no synchronous PDO
    const auto device = [this](const std::string& event)
    {
        std::string text = kDcf + Pdo("1400", "1600", "$NODEID+0x80000200", "0", "DefaultValue") +
                           Pdo("1401", "1601", "$NODEID+0x80000300", "0", "DefaultValue") +
                           Pdo("1800", "1A00", "$NODEID+0x180", event, "DefaultValue") +
                           Pdo("1801", "1A01", "$NODEID+0x80000280", "0", "DefaultValue");
        for (std::size_t type = text.find("ParameterValue=1\n"); type != std::string::npos;
             type = text.find("ParameterValue=1\n"))
        {
            text.replace(type, 16U, "ParameterValue=255");
        }
        static_cast<void>(File("io.dcf", text));
        const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", ""), 0U));
        EXPECT_FALSE(cia302::NeedsSync(net.Setup()));
        const std::vector<std::uint32_t> keys = Keys(net.Setup().slaves[5].concise_dcf);
        return std::vector<std::uint32_t>(keys.begin() + 8, keys.end()); // Behind RPDO 1 and 2, which are off.
    };
    // Then its whole sequence is kept, and 1006h
    EXPECT_EQ(device("0\nDefaultValue=20"),
              (std::vector<std::uint32_t>{0x180001U, 0x180002U, 0x180005U, 0x180001U, 0x180101U, 0x180102U, 0x180105U,
                                          0x180101U, 0x100600U, 0x200000U}));
    // A time that is 0 by default, or that a row writes, needs none
    const std::vector<std::uint32_t> rest{0x180101U, 0x180102U, 0x180105U, 0x180101U, 0x100600U, 0x200000U};
    EXPECT_EQ(device("0\nDefaultValue=0"), rest);
    EXPECT_EQ(device("0"), rest);
    EXPECT_EQ(device("20\nDefaultValue=10"), rest);
}

TEST_F(NetworkProfileTest, OtherConsumersOfTheSlaveAreKept)
{
    Verifies(req::SRS_ELM_213);
    // Given consumers 1 to 3 of a device: node 9, node 10 and the manager
    std::string text = kDcf;
    const std::size_t pdos = text.find("3=0x1400");
    text.erase(pdos, text.find("[ManufacturerObjects]") - pdos);
    text.replace(text.find("SupportedObjects=11\n"), 20U, "SupportedObjects=3\n");
    text.replace(text.find("11=0x1016"), 9U, "3=0x1016");
    text.replace(text.find("SubNumber=2"), 11U, "SubNumber=4");
    const std::size_t entry = text.find("[1016sub1]");
    const std::size_t end = text.find("[1017]");
    text.erase(entry, end - entry);
    for (const char* const sub :
         {"3]\nParameterValue=0x7F0190", "2]\nParameterValue=0x0A0190", "1]\nParameterValue=0x090190"})
    {
        text.insert(entry, "[1016sub" + std::string(sub) + "\nParameterName=x\nDataType=0x0007\nAccessType=rw\n");
    }
    static_cast<void>(File("io.dcf", text));
    const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n  heartbeat: 100 ms\n", ""), 0U));
    EXPECT_EQ(Keys(net.Setup().slaves[5].concise_dcf), (std::vector<std::uint32_t>{0x100600U, 0x101602U, 0x200000U}));
    ASSERT_EQ(net.Warnings().size(), 1U);
    EXPECT_NE(net.Warnings()[0].find(
                  ":8:5: warning: node 5 watches node 9 by 1016h:01, where the profile writes the manager, "
                  "expected it at another sub-index"),
              std::string::npos)
        << net.Warnings()[0];
}

TEST_F(NetworkProfileTest, TheGuardTimeIsThePeriodOfTheHeartbeat)
{
    Verifies(req::SRS_ELM_210);
    Verifies(req::SRS_ELM_214);
    // By its own keys or by 1F81h, whatever 1017h of the DCF says
    for (const char* const slave : {"    guard_time: 20 ms\n    retry_factor: 4\n", "    assignment: 0x0014040D\n"})
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", slave), 0U));
        const cia302::SlaveSetup& setup = net.Setup().slaves[5];
        EXPECT_EQ(setup.el6751->guard_time_ms, 20U) << slave;
        EXPECT_EQ(setup.el6751->life_time_factor, 4U) << slave;
        EXPECT_EQ(setup.heartbeat.producer_ms, 20U) << slave;
    }
}

TEST_F(NetworkProfileTest, APdoOf29BitsIsRefused)
{
    Verifies(req::SRS_ELM_215);
    const std::string dcf = File("io.dcf", kDcf + Pdo("1400", "1600", "$NODEID+0x20000200", "0", "DefaultValue") +
                                               Pdo("1401", "1601", "$NODEID+0x80000300", "0", "DefaultValue") +
                                               Pdo("1800", "1A00", "$NODEID+0xA0000180", "20", "DefaultValue") +
                                               Pdo("1801", "1A01", "$NODEID+0x80000280", "0", "DefaultValue"));
    try
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(Net("  profile: el6751\n", ""), 0U));
        ADD_FAILURE() << "accepted";
    }
    catch (const std::exception& error)
    {
        EXPECT_EQ(std::string(error.what()),
                  dcf +
                      ":75:16: error: 0x1400:01 is 0x20000205, a PDO with an identifier of 29 bits, expected one of 11 "
                      "bits (bit 29 is 0)");
    }
}

TEST_F(NetworkProfileTest, ASlaveThatHardlyWaitsForTheManagersHeartbeatIsTold)
{
    Verifies(req::SRS_NET_153);
    const auto warnings = [this](const std::string& manager, const std::string& slave)
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(Net(manager, slave), 0U));
        std::string text;
        for (const std::string& warning : net.Warnings())
        {
            text += warning.substr(warning.find(".yaml:") + 6U) + "\n";
        }
        return text;
    };
    // 100 ms x 2 as of the DCF; 1.5 times the period is enough
    EXPECT_EQ(warnings("  profile: el6751\n  heartbeat: 200 ms\n", ""),
              "8:5: warning: node 5 watches the manager for 200 ms, whose heartbeat comes every 200 ms, expected at "
              "least 300 ms, "
              "or a shorter heartbeat under manager\n");
    EXPECT_EQ(warnings("  profile: el6751\n  heartbeat: 134 ms\n", ""),
              "8:5: warning: node 5 watches the manager for 200 ms, whose heartbeat comes every 134 ms, expected at "
              "least 201 ms, "
              "or a shorter heartbeat under manager\n");
    EXPECT_EQ(warnings("  profile: el6751\n  heartbeat: 133 ms\n", ""), "");
    EXPECT_EQ(
        warnings("  profile: el6751\n", ""),
        "7:5: warning: node 5 watches the manager for 200 ms, and the manager sends no heartbeat, expected one under "
        "manager\n");
    // Under another profile what 1016h of the DCF says of this manager, not of another node
    const auto device = [this](const std::string& consumer)
    {
        std::string text = kDcf;
        const std::string usual = "ParameterName=Entry\nDataType=0x0007\nAccessType=rw\nDefaultValue=0\n";
        text.replace(text.find(usual), usual.size(), usual + "ParameterValue=" + consumer + "\n");
        const std::size_t pdos = text.find("3=0x1400");
        text.erase(pdos, text.find("[ManufacturerObjects]") - pdos);
        text.replace(text.find("SupportedObjects=11\n"), 20U, "SupportedObjects=3\n");
        text.replace(text.find("11=0x1016"), 9U, "3=0x1016");
        static_cast<void>(File("io.dcf", text));
    };
    device("0x7F0064");
    EXPECT_EQ(warnings("  heartbeat: 90 ms\n", ""), "3:3: warning: sync has no effect with the profile cia302\n"
                                                    "7:5: warning: node 5 watches the manager for 100 ms, whose "
                                                    "heartbeat comes every 90 ms, expected at least 135 ms, "
                                                    "or a shorter heartbeat under manager\n");
    device("0x7E0064");
    EXPECT_EQ(warnings("  heartbeat: 90 ms\n", ""), "3:3: warning: sync has no effect with the profile cia302\n");
}

TEST_F(NetworkProfileTest, ATimeThatTheEl6751RowsCannotHoldIsTold)
{
    Verifies(req::SRS_NET_230);
    const auto warnings = [this](const std::string& profile, const std::string& slave)
    {
        const LoadedNetwork net(
            runtime::ReadNetworkFile(Net("  profile: " + profile + "\n  heartbeat: 10 ms\n", slave), 0U));
        std::string text;
        for (const std::string& warning : net.Warnings())
        {
            text += warning.substr(warning.find(".yaml:") + 6U) + "\n";
        }
        return text;
    };
    // 60 s of a heartbeat each 100 ms: 600 of them, and the life time factor holds 255
    EXPECT_EQ(
        warnings("el6751", "    consumer: 60 s\n"),
        "8:5: warning: node 5 is lost after 25500 ms without a heartbeat (100 ms x life time factor 255, 65535 ms "
        "at most), and not after 60000 ms, expected no longer time than that, or a longer heartbeat\n");
    EXPECT_EQ(warnings("el6751", "    consumer: 25501 ms\n").find("8:5: warning: node 5 is lost after 25500 ms"), 0U);
    EXPECT_EQ(warnings("el6751", "    consumer: 25500 ms\n"), "");
    EXPECT_EQ(warnings("el6751", "    heartbeat: 240 ms\n    consumer: 60 s\n"), "");
    // 1 s x 66: 1016h holds 65535 ms
    EXPECT_EQ(
        warnings("el6751", "    guard_time: 1 s\n    retry_factor: 66\n"),
        "8:5: warning: node 5 is lost after 65535 ms without a heartbeat (1000 ms x life time factor 66, 65535 ms "
        "at most), and not after 66000 ms, expected no longer time than that, or a longer heartbeat\n");
    EXPECT_EQ(warnings("el6751", "    guard_time: 1 s\n    retry_factor: 65\n"), "");
    EXPECT_EQ(warnings("el6751", "    assignment: 0x03E8420D\n").find("8:5: warning: node 5 is lost after 65535 ms"),
              0U);
    // Who is not watched by the rows, and another profile
    EXPECT_EQ(warnings("el6751", "    heartbeat: 0 ms\n    consumer: 0 ms\n"), "");
    EXPECT_EQ(warnings("cia302", "    consumer: 60 s\n"), "3:3: warning: sync has no effect with the profile cia302\n");
}

TEST_F(NetworkProfileTest, ASyncThatTakesTheBusIsTold)
{
    Verifies(req::SRS_NET_232);
    const auto warnings = [this](const std::string& identifier, const std::string& period)
    {
        std::string text = kDcf;
        const std::size_t pdos = text.find("3=0x1400");
        text.erase(pdos, text.find("[ManufacturerObjects]") - pdos);
        text.replace(text.find("SupportedObjects=11\n"), 20U, "SupportedObjects=4\n");
        text.replace(text.find("11=0x1016"), 9U, "3=0x1016\n4=0x1005");
        text.replace(text.find("ParameterValue=9999"), 19U, "ParameterValue=" + period);
        static_cast<void>(File("io.dcf", text + "[1005]\nParameterName=SYNC\nDataType=0x0007\nAccessType=rw\n" +
                                             "ParameterValue=" + identifier + "\n"));
        const LoadedNetwork net(
            runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, dcf: io.dcf}]\n"), 0U));
        std::string all;
        for (const std::string& warning : net.Warnings())
        {
            all += warning.substr(warning.find("io.dcf:")) + "\n";
        }
        return all;
    };
    EXPECT_EQ(warnings("0x40000080", "1"),
              "io.dcf:28:16: warning: 0x1006:00: SYNC of node 5 each 1 us takes the bus (47 us a frame at 1 Mbit/s), "
              "expected 0, or a period that leaves room for others\n");
    EXPECT_EQ(warnings("0x40000080", "93").find("io.dcf:28:16: warning: 0x1006:00: SYNC of node 5 each 93 us"), 0U);
    EXPECT_EQ(warnings("0x40000080", "94"), "");
    EXPECT_EQ(warnings("0x40000080", "0"), "");
    EXPECT_EQ(warnings("0x80", "1"), ""); // It produces none.
}

} // namespace
} // namespace counterpoint::tools
