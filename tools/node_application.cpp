// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/node_application.hpp"

#include "verification/simulator/names.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::tools
{
namespace
{
using simulator::LogicOperation;

constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint16_t kMappingBase = 0x1380U;

std::uint8_t NumberOf(const CommunicationIndex index)
{
    return static_cast<std::uint8_t>(index.value - kCommunicationBase);
}
} // namespace

NodeApplication::NodeApplication(const simulator::DeviceModel& model, NodeReport& report) : report_(report)
{
    for (const simulator::VariablePair& source : model.Pairs())
    {
        const MappableObject& normal = model.Objects()[source.normal];
        const MappableObject& inverse = model.Objects()[source.inverse];
        Pair pair;
        pair.normal_place = {normal.place, normal.length_bits};
        pair.inverse_place = {inverse.place, inverse.length_bits};
        pair.address = {normal.index, normal.sub};
        pair.mask = ~std::uint64_t{0U} >> (64U - normal.length_bits);
        pair.srdo = source.srdo;
        pair.slot = model.SlotOf(source.srdo).value_or(0U);
        pair.is_consumer = source.is_consumer;
        pair.normal = ReadVariable(pair.normal_place).bits;
        pair.inverse = ReadVariable(pair.inverse_place).bits;
        if (pair.is_consumer)
        {
            SetSafe(pair, model.Config().srdos[pair.slot].safe_value, source.first_bit);
        }
        pairs_.push_back(pair);
    }
}

void NodeApplication::SetSafe(Pair& pair, const Payload& safe, const std::uint32_t first_bit)
{
    const std::uint64_t image = (std::uint64_t{safe.high} << 32U) | safe.low;
    pair.safe = (first_bit < kMaxPayloadBits) ? (image >> first_bit) & pair.mask : 0U;
    pair.normal = pair.safe;
    pair.inverse = ~pair.safe & pair.mask;
}

void NodeApplication::Follow(Kernel& kernel, const simulator::DeviceModel& model)
{
    for (Pair& pair : pairs_)
    {
        pair.is_mapped = false;
    }
    for (SlotIndex slot = 0U; slot < model.Srdos().size(); ++slot) // A plain device has none.
    {
        FollowSrdo(kernel, model.Config(), slot, model.NumberOf(slot));
    }
}

void NodeApplication::FollowSrdo(Kernel& kernel, const DeviceConfig& config, const SlotIndex slot,
                                 const std::uint8_t number)
{
    const CommunicationIndex index{static_cast<std::uint16_t>(kCommunicationBase + number)};
    const auto mapping = static_cast<std::uint16_t>(kMappingBase + number);
    const ParametersReply parameters = kernel.GetParameters(index);
    const bool is_on = parameters.result == Result::kSuccessful && parameters.direction != kDirectionOff;
    std::uint32_t first_bit = 0U;
    for (std::uint8_t entry = 1U; is_on && entry < parameters.map_count; entry = static_cast<std::uint8_t>(entry + 2U))
    {
        const VariablePlace normal = kernel.GetMapped(index, {entry}).variable;
        const VariablePlace inverse = kernel.GetMapped(index, {static_cast<std::uint8_t>(entry + 1U)}).variable;
        if (normal.place != nullptr && inverse.place != nullptr) // Else a dummy.
        {
            const std::uint32_t named = ToValue(kernel.ReadObject({mapping, entry}).data);
            Pair& pair =
                Take({normal,
                      inverse,
                      {static_cast<std::uint16_t>(named >> 16U), static_cast<std::uint8_t>((named >> 8U) & 0xFFU)}});
            const bool is_consumer = parameters.direction == kDirectionConsumer;
            const bool is_new_role = is_consumer != pair.is_consumer || number != pair.srdo;
            pair.is_consumer = is_consumer;
            pair.srdo = number;
            pair.slot = slot;
            pair.is_mapped = true;
            if (is_consumer && is_new_role)
            {
                SetSafe(pair, config.srdos[slot].safe_value, first_bit);
            }
        }
        first_bit += normal.length_bits;
    }
}

/// The pair of these two objects: one that is known and that no other SRDO has taken, or a new one.
NodeApplication::Pair& NodeApplication::Take(const MappedPair& mapped)
{
    const auto known = std::find_if(pairs_.begin(), pairs_.end(),
                                    [&mapped](const Pair& pair)
                                    {
                                        return !pair.is_mapped && pair.normal_place.place == mapped.normal.place &&
                                               pair.inverse_place.place == mapped.inverse.place;
                                    });
    if (known != pairs_.end())
    {
        return *known;
    }
    Pair pair;
    pair.normal_place = mapped.normal;
    pair.inverse_place = mapped.inverse;
    pair.address = mapped.address;
    pair.mask = ~std::uint64_t{0U} >> (64U - mapped.normal.length_bits);
    pair.normal = ReadVariable(pair.normal_place).bits;
    pair.inverse = ReadVariable(pair.inverse_place).bits;
    pairs_.push_back(pair);
    return pairs_.back();
}

void NodeApplication::Tell(OnPair on_pair)
{
    on_pair_ = std::move(on_pair);
}

std::size_t NodeApplication::Find(const ObjectAddress& normal) const
{
    const auto is_it = [&normal](const Pair& pair)
    { return pair.address.index == normal.index && pair.address.sub == normal.sub; };
    const auto mapped = std::find_if(pairs_.begin(), pairs_.end(),
                                     [&is_it](const Pair& pair) { return pair.is_mapped && is_it(pair); });
    const auto found = (mapped != pairs_.end()) ? mapped : std::find_if(pairs_.begin(), pairs_.end(), is_it);
    return static_cast<std::size_t>(found - pairs_.begin());
}

bool NodeApplication::AddRule(const simulator::LogicRule& rule)
{
    Rule known;
    known.target = Find(rule.target);
    known.operation = rule.operation;
    bool is_known = known.target < pairs_.size() && !pairs_[known.target].is_consumer;
    for (const ObjectAddress& input : rule.inputs)
    {
        known.inputs.push_back(Find(input));
        is_known = is_known && known.inputs.back() < pairs_.size();
    }
    if (is_known)
    {
        rules_.push_back(known);
    }
    return is_known;
}

bool NodeApplication::SetInput(const ObjectAddress& object, const std::uint64_t value)
{
    const std::size_t place = Find(object);
    const bool is_input = place < pairs_.size() && pairs_[place].is_mapped && !pairs_[place].is_consumer;
    if (!is_input || value > pairs_[place].mask)
    {
        return false;
    }
    Pair& pair = pairs_[place];
    has_changed_ = has_changed_ || pair.normal != value;
    pair.normal = value;
    pair.inverse = pair.mask - value; // The other path: arithmetic, not logic.
    return true;
}

void NodeApplication::Run(const SrdoMask open)
{
    for (Pair& pair : pairs_)
    {
        if (pair.is_consumer && pair.is_mapped)
        {
            TakePair(pair, open);
        }
    }
    for (const Rule& rule : rules_)
    {
        Apply(rule);
    }
    for (const Pair& pair : pairs_)
    {
        if (!pair.is_consumer && pair.is_mapped)
        {
            WriteVariable(pair.normal_place, {pair.normal});
            WriteVariable(pair.inverse_place, {pair.inverse});
        }
    }
}

void NodeApplication::TakePair(Pair& pair, const SrdoMask open)
{
    const bool is_open = ((open >> pair.slot) & 1U) != 0U;
    const bool is_inverse = IsInversePair(pair.normal_place, pair.inverse_place) == PairView::kInverse;
    const bool is_usable = is_open && is_inverse;
    const std::uint64_t normal = is_usable ? ReadVariable(pair.normal_place).bits : pair.safe;
    pair.inverse = is_usable ? ReadVariable(pair.inverse_place).bits : (~pair.safe & pair.mask);
    if (normal != pair.normal)
    {
        pair.normal = normal;
        TellValue(pair);
    }
}

// The inverse of a AND b is inverse a OR inverse b: no path looks at the other path's values.
void NodeApplication::Apply(const Rule& rule)
{
    Pair& target = pairs_[rule.target];
    if (target.is_consumer)
    {
        return; // Configured otherwise than when the rule was made.
    }
    std::uint64_t normal = pairs_[rule.inputs.front()].normal;
    std::uint64_t inverse = pairs_[rule.inputs.front()].inverse;
    for (std::size_t place = 1U; place < rule.inputs.size(); ++place)
    {
        const Pair& next = pairs_[rule.inputs[place]];
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

bool NodeApplication::TakeChange() noexcept
{
    return std::exchange(has_changed_, false);
}

std::string NodeApplication::Values() const
{
    std::string values;
    for (const Pair& pair : pairs_)
    {
        if (!pair.is_mapped)
        {
            continue;
        }
        values += (values.empty() ? "" : " ") + simulator::ObjectText(pair.address) + "=" + std::to_string(pair.normal);
    }
    return values;
}

void NodeApplication::TellValue(const Pair& pair)
{
    report_.Tell(now_ns_, "value " + simulator::ObjectText(pair.address) + " = " + std::to_string(pair.normal), "value",
                 {{"srdo", pair.srdo}, {"object", simulator::ObjectText(pair.address)}, {"value", pair.normal}});
}

RefreshAnswer NodeApplication::OnRefresh(const CommunicationIndex index) noexcept
{
    static_cast<void>(index);
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
    const std::string name = simulator::Name(cause);
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
    report_.Tell(now_ns_, "configuration of SRDO " + std::to_string(NumberOf(index)) + " does not hold: SRDOs are off",
                 "configuration_invalid", {{"srdo", NumberOf(index)}});
}

void NodeApplication::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    const std::string name = simulator::Name(report.fault);
    report_.Tell(now_ns_, "device safe state: " + name, "device_fault", {{"fault", name}});
}

void NodeApplication::OnFlow(const FlowCount& count) noexcept
{
    static_cast<void>(count);
}
} // namespace counterpoint::tools
