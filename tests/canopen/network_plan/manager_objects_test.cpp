// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the manager's own DCF says, and where the network file goes before it; concise DCFs that are replaced.
#include "tests/canopen/network_plan/plan_rig.hpp"

namespace counterpoint::network_plan
{
namespace
{
using test::Entry;
using test::Number;
using test::PlanTest;
using test::Record;

cia306::Device ManagerOf(const std::string& text)
{
    return cia306::test::DeviceOf("[DeviceInfo]\nVendorName=test\n\n" + text);
}

class ManagerObjectsTest : public PlanTest
{
  protected:
    NetworkPlan plan{PlanOf("")};
};

TEST_F(ManagerObjectsTest, TheNetworkFileGoesBeforeThem)
{
    Verifies(req::SRS_NET_341);
    const cia306::Device device = ManagerOf(Number("1F80", "0x21") + Record("1F81", 2) + Number("1F81sub5", "0x4") +
                                            Record("1016", 2) + Number("1016sub1", "0x000500C8") + Record("1F90", 4) +
                                            Entry("1F90sub3", 6, "rw", "ParameterValue=2"));
    plan.manager.start_up = 0x80U; // Neither known nor that of a master: what a person wrote is not judged here.
    plan.manager.flying = FlyingPlan{};
    plan.manager.flying->priority = std::uint16_t{1U};
    plan.slaves[0].assignment = 0x4U;
    plan.slaves[0].consumer_ms = std::uint16_t{77U};
    TakeManagerObjects(device, plan);
    EXPECT_EQ(plan.manager.start_up, 0x80U);
    EXPECT_EQ(plan.manager.flying->priority, std::uint16_t{1U});
    EXPECT_EQ(plan.slaves[0].assignment, 0x4U);
    EXPECT_EQ(plan.slaves[0].consumer_ms, std::uint16_t{77U});
}

TEST_F(ManagerObjectsTest, EachOfThemGoesBeforeWhatIsDerived)
{
    Verifies(req::SRS_NET_341);
    // Given a slave whose own DCF says other numbers
    plan = PlanOf("[DeviceInfo]\nVendorName=test\n\n" + Number("1000", "0x191") + Record("1018", 5) +
                  Number("1018sub1", "1") + Number("1018sub2", "2") + Number("1018sub3", "3") +
                  Number("1018sub4", "4") + Record("1020", 3) + Number("1020sub1", "5") + Number("1020sub2", "6") +
                  Entry("1017", 6, "rw", "ParameterValue=100"));
    {
        const LoadedNetwork network(plan);
        const cia302::SlaveSetup& derived = network.Setup().slaves[5];
        EXPECT_EQ(derived.assignment, 0x0DU);
        EXPECT_EQ(derived.device_type, 0x191U);
        EXPECT_EQ(derived.vendor_id, 1U);
        EXPECT_EQ(derived.serial_number, 4U);
        EXPECT_EQ(derived.configuration_date, 5U);
        EXPECT_EQ(derived.configuration_time, 6U);
        EXPECT_EQ(derived.heartbeat.consumer_ms, 200U);
    }
    std::string text = Number("1F80", "0x45") + Number("1F89", "7000") + Entry("102A", 6, "rw", "ParameterValue=30") +
                       Number("1006", "20000") + Entry("1017", 6, "rw", "ParameterValue=250") + Record("1016", 2) +
                       Number("1016sub1", "0x000501F4") + Record("1F8A", 2) +
                       Entry("1F8Asub5", 5, "rw", "ParameterValue=1");
    std::uint32_t value = 0x05U;
    for (const char* const index : {"1F81", "1F84", "1F85", "1F86", "1F87", "1F88", "1F26", "1F27"})
    {
        text += Record(index, 2) + Number(std::string(index) + "sub5", cia306::Hex(value, 2));
        value += 0x10U;
    }
    TakeManagerObjects(ManagerOf(text), plan);
    const LoadedNetwork network(plan);
    const cia302::NetworkSetup& setup = network.Setup();
    EXPECT_EQ(setup.start_up, 0x45U);
    EXPECT_EQ(setup.boot_time_ms, 7000U);
    EXPECT_EQ(setup.inhibit_100us, 30U);
    EXPECT_EQ(setup.sync_period_us, 20000U);
    EXPECT_EQ(network.Plan().manager.heartbeat_ms, std::uint16_t{250U});
    const cia302::SlaveSetup& slave = setup.slaves[5];
    EXPECT_EQ(slave.assignment, 0x05U);
    EXPECT_EQ(slave.device_type, 0x15U);
    EXPECT_EQ(slave.vendor_id, 0x25U);
    EXPECT_EQ(slave.product_code, 0x35U);
    EXPECT_EQ(slave.revision_number, 0x45U);
    EXPECT_EQ(slave.serial_number, 0x55U);
    EXPECT_EQ(slave.configuration_date, 0x65U);
    EXPECT_EQ(slave.configuration_time, 0x75U);
    EXPECT_EQ(slave.restore_sub, 1U);
    EXPECT_EQ(slave.heartbeat.consumer_ms, 500U);
}

// Bit 5 of 1F80h asks for a flying master; 1F90h says what the file leaves open.
TEST_F(ManagerObjectsTest, SayWhetherAndHowItIsAFlyingMaster)
{
    Verifies(req::SRS_NET_341);
    const cia306::Device device =
        ManagerOf(Number("1F80", "0x21") + Record("1F90", 4) + Entry("1F90sub3", 6, "rw", "ParameterValue=2"));
    TakeManagerObjects(device, plan);
    ASSERT_TRUE(plan.manager.flying.has_value());
    EXPECT_EQ(plan.manager.flying->priority, std::uint16_t{2U});
    plan = PlanOf("");
    plan.manager.flying = FlyingPlan{};
    plan.manager.flying->delay_ms = std::uint16_t{50U};
    TakeManagerObjects(device, plan);
    EXPECT_EQ(plan.manager.flying->delay_ms, std::uint16_t{50U});
    EXPECT_EQ(plan.manager.flying->priority, std::uint16_t{2U});
}

// An entry without a value, and one of 1016h that names no node or no time, says nothing.
TEST_F(ManagerObjectsTest, WithoutAValueSayNothing)
{
    Verifies(req::SRS_NET_341);
    TakeManagerObjects(ManagerOf(Entry("1F89", 7, "rw", "") + Record("1016", 4) + Number("1016sub1", "0x000000C8") +
                                 Number("1016sub2", "0x00000064") + Entry("1016sub3", 7, "rw", "")),
                       plan);
    EXPECT_FALSE(plan.manager.boot_time_ms.has_value());
    EXPECT_FALSE(plan.slaves[0].consumer_ms.has_value());
}

TEST_F(ManagerObjectsTest, ANodeIdOfTheManagerIsOneFrom1To127)
{
    Verifies(req::SRS_NET_004);
    const std::string refusal = "net.yaml:1:1: error: no node-ID of the manager, expected one from 1 to 127";
    for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{128U}, std::uint8_t{255U}})
    {
        plan.manager.node = node;
        EXPECT_EQ(RefusalOf(plan), refusal) << int{node};
    }
    plan.manager.node.reset();
    EXPECT_EQ(RefusalOf(plan), refusal);
    plan.manager.node = std::uint8_t{127U};
    EXPECT_EQ(RefusalOf(plan), "");
}

