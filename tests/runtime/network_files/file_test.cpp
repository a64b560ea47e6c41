// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Network files: what a manager learns from them and from the DCFs they name.
#include "canopen/network_plan/loaded_network.hpp"
#include "examples/network_manager/network.hpp"
#include "runtime/network_files/file.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/ids/target.hpp"
#include "verification/trace/verifies.hpp"

#include <algorithm>

namespace counterpoint::tools
{
namespace
{
using cia306::test::Changed;
using cia306::test::ExampleText;
using network_plan::LoadedNetwork;
using network_plan::NetworkPlan;

constexpr std::uint32_t kNoValue = 0xFFFFFFFFU;

/// What is expected of an object; kNoValue: nothing.
std::uint32_t ValueOf(const cia302::SafetyExpectation& safety, const std::uint16_t index, const std::uint8_t sub)
{
    const auto* const end = safety.objects + safety.count;
    const auto* const found = std::find_if(safety.objects, end, [=](const cia302::ExpectedObject& object)
                                           { return object.address.index == index && object.address.sub == sub; });
    return (found == end) ? kNoValue : static_cast<std::uint32_t>(found->value);
}

std::string Section(const std::string& name, const std::string& type, const std::string& access,
                    const std::string& value)
{
    return "[" + name + "]\nParameterName=More\nObjectType=0x7\nDataType=" + type + "\nAccessType=" + access +
           "\nDefaultValue=" + value + "\nPDOMapping=0\n\n";
}

/// The three devices of the emergency-stop chain, the controller as manager.
class NetworkFileTest : public cia306::test::FolderTest
{
  protected:
    NetworkFileTest()
    {
        static_cast<void>(File("sensor.dcf", ExampleText("sensor")));
        static_cast<void>(File("actuator.dcf", ExampleText("actuator")));
        static_cast<void>(
            File("manager.dcf", Changed(ExampleText("controller"), {{"CANopenManager=0", "CANopenManager=1"}})));
    }
    [[nodiscard]] std::string Cpj() const
    {
        return File("net.cpj", "[Topology]\nNetName=Chain\nNodes=0x03\n"
                               "Node1Present=0x01\nNode1Name=Stop button\nNode1DCFName=sensor.dcf\n"
                               "Node2Present=0x01\nNode2Name=Controller\nNode2DCFName=.\\manager.dcf\n"
                               "Node33Present=0x01\nNode33Name=Relay\nNode33DCFName=actuator.dcf\n"
                               "Node40Present=0x00\nNode40Name=Not there\n");
    }
};

TEST_F(NetworkFileTest, ACpjNamesManagerAndSlaves)
{
    Verifies(req::SRS_NET_001);
    const NetworkPlan plan = runtime::ReadNetworkFile(Cpj(), 0U);
    EXPECT_EQ(plan.name, "Chain");
    EXPECT_EQ(plan.manager.node, std::uint8_t{2U});
    ASSERT_EQ(plan.slaves.size(), 2U);
    EXPECT_EQ(plan.slaves[0].node, 1U);
    EXPECT_EQ(plan.slaves[0].name, "Stop button");
    EXPECT_EQ(plan.slaves[1].node, 33U);
    EXPECT_EQ(plan.slaves[1].name, "Relay");
}

TEST_F(NetworkFileTest, WhatTheManagerExpectsFollowsFromTheDcf)
{
    Verifies(req::SRS_NET_003);
    const LoadedNetwork net(runtime::ReadNetworkFile(Cpj(), 0U));
    const cia302::SlaveSetup& relay = net.Setup().slaves[33];
    // In the network, booted, mandatory
    EXPECT_EQ(relay.assignment, 0x0DU);
    EXPECT_EQ(relay.device_type, 0U);
    EXPECT_EQ(relay.vendor_id, 0U);
    EXPECT_EQ(relay.product_code, 3U);
    EXPECT_EQ(relay.revision_number, 0x00010000U);
    EXPECT_EQ(relay.serial_number, 33U);
    EXPECT_EQ(relay.heartbeat.producer_ms, 100U);
    EXPECT_EQ(relay.heartbeat.consumer_ms, 200U);
    EXPECT_EQ(net.Setup().own.value, 2U);
    EXPECT_EQ(net.Setup().start_up, 1U);
    EXPECT_EQ(net.Find(2U), nullptr);
    // The concise DCF: one entry, 1017h = 100; nothing of the safety configuration
    ASSERT_EQ(relay.concise_dcf.size_bytes, 13U);
    const std::vector<std::uint8_t> bytes(relay.concise_dcf.data, relay.concise_dcf.data + 13U);
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{1U, 0U, 0U, 0U, 0x17U, 0x10U, 0U, 2U, 0U, 0U, 0U, 100U, 0U}));
}

