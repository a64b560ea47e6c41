// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/pair_logic.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint16_t kMappingBase = 0x1380U;

void SetSafe(PairValue& pair, const Payload& safe, const std::uint32_t first_bit)
{
    const std::uint64_t image = (std::uint64_t{safe.high} << 32U) | safe.low;
    pair.safe = (first_bit < kMaxPayloadBits) ? (image >> first_bit) & pair.mask : 0U;
    pair.normal = pair.safe;
    pair.inverse = ~pair.safe & pair.mask;
}

PairValue PairOf(const VariablePlace& normal, const VariablePlace& inverse, const ObjectAddress& address)
{
    PairValue pair;
    pair.normal_place = normal;
    pair.inverse_place = inverse;
    pair.address = address;
    pair.mask = ~std::uint64_t{0U} >> (64U - normal.length_bits);
    pair.normal = ReadVariable(normal).bits;
    pair.inverse = ReadVariable(inverse).bits;
    return pair;
}
} // namespace

PairLogic::PairLogic(const DeviceModel& model, const Half half) : half_(half)
{
    for (const VariablePair& source : model.Pairs())
    {
        const MappableObject& normal = model.Objects()[source.normal];
        const MappableObject& inverse = model.Objects()[source.inverse];
        const SlotIndex slot = model.SlotOf(source.srdo).value_or(0U);
        PairValue pair = PairOf({normal.place, normal.length_bits}, {inverse.place, inverse.length_bits},
                                {normal.index, normal.sub});
        pair.slot = SrdoMask{1U} << slot;
        pair.srdo = source.srdo;
        pair.is_consumer = source.is_consumer;
        if (pair.is_consumer)
        {
            SetSafe(pair, model.Config().srdos[slot].safe_value, source.first_bit);
        }
        pairs_.push_back(pair);
    }
}

void PairLogic::Follow(Kernel& kernel, const DeviceModel& model)
{
    for (PairValue& pair : pairs_)
    {
        pair.is_mapped = false;
    }
    for (SlotIndex slot = 0U; slot < model.Srdos().size(); ++slot) // A plain device has none.
    {
        FollowSrdo(kernel, model.Config(), slot, model.NumberOf(slot));
    }
}