// Guarding needs both times; bits that only 1F81h of the manager has are left as they are.
TEST_F(ManagerObjectsTest, HalfOfAGuardingIsRefusedWhereTheFileAsksForIt)
{
    Verifies(req::SRS_NET_004);
    plan.slaves[0].assignment = 0x00640005U;
    EXPECT_EQ(RefusalOf(plan), "");
    plan.slaves[0].retry_factor = std::uint8_t{0U};
    EXPECT_EQ(RefusalOf(plan), "");
    plan.slaves[0].guard_ms = std::uint16_t{100U};
    EXPECT_EQ(RefusalOf(plan),
              "net.yaml:2:1: error: guard time 100 ms with retry factor 0, expected both above 0, or none");
}

std::vector<std::uint8_t> ConciseOf(const LoadedNetwork& network)
{
    const cia302::Bytes& bytes = network.Setup().slaves[5].concise_dcf;
    return {bytes.data, bytes.data + bytes.size_bytes};
}

// The heartbeat of the network file takes the place of that of the DCF, and stands first where there is none.
TEST_F(ManagerObjectsTest, TheHeartbeatOfTheFileIsWritten)
{
    Verifies(req::SRS_NET_341);
    const std::string filter = Entry("2000", 5, "rw", "ParameterValue=7");
    const std::string heartbeat = Entry("1017", 6, "rw", "ParameterValue=100");
    plan = PlanOf("[DeviceInfo]\nVendorName=test\n\n" + heartbeat + filter);
    plan.slaves[0].heartbeat_ms = std::uint16_t{300U};
    EXPECT_EQ(ConciseOf(LoadedNetwork(plan)),
              (std::vector<std::uint8_t>{2U, 0U,    0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 0x2CU, 1U, //
                                         0U, 0x20U, 0U, 1U, 0U,    0U,    0U, 7U}));
    plan = PlanOf("[DeviceInfo]\nVendorName=test\n\n" + filter);
    plan.slaves[0].heartbeat_ms = std::uint16_t{300U};
    EXPECT_EQ(ConciseOf(LoadedNetwork(plan)),
              (std::vector<std::uint8_t>{2U, 0U,    0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 0x2CU, 1U, //
                                         0U, 0x20U, 0U, 1U, 0U,    0U,    0U, 7U}));
}