TEST_F(NetworkFileTest, TypeVendorAndDateOfTheDcfAreExpectedToo)
{
    Verifies(req::SRS_NET_003);
    std::string text = ExampleText("actuator");
    for (const auto& [section, value] : {std::pair("[1000]", "0x00020191"), {"[1018sub1]", "0x2A"}})
    {
        const std::string none = "DefaultValue=0x00000000";
        text.replace(text.find(none, text.find(section)), none.size(), "DefaultValue=" + std::string(value));
    }
    static_cast<void>(
        File("dated.dcf", text + "\n[1020]\nParameterName=Verify configuration\nObjectType=0x8\nSubNumber=3\n\n" +
                              Section("1020sub0", "0x0005", "ro", "2") + Section("1020sub1", "0x0007", "rw", "9131") +
                              Section("1020sub2", "0x0007", "rw", "43200000")));
    const LoadedNetwork net(
        runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 33, dcf: dated.dcf}]\n"), 0U));
    const cia302::SlaveSetup& slave = net.Setup().slaves[33];
    EXPECT_EQ(slave.device_type, 0x00020191U);
    EXPECT_EQ(slave.vendor_id, 0x2AU);
    EXPECT_EQ(slave.configuration_date, 9131U);
    EXPECT_EQ(slave.configuration_time, 43200000U);
}

TEST_F(NetworkFileTest, TheSafetyExpectationIsTheSignedConfiguration)
{
    Verifies(req::SRS_NET_340);
    const LoadedNetwork net(runtime::ReadNetworkFile(Cpj(), 0U));
    const cia302::SafetyExpectation* const safety = net.Setup().slaves[33].safety;
    ASSERT_NE(safety, nullptr);
    EXPECT_TRUE(cia302::IsUsable(*safety));
    EXPECT_TRUE(net.Setup().HasSafetySlave());
    EXPECT_EQ(ValueOf(*safety, 0x1301U, 1U), 2U);
    EXPECT_EQ(ValueOf(*safety, 0x13FFU, 1U), 0x9FCBU);
    EXPECT_EQ(ValueOf(*safety, 0x13FFU, 0U), 1U);
    EXPECT_EQ(ValueOf(*safety, 0x1381U, 0U) % 2U, 0U);
}

TEST_F(NetworkFileTest, ADeviceWithItsSrdosOffIsASafetySlave)
{
    Verifies(req::SRS_NET_340);
    // Given a sensor whose SRDO is off, which `sign` gives another signature
    const std::string text =
        Changed(ExampleText("sensor"),
                {{"HighLimit=2\nDefaultValue=0\nParameterValue=1\n", "HighLimit=2\nDefaultValue=0\nParameterValue=0\n"},
                 {"ParameterValue=0xB631", "ParameterValue=0x3BED"}});
    static_cast<void>(File("off.dcf", text));
    const LoadedNetwork net(
        runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 1, dcf: off.dcf}]\n"), 0U));
    const cia302::SafetyExpectation* const safety = net.Setup().slaves[1].safety;
    ASSERT_NE(safety, nullptr);
    EXPECT_TRUE(cia302::IsUsable(*safety));
    EXPECT_TRUE(net.Setup().HasSafetySlave());
    EXPECT_EQ(ValueOf(*safety, 0x1301U, 1U), 0U);
    EXPECT_EQ(ValueOf(*safety, 0x13FFU, 1U), 0x3BEDU);
}

