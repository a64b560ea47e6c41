// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/application.hpp"

#include "runtime/device/names.hpp"
#include "runtime/node/number.hpp"

#include <utility>

namespace counterpoint::runtime
{
namespace
{

constexpr std::uint16_t kCommunicationBase = 0x1300U;

std::uint8_t NumberOf(const CommunicationIndex index)
{
    return static_cast<std::uint8_t>(index.value - kCommunicationBase);
}
} // namespace

NodeApplication::NodeApplication(const runtime::DeviceModel& model, const cia306::Device& file, NodeReport& report)
    : file_(file), report_(report), logic_(model, runtime::Half::kBoth)
{
}

void NodeApplication::Tell(OnPair on_pair)
{
    on_pair_ = std::move(on_pair);
}

void NodeApplication::Follow(Kernel& kernel, const runtime::DeviceModel& model)
{
    logic_.Follow(kernel, model);
}

RuleFinding NodeApplication::AddRule(const LogicRule& rule)
{
    return logic_.AddRule(rule);
}

std::optional<std::uint64_t> NodeApplication::HighestInput(const ObjectAddress& object) const
{
    const PairValue* const pair = logic_.Find(object);
    const bool is_input = pair != nullptr && pair->is_mapped && !pair->is_consumer;
    return is_input ? std::optional(pair->mask) : std::nullopt;
}

bool NodeApplication::SetInput(const ObjectAddress& object, const std::uint64_t value)
{
    const std::optional<std::uint64_t> highest = HighestInput(object);
    const bool is_taken = highest && value <= *highest;
    if (is_taken)
    {
        logic_.SetInput(object, value);
    }
    return is_taken;
}

void NodeApplication::Run(const SrdoMask open)
{
    logic_.Take(open, [this](const PairValue& pair) { TellValue(pair); });
    WriteOut();
}

void NodeApplication::WriteOut()
{
    for (const PairValue& pair : logic_.Pairs())
    {
        if (!pair.is_consumer && pair.is_mapped)
        {
            logic_.Write(pair);
        }
    }
}

std::string NodeApplication::Values() const
{
    std::string values;
    for (const PairValue& pair : logic_.Pairs())
    {
        if (!pair.is_mapped)
        {
            continue;
        }
        values += (values.empty() ? "" : " ") + runtime::ObjectText(pair.address) + "=" +
                  NumberText(FormOf(file_, pair.address), pair.normal);
    }
    return values;
}

void NodeApplication::TellValue(const PairValue& pair)
{
    const NumberForm form = FormOf(file_, pair.address);
    const std::string object = runtime::ObjectText(pair.address);
    report_.Tell(now_ns_, "value " + object + " = " + NumberText(form, pair.normal), "value",
                 {{"srdo", pair.srdo}, {"object", object}, {"value", NumberJson(form, pair.normal)}});
}

// The inputs as they are now, not as they were behind the cycle before. [SRS_NODE_041]
RefreshAnswer NodeApplication::OnRefresh(const CommunicationIndex index) noexcept
{
    static_cast<void>(index);
    WriteOut();
    return RefreshAnswer::kReady;
}

void NodeApplication::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    if (on_pair_)
    {
        on_pair_(NumberOf(index));
    }
}

void NodeApplication::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    const std::string name = Name(cause);
    report_.Tell(now_ns_, "SRDO " + std::to_string(NumberOf(index)) + ": " + name, "srdo_error",
                 {{"srdo", NumberOf(index)}, {"cause", name}});
}

void NodeApplication::OnGfc() noexcept
{
    report_.Tell(now_ns_, "global fail-safe command received", "gfc", {{"received", true}});
}

void NodeApplication::OnGfcNotFollowed() noexcept
{
    report_.Tell(now_ns_, "no SRDO followed the own global fail-safe command", "gfc", {{"followed", false}});
}

void NodeApplication::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    has_told_invalid_ = true;
    report_.Tell(now_ns_, "configuration of SRDO " + std::to_string(NumberOf(index)) + " does not hold: SRDOs are off",
                 "configuration_invalid", {{"srdo", NumberOf(index)}});
}

void NodeApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    const std::string name = Name(report.fault);
    report_.Tell(now_ns_, "device safe state: " + name, "device_fault", {{"fault", name}});
}

void NodeApplication::OnFlow(const FlowCount& count) noexcept
{
    static_cast<void>(count);
}
} // namespace counterpoint::runtime
