// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What a person should know before a network starts.
#include "tests/canopen/network_plan/plan_rig.hpp"

#include <optional>

namespace counterpoint::network_plan
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using test::Entry;
using test::Number;
using test::PlanTest;
using test::Record;
using Texts = std::vector<std::string>;

const std::string kHead = "[DeviceInfo]\nVendorName=test\n\n";

class NetworkWarningsTest : public PlanTest
{
  protected:
    /// The actuator of the example, node 33, as its file is changed.
    [[nodiscard]] NetworkPlan Relay(const std::string& text) const
    {
        NetworkPlan plan = PlanOf("");
        plan.slaves.clear();
        plan.slaves.push_back(SlaveOf(33U, text));
        return plan;
    }
    /// What is told of it behind the name of its file and "LINE:COLUMN: warning: ".
    [[nodiscard]] Texts ToldOf(const NetworkPlan& plan) const
    {
        Texts told;
        for (const std::string& warning : WarningsOf(plan))
        {
            told.push_back(warning.substr(warning.find("warning: ") + 9U));
        }
        return told;
    }
    [[nodiscard]] static std::string With(const std::string& section, const std::string& from, const std::string& to)
    {
        std::string text = ExampleText("actuator");
        const std::size_t place = text.find(from, text.find("[" + section + "]"));
        return text.replace(place, from.size(), to);
    }
};

TEST_F(NetworkWarningsTest, AFileThatIsNotWrittenIsTold)
{
    Verifies(req::SRS_MGR_323);
    const auto told = [this](const std::string& access, const std::string& keys)
    { return ToldOf(PlanOf(kHead + Entry("2000", 15, access, keys))); };
    EXPECT_EQ(
        told("rw", "DownloadFile=table.bin"),
        Texts{"0x2000:00: 'table.bin' is not written to node 5, expected ParameterValue, or a tool that downloads "
              "files"});
    EXPECT_EQ(told("rw", "DownloadFile="), Texts{});
    EXPECT_EQ(told("rw", "UploadFile=table.bin"), Texts{});
    EXPECT_EQ(told("ro", "DownloadFile=table.bin"), Texts{});
    EXPECT_EQ(told("rw", "DownloadFile=table.bin\nObjFlags=1"), Texts{});
}

TEST_F(NetworkWarningsTest, OneStartForAllIsAskedForWithoutASafetySlave)
{
    Verifies(req::SRS_NET_150);
    NetworkPlan plan = PlanOf("");
    plan.manager.start_up = 0x3U;
    EXPECT_EQ(ToldOf(plan), Texts{});
    plan = Relay(ExampleText("actuator"));
    plan.manager.start_up = 0x3U;
    EXPECT_EQ(
        ToldOf(plan),
        Texts{"one start for all is asked for (1F80h bit 1), and there is a safety slave: each slave is started by "
              "itself after its verification"});
}

TEST_F(NetworkWarningsTest, AConfigurationThatNobodyDeclaresValid)
{
    Verifies(req::SRS_NET_151);
    const std::string text = With("13FE", "ParameterValue=0xA5", "ParameterValue=0x00");
    NetworkPlan plan = Relay(text);
    EXPECT_EQ(ToldOf(plan),
              Texts{"0x13FE:00: 0x00 keeps node 33 from being started until somebody declares its configuration valid, "
                    "expected 0xA5, or write_safety: true in the network file"});
    plan.slaves[0].writes_safety = true;
    EXPECT_EQ(ToldOf(plan), Texts{});
}

TEST_F(NetworkWarningsTest, EmergenciesThatNobodyHears)
{
    Verifies(req::SRS_NET_151);
    EXPECT_EQ(
        ToldOf(Relay(With("1014", "$NODEID+0x80", "0x800000A1"))),
        Texts{"0x1014:00: 0x800000A1 switches off the emergencies of node 33, which counts as good in its safe state, "
              "expected an identifier without bit 31"});
    EXPECT_EQ(
        ToldOf(Relay(With("1014", "$NODEID+0x80", "0x200000A1"))),
        Texts{"0x1014:00: 0x200000A1: the emergencies of node 33 are not heard, and it counts as good in its safe "
              "state, expected 0x001 to 0x7FF"});
    EXPECT_EQ(ToldOf(Relay(With("1014", "$NODEID+0x80", "0x7FF"))), Texts{});
}

TEST_F(NetworkWarningsTest, RoomForMoreSignaturesThanTheFileHasSrdos)
{
    Verifies(req::SRS_NET_151);
    EXPECT_EQ(ToldOf(Relay(With("13FFsub0", "DefaultValue=1", "DefaultValue=2"))),
              Texts{"0x13FF:00: room for 2 signatures, and the highest SRDO of the file is 1: what node 33 has in the "
                    "others is not read, expected them in the file"});
}