TEST_F(NetworkFileTest, AnSrdoThatIsOnlyListedIsNoPlainSlave)
{
    Verifies(req::SRS_NET_340);
    // Given a DCF of a plain slave whose list of objects names 1302h, without a section for it
    const std::string plain = cia306::ReadTextFile(cia306::test::SourceFolder() + "/tests/runtime/data/plain.dcf");
    static_cast<void>(
        File("listed.dcf", Changed(plain, {{"SupportedObjects=11\n", "SupportedObjects=12\n12=0x1302\n"}})));
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves: [{node: 5, dcf: listed.dcf}]\n");
    std::string refusal;
    try
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    }
    catch (const cia306::InputError& error)
    {
        refusal = error.what();
    }
    EXPECT_EQ(refusal, Path("listed.dcf") + ":51:4: error: 0x1302: is listed, expected a section that describes it");
}

TEST_F(NetworkFileTest, WhatIsConstInTheSafetyConfigurationIsExpectedToo)
{
    Verifies(req::SRS_NET_340);
    // Given an actuator with a const entry above the count of its mapping, a const signature of an SRDO that is not
    // there, and one of each that is not const
    const std::string text = Changed(
        ExampleText("actuator"), {{"[13FFsub0]", Section("1381sub9", "0x0007", "const", "0x20000108") +
                                                     Section("1381subA", "0x0007", "rw", "0x20000108") +
                                                     Section("13FFsub7", "0x0006", "const", "0x0102") +
                                                     Section("13FFsub8", "0x0006", "rw", "0x0102") + "[13FFsub0]"}});
    static_cast<void>(File("more.dcf", text));
    const LoadedNetwork net(
        runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127}\nslaves: [{node: 33, dcf: more.dcf}]\n"), 0U));
    const cia302::SafetyExpectation& safety = *net.Setup().slaves[33].safety;
    EXPECT_TRUE(cia302::IsUsable(safety));
    EXPECT_EQ(ValueOf(safety, 0x1301U, 0U), 6U);
    EXPECT_EQ(ValueOf(safety, 0x1381U, 9U), 0x20000108U);
    EXPECT_EQ(ValueOf(safety, 0x1381U, 10U), kNoValue);
    EXPECT_EQ(ValueOf(safety, 0x13FFU, 7U), 0x0102U);
    EXPECT_EQ(ValueOf(safety, 0x13FFU, 8U), kNoValue);
}

TEST_F(NetworkFileTest, ATimeOf0NeedsNoUnit)
{
    Verifies(req::SRS_NET_002);
    const LoadedNetwork net(runtime::ReadNetworkFile(
        File("net.yaml", "manager: {node: 127, boot_time: 0, inhibit: 0 ms, heartbeat: 0}\nslaves: [{node: 5}]\n"),
        0U));
    EXPECT_EQ(net.Setup().boot_time_ms, 0U);
    EXPECT_EQ(net.Setup().inhibit_100us, 0U);
    EXPECT_EQ(net.Plan().manager.heartbeat_ms, std::uint16_t{0U});
    const std::string bad = File("bad.yaml", "manager: {node: 127, boot_time: 00}\nslaves: [{node: 5}]\n");
    EXPECT_THROW(static_cast<void>(runtime::ReadNetworkFile(bad, 0U)), std::exception);
}

