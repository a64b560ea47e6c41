// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/orders.hpp"

#include "canopen/cia306/file/saved.hpp"
#include "runtime/device/names.hpp"
#include "runtime/node/number.hpp"
#include "runtime/node/object_value.hpp"

#include <optional>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kBitsOfByte = 8U;

/// As the device's own application, but for the state: a person saves and restores where a client may. [SRS_NODE_530]
cia301::SdoAbort WriteObject(DeviceAssembly& assembly, const ObjectAddress& object, const std::uint64_t bits,
                             const cia301::Attempt attempt)
{
    cia301::Dictionary& objects = assembly.Dictionary();
    const std::uint32_t size_bytes = objects.SizeOf(object).size_bytes;
    if (attempt == cia301::Attempt::kAgain)
    {
        return objects.WriteNumberAgain(object, bits, size_bytes);
    }
    const bool is_operational = assembly.Device().State() == cia301::NodeState::kOperational;
    return is_operational && cia306::IsStoreCommand(object.index) ? cia301::SdoAbort::kDeviceState
                                                                  : objects.WriteNumber(object, bits, size_bytes);
}

/// A BOOLEAN has one word for each value that is none of its two. [SRS_NODE_531]
cia301::SdoAbort OfType(const cia301::SdoAbort abort, const cia306::Device& file, const ObjectAddress& object)
{
    const cia306::Entry* const entry = file.Find(object.index, object.sub);
    const bool is_boolean = entry != nullptr && entry->type.kind == cia306::DataKind::kBoolean;
    const bool is_outside = abort == cia301::SdoAbort::kValueHigh || abort == cia301::SdoAbort::kValueLow;
    return is_boolean && is_outside ? cia301::SdoAbort::kValueRange : abort;
}
/// Whether the device produces that SRDO at present: nobody waits for an acknowledge of it. [SRS_NODE_660]
bool IsSent(const std::uint64_t number, NodeDevice& device)
{
    const auto index = static_cast<std::uint16_t>(0x1300U + number);
    return device.Assembly().Core().ReadObject({index, 1U}).data.bytes[0] == kDirectionProducer;
}
} // namespace

NodeOrders::NodeOrders(NodePorts& ports, NodeReport& report) : ports_(ports), report_(report)
{
}

bool NodeOrders::Carry(const NodeOrder& order, NodeDevice& device, const NodeMoment& at)
{
    at_ = at;
    switch (order.kind)
    {
    case OrderKind::kSet:
        Set(order, device, cia301::Attempt::kFirst);
        break;
    case OrderKind::kGet:
        TellObject(order.object, device);
        break;
    case OrderKind::kAcknowledge:
        Acknowledge(order, device);
        break;
    case OrderKind::kGfc:
        if (device.Assembly().Core().SendGfc() != Result::kSuccessful)
        {
            TellProblem("gfc: refused, expected OPERATIONAL, a valid configuration and 1300h = 1", "gfc refused");
        }
        break;
    case OrderKind::kNmt:
    {
        const std::string name = Name(cia301::KernelState(device.Assembly().Device().State()));
        report_.Tell(at_.now_ns, "NMT " + name, "nmt", {{"state", name}});
        break;
    }
    case OrderKind::kCommand:
        SendCommand(order, device);
        break;
    case OrderKind::kState:
        TellState(device);
        break;
    case OrderKind::kTime:
        TellProblem(device.Transfers().SendTime(device.Assembly().Device().State(), at_.now.a));
        break;
    case OrderKind::kRead:
    case OrderKind::kWrite:
        TellProblem(device.Transfers().StartTransfer(order, at_.now.a));
        break;
    case OrderKind::kHelp:
        report_.Print(OrderHelp());
        break;
    case OrderKind::kQuit:
        break;
    case OrderKind::kProblem:
        TellProblem(order.problem);
        break;
    case OrderKind::kNothing:
        break;
    }
    return order.kind != OrderKind::kQuit;
}

void NodeOrders::Acknowledge(const NodeOrder& order, NodeDevice& device)
{
    const std::string number = std::to_string(order.value);
    if (!device.Acknowledge(static_cast<std::uint8_t>(order.value), at_.now_ns))
    {
        TellProblem("ack: no SRDO " + number + ", expected one of this device", "no such SRDO");
    }
    else if (IsSent(order.value, device))
    {
        TellProblem("ack: SRDO " + number + " is sent, expected one that is received", "no such SRDO");
    }
}

void NodeOrders::GoOn(NodeDevice& device, const NodeMoment& at)
{
    at_ = at;
    if (pending_)
    {
        Set(*std::exchange(pending_, std::nullopt), device, cia301::Attempt::kAgain);
    }
}

