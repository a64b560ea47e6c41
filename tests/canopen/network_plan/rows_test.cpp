// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The EL6751 profile: PDOs, outputs, and what its rows write in place of the concise DCF.
#include "canopen/cia302/network/concise_dcf.hpp"
#include "tests/canopen/network_plan/plan_rig.hpp"

namespace counterpoint::network_plan
{
namespace
{
using test::Entry;
using test::Number;
using test::PlanTest;
using test::Record;
using Texts = std::vector<std::string>;

const std::string kHead = "[DeviceInfo]\nVendorName=test\n\n";

/// "1800:05" for each entry of the concise DCF of node 5.
Texts KeysOf(const LoadedNetwork& network)
{
    Texts keys;
    const cia302::Bytes& bytes = network.Setup().slaves[5].concise_dcf;
    cia302::ConciseReading entry = cia302::ReadConcise(bytes, {0U, 0U});
    for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(bytes, entry.next))
    {
        keys.push_back(cia306::Hex(entry.object.index, 4).substr(2U) + ":" +
                       cia306::Hex(entry.object.sub, 2).substr(2U));
    }
    return keys;
}

/// A PDO that is on and maps a byte; `more` are further parameters of it.
std::string Pdo(const std::string& index, const std::string& mapping, const std::string& cob_id,
                const std::string& more = "")
{
    return Record(index, 6) + Number(index + "sub1", cob_id) + more + Record(mapping, 2) +
           Entry(mapping + "sub0", 5, "rw", "DefaultValue=1") +
           Entry(mapping + "sub1", 7, "rw", "DefaultValue=0x60000108");
}

class RowsTest : public PlanTest
{
  protected:
    [[nodiscard]] NetworkPlan El6751(const std::string& dcf) const
    {
        NetworkPlan plan = PlanOf(kHead + dcf);
        plan.manager.profile = StartProfile::kEl6751;
        return plan;
    }
};

// COB-ID, type, inhibit time and event time are rows; sub-index 4 and those above 5 are not.
TEST_F(RowsTest, WriteTheParametersOfPdosThatAreOn)
{
    Verifies(req::SRS_NET_003);
    const std::string more =
        Entry("1800sub2", 5, "rw", "ParameterValue=254") + Entry("1800sub3", 6, "rw", "ParameterValue=10") +
        Entry("1800sub4", 5, "rw", "ParameterValue=1") + Entry("1800sub5", 6, "rw", "ParameterValue=20") +
        Entry("1800sub6", 5, "rw", "ParameterValue=3");
    const LoadedNetwork network(El6751(Pdo("1800", "1A00", "0x185", more) + Pdo("1801", "1A01", "0x285")));
    EXPECT_EQ(KeysOf(network), (Texts{"1800:04", "1800:06"}));
    ASSERT_EQ(network.Setup().slaves[5].el6751->tx_count, 2U);
    EXPECT_EQ(network.Setup().slaves[5].el6751->tx_pdos[0].inhibit_100us, 10U);
    EXPECT_EQ(network.Setup().slaves[5].el6751->tx_pdos[0].event_ms, 20U);
    EXPECT_EQ(network.Setup().slaves[5].el6751->tx_pdos[1].cob_id, 0x285U);
}

// A PDO that is on and maps nothing is none of the profile, nor is one that is off.
TEST_F(RowsTest, AreOfPdosThatMapSomething)
{
    Verifies(req::SRS_NET_003);
    const LoadedNetwork network(El6751(Record("1800", 2) + Number("1800sub1", "0x185") + Record("1A00", 1) +
                                       Entry("1A00sub0", 5, "rw", "DefaultValue=0") +
                                       Pdo("1801", "1A01", "0x80000285")));
    EXPECT_EQ(network.Setup().slaves[5].el6751->tx_count, 0U);
    EXPECT_EQ(KeysOf(network), (Texts{"1800:01", "1800:01", "1801:01", "1801:01"}));
}

// Given a time that the device has by itself and the DCF switches off, then the whole PDO is written as it says.
TEST_F(RowsTest, LeaveAPdoWhoseTimeIsSwitchedOffToTheConciseDcf)
{
    Verifies(req::SRS_NET_003);
    const Texts whole{"1800:01", "1800:03", "1800:01"};
    const auto keys = [this](const std::string& sub, const std::string& access, const std::string& values)
    { return KeysOf(LoadedNetwork(El6751(Pdo("1800", "1A00", "0x185", Entry("1800sub" + sub, 6, access, values))))); };
    EXPECT_EQ(keys("3", "rw", "DefaultValue=5\nParameterValue=0"), whole);
    EXPECT_EQ(keys("5", "rw", "DefaultValue=5\nParameterValue=0"), (Texts{"1800:01", "1800:05", "1800:01"}));
    // It had none, it gets one, or it cannot change
    EXPECT_EQ(keys("3", "rw", "DefaultValue=0\nParameterValue=0"), Texts{});
    EXPECT_EQ(keys("3", "rw", "DefaultValue=5\nParameterValue=7"), Texts{});
    EXPECT_EQ(keys("3", "rw", "ParameterValue=0"), Texts{});
    EXPECT_EQ(keys("3", "rw", "DefaultValue=5"), Texts{});
    EXPECT_EQ(keys("3", "const", "DefaultValue=5\nParameterValue=0"), Texts{});
    // Nor has it a time of its own, or gets one, that 16 bits cannot have
    EXPECT_EQ(keys("3", "rw", "DefaultValue=70000\nParameterValue=0"), Texts{});
    EXPECT_EQ(keys("3", "rw", "DefaultValue=5\nParameterValue=70000"), Texts{});
}

// Given a mapping that the device has by itself, then it is no change of it, though the DCF says it once more.
TEST_F(RowsTest, LeaveOutAMappingThatTheDeviceHasByItself)
{
    Verifies(req::SRS_NET_480);
    const auto keys = [this](const std::string& cob_id, const std::string& count, const std::string& mapped,
                             const cia302::El6751Kind kind = cia302::El6751Kind::kGeneral)
    {
        NetworkPlan plan =
            El6751(Record("1800", 6) + Number("1800sub1", cob_id) + Entry("1800sub2", 5, "rw", "ParameterValue=254") +
                   Record("1A00", 2) + Entry("1A00sub0", 5, "rw", count) + Entry("1A00sub1", 7, "rw", mapped));
        plan.slaves[0].el6751 = cia302::El6751Slave{};
        plan.slaves[0].el6751->kind = kind;
        return KeysOf(LoadedNetwork(plan));
    };
    const Texts whole{"1800:01", "1800:02", "1A00:00", "1A00:01", "1A00:00", "1800:01"};
    const std::string one = "DefaultValue=1\nParameterValue=1";
    const std::string same = "DefaultValue=0x60000108\nParameterValue=0x60000108";
    EXPECT_EQ(keys("0x185", one, same), Texts{});
    EXPECT_EQ(keys("0x185", "DefaultValue=1", same), Texts{});
    EXPECT_EQ(keys("0x185", one, same, cia302::El6751Kind::kBusCoupler), Texts{});
    // Another object, another count, or nobody knows what the device has by itself
    EXPECT_EQ(keys("0x185", one, "DefaultValue=0x60000208\nParameterValue=0x60000108"), whole);
    EXPECT_EQ(keys("0x185", "DefaultValue=2\nParameterValue=1", same), whole);
    EXPECT_EQ(keys("0x185", one, "ParameterValue=0x60000108"), whole);
    EXPECT_EQ(keys("0x185", "DefaultValue=300\nParameterValue=1", same), whole);
    // A PDO that is off has no rows: all of it is written
    EXPECT_EQ(keys("0x80000185", one, same), whole);
}

// Guarding, heartbeat and the first consumer are rows where the slave is watched; another consumer is not.
TEST_F(RowsTest, WriteTheSupervision)
{
    Verifies(req::SRS_NET_003);
    const std::string times = Entry("100C", 6, "rw", "ParameterValue=100") +
                              Entry("100D", 5, "rw", "ParameterValue=3") +
                              Entry("1017", 6, "rw", "ParameterValue=100") + Record("1016", 4) +
                              Number("1016sub1", "0x000900C8") + Number("1016sub2", "0x007F00C8") +
                              Number("1016sub3", "0x000A00C8") + Entry("1016sub4", 6, "rw", "ParameterValue=1");
    EXPECT_EQ(KeysOf(LoadedNetwork(El6751(times))), (Texts{"1016:03", "1016:04"}));
    NetworkPlan silent = El6751(times);
    silent.slaves[0].heartbeat_ms = std::uint16_t{0U};
    EXPECT_EQ(KeysOf(LoadedNetwork(silent)),
              (Texts{"100C:00", "100D:00", "1016:01", "1016:02", "1016:03", "1016:04", "1017:00"}));
}

TEST_F(RowsTest, HaveTheOutputsOfTheFile)
{
    Verifies(req::SRS_NET_004);
    Verifies(req::SRS_NET_342);
    const std::string dcf = Pdo("1400", "1600", "0x205") + Pdo("1401", "1601", "0x305");
    NetworkPlan plan = El6751(dcf);
    plan.slaves[0].outputs = {{{7U, 3U}, 2U, {0xA5U}}};
    {
        const LoadedNetwork network(plan);
        const cia302::El6751Slave& slave = *network.Setup().slaves[5].el6751;
        ASSERT_EQ(slave.rx_count, 2U);
        EXPECT_EQ(slave.rx_pdos[0].data_bytes[0], 0U);
        EXPECT_EQ(slave.rx_pdos[1].data_bytes[0], 0xA5U);
    }
    plan.slaves[0].outputs = {{{7U, 3U}, 3U, {0xA5U}}};
    EXPECT_EQ(RefusalOf(plan),
              "net.yaml:7:3: error: no RxPDO 3 of node 5, expected one that its DCF switches on and maps");
    plan.slaves[0].outputs = {{{7U, 3U}, 1U, {1U}}, {{8U, 3U}, 1U, {1U}}};
    EXPECT_EQ(RefusalOf(plan), "net.yaml:8:3: error: RxPDO 1 of node 5 a second time, expected each RxPDO once");
    plan.slaves[0].outputs = {{{7U, 3U}, 1U, {1U, 2U}}};
    EXPECT_EQ(RefusalOf(plan), "net.yaml:7:3: error: RxPDO 1 of node 5 with 2 bytes, expected 1 as its mapping has");
    plan.slaves[0].outputs = {{{7U, 3U}, 1U, {1U}}};
    for (const StartProfile profile : {StartProfile::kCia302, StartProfile::kPlcDesigner})
    {
        plan.manager.profile = profile;
        EXPECT_EQ(RefusalOf(plan), "net.yaml:7:3: error: outputs of node 5 with another profile, expected the profile "
                                   "el6751, which sends RxPDOs");
    }
}

TEST_F(RowsTest, AreOf255PdosAtMost)
{
    Verifies(req::SRS_NET_004);
    const auto pdos = [](const std::uint32_t count)
    {
        std::string text;
        for (std::uint32_t number = 0U; number < count; ++number)
        {
            text +=
                Pdo(cia306::Hex(0x1800U + number, 4).substr(2U), cia306::Hex(0x1A00U + number, 4).substr(2U), "0x185");
        }
        return text;
    };
    EXPECT_EQ(RefusalOf(El6751(pdos(255U))), "");
    EXPECT_EQ(RefusalOf(El6751(pdos(256U))),
              Path("slave5.dcf") + ":1:1: error: 256 PDOs that are on, expected at most 255 with the EL6751 start-up");
}
} // namespace
} // namespace counterpoint::network_plan
