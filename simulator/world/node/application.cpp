// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/application.hpp"

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

std::uint8_t NumberOf(const CommunicationIndex index)
{
    return static_cast<std::uint8_t>((index.value > kCommunicationBase) ? index.value - kCommunicationBase : 0);
}
} // namespace

NodeApplication::NodeApplication(const NodePlace& place, const runtime::DeviceModel& model, const runtime::Half half,
                                 PartFaults& faults)
    : place_(place), model_(model), faults_(faults), logic_(model, half),
      on_value_([this](const runtime::PairValue& pair)
                { place_.Note(EventKind::kValue, pair.srdo, pair.normal, ObjectNumber(pair.address)); })
{
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

/// Several may press at once: the input is 0 when the last one lets go. [SRS_SIM_170]
void NodeApplication::SetAcknowledge(const std::uint8_t srdo, const bool level)
{
    const SlotIndex slot = model_.SlotOf(srdo).value_or(0U);
    std::uint32_t& presses = presses_.at(slot);
    const bool was_pressed = presses != 0U;
    presses = level ? presses + 1U : presses - 1U;
    const bool is_pressed = presses != 0U;
    if (is_pressed != was_pressed)
    {
        acknowledge_ ^= SrdoMask{1U} << slot;
        place_.Tell(EventKind::kAcknowledge, srdo, is_pressed ? 1U : 0U, 0U);
    }
}

SrdoMask NodeApplication::AcknowledgeFor(const Part part)
{
    SrdoMask& seen = (part == Part::kAcknowledgeA) ? seen_a_ : seen_b_;
    const PartCondition& condition = faults_.Condition(part);
    if (!condition.is_faulty)
    {
        seen = acknowledge_;
    }
    else if (seen != acknowledge_)
    {
        faults_.HasEffect(condition);
    }
    return seen;
}

void NodeApplication::Run(const SrdoMask open)
{
    logic_.Take(open, on_value_);
    WriteOut();
}

void NodeApplication::WriteOut()
{
    const PartCondition& condition = faults_.Condition(Part::kApplication);
    for (const runtime::PairValue& pair : logic_.Pairs())
    {
        if (pair.is_consumer || !pair.is_mapped)
        {
            continue;
        }
        if (!condition.is_faulty)
        {
            logic_.Write(pair);
        }
        else if (ReadVariable(pair.normal_place).bits != pair.normal)
        {
            faults_.HasEffect(condition);
        }
    }
}

std::uint64_t NodeApplication::SafeValueOf(const ObjectAddress& normal) const
{
    return PairAt(normal).safe;
}

void NodeApplication::NoteUntold(const DeviceFaultReport& report) noexcept
{
    if (report.fault != DeviceFault::kNone && !knows_fault_)
    {
        NodeApplication::OnDeviceFault(report);
    }
}

// The inputs as they are now, not as they were behind the cycle before. [SRS_SIM_072]
RefreshAnswer NodeApplication::OnRefresh(const CommunicationIndex /*index*/) noexcept
{
    WriteOut();
    return RefreshAnswer::kReady;
}

void NodeApplication::OnSrdoEvent(const CommunicationIndex /*index*/) noexcept
{
}

void NodeApplication::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    place_.Note(EventKind::kSignal, NumberOf(index), static_cast<std::uint64_t>(cause), 0U);
}

void NodeApplication::OnGfc() noexcept
{
    place_.Tell(EventKind::kGfc, 0U, 2U, 0U);
}

void NodeApplication::OnGfcNotFollowed() noexcept
{
    place_.Tell(EventKind::kGfc, 0U, 3U, 0U);
}

void NodeApplication::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    place_.Note(EventKind::kConfigurationInvalid, NumberOf(index), 0U, 0U);
}

void NodeApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    knows_fault_ = true;
    const DeviceConfig& config = model_.Config();
    const bool has_slot = report.slot < config.srdo_count;
    const auto number = static_cast<std::uint8_t>(has_slot ? config.srdos[report.slot].number : 0U);
    const DeviceFault verdict = (kernel_ == nullptr) ? DeviceFault::kNone : kernel_->LastVerdict().fault;
    place_.Note(EventKind::kDeviceFault, number, static_cast<std::uint64_t>(report.fault),
                static_cast<std::uint64_t>(verdict));
}

void NodeApplication::OnFlow(const FlowCount& /*count*/) noexcept
{
}
} // namespace counterpoint::simulator
