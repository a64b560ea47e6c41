// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// An SDO client reads and writes the generated dictionary. Then the second of examples/actuator: commands every 25 ms,
// a stop from 300 to 400 ms, none from 500 to 600 ms; a person acknowledges at 150 and at 750 ms.
#include "examples/generated_actuator/run.hpp"

#include "actuator/object_dictionary.hpp"
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"
#include "canopen/cia301/sdo/server.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/generated_actuator/drive.hpp"
#include "examples/host/bench.hpp"

namespace counterpoint::examples
{
namespace
{

/// Everything of the node but its hardware.
struct Node
{
    explicit Node(Board& board) : kernel{KernelParts{a, b, board.can, board.output, board.watchdog, drive}}
    {
    }

    channel_a::StorageFor<actuator::kSrdoCount, actuator::kMapEntries> storage_a{};
    channel_b::StorageFor<actuator::kSrdoCount, actuator::kMapEntries> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    Drive drive{};
    Kernel kernel;
    cia301::KernelObjects safety_objects{kernel};
    cia301::Dictionary dictionary{actuator::kEntryTable, safety_objects};
    std::uint8_t buffer[actuator::kLongestObjectBytes]{};
    cia301::SdoServer server{{dictionary, {buffer, actuator::kLongestObjectBytes}, 100000U, 127U}};
    cia301::HeartbeatProducer heartbeat{cia301::NodeId{actuator::kNodeId}};
    HeartbeatTime heartbeat_time{heartbeat};
};

/// First what the file says of the device and its configuration, then who keeps 1017h.
std::string PowerOn(Node& node)
{
    if (node.kernel.Start(actuator::kDevice, FlowCallback::kOff) != StartResult::kStarted)
    {
        return "start refused\n";
    }
    if (actuator::Configure(node.kernel).abort != AbortCode::kNone)
    {
        return "configuration refused\n";
    }
    const generated::IndexRange heartbeat{0x1017U, 0x1017U};
    static_cast<void>(actuator::Objects().Attach(heartbeat, {nullptr, &node.heartbeat_time}));
    static_cast<void>(actuator::Objects().Preset(heartbeat));
    node.dictionary.SetNmtState(NmtState::kPreOperational);
    return "";
}

/// The four data bytes of an expedited answer.
std::uint32_t Ask(Node& node, const cia301::SdoFrame& request)
{
    const cia301::SdoFrame answer = node.server.OnFrame(request, 8U, Instant{0U}).frame;
    return static_cast<std::uint32_t>(cia301::FromLittleEndian(&answer.bytes[4], 4U));
}

std::string Converse(Node& node)
{
    std::string text = "1018h:02 " + std::to_string(Ask(node, {{0x40U, 0x18U, 0x10U, 2U, 0U, 0U, 0U, 0U}}));
    text += ", SCT " + std::to_string(Ask(node, {{0x40U, 0x01U, 0x13U, 2U, 0U, 0U, 0U, 0U}})) + " ms";
    text += ", heartbeat " + std::to_string(node.heartbeat.PeriodMs()) + " ms";
    static_cast<void>(Ask(node, {{0x2BU, 0x17U, 0x10U, 0U, 0xFAU, 0U, 0U, 0U}}));
    return text + ", then " + std::to_string(node.heartbeat.PeriodMs()) + " ms, and " +
           std::to_string(actuator::GetProducerHeartbeatTimeMs()) + " ms in the dictionary\n";
}

} // namespace

std::string RunGeneratedActuator()
{
    host::VirtualBus bus{host::BitRate::k500k};
    Board board{bus, InstantPair{{123456U}, {0U}}};
    OtherNode controller{bus, 0x103U, 0x105U};
    actuator::ResetApplication();
    Node node{board};
    board.kernel = &node.kernel;
    const std::string problem = PowerOn(node);
    if (!problem.empty())
    {
        return problem;
    }
    const std::string conversation = Converse(node);
    board.PowerOn();
    TimeLine line{};
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 10U)
        {
            node.kernel.SetNmtState(NmtState::kOperational);
        }
        if (((ms % 25U) == 0U) && ((ms < 500U) || (ms >= 600U)))
        {
            const std::uint8_t command = ((ms >= 300U) && (ms < 400U)) ? 0U : 1U;
            controller.Send(TwoBytes{command, command});
        }
        bus.Advance(ms * host::kMillisecond);
        const bool is_pressed = ((ms >= 150U) && (ms < 200U)) || ((ms >= 750U) && (ms < 800U));
        const SrdoMask acknowledge = is_pressed ? SrdoMask{1U} << actuator::kSrdo1Slot : 0U;
        node.kernel.Cycle(CycleCall{board.clocks.Now(), acknowledge, acknowledge});
        const SrdoMask open = board.output.Open();
        line.Note(ms, std::string{NameOf(node.kernel.GetState(actuator::kSrdo1).state)} + ", gate " +
                          ((open != 0U) ? "open" : "closed") + ", drive " +
                          (Drive::MayMove(open) ? "moves" : "stands"));
    }
    return conversation + line.Text() + NameOf(node.kernel.DeviceState()) + "\n";
}

} // namespace counterpoint::examples
