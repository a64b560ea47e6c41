// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// A device of a file from its parts: with its services and without, its resets, its supply, its node-ID by LSS.
#include "runtime/device/assembly.hpp"

#include "canopen/cia306/file/device_reader.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/owned_channel.hpp"
#include "runtime/device/pair_logic.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "tests/canopen/cia306/folder_of_files.hpp"
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::runtime
{
namespace
{
using cia301::NodeState;
using Octets = std::vector<std::uint8_t>;

/// Keeps what a device tells its owner; starts the watchdog as one who owns a device does.
class Owner final : public AssemblyOwner
{
  public:
    void OnStart() noexcept override
    {
        ++starts;
    }
    void OnNoStart(const StartResult result) noexcept override
    {
        no_start = result;
    }
    void OnLoaded(const std::uint8_t groups) noexcept override
    {
        static_cast<void>(groups);
    }
    void OnRefused(const ConfigurationWrite& write, const AbortCode code) noexcept override
    {
        refused.emplace_back(write.object.index, code);
    }
    void OnResetCommunication(const std::vector<cia306::Finding>& refusals) noexcept override
    {
        ++resets;
        refusal_count = refusals.size();
    }
    void OnTime(const cia301::TimeOfDay& time, const Instant now) noexcept override
    {
        static_cast<void>(time);
        static_cast<void>(now);
    }
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override
    {
        static_cast<void>(emergency);
    }

    int starts{0};
    int resets{0};
    std::size_t refusal_count{0U};
    std::optional<StartResult> no_start{};
    std::vector<std::pair<std::uint16_t, AbortCode>> refused{};
};

/// A device of a file on a bus of which the test is the other side.
class Built
{
  public:
    explicit Built(const std::string& path, const bool has_services = true,
                   const std::optional<std::uint32_t> cycle_us = std::nullopt)
        : file(cia306::ReadDeviceFile(path)),
          model(path, std::nullopt, has_services ? SafetyNeed::kOptional : SafetyNeed::kRequired),
          config(ConfigOf(model, cycle_us)), channel_a(MakeChannel(Letter::kA, RoomOf(config))),
          channel_b(MakeChannel(Letter::kB, RoomOf(config))),
          assembly(model, config,
                   {channel_a->Voice(), channel_b->Voice(), ports, output, watchdog, application, nullptr, owner,
                    has_services ? &file : nullptr})
    {
        output.now_us = &now_us;
        watchdog.now_us = &now_us;
        if (has_services)
        {
            assembly.Connect(nullptr);
        }
    }
    [[nodiscard]] device::LoadResult PowerOn()
    {
        watchdog.timer.Start(WindowOf(config), Instant{now_us});
        return assembly.Device().PowerOn(Instant{now_us});
    }
    void Receive(const std::uint32_t identifier, const Octets& bytes)
    {
        CanFrame frame{};
        frame.identifier = identifier;
        frame.kind = FrameKind::kData;
        frame.port = CanPortId::kFirst;
        frame.length_bytes = static_cast<std::uint8_t>(bytes.size());
        std::copy(bytes.begin(), bytes.end(), &frame.data[0]);
        const Instant now{now_us};
        assembly.Device().OnFrame({frame, {now, now}});
    }
    /// What was sent comes back, then a cycle.
    void Cycle()
    {
        const std::vector<CanFrame> sent = std::exchange(ports.sent, {});
        const Instant before{now_us};
        for (const CanFrame& frame : sent)
        {
            assembly.Device().OnConfirm({frame, {before, before}});
        }
        all.insert(all.end(), sent.begin(), sent.end());
        now_us += config.cycle_us;
        const Instant now{now_us};
        assembly.Device().Cycle({{now, now}, 0U, 0U});
    }
    void Command(const std::uint8_t command)
    {
        Receive(0x000U, {command, 0U});
        Cycle();
        Cycle();
    }
    /// Data of the frames that were sent with this identifier.
    [[nodiscard]] std::vector<Octets> Sent(const std::uint32_t identifier)
    {
        Cycle();
        Cycle();
        std::vector<Octets> data;
        for (const CanFrame& frame : all)
        {
            if (frame.identifier == identifier)
            {
                data.emplace_back(&frame.data[0], &frame.data[0] + frame.length_bytes);
            }
        }
        return data;
    }

    std::uint32_t now_us{5000U};
    cia306::Device file;
    DeviceModel model;
    DeviceConfig config;
    std::unique_ptr<OwnedChannel> channel_a;
    std::unique_ptr<OwnedChannel> channel_b;
    RecordingPorts ports{};
    GateOutput output{};
    TimerWatchdog watchdog{};
    RecordingApplication application{};
    Owner owner{};
    std::vector<CanFrame> all{};
    DeviceAssembly assembly;
};

std::string ExampleFile(const std::string& name)
{
    return cia306::test::SourceFolder() + "/examples/emergency_stop/" + name + ".dcf";
}

std::string TestFile(const std::string& name)
{
    return cia306::test::SourceFolder() + "/tests/canopen/cia306/data/" + name + ".dcf";
}

const std::string kNodeFive =
    "[DeviceInfo]\nVendorName=t\n[DeviceComissioning]\nNodeID=5\n" + cia306::test::VariableText("1000", "7", "0");

using AssemblyTest = cia306::test::FolderTest;

TEST_F(AssemblyTest, WithoutServicesFollowsNmtAndSendsItsSrdosAlone)
{
    Verifies(req::SRS_DEV_022);
    Built sensor(ExampleFile("sensor"), false);
    ASSERT_EQ(sensor.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_EQ(sensor.owner.starts, 1);
    EXPECT_EQ(sensor.owner.resets, 1);
    EXPECT_TRUE(sensor.owner.refused.empty());
    EXPECT_EQ(sensor.assembly.Device().State(), NodeState::kPreOperational);
    EXPECT_EQ(&sensor.assembly.Told(), &sensor.application);
    sensor.Command(1U);
    EXPECT_EQ(sensor.assembly.Device().State(), NodeState::kOperational);
    // Then nothing leaves but its boot-up message and its SRDO, each 25 ms
    for (int cycle = 0; cycle < 100; ++cycle)
    {
        sensor.Cycle();
    }
    EXPECT_TRUE(sensor.Sent(0x701U).empty() || sensor.Sent(0x701U) == std::vector<Octets>{{0U}});
    EXPECT_GE(sensor.Sent(0x101U).size(), 2U);
    EXPECT_EQ(sensor.Sent(0x101U).size(), sensor.Sent(0x102U).size());
    EXPECT_EQ(sensor.all.size(), sensor.Sent(0x701U).size() + 2U * sensor.Sent(0x101U).size());
    sensor.Command(130U);
    EXPECT_EQ(sensor.owner.resets, 2);
    sensor.Command(129U);
    EXPECT_EQ(sensor.owner.starts, 2);
    EXPECT_EQ(sensor.owner.resets, 3);
    // When its supply is gone and comes again, then it begins as at first
    sensor.assembly.PowerOff();
    EXPECT_FALSE(sensor.assembly.NewNodeId().has_value());
    ASSERT_EQ(sensor.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_EQ(sensor.assembly.Device().State(), NodeState::kPreOperational);
}

TEST_F(AssemblyTest, HasTheStaticMappingsOfItsFile)
{
    Verifies(req::SRS_SIM_009);
    Built device(TestFile("static"), false);
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_TRUE(device.owner.refused.empty());
    EXPECT_EQ(device.assembly.Core().GetParameters(CommunicationIndex{0x1301U}).map_count, 16U);
    EXPECT_EQ(device.assembly.Core().GetParameters(CommunicationIndex{0x1303U}).map_count, 6U);
}

// SRDO 1 each 50 ms, SRDO 2 each 25 ms, SRDO 3 each 40 ms; the application sends all, with a cycle of 1 ms.
TEST_F(AssemblyTest, SendsAsOftenAsItsFastestProducerWants)
{
    Verifies(req::SRS_NODE_025);
    using cia306::test::VariableText;
    const std::vector<cia306::test::SrdoText> srdos{{1, "1", "50", "20", "0x101", "0x102", {}},
                                                    {2, "1", "25", "20", "0x103", "0x104", {}},
                                                    {3, "1", "40", "20", "0x105", "0x106", {}}};
    Built device(File("a.dcf", cia306::test::SrdoFileText(srdos) +
                                   "[DeviceComissioning]\nNodeID=5\n[5F03]\nParameterName=f\nObjectType=8\n" +
                                   VariableText("5F03sub0", "5", "3") + VariableText("5F03sub1", "5", "0") +
                                   VariableText("5F03sub2", "5", "0") + VariableText("5F03sub3", "5", "0")));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_EQ(device.assembly.CyclesPerSend(), 25U);
}

// Of SRDO 5 the provider is called: nobody sends it by itself.
TEST_F(AssemblyTest, SendsWhatItsApplicationSendsAlone)
{
    Verifies(req::SRS_NODE_025);
    Built device(TestFile("digest"));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    device.Command(1U);
    EXPECT_EQ(device.assembly.CyclesPerSend(), 0U);
    const std::size_t before = device.Sent(0x109U).size();
    device.assembly.SendAll();
    EXPECT_EQ(device.Sent(0x109U).size(), before);
}

TEST_F(AssemblyTest, WithACycleThatIsLongerThanARefreshTimeIsRefused)
{
    Verifies(req::SRS_NODE_009);
    const DeviceModel sensor(ExampleFile("sensor"), std::nullopt);
    EXPECT_EQ(ConfigOf(sensor, 25000U).cycle_us, 25000U);
    try
    {
        static_cast<void>(ConfigOf(sensor, 25001U));
        ADD_FAILURE() << "expected a refusal";
    }
    catch (const cia306::InputError& error)
    {
        EXPECT_EQ(error.Message(), "--cycle-us 25001 for SRDO 1, which is sent every 25 ms, expected a cycle that is "
                                   "no longer");
    }
    // A consumer has no such time
    EXPECT_EQ(ConfigOf(DeviceModel(ExampleFile("actuator"), std::nullopt), 60000U).cycle_us, 60000U);
}

TEST_F(AssemblyTest, WithASupplyThatWasGoneHasNoErrors)
{
    Verifies(req::SRS_DEV_023);
    Built sensor(ExampleFile("sensor"));
    ASSERT_EQ(sensor.PowerOn(), device::LoadResult::kLoaded);
    sensor.assembly.Device().OnBus(device::BusCondition::kPassive);
    sensor.Cycle();
    EXPECT_TRUE(sensor.assembly.Services().emergency.HasErrors());
    sensor.assembly.PowerOff();
    EXPECT_FALSE(sensor.assembly.Services().emergency.HasErrors());
    ASSERT_EQ(sensor.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_EQ(sensor.assembly.Device().State(), NodeState::kPreOperational);
}

TEST_F(AssemblyTest, WithoutAStoreSaysThatNothingIsSaved)
{
    Verifies(req::SRS_NODE_011);
    Built plain(cia306::test::SourceFolder() + "/tests/runtime/data/everything.dcf");
    ASSERT_EQ(plain.PowerOn(), device::LoadResult::kLoaded);
    std::uint8_t bytes[4U]{0xFFU, 0xFFU, 0xFFU, 0xFFU};
    const auto read = [&plain, &bytes](const std::uint32_t room)
    { return plain.assembly.Dictionary().Read({0x1010U, 1U}, {bytes, room}).abort; };
    EXPECT_EQ(read(3U), cia301::SdoAbort::kOutOfMemory);
    EXPECT_EQ(read(4U), cia301::SdoAbort::kNone);
    EXPECT_EQ(bytes[0], 0U);
    EXPECT_EQ(plain.assembly.Dictionary().WriteNumber({0x1010U, 1U}, 0x65766173U, 4U), cia301::SdoAbort::kNotStored);
}

const std::string kIdentity = "[1018]\nParameterName=Identity\nObjectType=9\n";

std::string Part(const std::string& sub, const std::string& value)
{
    return "[1018sub" + sub + "]\nParameterName=x\nObjectType=7\nDataType=7\nAccessType=ro\n" + value;
}

/// LSS selective: command, then four bytes.
Octets Select(const std::uint8_t command, const std::uint32_t value)
{
    return {command,
            static_cast<std::uint8_t>(value & 0xFFU),
            static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
            static_cast<std::uint8_t>((value >> 16U) & 0xFFU),
            static_cast<std::uint8_t>(value >> 24U),
            0U,
            0U,
            0U};
}

// What the file does not say of the identity is 0.
TEST_F(AssemblyTest, IsSelectedByTheIdentityOfItsFile)
{
    Verifies(req::SRS_NODE_015);
    Built device(File("a.dcf", kNodeFive + kIdentity + Part("0", "DefaultValue=2\n") +
                                   Part("1", "DefaultValue=0x11\n") + Part("2", "")));
    device.assembly.UseLss(device.file, {5U, {0U}}, {});
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    for (const auto& [command, value] :
         {std::pair<int, std::uint32_t>{0x40, 0x11U}, {0x41, 0U}, {0x42, 0U}, {0x43, 0U}})
    {
        EXPECT_TRUE(device.Sent(0x7E4U).empty());
        device.Receive(0x7E5U, Select(static_cast<std::uint8_t>(command), value));
    }
    ASSERT_EQ(device.Sent(0x7E4U).size(), 1U);
    EXPECT_EQ(device.Sent(0x7E4U)[0][0], 0x44U);
    // And with nobody who keeps its settings it says that it cannot: store, error 1
    device.Receive(0x7E5U, {0x17U, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
    ASSERT_EQ(device.Sent(0x7E4U).size(), 2U);
    EXPECT_EQ(device.Sent(0x7E4U)[1][0], 0x17U);
    EXPECT_EQ(device.Sent(0x7E4U)[1][1], 1U);
}

TEST_F(AssemblyTest, ForgetsANodeIdThatWasNotSavedWithItsSupply)
{
    Verifies(req::SRS_NODE_015);
    Built device(File("a.dcf", kNodeFive));
    device.assembly.UseLss(device.file, {5U, {0U}}, {});
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    // Given another node-ID by LSS, and a reset of communication
    device.Receive(0x7E5U, {0x04U, 1U, 0U, 0U, 0U, 0U, 0U, 0U});
    device.Receive(0x7E5U, {0x11U, 9U, 0U, 0U, 0U, 0U, 0U, 0U});
    device.Receive(0x7E5U, {0x04U, 0U, 0U, 0U, 0U, 0U, 0U, 0U});
    device.Cycle();
    device.Command(130U);
    EXPECT_EQ(device.assembly.NewNodeId(), std::optional<std::uint8_t>(9U));
    EXPECT_EQ(device.assembly.NodeId(), 9U);
    // When the supply was gone, then it is what it was
    device.assembly.PowerOff();
    EXPECT_FALSE(device.assembly.NewNodeId().has_value());
    EXPECT_EQ(device.assembly.NodeId(), 5U);
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
}

TEST_F(AssemblyTest, HasTheServicesOfItsFileAlone)
{
    Verifies(req::SRS_NODE_012);
    const std::string time = "[1013]\nParameterName=x\nObjectType=7\nDataType=7\nAccessType=rw\n";
    Built device(File("a.dcf", kNodeFive + time));
    EXPECT_NE(device.assembly.Optional().HookOf(0x1013U), nullptr);
    EXPECT_EQ(device.assembly.Optional().HookOf(0x1201U), nullptr);
    EXPECT_EQ(device.assembly.Optional().ClientOf(7U), nullptr);
    // A client that is off is one of nobody
    Built off(File("b.dcf", kNodeFive + "[1280]\nParameterName=c\nObjectType=9\n" +
                                cia306::test::VariableText("1280sub1", "7", "0x80000000") +
                                cia306::test::VariableText("1280sub2", "7", "0x80000000") +
                                cia306::test::VariableText("1280sub3", "5", "7")));
    ASSERT_EQ(off.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_NE(off.assembly.Optional().HookOf(0x1280U), nullptr);
    EXPECT_EQ(off.assembly.Optional().ClientOf(7U), nullptr);
}

// Dummies are no pairs: 2 of 8, 16 and 32 bits stand around those of the file.
TEST_F(AssemblyTest, HasNoPairForADummy)
{
    Verifies(req::SRS_NODE_019);
    Built device(TestFile("dummies"));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    EXPECT_TRUE(device.owner.refused.empty());
    PairLogic logic(device.model, Half::kBoth);
    logic.Follow(device.assembly.Core(), device.model);
    ASSERT_EQ(logic.Pairs().size(), 3U);
    EXPECT_TRUE(logic.Pairs()[0].is_mapped);
    EXPECT_TRUE(logic.Pairs()[1].is_mapped);
    EXPECT_TRUE(logic.Pairs()[2].is_mapped);
}

TEST_F(AssemblyTest, KnowsItsPairsInAnyOrder)
{
    Verifies(req::SRS_NODE_019);
    // Given the controller, of which somebody maps the second pair of SRDO 1 first
    Built device(ExampleFile("controller"));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    PairLogic logic(device.model, Half::kBoth);
    ASSERT_EQ(logic.Pairs().size(), 4U);
    const auto write = [&device](const ObjectAddress& object, const std::uint32_t value, const std::uint8_t size)
    { EXPECT_EQ(device.assembly.Core().WriteObject(object, DataOf({object, value, size, {}})), AbortCode::kNone); };
    const auto map = [&write](const std::vector<std::uint32_t>& entries)
    {
        write({0x1301U, 1U}, 0U, 1U);
        write({0x1381U, 0U}, 0U, 1U);
        for (std::size_t place = 0U; place < entries.size(); ++place)
        {
            write({0x1381U, static_cast<std::uint8_t>(place + 1U)}, entries[place], 4U);
        }
        write({0x1381U, 0U}, static_cast<std::uint32_t>(entries.size()), 1U);
        write({0x1301U, 1U}, 2U, 1U);
    };
    map({0x22000208U, 0x23000208U, 0x22000108U, 0x23000108U});
    logic.Follow(device.assembly.Core(), device.model);
    EXPECT_EQ(logic.Pairs().size(), 4U);
    // When a normal object is mapped with another inverse one, then that is another pair
    map({0x22000208U, 0x23000108U});
    logic.Follow(device.assembly.Core(), device.model);
    ASSERT_EQ(logic.Pairs().size(), 5U);
    EXPECT_TRUE(logic.Pairs()[4].is_mapped);
    EXPECT_EQ(logic.Pairs()[4].address.index, 0x2200U);
    EXPECT_EQ(logic.Pairs()[4].address.sub, 2U);
    EXPECT_EQ(logic.Find({0x2200U, 2U}), &logic.Pairs()[4]);
}

TEST_F(AssemblyTest, TellsWhatTheKernelRefusesOfItsFile)
{
    Verifies(req::SRS_NODE_030);
    // Given a file with 1300h for a device without GFC
    std::string text = cia306::test::FileText("digest");
    const std::size_t use = text.find("ParameterValue=", text.find("[5F00subE]\n"));
    text.replace(use, text.find('\n', use) - use, "ParameterValue=0");
    const std::size_t digest = text.find("ParameterValue=", text.find("[5F04]\n"));
    text.replace(digest, text.find('\n', digest) - digest, "ParameterValue=0");
    Built device(File("a.dcf", text));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    std::vector<std::pair<std::uint16_t, AbortCode>> refused{{0x1300U, AbortCode::kObjectUnknown}};
    EXPECT_EQ(device.owner.refused, refused);
    // And told again when communication is reset
    device.Command(130U);
    refused.emplace_back(0x1300U, AbortCode::kObjectUnknown);
    EXPECT_EQ(device.owner.refused, refused);
}

// Two services with one identifier are told but where a store gave the value.
TEST_F(AssemblyTest, SaysNothingOfAnIdentifierThatWasSaved)
{
    Verifies(req::SRS_NODE_050);
    using cia306::test::VariableText;
    Built device(File("a.dcf", kNodeFive + VariableText("1005", "7", "0x240") + VariableText("1014", "7", "0x240")));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    const auto told = [&device](const bool is_replaced)
    { return device.assembly.Objects().NotTaken([is_replaced](const ObjectAddress&) { return is_replaced; }).size(); };
    EXPECT_EQ(told(false), 1U);
    EXPECT_EQ(told(true), 0U);
}

// What builds a device and says nothing of a DOMAIN is check, simulate and a scenario: it has 8192 bytes, and the
// server room for all of them.
TEST_F(AssemblyTest, HasADomainOf8192Bytes)
{
    Verifies(req::SRS_NODE_040);
    Built device(File("a.dcf", kNodeFive + "[3000]\nParameterName=d\nObjectType=2\nAccessType=rw\n"));
    ASSERT_EQ(device.PowerOn(), device::LoadResult::kLoaded);
    const auto answer = [&device]
    {
        const std::vector<Octets> answers = device.Sent(0x585U);
        return answers.empty() ? Octets{} : answers.back();
    };
    // When 1170 segments of 7 bytes come without a stated length, then two bytes more are taken, three are too many
    for (const std::uint8_t rest : {std::uint8_t{2U}, std::uint8_t{3U}})
    {
        device.Receive(0x605U, {0x20U, 0x00U, 0x30U, 0U, 0U, 0U, 0U, 0U});
        device.Cycle();
        std::uint8_t toggle = 0U;
        for (int segment = 0; segment < 1170; ++segment)
        {
            device.Receive(0x605U, {toggle, 1U, 2U, 3U, 4U, 5U, 6U, 7U});
            device.Cycle();
            toggle ^= 0x10U;
        }
        ASSERT_EQ(answer()[0], 0x30U);
        const auto last = static_cast<std::uint8_t>(toggle | ((7U - rest) << 1U) | 1U);
        device.Receive(0x605U, {last, 1U, 2U, 3U, 0U, 0U, 0U, 0U});
        device.Cycle();
        EXPECT_EQ(answer(), (rest == 2U) ? (Octets{0x20U, 0U, 0U, 0U, 0U, 0U, 0U, 0U})
                                         : (Octets{0x80U, 0x00U, 0x30U, 0x00U, 0x05U, 0x00U, 0x04U, 0x05U}));
    }
}

TEST(OptionalServiceTexts, SayWhatCame)
{
    Verifies(req::SRS_NODE_012);
    cia301::TimeOfDay time{};
    time.ms = 1500U;
    time.days = 2U;
    EXPECT_EQ(TextOf(time), "time 1500 ms of day 2");
    cia301::ReceivedEmergency emergency{};
    emergency.node.value = 7U;
    emergency.code = 0x8130U;
    emergency.error_register = 0x11U;
    emergency.details[4] = 0xAAU;
    EXPECT_EQ(TextOf(emergency), "emergency of node 7: 0x8130, register 0x11, 00 00 00 00 AA");
    const Octets bytes(33U, 0x5AU);
    EXPECT_EQ(BytesText(bytes.data(), 2U), "5A 5A");
    const std::string all = BytesText(bytes.data(), 32U);
    EXPECT_EQ(all.size(), 95U);
    EXPECT_EQ(BytesText(bytes.data(), 33U), all + " ...");
}
} // namespace
} // namespace counterpoint::runtime