TEST_F(NetworkFileTest, YamlSaysMore)
{
    Verifies(req::SRS_NET_002);
    Verifies(req::SRS_NET_154);
    const std::string file = File("net.yaml", R"(name: Chain
manager: {node: 127, start_up: 0x41, boot_time: 5 s, inhibit: 2 ms, sync: 10 ms, sdo_timeout: 300 ms, sdo_tries: 2,
          flying: {priority: 1, level_slot: 2 s, preset: so1114}}
slaves:
  - {node: 1, name: Stop button, dcf: sensor.dcf, mandatory: false, serial: 7, heartbeat: 50 ms, consumer: 120 ms}
  - {node: 33, dcf: actuator.dcf, keep_alive: true, arming: immediately, write_safety: true, restore: 1}
  - {node: 34, assignment: 0x5, guard_time: 100 ms, retry_factor: 3, device_type: 0x191}
)");
    const NetworkPlan plan = runtime::ReadNetworkFile(file, 0U);
    EXPECT_EQ(plan.manager.sdo_time_out_ms, std::uint32_t{300U});
    EXPECT_EQ(plan.manager.flying->level_slot_ms, std::uint16_t{2000U});
    EXPECT_EQ(plan.manager.flying->options.cyclic, cia302::CyclicMessage::kNegotiation);
    const LoadedNetwork net(plan);
    EXPECT_EQ(net.Setup().start_up, 0x61U);
    EXPECT_EQ(net.Setup().boot_time_ms, 5000U);
    EXPECT_EQ(net.Setup().inhibit_100us, 20U);
    EXPECT_EQ(net.Setup().sync_period_us, 10000U);
    EXPECT_EQ(net.Setup().slaves[1].assignment, 0x05U);
    EXPECT_EQ(net.Setup().slaves[1].serial_number, 7U);
    EXPECT_EQ(net.Setup().slaves[1].heartbeat.consumer_ms, 120U);
    EXPECT_EQ(net.Setup().slaves[1].heartbeat.producer_ms, 50U);
    // 'restore' sets bit 7 as well: 1F8Ah alone restores nothing
    EXPECT_EQ(net.Setup().slaves[33].assignment, 0x9DU);
    EXPECT_EQ(net.Setup().slaves[33].restore_sub, 1U);
    EXPECT_EQ(net.Setup().slaves[33].heartbeat.arming, cia302::Arming::kImmediately);
    EXPECT_TRUE(net.Find(33U)->plan.writes_safety);
    EXPECT_EQ(net.Setup().slaves[33].emergency_id, 0xA1U); // $NODEID+0x80 of the DCF.
    EXPECT_EQ(net.Setup().slaves[34].assignment, 0x00640305U);
    EXPECT_EQ(net.Setup().slaves[34].emergency_id, 0U);
    EXPECT_EQ(net.Setup().slaves[34].device_type, 0x191U);
    EXPECT_EQ(net.Setup().slaves[34].safety, nullptr);
}

TEST_F(NetworkFileTest, SoftwareThatIsVerifiedAndUpdated)
{
    Verifies(req::SRS_NET_002);
    Verifies(req::SRS_NET_154);
    static_cast<void>(File("program.bin", "abc"));
    const std::string file = File("net.yaml", R"(manager: {node: 127}
slaves:
  - {node: 1, software: {identification: 0x55, date: 2, time: 3}}
  - {node: 2, software: {identification: 0x56, update: true, program: program.bin}}
)");
    const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    const cia302::SlaveSetup& verified = net.Setup().slaves[1];
    EXPECT_EQ(verified.assignment, 0x2DU);
    EXPECT_EQ(verified.software.identification, 0x55U);
    EXPECT_EQ(verified.software.date, 2U);
    EXPECT_EQ(verified.software.time, 3U);
    EXPECT_EQ(verified.software.program.size_bytes, 0U);
    const cia302::SlaveSetup& updated = net.Setup().slaves[2];
    EXPECT_EQ(updated.assignment, 0x6DU);
    ASSERT_EQ(updated.software.program.size_bytes, 3U);
    EXPECT_EQ(updated.software.program.data[2], 'c');
}

