// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The guard's part: what it stores, validates and rechecks.
#include "verification/differential/differential.hpp"

namespace counterpoint::differential
{

void Differential::StoreBoth(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept
{
    const ConfigItem item{ConfigAddress{slot, field, sub}, value};
    Step("Store: field, sub, value", slot, static_cast<std::uint64_t>(field), sub, value);
    a_.Store(item);
    b_.Store(item);
}

/// Random addresses, those that do not exist included.
void Differential::LoadBoth() noexcept
{
    const ConfigAddress address{static_cast<SlotIndex>(random_.Chance(900U) ? AnySlot() : random_.Below(256U)),
                                static_cast<ConfigField>(random_.Below(14U)),
                                static_cast<std::uint8_t>(random_.Below(random_.Chance(500U) ? 19U : 132U))};
    Step("Load: field, sub", address.slot, static_cast<std::uint64_t>(address.field), address.sub, 0U);
    // Sub-index 0 with everything but map entries; what another one would mean is said nowhere.
    const bool is_entry = address.field == ConfigField::kMapEntry;
    const ConfigAddress asked{address.slot, address.field, is_entry ? address.sub : std::uint8_t{0U}};
    Same("value of Load", address.slot, a_.Load(asked).value, b_.Load(asked).value);
}

void Differential::StoreSlot(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    StoreBoth(slot, ConfigField::kSct, 0U, plan.sct_ms);
    StoreBoth(slot, ConfigField::kSrvt, 0U, plan.srvt_ms);
    if (plan.transmission_type != kTransmissionTypeAsynchronous)
    {
        StoreBoth(slot, ConfigField::kTransmissionType, 0U, plan.transmission_type);
    }
    StoreBoth(slot, ConfigField::kCobId1, 0U, plan.cob_id_1);
    StoreBoth(slot, ConfigField::kCobId2, 0U, plan.cob_id_2);
    const std::uint32_t entries = 2U * static_cast<std::uint32_t>(plan.pairs);
    for (std::uint8_t sub = 1U; sub <= entries; ++sub)
    {
        StoreBoth(slot, ConfigField::kMapEntry, sub, plan.entries[sub - 1U]);
    }
    StoreBoth(slot, ConfigField::kMapCount, 0U, plan.map_count);
    StoreBoth(slot, ConfigField::kDirection, 0U, plan.direction);
    RegisterFields(slot);
}

void Differential::RegisterBoth(SlotIndex slot, std::uint32_t normal_at, std::uint32_t inverse_at) noexcept
{
    const std::uint32_t first = Memory::kSlotBytes * slot;
    Step("SetFields: normal, inverse field from the first byte of the slot on", slot, normal_at, inverse_at, 0U);
    a_.SetFields(slot,
                 StaticFields{&device_.memory_a.bytes[first + normal_at], &device_.memory_a.bytes[first + inverse_at]});
    b_.SetFields(slot,
                 StaticFields{&device_.memory_b.bytes[first + normal_at], &device_.memory_b.bytes[first + inverse_at]});
}

/// The right ones, unless they are the flaw; sometimes those of a dynamic mapping, where they mean nothing.
void Differential::RegisterFields(SlotIndex slot) noexcept
{
    const SlotPlan& plan = device_.plans[slot];
    if (plan.flaw == Flaw::kFields)
    {
        switch (random_.Below(4U))
        {
        case 0U:
            break; // Never registered.
        case 1U:
            RegisterBoth(slot, random_.Between(1U, 3U), Memory::kInverseAt);
            break;
        case 2U:
            RegisterBoth(slot, 0U, Memory::kInverseAt - random_.Between(1U, 3U));
            break;
        default:
            Step("SetFields: none", slot, 0U, 0U, 0U);
            a_.SetFields(slot, StaticFields{nullptr, nullptr});
            b_.SetFields(slot, StaticFields{nullptr, nullptr});
            break;
        }
    }
    else if (plan.is_static || random_.Chance(50U))
    {
        RegisterBoth(slot, 0U, Memory::kInverseAt);
    }
}

/// Every slot in turn, as the guard does it.
void Differential::DigestBoth() noexcept
{
    DeviceDigest a{random_.Chance(100U) ? random_.Next() : 0U};
    DeviceDigest b = a;
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        Step("Digest: before", slot, a.value, 0U, 0U);
        a = a_.Digest(slot, a);
        b = b_.Digest(slot, b);
        Same("digest", slot, a.value, b.value);
    }
    reached_.Add(Item::kDigest);
}

CheckResult Differential::ValidateBoth(SlotIndex slot) noexcept
{
    Step("Validate", slot, 0U, 0U, 0U);
    const CheckResult a = a_.Validate(slot);
    const CheckResult b = b_.Validate(slot);
    Same("fault of Validate", slot, static_cast<std::uint64_t>(a.fault), static_cast<std::uint64_t>(b.fault));
    Same("signature of Validate", slot, a.signature, b.signature);
    reached_.AddFault(a.fault);
    if ((a.fault == ConfigFault::kNone) && (device_.plans[slot].direction == kDirectionConsumer))
    {
        configured_ |= SrdoMask{1U} << slot;
    }
    const Flaw flaw = device_.plans[slot].flaw;
    if (a.fault == ConfigFault::kMapping)
    {
        reached_.Add(Item::kFaultDummy, (flaw == Flaw::kDummy) ? 1U : 0U);
        reached_.Add(Item::kFaultFields, ((flaw == Flaw::kFields) && device_.plans[slot].is_static) ? 1U : 0U);
    }
    if ((a.fault == ConfigFault::kNone) &&
        ((flaw == Flaw::kEntry) || (flaw == Flaw::kMapCount) || (flaw == Flaw::kDummy)))
    {
        has_odd_mapping_ = true; // Sound, but of other objects than those that CompareObjects looks at.
    }
    return a;
}

void Differential::ValidateSlot(SlotIndex slot) noexcept
{
    const CheckResult first = ValidateBoth(slot);
    if (first.fault == ConfigFault::kSignature)
    {
        const bool is_wrong = device_.plans[slot].flaw == Flaw::kSignature;
        StoreBoth(slot, ConfigField::kSignature, 0U, is_wrong ? random_.Next() : first.signature);
        static_cast<void>(ValidateBoth(slot));
    }
    CompareObjects(slot);
}

void Differential::RecheckBoth(SlotIndex slot) noexcept
{
    Step("Recheck", slot, 0U, 0U, 0U);
    const CheckResult a = a_.Recheck(slot);
    const CheckResult b = b_.Recheck(slot);
    Same("fault of Recheck", slot, static_cast<std::uint64_t>(a.fault), static_cast<std::uint64_t>(b.fault));
    Same("signature of Recheck", slot, a.signature, b.signature);
    reached_.AddFault(a.fault);
    CompareSlot(slot);
}

void Differential::Configure() noexcept
{
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        StoreSlot(slot);
    }
    for (SlotIndex slot = 0U; slot < device_.config_a.srdo_count; ++slot)
    {
        if (device_.plans[slot].flaw != Flaw::kNeverValidated)
        {
            ValidateSlot(slot);
        }
        else
        {
            RecheckBoth(slot);
        }
    }
    StoreBoth(0U, ConfigField::kGfcParameter, 0U, device_.gfc_parameter);
    configuration_valid_ =
        random_.Chance(970U) ? kConfigurationValidValue : static_cast<std::uint8_t>(random_.Below(256U));
    StoreBoth(0U, ConfigField::kConfigurationValid, 0U, configuration_valid_);
    LoadBoth();
    DigestBoth();
    nmt_ = random_.Chance(950U) ? NmtState::kOperational : NmtState::kPreOperational;
    CycleStep();
}

