// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the EL6751 profile makes of a DCF where it and the rows of the text do not fit together.
#include "tests/runtime/network_files/profile_rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::tools
{
namespace
{

TEST_F(NetworkProfileTest, WhatNoRowWritesStaysAFurtherObject)
{
    Verifies(req::SRS_ELM_051);
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
    Verifies(req::SRS_ELM_051);
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
    EXPECT_NE(net.Warnings()[0].find(":8: node 5 watches node 9 by 1016h:01, where the profile writes the manager, "
                                     "expected it at another sub-index"),
              std::string::npos)
        << net.Warnings()[0];
}

TEST_F(NetworkProfileTest, TheGuardTimeIsThePeriodOfTheHeartbeat)
{
    Verifies(req::SRS_ELM_051);
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
    Verifies(req::SRS_ELM_051);
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
                  dcf + ":75: error: 0x1400:01 is 0x20000205, a PDO with an identifier of 29 bits, expected one of 11 "
                        "bits (bit 29 is 0)");
    }
}

TEST_F(NetworkProfileTest, ASlaveThatHardlyWaitsForTheManagersHeartbeatIsTold)
{
    Verifies(req::SRS_NET_006);
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
              "8: node 5 watches the manager for 200 ms, whose heartbeat comes every 200 ms, expected at least 300 ms, "
              "or a shorter heartbeat under manager\n");
    EXPECT_EQ(warnings("  profile: el6751\n  heartbeat: 134 ms\n", ""),
              "8: node 5 watches the manager for 200 ms, whose heartbeat comes every 134 ms, expected at least 201 ms, "
              "or a shorter heartbeat under manager\n");
    EXPECT_EQ(warnings("  profile: el6751\n  heartbeat: 133 ms\n", ""), "");
    EXPECT_EQ(warnings("  profile: el6751\n", ""),
              "7: node 5 watches the manager for 200 ms, and the manager sends no heartbeat, expected one under "
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
    EXPECT_EQ(warnings("  heartbeat: 90 ms\n", ""),
              "3: sync has no effect with the profile cia302\n"
              "7: node 5 watches the manager for 100 ms, whose heartbeat comes every 90 ms, expected at least 135 ms, "
              "or a shorter heartbeat under manager\n");
    device("0x7E0064");
    EXPECT_EQ(warnings("  heartbeat: 90 ms\n", ""), "3: sync has no effect with the profile cia302\n");
}

} // namespace
} // namespace counterpoint::tools