TEST_F(NetworkFileTest, WhatTheProfileDoesNotLookAtIsTold)
{
    Verifies(req::SRS_NET_006);
    const auto warnings = [this](const std::string& profile)
    {
        const LoadedNetwork net(
            runtime::ReadNetworkFile(File("net.yaml", "manager: {node: 127, profile: " + profile +
                                                          R"(, sync: 10 ms, boot_time: 1 s, start_up: 0x41,
  el6751: {sync_multiplier: 2}}
slaves:
  - {node: 1, serial: 7, keep_alive: true, restore: 1, el6751: {start: false}, plc_designer: {optional: true}}
)"),
                                     0U));
        std::vector<std::string> told;
        for (const std::string& warning : net.Warnings())
        {
            const std::size_t line = warning.find(".yaml:") + 6U;
            told.push_back(warning.substr(line, warning.find(" has no effect with the profile " + profile) - line));
        }
        return told;
    };
    EXPECT_EQ(warnings("cia302"), (std::vector<std::string>{"1:10: warning: sync", "1:10: warning: el6751",
                                                            "4:5: warning: el6751", "4:5: warning: plc_designer"}));
    EXPECT_EQ(
        warnings("el6751"),
        (std::vector<std::string>{"1:10: warning: boot_time", "1:10: warning: bit 6 of start_up",
                                  "4:5: warning: plc_designer", "4:5: warning: keep_alive", "4:5: warning: restore"}));
    EXPECT_EQ(warnings("plc_designer"),
              (std::vector<std::string>{"1:10: warning: sync", "1:10: warning: el6751", "1:10: warning: boot_time",
                                        "1:10: warning: bit 6 of start_up", "4:5: warning: el6751",
                                        "4:5: warning: keep_alive", "4:5: warning: restore", "4:5: warning: serial"}));
}

TEST_F(NetworkFileTest, AGuardTimeBesideAHeartbeatAndAReservedBitAreToldToo)
{
    Verifies(req::SRS_NET_006);
    const std::string guarded = "guard_time: 100 ms, retry_factor: 3";
    const std::string file = File("net.yaml", "manager: {node: 127}\nslaves:\n"
                                              "  - {node: 1, consumer: 300 ms, " +
                                                  guarded + "}\n  - {node: 2, " + guarded +
                                                  "}\n  - {node: 3, assignment: 0x07}\n"
                                                  "  - {node: 4, heartbeat: 50 ms, consumer: 0 ms, " +
                                                  guarded + "}\n");
    const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    ASSERT_EQ(net.Warnings().size(), 3U);
    const auto says = [&net](const std::size_t number, const std::string& text)
    { return net.Warnings()[number].find("net.yaml:" + text) != std::string::npos; };
    EXPECT_TRUE(
        says(0U, "3:5: warning: guard_time has no effect: node 1 is supervised by heartbeat within 300 ms, expected "
                 "heartbeat: 0 ms and no consumer time for one that is guarded"));
    EXPECT_TRUE(says(1U, "5:5: warning: bit 1 of assignment, which is reserved, has no effect"));
    EXPECT_TRUE(
        says(2U, "6:5: warning: node 4 sends a heartbeat each 50 ms and will not answer when it is guarded, expected "
                 "heartbeat: 0 ms"));
}

std::string Variable(const std::string& section, const std::string& type, const std::string& value)
{
    return "\n[" + section + "]\nParameterName=x\nObjectType=0x7\nDataType=" + type +
           "\nAccessType=rw\nParameterValue=" + value + "\nPDOMapping=0\n";
}

std::string Array(const std::string& section, const std::string& count)
{
    return "\n[" + section + "]\nParameterName=x\nObjectType=0x8\nSubNumber=" + count + "\n";
}

