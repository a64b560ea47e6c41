// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// An SDO client reads and writes the generated dictionary. Then the second of examples/actuator: commands every 25 ms,
// a stop from 300 to 400 ms, none from 500 to 600 ms; a person acknowledges at 150 and at 750 ms.
#include "examples/generated_actuator/run.hpp"

#include "actuator/object_dictionary.hpp"
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "examples/generated_actuator/drive.hpp"
#include "examples/host/bench.hpp"

namespace counterpoint::examples
{
namespace
{

constexpr std::uint32_t kSafetyFrames = (2U * actuator::kSrdoCount) + 2U;
constexpr std::uint32_t kServiceFrames = 16U;
constexpr std::uint8_t kHistory = 4U;

/// A whole device with the services of CiA 301, but for its hardware.
struct Node final : private device::Owner
{
    explicit Node(Board& board)
        : kernel{KernelParts{a, b, board.can, board.output, board.watchdog, watch, nullptr, &windows[0]}},
          services{cia301::NodeId{actuator::kNodeId},
                   device::ServiceParts{
                       emergency, board.can, dictionary,
                       device::ServiceRooms{
                           {nullptr, 0U}, {nullptr, 0U}, {nullptr, 0U}, {buffer, actuator::kLongestObjectBytes}}}},
          whole{device::DeviceParts{kernel, watch, dictionary, services, *this,
                                    device::FrameRoom{safety_frames, kSafetyFrames},
                                    device::FrameRoom{service_frames, kServiceFrames}, actuator::kSrdoCount}}
    {
    }

    device::LoadResult OnResetNode() noexcept override
    {
        started = kernel.Start(actuator::kDevice, FlowCallback::kOff);
        return (started == StartResult::kStarted) ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
    }
    /// What the file says of the configuration, and who keeps 1017h.
    device::LoadResult OnResetCommunication() noexcept override
    {
        const generated::IndexRange heartbeat{0x1017U, 0x1017U};
        static_cast<void>(actuator::Objects().Attach(heartbeat, {nullptr, &services.objects}));
        static_cast<void>(actuator::Objects().Preset(heartbeat));
        configured = actuator::Configure(kernel).abort;
        return (configured == AbortCode::kNone) ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
    }

    StartResult started{StartResult::kInvalid};
    AbortCode configured{AbortCode::kNone};
    channel_a::StorageFor<actuator::kSrdoCount, actuator::kMapEntries> storage_a{};
    channel_b::StorageFor<actuator::kSrdoCount, actuator::kMapEntries> storage_b{};
    channel_a::Channel a{storage_a.Handle()};
    channel_b::Channel b{storage_b.Handle()};
    Drive drive{};
    std::uint32_t history[kHistory]{};
    cia301::EmergencyProducer emergency{cia301::NodeId{actuator::kNodeId}, cia301::ErrorHistory{history, kHistory}};
    device::KernelWatch watch{emergency, drive};
    CauseWindows windows[actuator::kSrdoCount]{};
    Kernel kernel;
    device::SafetyObjects safety_objects{kernel, actuator::kEntryTable};
    cia301::Dictionary dictionary{actuator::kEntryTable, safety_objects};
    std::uint8_t buffer[actuator::kLongestObjectBytes]{};
    device::QueuedFrame safety_frames[kSafetyFrames]{};
    device::QueuedFrame service_frames[kServiceFrames]{};
    device::Services services;
    device::Device whole;
};

/// The four data bytes of an expedited answer.
std::uint32_t Ask(Node& node, const cia301::SdoFrame& request)
{
    const cia301::SdoFrame answer = node.services.sdo.OnFrame(request, 8U, Instant{0U}).frame;
    return static_cast<std::uint32_t>(cia301::FromLittleEndian(&answer.bytes[4], 4U));
}

std::string Converse(Node& node)
{
    std::string text = "1018h:02 " + std::to_string(Ask(node, {{0x40U, 0x18U, 0x10U, 2U, 0U, 0U, 0U, 0U}}));
    text += ", SCT " + std::to_string(Ask(node, {{0x40U, 0x01U, 0x13U, 2U, 0U, 0U, 0U, 0U}})) + " ms";
    text += ", heartbeat " + std::to_string(node.services.producer.PeriodMs()) + " ms";
    static_cast<void>(Ask(node, {{0x2BU, 0x17U, 0x10U, 0U, 0xFAU, 0U, 0U, 0U}}));
    return text + ", then " + std::to_string(node.services.producer.PeriodMs()) + " ms, and " +
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
    board.device = &node.whole;
    if (!board.PowerOn())
    {
        return RefusalOf(node.started, node.configured);
    }
    const std::string conversation = Converse(node);
    TimeLine line{};
    for (unsigned ms = 1U; ms <= 1000U; ++ms)
    {
        if (ms == 9U)
        {
            controller.StartAll();
        }
        if (((ms % 25U) == 0U) && ((ms < 500U) || (ms >= 600U)))
        {
            const std::uint8_t command = ((ms >= 300U) && (ms < 400U)) ? 0U : 1U;
            controller.Send(TwoBytes{command, command});
        }
        bus.Advance(ms * host::kMillisecond);
        const bool is_pressed = ((ms >= 150U) && (ms < 200U)) || ((ms >= 750U) && (ms < 800U));
        // A button of two contacts, one for each channel: one closes when it is pressed, one opens.
        const bool make_contact = is_pressed;
        const bool break_contact = !is_pressed;
        constexpr SrdoMask kSlot = SrdoMask{1U} << actuator::kSrdo1Slot;
        node.whole.Cycle(CycleCall{board.clocks.Now(), make_contact ? kSlot : 0U, break_contact ? 0U : kSlot});
        const SrdoMask open = board.output.Open();
        line.Note(ms, std::string{NameOf(node.kernel.GetState(actuator::kSrdo1).state)} + ", gate " +
                          ((open != 0U) ? "open" : "closed") + ", drive " +
                          (Drive::MayMove(open) ? "moves" : "stands"));
    }
    return conversation + line.Text() + NameOf(node.kernel.DeviceState()) + "\n";
}

} // namespace counterpoint::examples
