// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/loop.hpp"

#include "runtime/node/srdo_line.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/names.hpp"

// What a live node is asked, and its answers. [SRS_NODE_003, SRS_NODE_004]
namespace counterpoint::runtime
{
namespace
{
using runtime::ObjectText;

constexpr std::uint16_t kCommunicationBase = 0x1300U;

std::string AbortText(const cia301::SdoAbort abort)
{
    return runtime::AbortText(static_cast<AbortCode>(static_cast<std::uint32_t>(abort)));
}

std::string Milliseconds(const std::uint32_t us)
{
    return runtime::MillisecondsText(runtime::Nanoseconds{us} * runtime::kNanosecondsPerMicrosecond);
}
} // namespace

void NodeLoop::TellStart()
{
    const DeviceConfig& config = device_->Config();
    const runtime::DeviceModel& model = device_->Model();
    const bool has_node_id = device_->NodeId() != 0U;
    Tell((has_node_id ? "node " + std::to_string(config.node_id) : std::string("node without a node-ID")) + " of " +
             cia306::Printable(model.File()) + " on " + BusNames() + ", cycle " + Milliseconds(config.cycle_us) +
             ", late above " + Milliseconds(config.cycle_us + config.cycle_tolerance_us),
         "start",
         {{"node_id", device_->NodeId()},
          {"dcf", model.File()},
          {"can", BusNames()},
          {"cycle_us", config.cycle_us},
          {"cycle_tolerance_us", config.cycle_tolerance_us}});
    const NodeSelfTest* const tests = device_->SelfTests();
    const std::string covered = (tests == nullptr) ? "none" : tests->Text();
    Tell("self tests: " + covered, "self_tests", {{"covered", covered}});
    if (model.Srdos().empty())
    {
        Tell("no safety objects: a plain CANopen device", "plain", nlohmann::ordered_json::object());
    }
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        if (srdo.direction == kDirectionConsumer || srdo.direction == kDirectionProducer)
        {
            TellSrdo(parts_.report, now_ns_, config, srdo);
        }
    }
}

std::string NodeLoop::BusNames() const
{
    host::LiveBus* const inverse = parts_.ports.Inverse();
    return parts_.ports.Services().Name() + (inverse == nullptr ? "" : " and " + inverse->Name());
}

void NodeLoop::TellProblem(const std::string& problem)
{
    if (!problem.empty())
    {
        Tell(problem, "problem", {{"text", problem}});
    }
}

void NodeLoop::Carry(const NodeOrder& order)
{
    switch (order.kind)
    {
    case OrderKind::kSet:
        SetObject(order);
        break;
    case OrderKind::kGet:
        TellObject(order.object);
        break;
    case OrderKind::kAcknowledge:
        if (!device_->Acknowledge(static_cast<std::uint8_t>(order.value), now_ns_))
        {
            Tell("ack: no SRDO " + std::to_string(order.value) + ", expected one of this device", "problem",
                 {{"text", "no such SRDO"}});
        }
        break;
    case OrderKind::kGfc:
        if (device_->Core().SendGfc() != Result::kSuccessful)
        {
            Tell("gfc: refused, expected OPERATIONAL, a valid configuration and 1300h = 1", "problem",
                 {{"text", "gfc refused"}});
        }
        break;
    case OrderKind::kNmt:
    {
        const std::string name = Name(cia301::KernelState(device_->Services().State()));
        Tell("NMT " + name, "nmt", {{"state", name}});
        break;
    }
    case OrderKind::kCommand:
        SendCommand(order);
        break;
    case OrderKind::kState:
        TellState();
        break;
    case OrderKind::kTime:
        TellProblem(device_->Further().SendTime(device_->Services().State(), now_.a));
        break;
    case OrderKind::kRead:
    case OrderKind::kWrite:
        TellProblem(device_->Further().StartTransfer(order, now_.a));
        break;
    case OrderKind::kHelp:
        parts_.report.Print(OrderHelp());
        break;
    case OrderKind::kQuit:
        reason_ = "quit";
        break;
    case OrderKind::kProblem:
        TellProblem(order.problem);
        break;
    case OrderKind::kNothing:
        break;
    }
}