// The identifier of 1014h, else 80h + node-ID; above 7FFh nobody hears either.
TEST_F(NetworkWarningsTest, EmergenciesOfTwoSlavesWithOneIdentifier)
{
    Verifies(req::SRS_NET_151);
    NetworkPlan plan = PlanOf(kHead + Number("1014", "0x86"));
    plan.slaves.push_back(SlaveOf(6U, ""));
    EXPECT_EQ(
        WarningsOf(plan),
        Texts{Path("slave5.dcf") +
              ":9:16: warning: 0x1014:00: 0x086 of node 5 is that of node 6, too (net.yaml:2:1): whose emergencies "
              "come with it is not known, expected one for each"});
    plan = PlanOf(kHead + Number("1014", "0x85"));
    plan.slaves.push_back(SlaveOf(6U, ""));
    EXPECT_EQ(WarningsOf(plan), Texts{});
    plan = PlanOf(kHead + Number("1014", "0x20000085"));
    plan.slaves.push_back(SlaveOf(6U, kHead + Number("1014", "0x20000085")));
    EXPECT_EQ(WarningsOf(plan), Texts{});
}

// Who watches the manager, by 1016h of its DCF or by the rows of the EL6751 profile, needs a heartbeat that is short
// enough.
TEST_F(NetworkWarningsTest, ASlaveThatWatchesTheManager)
{
    Verifies(req::SRS_NET_153);
    const auto watches = [this](const std::string& entry, const std::uint16_t heartbeat_ms)
    {
        NetworkPlan plan = PlanOf(kHead + Record("1016", 2) + entry);
        plan.manager.heartbeat_ms = heartbeat_ms;
        return ToldOf(plan);
    };
    const std::string manager = Number("1016sub1", "0x007F00C8");
    EXPECT_EQ(watches(manager, 0U), Texts{"node 5 watches the manager for 200 ms, and the manager sends no heartbeat, "
                                          "expected one under manager"});
    EXPECT_EQ(watches(manager, 133U), Texts{});
    EXPECT_EQ(watches(manager, 134U),
              Texts{"node 5 watches the manager for 200 ms, whose heartbeat comes every 134 ms, "
                    "expected at least 201 ms, or a shorter heartbeat under manager"});
    // Another node, and an entry that is none
    EXPECT_EQ(watches(Number("1016sub1", "0x000900C8"), 0U), Texts{});
    EXPECT_EQ(watches(Entry("1016sub1", 6, "rw", "ParameterValue=200"), 0U), Texts{});
}

TEST_F(NetworkWarningsTest, ASlaveThatWatchesAnotherNodeByTheRowOfTheManager)
{
    Verifies(req::SRS_NET_510);
    const auto told = [this](const std::string& first, const std::string& producer)
    {
        NetworkPlan plan = PlanOf(kHead + producer + Record("1016", 2) + Number("1016sub1", first));
        plan.manager.profile = StartProfile::kEl6751;
        plan.manager.heartbeat_ms = std::uint16_t{100U};
        plan.slaves[0].guard_ms = std::uint16_t{200U};
        plan.slaves[0].retry_factor = std::uint8_t{2U};
        return ToldOf(plan);
    };
    const std::string heartbeat = Entry("1017", 6, "rw", "DefaultValue=0");
    EXPECT_EQ(told("0x007F00C8", heartbeat), Texts{});
    EXPECT_EQ(told("0x000900C8", heartbeat), Texts{"node 5 watches node 9 by 1016h:01, where the profile writes the "
                                                   "manager, expected it at another sub-index"});
    // Without 1017h it is guarded, and watches nobody
    EXPECT_EQ(told("0x007F00C8", ""), Texts{});
}

// Keys of another profile are told, but where a scenario has chosen the profile.
TEST_F(NetworkWarningsTest, KeysOfAnotherProfile)
{
    Verifies(req::SRS_NET_006);
    NetworkPlan plan = PlanOf("");
    plan.manager.sync_us = 10000U;
    EXPECT_EQ(ToldOf(plan), Texts{"sync has no effect with the profile cia302"});
    plan.manager.is_profile_chosen = true;
    EXPECT_EQ(ToldOf(plan), Texts{});
}