/// What a person would copy from the example is what the reader makes of the drive's DCF.
TEST_F(NetworkFileTest, TheTablesOfTheExampleAreThoseOfItsDcf)
{
    Verifies(req::SRS_TGT_230);
    const std::string file =
        File("net.yaml", "manager: {node: 1}\nslaves: [{node: 33, dcf: " + cia306::test::SourceFolder() +
                             "/examples/actuator/actuator.dcf}]\n");
    const LoadedNetwork net(runtime::ReadNetworkFile(file, 0U));
    const cia302::SlaveSetup& read = net.Setup().Slave(examples::kDrive);
    const examples::ManagerSettings settings = examples::AloneSettings();
    const cia302::SlaveSetup& example = settings.setup.Slave(examples::kDrive);
    ASSERT_EQ(example.safety->count, read.safety->count);
    for (std::uint16_t place = 0U; place < read.safety->count; ++place)
    {
        const cia302::ExpectedObject& is = example.safety->objects[place];
        const cia302::ExpectedObject& should = read.safety->objects[place];
        EXPECT_EQ(is.address.index, should.address.index) << place;
        EXPECT_EQ(is.address.sub, should.address.sub) << place;
        EXPECT_EQ(is.value, should.value) << place;
        EXPECT_EQ(is.is_fixed, should.is_fixed) << place;
    }
    EXPECT_EQ(example.device_type, read.device_type);
    EXPECT_EQ(example.vendor_id, read.vendor_id);
    EXPECT_EQ(example.product_code, read.product_code);
    EXPECT_EQ(example.revision_number, read.revision_number);
    EXPECT_EQ(example.serial_number, read.serial_number);
    EXPECT_EQ(
        std::vector<std::uint8_t>(example.concise_dcf.data, example.concise_dcf.data + example.concise_dcf.size_bytes),
        std::vector<std::uint8_t>(read.concise_dcf.data, read.concise_dcf.data + read.concise_dcf.size_bytes));
}

// A manager's own file with 1F80h, 1F89h, and 1F81h and 1F88h for node 33
class ManagersFileTest : public NetworkFileTest
{
  protected:
    ManagersFileTest() : dcf(Changed(ExampleText("controller"), {{"CANopenManager=0", "CANopenManager=1"}}))
    {
        const std::string list = "[OptionalObjects]\nSupportedObjects=";
        const std::size_t place = dcf.find(list) + list.size();
        const std::size_t end = dcf.find('\n', place);
        const int count = std::stoi(dcf.substr(place, end - place));
        std::string more;
        int number = count;
        for (const char* const added : {"0x1F80", "0x1F81", "0x1F88", "0x1F89"})
        {
            ++number;
            more += "\n" + std::to_string(number) + "=" + added;
        }
        dcf.insert(dcf.find("\n\n", place), more);
        dcf.replace(place, end - place, std::to_string(number));
        dcf += Variable("1F80", "0x0007", "0x11") + Variable("1F89", "0x0007", "7000") + Array("1F81", "2") +
               Variable("1F81sub0", "0x0005", "33") + Variable("1F81sub21", "0x0007", "0x05") + Array("1F88", "2") +
               Variable("1F88sub0", "0x0005", "33") + Variable("1F88sub21", "0x0007", "4711");
    }