/// An input of the application, else an object of the device itself.
void NodeLoop::SetObject(const NodeOrder& order)
{
    if (device_->App().SetInput(order.object, order.value))
    {
        return;
    }
    cia301::Dictionary& objects = device_->Objects();
    const cia301::Reading size = objects.SizeOf(order.object);
    cia301::SdoAbort abort = size.abort;
    if (abort == cia301::SdoAbort::kNone)
    {
        abort = objects.WriteNumber(order.object, order.value, size.size_bytes);
    }
    pending_ = (abort == cia301::SdoAbort::kPending) ? order : NodeOrder{};
    if (abort != cia301::SdoAbort::kNone && abort != cia301::SdoAbort::kPending)
    {
        const std::string text = "set: " + ObjectText(order.object) + " = " + std::to_string(order.value) +
                                 " refused with " + AbortText(abort) +
                                 ", expected an input or an object of the device, and a value that it takes";
        Tell(text, "problem", {{"text", text}});
    }
}

void NodeLoop::TellObject(const ObjectAddress& object)
{
    const cia301::NumberReading reading = device_->Objects().ReadNumber(object);
    if (reading.abort == cia301::SdoAbort::kNone)
    {
        Tell(ObjectText(object) + " = " + std::to_string(reading.value), "object",
             {{"object", ObjectText(object)}, {"value", reading.value}});
        return;
    }
    const std::string text =
        "get: " + ObjectText(object) + ": " + AbortText(reading.abort) + ", expected an object of numbers";
    Tell(text, "problem", {{"text", text}});
}

/// To this node as if it had come from the bus, to another as a master would.
void NodeLoop::SendCommand(const NodeOrder& order)
{
    const std::uint8_t own = device_->NodeId();
    host::LiveFrame frame;
    frame.length_bytes = 2U;
    frame.data[0U] = static_cast<std::uint8_t>(order.value);
    frame.data[1U] = (order.node == 0U) ? own : order.node;
    if (frame.data[1U] == own)
    {
        device_->OnFrame(frame, CanPortId::kFirst, now_);
    }
    else if (parts_.ports.Services().Send(frame) != host::SendResult::kSent)
    {
        Tell("nmt: the bus takes no frame now", "problem", {{"text", "bus takes no frame"}});
    }
}

void NodeLoop::TellState()
{
    const DeviceFaultReport fault = device_->Core().DeviceState();
    const SrdoMask open = device_->Open();
    std::string text = std::string("NMT ") + Name(cia301::KernelState(device_->Services().State())) + ", device " +
                       (fault.fault == DeviceFault::kNone ? "running" : Name(fault.fault));
    nlohmann::ordered_json details{{"nmt", Name(cia301::KernelState(device_->Services().State()))},
                                   {"device_fault", Name(fault.fault)},
                                   {"srdos", nlohmann::ordered_json::array()}};
    for (SlotIndex slot = 0U; slot < device_->Model().Srdos().size(); ++slot)
    {
        const std::uint8_t number = device_->Model().NumberOf(slot);
        const auto index = static_cast<std::uint16_t>(kCommunicationBase + number);
        const StateReply state = device_->Core().GetState({index});
        const bool is_open = ((open >> slot) & 1U) != 0U;
        const std::string name = runtime::NameOf(runtime::kStateWords, state.state);
        const std::string cause = Name(state.first_cause);
        text += "; SRDO " + std::to_string(number) + " " + name + (cause == "none" ? "" : " (" + cause + ")") +
                (is_open ? ", output open" : "");
        details["srdos"].push_back(
            {{"srdo", number}, {"state", name}, {"cause", cause}, {"errors", state.error_count}, {"open", is_open}});
    }
    details["values"] = device_->App().Values();
    Tell(text + "; " + device_->App().Values(), "state", details);
}
} // namespace counterpoint::runtime