// Given another concise DCF, then a slave gets it, but for one that is damaged or writes the safety configuration.
TEST_F(ManagerObjectsTest, AConciseDcfIsReplacedByAWholeOne)
{
    Verifies(req::SRS_NET_341);
    plan = PlanOf("[DeviceInfo]\nVendorName=test\n\n" + Entry("2000", 5, "rw", "ParameterValue=7"));
    LoadedNetwork network(plan);
    const std::vector<std::uint8_t> before = ConciseOf(network);
    const auto replace = [&network](const std::uint8_t node, const std::vector<std::uint8_t>& bytes)
    { return network.ReplaceConcise(node, {bytes.data(), static_cast<std::uint32_t>(bytes.size())}); };
    const std::vector<std::uint8_t> other{1U, 0U, 0U, 0U, 0U, 0x20U, 0U, 1U, 0U, 0U, 0U, 9U};
    EXPECT_FALSE(replace(6U, other));
    EXPECT_FALSE(replace(5U, {1U, 0U, 0U, 0U, 0U, 0x20U}));
    for (const std::uint8_t low : {std::uint8_t{0x00U}, std::uint8_t{0xFFU}})
    {
        EXPECT_FALSE(replace(5U, {1U, 0U, 0U, 0U, low, 0x13U, 0U, 1U, 0U, 0U, 0U, 9U})) << int{low};
    }
    // Of several entries the first one is of the safety configuration, or the last one is cut
    EXPECT_FALSE(replace(5U, {2U, 0U, 0U, 0U, 0U, 0x13U, 0U, 1U, 0U, 0U, 0U, 9U, 0U, 0x20U, 0U, 1U, 0U, 0U, 0U, 9U}));
    EXPECT_FALSE(replace(5U, {2U, 0U, 0U, 0U, 0U, 0x20U, 0U, 1U, 0U, 0U, 0U, 9U, 0U, 0x20U}));
    EXPECT_EQ(ConciseOf(network), before);
    EXPECT_TRUE(replace(5U, other));
    EXPECT_EQ(ConciseOf(network), other);
    EXPECT_TRUE(replace(5U, {1U, 0U, 0U, 0U, 0xFFU, 0x12U, 0U, 1U, 0U, 0U, 0U, 9U}));
    EXPECT_TRUE(replace(5U, {1U, 0U, 0U, 0U, 0x00U, 0x14U, 0U, 1U, 0U, 0U, 0U, 9U}));
    // It reads as before where it is asked for by its node
    EXPECT_EQ(network.Find(5U)->plan.node, 5U);
    EXPECT_EQ(network.Find(6U), nullptr);
}
} // namespace
} // namespace counterpoint::network_plan