    std::string Refusal(const std::string& text)
    {
        static_cast<void>(File("manager.dcf", text));
        try
        {
            const LoadedNetwork wrong(runtime::ReadNetworkFile(Cpj(), 0U));
        }
        catch (const cia306::InputError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    }

    std::string dcf;
};

TEST_F(ManagersFileTest, ASyncPeriodThatIsTooShortIsRefusedWhereItStands)
{
    Verifies(req::SRS_NET_231);
    std::string with_sync = dcf + Variable("1006", "0x0007", "1");
    const std::string last = "=0x1F89";
    const std::size_t place = with_sync.find(last);
    const std::size_t begin = with_sync.rfind('\n', place) + 1U;
    const int number = std::stoi(with_sync.substr(begin, place - begin));
    with_sync.insert(place + last.size(), "\n" + std::to_string(number + 1) + "=0x1006");
    const std::string count = "[OptionalObjects]\nSupportedObjects=" + std::to_string(number);
    with_sync.replace(with_sync.find(count), count.size(),
                      "[OptionalObjects]\nSupportedObjects=" + std::to_string(number + 1));
    const std::string text = Refusal(with_sync);
    const auto line =
        std::count(with_sync.begin(), with_sync.begin() + static_cast<long>(with_sync.find("[1006]")), '\n');
    EXPECT_NE(text.find("/manager.dcf:" + std::to_string(line + 6) + ":16: error: SYNC"), std::string::npos) << text;
    EXPECT_NE(text.find("SYNC period (1006h) of 1 us, expected none, or at least 1000 us"), std::string::npos) << text;
    // The network file goes before it
    const std::string file =
        File("net.yaml", "manager: {node: 2, dcf: manager.dcf, sync: 10 us}\nslaves: [{node: 9}]\n");
    try
    {
        const LoadedNetwork wrong(runtime::ReadNetworkFile(file, 0U));
        FAIL() << "accepted";
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_EQ(std::string(error.what()),
                  file + ":1:10: error: SYNC period (1006h) of 10 us, expected none, or at least 1000 us");
    }
}

TEST_F(ManagersFileTest, ItsOwnObjectsGoBeforeDerivedOnes)
{
    Verifies(req::SRS_NET_341);
    static_cast<void>(File("manager.dcf", dcf));
    const LoadedNetwork net(runtime::ReadNetworkFile(Cpj(), 0U));
    EXPECT_EQ(net.Setup().start_up, 0x11U);
    EXPECT_EQ(net.Setup().boot_time_ms, 7000U);
    EXPECT_EQ(net.Setup().slaves[33].assignment, 0x05U);
    EXPECT_EQ(net.Setup().slaves[33].serial_number, 4711U);
    EXPECT_EQ(net.Setup().slaves[1].assignment, 0x0DU);
}

TEST_F(ManagersFileTest, ItsBitsAreKnownOnesAndWhoIsInItsNetworkIsInItsList)
{
    Verifies(req::SRS_NET_341);
    Verifies(req::SRS_NET_342);
    // A manager is an NMT master, and its bits are known ones
    for (const std::string& value : {std::string("0x10"), std::string("0x0"), std::string("0x81")})
    {
        const std::string line = Refusal(Changed(dcf, {{"ParameterValue=0x11\n", "ParameterValue=" + value + "\n"}}));
        EXPECT_NE(line.find("/manager.dcf:892:16: error: 0x1F80:00: " + value +
                            ", expected bit 0 (NMT master), and of the others bits 1 to 6 alone"),
                  std::string::npos)
            << line;
    }
    // Who is in its network is in its list
    EXPECT_NE(
        Refusal(Changed(dcf, {{"ParameterValue=0x05\n", "ParameterValue=0x04\n"}}))
            .find(": error: 0x1F81:21: 0x4, expected bit 0 (in the network), as node 33 is, or 0 for the usual bits"),
        std::string::npos);
    EXPECT_EQ(Refusal(Changed(dcf, {{"ParameterValue=0x05\n", "ParameterValue=0\n"}})), "");
}

TEST_F(ManagersFileTest, ItWaitsForTheHeartbeatOfANodeForOneTimeAlone)
{
    Verifies(req::SRS_NET_341);
    Verifies(req::SRS_NET_342);
    const std::string consumers = Changed(dcf, {{"=0x1F88", "=0x1016"},
                                                {"[1F88]", "[1016]"},
                                                {"[1F88sub0]", "[1016sub0]"},
                                                {"[1F88sub21]", "[1016sub21]"},
                                                {"ParameterValue=4711", "ParameterValue=0x002100C8"}});
    EXPECT_EQ(Refusal(consumers), "");
    EXPECT_NE(Refusal(Changed(consumers, {{"=0x002100C8", "=0x012100C8"}}))
                  .find(": error: 0x1016:21: 0x012100C8, expected each node-ID in one entry"),
              std::string::npos);
    const std::string twice = Changed(consumers, {{"[1016]\nParameterName=x\nObjectType=0x8\nSubNumber=2",
                                                   "[1016]\nParameterName=x\nObjectType=0x8\nSubNumber=3"}}) +
                              Variable("1016sub22", "0x0007", "0x00210032");
    EXPECT_NE(Refusal(twice).find(": error: 0x1016:22: 0x00210032, expected each node-ID in one entry"),
              std::string::npos)
        << Refusal(twice);
}

TEST_F(NetworkFileTest, OneStartForAllWithASafetySlaveIsWarnedOf)
{
    Verifies(req::SRS_NET_005);
    Verifies(req::SRS_NET_150);
    Verifies(req::SRS_NET_006);
    const auto warnings = [this](const std::string& profile)
    {
        const LoadedNetwork net(
            runtime::ReadNetworkFile(File("net.yaml", "name: Chain\n"
                                                      "manager: {node: 127, start_up: 7, profile: " +
                                                          profile + "}\nslaves: [{node: 33, dcf: actuator.dcf}]\n"),
                                     0U));
        return net.Warnings();
    };
    const std::string place = Path("net.yaml") + ":2:10: warning: ";
    const std::string singly = place + "one start for all is asked for (1F80h bit 1), and there is a safety slave: "
                                       "each slave is started by itself after its verification";
    EXPECT_EQ(warnings("cia302"), std::vector<std::string>{singly});
    EXPECT_EQ(
        warnings("plc_designer"),
        (std::vector<std::string>{place + "bit 2 of start_up has no effect with the profile plc_designer", singly}));
    // A profile that never starts all at once says no more than that
    EXPECT_EQ(warnings("el6751"),
              (std::vector<std::string>{place + "bit 1 of start_up has no effect with the profile el6751",
                                        place + "bit 2 of start_up has no effect with the profile el6751"}));
}

TEST_F(NetworkFileTest, AConsumerTimeOfASlaveThatIsToldToSendNoHeartbeatIsWarnedOf)
{
    Verifies(req::SRS_NET_006);
    const auto warnings = [this](const std::string& profile, const std::string& slave)
    {
        const LoadedNetwork net(runtime::ReadNetworkFile(
            File("net.yaml", "manager: {node: 127, profile: " + profile + "}\nslaves:\n  - {node: 5" + slave + "}\n"),
            0U));
        return net.Warnings();
    };
    const std::string told =
        Path("net.yaml") + ":3:5: warning: node 5 is told to send no heartbeat and awaited within 300 ms: ";
    const std::string expected = ", expected a heartbeat, or consumer: 0 ms";
    const std::string silent = ", heartbeat: 0 ms, consumer: 300 ms";
    EXPECT_EQ(warnings("cia302", silent),
              std::vector<std::string>{told + "its start-up ends with letter K" + expected});
    EXPECT_EQ(warnings("plc_designer", silent), std::vector<std::string>{told + "it is not supervised" + expected});
    EXPECT_EQ(warnings("el6751", silent + ", arming: boot_up"),
              std::vector<std::string>{told + "it is taken for lost" + expected});
    // Who is not booted is told nothing, nor is one whose heartbeat is its own matter
    EXPECT_TRUE(warnings("cia302", silent + ", boot: false").empty());
    EXPECT_TRUE(warnings("cia302", ", consumer: 300 ms").empty());
    EXPECT_TRUE(warnings("cia302", ", heartbeat: 0 ms, consumer: 0 ms").empty());
    EXPECT_TRUE(warnings("cia302", ", heartbeat: 100 ms, consumer: 300 ms").empty());
}
} // namespace
} // namespace counterpoint::tools
