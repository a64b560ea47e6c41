// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/node_application.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
constexpr std::uint16_t kCommunicationBase = 0x1300U;

std::uint64_t MaskOf(const std::uint8_t bits)
{
    return ~std::uint64_t{0U} >> (64U - bits);
}

std::uint64_t ObjectNumber(const ObjectAddress& object)
{
    return (std::uint64_t{object.index} << 8U) | object.sub;
}
} // namespace

NodeApplication::NodeApplication(const NodeIndex node, const DeviceModel& model, Journal& journal, const Half half)
    : node_(node), half_(half), config_(model.Config()), journal_(journal)
{
    for (const VariablePair& pair : model.Pairs())
    {
        const MappableObject& normal = model.Objects()[pair.normal];
        const MappableObject& inverse = model.Objects()[pair.inverse];
        PairState state;
        state.normal_place = {normal.place, normal.length_bits};
        state.inverse_place = {inverse.place, inverse.length_bits};
        state.address = {normal.index, normal.sub};
        state.mask = MaskOf(normal.length_bits);
        state.normal = ReadVariable(state.normal_place).bits;
        state.inverse = ReadVariable(state.inverse_place).bits;
        state.srdo = pair.srdo;
        state.first_bit = pair.first_bit;
        state.is_consumer = pair.is_consumer;
        state.slot = SrdoMask{1U} << model.SlotOf(pair.srdo).value_or(0U);
        pairs_.push_back(state);
    }
    SetSafeValues();
}

void NodeApplication::SetSafeValues()
{
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        const SrdoSetup& setup = config_.srdos[slot];
        const std::uint64_t image = (std::uint64_t{setup.safe_value.high} << 32U) | setup.safe_value.low;
        for (PairState& pair : pairs_)
        {
            if (pair.srdo != setup.number || !pair.is_consumer || pair.first_bit >= kMaxPayloadBits)
            {
                continue;
            }
            pair.safe = (image >> pair.first_bit) & pair.mask;
            pair.normal = pair.safe;
            pair.inverse = ~pair.safe & pair.mask;
        }
    }
}

std::size_t NodeApplication::IndexOf(const ObjectAddress& normal) const
{
    const auto found = std::find_if(pairs_.begin(), pairs_.end(), [&normal](const PairState& pair)
                                    { return pair.address.index == normal.index && pair.address.sub == normal.sub; });
    return static_cast<std::size_t>(found - pairs_.begin());
}

void NodeApplication::Join(const Kernel& kernel) noexcept
{
    kernel_ = &kernel;
}

void NodeApplication::AddRule(const LogicRule& rule)
{
    Rule known;
    known.target = IndexOf(rule.target);
    known.operation = rule.operation;
    for (const ObjectAddress& input : rule.inputs)
    {
        known.inputs.push_back(IndexOf(input));
    }
    rules_.push_back(known);
}

void NodeApplication::SetInput(const ObjectAddress& object, const std::uint64_t value)
{
    PairState& pair = pairs_.at(IndexOf(object));
    has_changed_ = has_changed_ || pair.normal != (value & pair.mask);
    pair.normal = value & pair.mask;
    pair.inverse = pair.mask - pair.normal; // The other path: arithmetic, not logic.
}

void NodeApplication::Disturb(const ObjectAddress& object, const std::uint64_t bits)
{
    pairs_.at(IndexOf(object)).disturbance = bits;
}

void NodeApplication::SetNow(const Nanoseconds now) noexcept
{
    now_ = now;
}

bool NodeApplication::Run(const SrdoMask open, const Nanoseconds now, const bool is_frozen)
{
    for (PairState& pair : pairs_)
    {
        if (pair.is_consumer)
        {
            TakePair(pair, open, now);
        }
    }
    for (const Rule& rule : rules_)
    {
        Apply(rule);
    }
    bool is_held_back = false;
    for (PairState& pair : pairs_)
    {
        if (!pair.is_consumer && is_frozen)
        {
            is_held_back = is_held_back || ReadVariable(pair.normal_place).bits != pair.normal;
        }
        else if (!pair.is_consumer)
        {
            Write(pair, now);
        }
    }
    return is_held_back;
}

void NodeApplication::TakePair(PairState& pair, const SrdoMask open, const Nanoseconds now)
{
    const bool is_open = (open & pair.slot) != 0U;
    const bool is_inverse =
        half_ != Half::kBoth || IsInversePair(pair.normal_place, pair.inverse_place) == PairView::kInverse;
    const bool is_usable = is_open && is_inverse;
    const std::uint64_t read_normal = ReadVariable(pair.normal_place).bits;
    const std::uint64_t read_inverse = ReadVariable(pair.inverse_place).bits;
    // The half that is on the other CPU follows from the own one.
    const std::uint64_t normal_bits = (half_ == Half::kInverse) ? (~read_inverse & pair.mask) : read_normal;
    const std::uint64_t inverse_bits = (half_ == Half::kNormal) ? (~read_normal & pair.mask) : read_inverse;
    const std::uint64_t normal = is_usable ? normal_bits : pair.safe;
    pair.inverse = is_usable ? inverse_bits : (~pair.safe & pair.mask);
    if (normal != pair.normal)
    {
        pair.normal = normal;
        journal_.Note({now, EventKind::kValue, node_, pair.srdo, normal, ObjectNumber(pair.address)});
    }
}

// The inverse of a AND b is inverse a OR inverse b: no path looks at the other path's values.
void NodeApplication::Apply(const Rule& rule)
{
    PairState& target = pairs_[rule.target];
    const PairState& first = pairs_[rule.inputs.front()];
    std::uint64_t normal = first.normal;
    std::uint64_t inverse = first.inverse;
    for (std::size_t place = 1U; place < rule.inputs.size(); ++place)
    {
        const PairState& next = pairs_[rule.inputs[place]];
        const bool is_and = rule.operation == LogicOperation::kAnd;
        normal = is_and ? (normal & next.normal) : (normal | next.normal);
        inverse = is_and ? (inverse | next.inverse) : (inverse & next.inverse);
    }
    if (rule.operation == LogicOperation::kNot)
    {
        normal = ~normal;
        inverse = ~inverse;
    }
    has_changed_ = has_changed_ || target.normal != (normal & target.mask);
    target.normal = normal & target.mask;
    target.inverse = inverse & target.mask;
}

void NodeApplication::Write(PairState& pair, const Nanoseconds now)
{
    if (half_ != Half::kInverse)
    {
        WriteVariable(pair.normal_place, {pair.normal});
    }
    if (half_ != Half::kNormal)
    {
        WriteVariable(pair.inverse_place, {pair.inverse ^ pair.disturbance});
    }
    if (pair.disturbance != 0U && disturbed_at_ == kNever)
    {
        disturbed_at_ = now;
    }
}

std::uint64_t NodeApplication::ValueOf(const ObjectAddress& normal) const
{
    return pairs_.at(IndexOf(normal)).normal;
}

std::uint64_t NodeApplication::SafeValueOf(const ObjectAddress& normal) const
{
    return pairs_.at(IndexOf(normal)).safe;
}

bool NodeApplication::TakeChange()
{
    const bool has_changed = has_changed_;
    has_changed_ = false;
    return has_changed;
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