void PairLogic::FollowSrdo(Kernel& kernel, const DeviceConfig& config, const SlotIndex slot, const std::uint8_t number)
{
    const CommunicationIndex index = CommunicationIndexOf(number);
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
            PairValue& pair = TakeMapped(
                {normal,
                 inverse,
                 {static_cast<std::uint16_t>(named >> 16U), static_cast<std::uint8_t>((named >> 8U) & 0xFFU)}});
            const bool is_consumer = parameters.direction == kDirectionConsumer;
            const bool is_new_role = is_consumer != pair.is_consumer || number != pair.srdo;
            pair.is_consumer = is_consumer;
            pair.srdo = number;
            pair.slot = SrdoMask{1U} << slot;
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
PairValue& PairLogic::TakeMapped(const MappedPair& mapped)
{
    const auto known = std::find_if(pairs_.begin(), pairs_.end(),
                                    [&mapped](const PairValue& pair)
                                    {
                                        return !pair.is_mapped && pair.normal_place.place == mapped.normal.place &&
                                               pair.inverse_place.place == mapped.inverse.place;
                                    });
    if (known != pairs_.end())
    {
        return *known;
    }
    pairs_.push_back(PairOf(mapped.normal, mapped.inverse, mapped.address));
    return pairs_.back();
}

const std::vector<PairValue>& PairLogic::Pairs() const noexcept
{
    return pairs_;
}

std::size_t PairLogic::IndexOf(const ObjectAddress& normal) const noexcept
{
    const auto is_it = [&normal](const PairValue& pair)
    { return pair.address.index == normal.index && pair.address.sub == normal.sub; };
    const auto mapped = std::find_if(pairs_.begin(), pairs_.end(),
                                     [&is_it](const PairValue& pair) { return pair.is_mapped && is_it(pair); });
    const auto found = (mapped != pairs_.end()) ? mapped : std::find_if(pairs_.begin(), pairs_.end(), is_it);
    return static_cast<std::size_t>(found - pairs_.begin());
}

const PairValue* PairLogic::Find(const ObjectAddress& normal) const noexcept
{
    const std::size_t place = IndexOf(normal);
    return (place < pairs_.size()) ? &pairs_[place] : nullptr;
}

RuleFinding PairLogic::AddRule(const LogicRule& rule)
{
    Rule known;
    known.target = IndexOf(rule.target);
    known.operation = rule.operation;
    const bool has_target = known.target < pairs_.size() && !pairs_[known.target].is_consumer;
    RuleFinding finding = has_target ? RuleFinding::kNone : RuleFinding::kNoPair;
    for (const ObjectAddress& input : rule.inputs)
    {
        const std::size_t place = IndexOf(input);
        known.inputs.push_back(place);
        if (place >= pairs_.size() || !pairs_[place].is_consumer)
        {
            finding = RuleFinding::kNoPair;
        }
        else if (finding == RuleFinding::kNone && pairs_[place].mask != pairs_[known.target].mask)
        {
            finding = RuleFinding::kOtherLength;
        }
    }
    if (finding == RuleFinding::kNone)
    {
        rules_.push_back(known);
    }
    return finding;
}

bool PairLogic::IsComputed(const ObjectAddress& normal) const noexcept
{
    const std::size_t place = IndexOf(normal);
    return std::any_of(rules_.begin(), rules_.end(), [place](const Rule& rule) { return rule.target == place; });
}

void PairLogic::Disturb(const ObjectAddress& normal, const std::uint64_t bits) noexcept
{
    pairs_[IndexOf(normal)].disturbance = bits;
}

void PairLogic::SetInput(const ObjectAddress& normal, const std::uint64_t value) noexcept
{
    PairValue& pair = pairs_[IndexOf(normal)];
    const std::uint64_t bits = value & pair.mask;
    has_changed_ = has_changed_ || pair.normal != bits;
    pair.normal = bits;
    pair.inverse = pair.mask - bits; // The other path: arithmetic, not logic.
}

void PairLogic::Take(const SrdoMask open, const OnValue& on_value)
{
    for (PairValue& pair : pairs_)
    {
        if (pair.is_consumer && pair.is_mapped)
        {
            TakePair(pair, open, on_value);
        }
    }
    for (const Rule& rule : rules_)
    {
        Apply(rule);
    }
}

void PairLogic::TakePair(PairValue& pair, const SrdoMask open, const OnValue& on_value) const
{
    const bool is_open = (open & pair.slot) != 0U;
    const bool is_inverse =
        half_ != Half::kBoth || IsInversePair(pair.normal_place, pair.inverse_place) == PairView::kInverse;
    std::uint64_t normal = pair.safe;
    if (is_open && is_inverse)
    {
        normal = (half_ == Half::kInverse) ? (~ReadVariable(pair.inverse_place).bits & pair.mask)
                                           : ReadVariable(pair.normal_place).bits;
    }
    pair.inverse =
        ~normal & pair.mask; // As was just found; the half that is on the other CPU follows from the own one.
    if (normal != pair.normal)
    {
        pair.normal = normal;
        on_value(pair);
    }
}

// The inverse of a AND b is inverse a OR inverse b: no path looks at the other path's values.
void PairLogic::Apply(const Rule& rule)
{
    PairValue& target = pairs_[rule.target];
    if (target.is_consumer)
    {
        return; // Configured otherwise than when the rule was made.
    }
    const PairValue& first = pairs_[rule.inputs.front()];
    std::uint64_t normal = first.normal;
    std::uint64_t inverse = first.inverse;
    for (std::size_t place = 1U; place < rule.inputs.size(); ++place)
    {
        const PairValue& next = pairs_[rule.inputs[place]];
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

void PairLogic::Write(const PairValue& pair) const noexcept
{
    if (half_ != Half::kInverse)
    {
        WriteVariable(pair.normal_place, {pair.normal});
    }
    if (half_ != Half::kNormal)
    {
        WriteVariable(pair.inverse_place, {pair.inverse ^ pair.disturbance});
    }
}

bool PairLogic::TakeChange() noexcept
{
    return std::exchange(has_changed_, false);
}
} // namespace counterpoint::runtime