/// 1300h in every state; everything else only outside OPERATIONAL, since the guard stores nothing there.
void Differential::Reconfigure() noexcept
{
    const SlotIndex slot = AnySlot();
    const SlotPlan& plan = device_.plans[slot];
    if (nmt_ == NmtState::kOperational)
    {
        if (random_.Chance(300U))
        {
            device_.gfc_parameter = static_cast<std::uint8_t>(random_.Below(3U));
            StoreBoth(slot, ConfigField::kGfcParameter, 0U, device_.gfc_parameter);
        }
        else
        {
            LoadBoth();
        }
        return;
    }
    switch (random_.Below(7U))
    {
    case 5U:
        RegisterFields(slot);
        break;
    case 6U:
    {
        // One after the other: compilers differ in the order in which they evaluate arguments.
        const std::uint8_t sub = static_cast<std::uint8_t>(random_.Between(plan.map_count + 1U, 255U));
        StoreBoth(slot, ConfigField::kMapEntry, sub, random_.Next());
        break;
    }
    case 0U:
        StoreBoth(slot, ConfigField::kSct, 0U, device_.plans[slot].sct_ms);
        break;
    case 1U:
        StoreBoth(slot, ConfigField::kSignature, 0U, random_.Next());
        break;
    case 2U:
        configuration_valid_ = random_.Chance(700U) ? kConfigurationValidValue : std::uint8_t{0U};
        StoreBoth(slot, ConfigField::kConfigurationValid, 0U, configuration_valid_);
        break;
    case 3U:
        StoreBoth(slot, ConfigField::kMapCount, 0U, random_.Below(random_.Chance(500U) ? 20U : 256U));
        StoreBoth(slot, ConfigField::kMapCount, 0U, device_.plans[slot].map_count);
        break;
    default:
        StoreBoth(slot, ConfigField::kDirection, 0U, 0U);
        StoreBoth(slot, ConfigField::kDirection, 0U, device_.plans[slot].direction);
        break;
    }
    if (random_.Chance(500U))
    {
        RecheckBoth(slot);
    }
    ValidateSlot(slot);
    CompareSlot(slot);
}

} // namespace counterpoint::differential
