// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node_application.hpp"

#include <stdexcept>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint16_t kCommunicationBase = 0x1300U;

std::uint64_t ObjectNumber(const ObjectAddress& object)
{
    return (std::uint64_t{object.index} << 8U) | object.sub;
}
} // namespace

NodeApplication::NodeApplication(const NodeIndex node, const runtime::DeviceModel& model, Journal& journal,
                                 const runtime::Half half)
    : node_(node), config_(model.Config()), journal_(journal), logic_(model, half)
{
}

void NodeApplication::Join(const Kernel& kernel) noexcept
{
    kernel_ = &kernel;
}

void NodeApplication::AddRule(const runtime::LogicRule& rule)
{
    static_cast<void>(logic_.AddRule(rule));
}

void NodeApplication::Follow(Kernel& kernel, const runtime::DeviceModel& model)
{
    logic_.Follow(kernel, model);
}

const runtime::PairValue& NodeApplication::PairAt(const ObjectAddress& object) const
{
    const runtime::PairValue* const pair = logic_.Find(object);
    if (pair == nullptr)
    {
        throw std::out_of_range("no pair of the device");
    }
    return *pair;
}

void NodeApplication::SetInput(const ObjectAddress& object, const std::uint64_t value)
{
    logic_.SetInput(PairAt(object).address, value);
}

void NodeApplication::Disturb(const ObjectAddress& object, const std::uint64_t bits)
{
    logic_.Disturb(PairAt(object).address, bits);
}

void NodeApplication::SetNow(const Nanoseconds now) noexcept
{
    now_ = now;
}

bool NodeApplication::Run(const SrdoMask open, const Nanoseconds now, const bool is_frozen)
{
    logic_.Take(
        open, [this, now](const runtime::PairValue& pair)
        { journal_.Note({now, EventKind::kValue, node_, pair.srdo, pair.normal, ObjectNumber(pair.address)}); });
    bool is_held_back = false;
    for (const runtime::PairValue& pair : logic_.Pairs())
    {
        if (pair.is_consumer || !pair.is_mapped)
        {
            continue;
        }
        if (is_frozen)
        {
            is_held_back = is_held_back || ReadVariable(pair.normal_place).bits != pair.normal;
        }
        else
        {
            logic_.Write(pair);
            const bool is_first = pair.disturbance != 0U && disturbed_at_ == kNever;
            disturbed_at_ = is_first ? now : disturbed_at_;
        }
    }
    return is_held_back;
}

std::uint64_t NodeApplication::ValueOf(const ObjectAddress& normal) const
{
    return PairAt(normal).normal;
}

std::uint64_t NodeApplication::SafeValueOf(const ObjectAddress& normal) const
{
    return PairAt(normal).safe;
}

bool NodeApplication::TakeChange()
{
    return logic_.TakeChange();
}

Nanoseconds NodeApplication::DisturbedAt() const noexcept
{
    return disturbed_at_;
}

Event NodeApplication::At(const EventKind kind, const CommunicationIndex index, const std::uint64_t value) const
{
    const bool has_srdo = index.value > kCommunicationBase;
    const auto srdo = static_cast<std::uint8_t>(has_srdo ? index.value - kCommunicationBase : 0U);
    return {now_, kind, node_, srdo, value, 0U};
}

void NodeApplication::ForgetFault() noexcept
{
    knows_fault_ = false;
}

void NodeApplication::NoteUntold(const DeviceFaultReport& report) noexcept
{
    if (report.fault != DeviceFault::kNone && !knows_fault_)
    {
        NodeApplication::OnDeviceFault(report);
    }
}

RefreshAnswer NodeApplication::OnRefresh(const CommunicationIndex index) noexcept
{
    static_cast<void>(index);
    return RefreshAnswer::kReady;
}

void NodeApplication::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    static_cast<void>(index);
}

void NodeApplication::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    journal_.Note(At(EventKind::kSignal, index, static_cast<std::uint64_t>(cause)));
}

void NodeApplication::OnGfc() noexcept
{
    journal_.Tell(At(EventKind::kGfc, CommunicationIndex{0U}, 2U));
}

void NodeApplication::OnGfcNotFollowed() noexcept
{
    journal_.Tell(At(EventKind::kGfc, CommunicationIndex{0U}, 3U));
}

void NodeApplication::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    journal_.Note(At(EventKind::kConfigurationInvalid, index, 0U));
}

void NodeApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    knows_fault_ = true;
    const bool has_slot = report.slot < config_.srdo_count;
    const auto number = static_cast<std::uint8_t>(has_slot ? config_.srdos[report.slot].number : 0U);
    const DeviceFault verdict = (kernel_ == nullptr) ? DeviceFault::kNone : kernel_->LastVerdict().fault;
    journal_.Note({now_, EventKind::kDeviceFault, node_, number, static_cast<std::uint64_t>(report.fault),
                   static_cast<std::uint64_t>(verdict)});
}

void NodeApplication::OnFlow(const FlowCount& count) noexcept
{
    static_cast<void>(count);
}
} // namespace counterpoint::simulator