/// An input of the application, else an object of the device itself.
void NodeOrders::Set(const NodeOrder& order, NodeDevice& device, const cia301::Attempt attempt)
{
    if (device.App().IsComputed(order.object))
    {
        TellProblem("set: " + ObjectText(order.object) +
                    " is what a rule of the script computes, expected an object that no rule sets");
        return;
    }
    const cia306::Device& file = device.App().File();
    const NumberBits number = BitsOf(FormOf(file, device.Assembly().Dictionary(), order.object), order);
    const cia301::Reading size = device.Assembly().Dictionary().SizeOf(order.object);
    const std::optional<std::uint64_t> highest = device.App().HighestInput(order.object);
    const bool is_cut = size.size_bytes < sizeof(number.bits) && (number.bits >> (kBitsOfByte * size.size_bytes)) != 0U;
    cia301::SdoAbort abort = (size.abort == cia301::SdoAbort::kNone) ? number.abort : size.abort;
    if (abort == cia301::SdoAbort::kNone && (is_cut || number.bits > highest.value_or(number.bits)))
    {
        abort = cia301::SdoAbort::kValueHigh;
    }
    if (abort == cia301::SdoAbort::kNone && !device.App().SetInput(order.object, number.bits))
    {
        abort = WriteObject(device.Assembly(), order.object, number.bits, attempt);
    }
    abort = OfType(abort, file, order.object);
    if (abort == cia301::SdoAbort::kPending)
    {
        pending_ = order;
    }
    if (abort != cia301::SdoAbort::kNone && abort != cia301::SdoAbort::kPending)
    {
        TellProblem("set: " + ObjectText(order.object) + " = " + (order.is_negative ? "-" : "") +
                    std::to_string(order.value) + " refused with " + SdoAbortText(abort) +
                    ", expected an input or an object of the device, and a value that it takes");
    }
}

void NodeOrders::TellObject(const ObjectAddress& object, NodeDevice& device)
{
    const ObjectValue value = ValueOf(device.App().File(), device.Assembly().Dictionary(), object);
    if (value.abort == cia301::SdoAbort::kNone)
    {
        nlohmann::ordered_json details{{"object", ObjectText(object)}};
        details.update(value.details);
        report_.Tell(at_.now_ns, ObjectText(object) + " = " + value.text, "object", details);
        return;
    }
    TellProblem("get: " + ObjectText(object) + ": " + SdoAbortText(value.abort) +
                ", expected an object of the device that has a value");
}

/// To this node as if it had come from the bus, to another as a master would.
void NodeOrders::SendCommand(const NodeOrder& order, NodeDevice& device)
{
    const std::uint8_t own = device.Assembly().NodeId();
    host::LiveFrame frame;
    frame.length_bytes = 2U;
    frame.data[0U] = static_cast<std::uint8_t>(order.value);
    frame.data[1U] = (order.node == 0U) ? own : order.node;
    if (frame.data[1U] == own)
    {
        device.OnFrame(frame, CanPortId::kFirst, at_.now);
    }
    else if (ports_.Services().Send(frame) != host::SendResult::kSent)
    {
        TellProblem("nmt: the bus takes no frame now", "bus takes no frame");
    }
}

void NodeOrders::TellState(NodeDevice& device)
{
    const char* const nmt = Name(cia301::KernelState(device.Assembly().Device().State()));
    const DeviceFaultReport fault = device.Assembly().Core().DeviceState();
    const SrdoMask open = device.Outputs().Open();
    std::string text =
        std::string("NMT ") + nmt + ", device " + (fault.fault == DeviceFault::kNone ? "running" : Name(fault.fault));
    nlohmann::ordered_json details{
        {"nmt", nmt}, {"device_fault", Name(fault.fault)}, {"srdos", nlohmann::ordered_json::array()}};
    for (SlotIndex slot = 0U; slot < device.Model().Srdos().size(); ++slot)
    {
        const std::uint8_t number = device.Model().NumberOf(slot);
        const StateReply state = device.Assembly().Core().GetState(CommunicationIndexOf(number));
        const bool is_open = ((open >> slot) & 1U) != 0U;
        const std::string name = NameOf(kStateWords, state.state);
        const std::string cause = Name(state.first_cause);
        text += "; SRDO " + std::to_string(number) + " " + name + (cause == "none" ? "" : " (" + cause + ")") +
                (is_open ? ", output open" : "");
        details["srdos"].push_back(
            {{"srdo", number}, {"state", name}, {"cause", cause}, {"errors", state.error_count}, {"open", is_open}});
    }
    details["values"] = device.App().Values();
    report_.Tell(at_.now_ns, text + "; " + device.App().Values(), "state", details);
}

void NodeOrders::TellProblem(const std::string& text, const std::string& shown)
{
    if (!text.empty())
    {
        report_.Tell(at_.now_ns, text, "problem", {{"text", shown.empty() ? text : shown}});
    }
}
} // namespace counterpoint::runtime