// Masters that no file tells more of are watched for the watch time.
TEST_F(NetworkWarningsTest, AWatchTimeThatIsNotAboveTheHeartbeat)
{
    Verifies(req::SRS_NET_006);
    NetworkPlan plan = PlanOf("");
    plan.manager.heartbeat_ms = std::uint16_t{60000U};
    plan.manager.flying = FlyingPlan{};
    plan.manager.flying->node_slot_ms = std::uint16_t{0U};
    plan.manager.flying->options.watch = cia302::MasterWatch::kInstalled;
    plan.manager.flying->options.watch_ms = 200U;
    const Texts told{
        "watch_time 200 ms for masters with a heartbeat each 60000 ms as this one: their standbys lose them "
        "again and again, expected a longer one"};
    EXPECT_EQ(ToldOf(plan), told);
    // One of several is enough
    plan.slaves.push_back(SlaveOf(6U, ""));
    EXPECT_EQ(ToldOf(plan), told);
    // A slave with a DCF is no master, nor is one whose heartbeat is awaited
    plan.slaves = {SlaveOf(5U, kHead + Number("2000", "1"))};
    EXPECT_EQ(ToldOf(plan), Texts{});
    plan.slaves = {SlaveOf(5U, "")};
    plan.slaves[0].consumer_ms = std::uint16_t{100U};
    EXPECT_EQ(ToldOf(plan), Texts{});
}

class RowTimesTest : public NetworkWarningsTest
{
  protected:
    /// Of node 5 without a DCF, as it is supervised under the profile.
    [[nodiscard]] Texts Told(const StartProfile profile, const SlavePlan& supervised) const
    {
        NetworkPlan plan = PlanOf("");
        plan.manager.profile = profile;
        plan.manager.heartbeat_ms = std::uint16_t{10U};
        const SlavePlan one = plan.slaves[0];
        plan.slaves[0] = supervised;
        plan.slaves[0].node = one.node;
        plan.slaves[0].place = one.place;
        return ToldOf(plan);
    }
    [[nodiscard]] static SlavePlan Times(const std::optional<std::uint16_t> heartbeat,
                                         const std::optional<std::uint16_t> consumer, const bool is_guarded = false)
    {
        SlavePlan slave;
        slave.heartbeat_ms = heartbeat;
        slave.consumer_ms = consumer;
        slave.guard_ms = is_guarded ? std::optional<std::uint16_t>(100U) : std::nullopt;
        slave.retry_factor = is_guarded ? std::optional<std::uint8_t>(3U) : std::nullopt;
        return slave;
    }
};

// The rows count heartbeats: 400 ms of one each 300 ms are two of them.
TEST_F(RowTimesTest, ASlaveThatIsLostLaterThanAskedForIsTold)
{
    Verifies(req::SRS_NET_751);
    const auto told = [this](const std::uint16_t heartbeat, const std::uint16_t consumer)
    { return Told(StartProfile::kEl6751, Times(heartbeat, consumer)); };
    EXPECT_EQ(told(300U, 400U), Texts{"node 5 is lost after 600 ms without a heartbeat (300 ms x life time factor 2, "
                                      "65535 ms at most), and not after 400 ms, expected a multiple of its heartbeat"});
    EXPECT_EQ(told(100U, 301U), Texts{"node 5 is lost after 400 ms without a heartbeat (100 ms x life time factor 4, "
                                      "65535 ms at most), and not after 301 ms, expected a multiple of its heartbeat"});
    EXPECT_EQ(told(100U, 300U), Texts{});
    // The usual time is twice the heartbeat
    EXPECT_EQ(Told(StartProfile::kEl6751, Times(std::uint16_t{300U}, std::nullopt)), Texts{});
    // Another profile has the time as it is
    EXPECT_EQ(Told(StartProfile::kCia302, Times(std::uint16_t{300U}, std::uint16_t{400U})), Texts{});
    EXPECT_EQ(Told(StartProfile::kPlcDesigner, Times(std::uint16_t{300U}, std::uint16_t{400U})), Texts{});
}

TEST_F(RowTimesTest, HeartbeatAndConsumerBesideAGuardTimeAreTold)
{
    Verifies(req::SRS_NET_006);
    Verifies(req::SRS_NET_752);
    const auto told = [this](const std::optional<std::uint16_t> heartbeat, const std::optional<std::uint16_t> consumer)
    { return Told(StartProfile::kEl6751, Times(heartbeat, consumer, true)); };
    const std::string consumer =
        "consumer has no effect with the profile el6751: node 5 is lost after 300 ms without "
        "a heartbeat (100 ms x life time factor 3, 65535 ms at most), expected that time, or no "
        "such key";
    const std::string heartbeat = "heartbeat has no effect beside guard_time with the profile el6751: node 5 is told "
                                  "to send one each 100 ms, expected that, or no such key";
    EXPECT_EQ(told(std::nullopt, std::uint16_t{2000U}), Texts{consumer});
    EXPECT_EQ(told(std::nullopt, std::uint16_t{0U}), Texts{consumer});
    EXPECT_EQ(told(std::uint16_t{500U}, std::nullopt), Texts{heartbeat});
    EXPECT_EQ(told(std::uint16_t{500U}, std::uint16_t{2000U}), (Texts{heartbeat, consumer}));
    EXPECT_EQ(told(std::uint16_t{0U}, std::uint16_t{2000U}), (Texts{heartbeat, consumer}));
    // What says the same
    EXPECT_EQ(told(std::uint16_t{100U}, std::uint16_t{300U}), Texts{});
    EXPECT_EQ(told(std::nullopt, std::nullopt), Texts{});
    // No supervision is asked for, and the rows have one
    EXPECT_EQ(Told(StartProfile::kEl6751, Times(std::uint16_t{100U}, std::uint16_t{0U})),
              Texts{"consumer has no effect with the profile el6751: node 5 is lost after 100 ms without a heartbeat "
                    "(100 ms x life time factor 1, 65535 ms at most), expected that time, or no such key"});
    // No rows: the heartbeat is supervised as it is told
    EXPECT_EQ(Told(StartProfile::kEl6751, Times(std::nullopt, std::uint16_t{400U})), Texts{});
}

TEST_F(RowTimesTest, WhenSilenceCountsIsNoMatterOfTheRows)
{
    Verifies(req::SRS_NET_006);
    const Texts told{"arming has no effect with the profile el6751"};
    for (const cia302::Arming arming :
         {cia302::Arming::kFirstHeartbeat, cia302::Arming::kBootUp, cia302::Arming::kImmediately})
    {
        SlavePlan slave = Times(std::uint16_t{100U}, std::uint16_t{400U});
        slave.arming = arming;
        EXPECT_EQ(Told(StartProfile::kEl6751, slave), told);
        EXPECT_EQ(Told(StartProfile::kCia302, slave), Texts{});
        EXPECT_EQ(Told(StartProfile::kPlcDesigner, slave), Texts{});
        // Without rows it counts
        slave.heartbeat_ms = std::nullopt;
        EXPECT_EQ(Told(StartProfile::kEl6751, slave), Texts{});
    }
    // So it does for a slave that may lead the network
    NetworkPlan plan = PlanOf("");
    plan.manager.profile = StartProfile::kEl6751;
    plan.manager.heartbeat_ms = std::uint16_t{10U};
    plan.slaves[0].heartbeat_ms = std::uint16_t{100U};
    plan.slaves[0].arming = cia302::Arming::kImmediately;
    EXPECT_EQ(ToldOf(plan), told);
    plan.manager.flying = FlyingPlan{};
    EXPECT_EQ(ToldOf(plan), Texts{});
}

TEST_F(RowTimesTest, DateAndTimeOfAProfileThatDoesNotReadThem)
{
    Verifies(req::SRS_NET_006);
    SlavePlan slave;
    slave.date = 5U;
    slave.time = 7U;
    EXPECT_EQ(Told(StartProfile::kCia302, slave), Texts{});
    EXPECT_EQ(Told(StartProfile::kEl6751, slave),
              (Texts{"date has no effect with the profile el6751", "time has no effect with the profile el6751"}));
    EXPECT_EQ(Told(StartProfile::kPlcDesigner, slave), (Texts{"date has no effect with the profile plc_designer",
                                                              "time has no effect with the profile plc_designer"}));
    slave.date = 0U;
    slave.time = 0U;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), Texts{});
}

TEST_F(RowTimesTest, KeysOfABusCouplerAtAnotherDevice)
{
    Verifies(req::SRS_NET_006);
    const Texts told{"node 5 is no bus coupler: coupler_pdos, coupler_inhibit and coupler_event have no effect, "
                     "expected kind: bk51x0, or none of them"};
    SlavePlan slave;
    slave.coupler_pdos = 0U;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), Texts{});
    slave.coupler_pdos = 2U;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), told);
    slave = SlavePlan{};
    slave.el6751 = cia302::El6751Slave{};
    slave.el6751->coupler_inhibit_100us = 1U;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), told);
    EXPECT_EQ(Told(StartProfile::kCia302, slave), Texts{"el6751 has no effect with the profile cia302"});
    slave.el6751->kind = cia302::El6751Kind::kBusCoupler;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), Texts{});
    slave.el6751 = cia302::El6751Slave{};
    slave.el6751->coupler_event_ms = 1U;
    EXPECT_EQ(Told(StartProfile::kEl6751, slave), told);
}
} // namespace
} // namespace counterpoint::network_plan
