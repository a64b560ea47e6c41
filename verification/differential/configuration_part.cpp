// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/configuration_part.hpp"

namespace counterpoint::differential
{

void ConfigurationPart::Store(SlotIndex slot, ConfigField field, std::uint8_t sub, std::uint32_t value) noexcept
{
    const ConfigItem item{ConfigAddress{slot, field, sub}, value};
    compare_.Step("Store: field, sub, value", slot, static_cast<std::uint64_t>(field), sub, value);
    scene_.a.Store(item);
    scene_.b.Store(item);
}

/// Random addresses, those that do not exist included.
void ConfigurationPart::Load() noexcept
{
    const ConfigAddress address{
        static_cast<SlotIndex>(scene_.random.Chance(900U) ? scene_.AnySlot() : scene_.random.Below(256U)),
        static_cast<ConfigField>(scene_.random.Below(14U)),
        static_cast<std::uint8_t>(scene_.random.Below(scene_.random.Chance(500U) ? 19U : 132U))};
    compare_.Step("Load: field, sub", address.slot, static_cast<std::uint64_t>(address.field), address.sub, 0U);
    // Sub-index 0 with everything but map entries; what another one would mean is said nowhere.
    const bool is_entry = address.field == ConfigField::kMapEntry;
    const ConfigAddress asked{address.slot, address.field, is_entry ? address.sub : std::uint8_t{0U}};
    compare_.Same("value of Load", address.slot, scene_.a.Load(asked).value, scene_.b.Load(asked).value);
}

void ConfigurationPart::StoreSlot(SlotIndex slot) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    Store(slot, ConfigField::kSct, 0U, plan.sct_ms);
    Store(slot, ConfigField::kSrvt, 0U, plan.srvt_ms);
    if (plan.transmission_type != kTransmissionTypeAsynchronous)
    {
        Store(slot, ConfigField::kTransmissionType, 0U, plan.transmission_type);
    }
    Store(slot, ConfigField::kCobId1, 0U, plan.cob_id_1);
    Store(slot, ConfigField::kCobId2, 0U, plan.cob_id_2);
    const std::uint32_t entries = 2U * static_cast<std::uint32_t>(plan.pairs);
    for (std::uint8_t sub = 1U; sub <= entries; ++sub)
    {
        Store(slot, ConfigField::kMapEntry, sub, plan.entries[sub - 1U]);
    }
    Store(slot, ConfigField::kMapCount, 0U, plan.map_count);
    Store(slot, ConfigField::kDirection, 0U, plan.direction);
    RegisterFields(slot);
}

void ConfigurationPart::Register(SlotIndex slot, std::uint32_t normal_at, std::uint32_t inverse_at) noexcept
{
    const std::uint32_t first = Memory::kSlotBytes * slot;
    compare_.Step("SetFields: normal, inverse field from the first byte of the slot on", slot, normal_at, inverse_at,
                  0U);
    scene_.a.SetFields(slot, StaticFields{&scene_.device.memory_a.bytes[first + normal_at],
                                          &scene_.device.memory_a.bytes[first + inverse_at]});
    scene_.b.SetFields(slot, StaticFields{&scene_.device.memory_b.bytes[first + normal_at],
                                          &scene_.device.memory_b.bytes[first + inverse_at]});
}

/// The right ones, unless they are the flaw; sometimes those of a dynamic mapping, where they mean nothing.
void ConfigurationPart::RegisterFields(SlotIndex slot) noexcept
{
    const SlotPlan& plan = scene_.device.plans[slot];
    if (plan.flaw == Flaw::kFields)
    {
        switch (scene_.random.Below(4U))
        {
        case 0U:
            break; // Never registered.
        case 1U:
            Register(slot, scene_.random.Between(1U, 3U), Memory::kInverseAt);
            break;
        case 2U:
            Register(slot, 0U, Memory::kInverseAt - scene_.random.Between(1U, 3U));
            break;
        default:
            compare_.Step("SetFields: none", slot, 0U, 0U, 0U);
            scene_.a.SetFields(slot, StaticFields{nullptr, nullptr});
            scene_.b.SetFields(slot, StaticFields{nullptr, nullptr});
            break;
        }
    }
    else if (plan.is_static || scene_.random.Chance(50U))
    {
        Register(slot, 0U, Memory::kInverseAt);
    }
}

/// Every slot in turn, as the guard does it.
void ConfigurationPart::Digest() noexcept
{
    DeviceDigest a{scene_.random.Chance(100U) ? scene_.random.Next() : 0U};
    DeviceDigest b = a;
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        compare_.Step("Digest: before", slot, a.value, 0U, 0U);
        a = scene_.a.Digest(slot, a);
        b = scene_.b.Digest(slot, b);
        compare_.Same("digest", slot, a.value, b.value);
    }
    scene_.reached.Add(Item::kDigest);
}

CheckResult ConfigurationPart::Validate(SlotIndex slot) noexcept
{
    compare_.Step("Validate", slot, 0U, 0U, 0U);
    const CheckResult a = scene_.a.Validate(slot);
    const CheckResult b = scene_.b.Validate(slot);
    compare_.Same("fault of Validate", slot, static_cast<std::uint64_t>(a.fault), static_cast<std::uint64_t>(b.fault));
    compare_.Same("signature of Validate", slot, a.signature, b.signature);
    scene_.reached.AddFault(a.fault);
    if ((a.fault == ConfigFault::kNone) && (scene_.device.plans[slot].direction == kDirectionConsumer))
    {
        scene_.configured |= SrdoMask{1U} << slot;
    }
    const Flaw flaw = scene_.device.plans[slot].flaw;
    if (a.fault == ConfigFault::kMapping)
    {
        scene_.reached.Add(Item::kFaultDummy, (flaw == Flaw::kDummy) ? 1U : 0U);
        scene_.reached.Add(Item::kFaultShared, (flaw == Flaw::kNone) ? 1U : 0U); // Sound but for what others map.
        scene_.reached.Add(Item::kFaultFields,
                           ((flaw == Flaw::kFields) && scene_.device.plans[slot].is_static) ? 1U : 0U);
    }
    if ((a.fault == ConfigFault::kNone) &&
        ((flaw == Flaw::kEntry) || (flaw == Flaw::kMapCount) || (flaw == Flaw::kDummy) || (flaw == Flaw::kShared)))
    {
        const bool is_producer = scene_.device.plans[slot].direction == kDirectionProducer;
        scene_.reached.Add(Item::kSharedBySenders, (is_producer && (flaw == Flaw::kShared)) ? 1U : 0U);
        scene_.has_odd_mapping = true; // Sound, but of other objects than those that CompareObjects looks at.
    }
    return a;
}

void ConfigurationPart::ValidateSlot(SlotIndex slot) noexcept
{
    const CheckResult first = Validate(slot);
    if (first.fault == ConfigFault::kSignature)
    {
        const bool is_wrong = scene_.device.plans[slot].flaw == Flaw::kSignature;
        Store(slot, ConfigField::kSignature, 0U, is_wrong ? scene_.random.Next() : first.signature);
        static_cast<void>(Validate(slot));
    }
    compare_.Objects(slot);
}

void ConfigurationPart::Recheck(SlotIndex slot) noexcept
{
    compare_.Step("Recheck", slot, 0U, 0U, 0U);
    const CheckResult a = scene_.a.Recheck(slot);
    const CheckResult b = scene_.b.Recheck(slot);
    compare_.Same("fault of Recheck", slot, static_cast<std::uint64_t>(a.fault), static_cast<std::uint64_t>(b.fault));
    compare_.Same("signature of Recheck", slot, a.signature, b.signature);
    scene_.reached.AddFault(a.fault);
    compare_.Slot(slot);
}

void ConfigurationPart::Configure() noexcept
{
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        StoreSlot(slot);
    }
    for (SlotIndex slot = 0U; slot < scene_.device.config_a.srdo_count; ++slot)
    {
        if (scene_.device.plans[slot].flaw != Flaw::kNeverValidated)
        {
            ValidateSlot(slot);
        }
        else
        {
            Recheck(slot);
        }
    }
    Store(0U, ConfigField::kGfcParameter, 0U, scene_.device.gfc_parameter);
    scene_.configuration_valid =
        scene_.random.Chance(970U) ? kConfigurationValidValue : static_cast<std::uint8_t>(scene_.random.Below(256U));
    Store(0U, ConfigField::kConfigurationValid, 0U, scene_.configuration_valid);
    Load();
    Digest();
    scene_.nmt = scene_.random.Chance(950U) ? NmtState::kOperational : NmtState::kPreOperational;
    cycle_.Step();
}

/// 1300h in every state; everything else only outside OPERATIONAL, since the guard stores nothing there.
void ConfigurationPart::Reconfigure() noexcept
{
    const SlotIndex slot = scene_.AnySlot();
    const SlotPlan& plan = scene_.device.plans[slot];
    if (scene_.nmt == NmtState::kOperational)
    {
        if (scene_.random.Chance(300U))
        {
            scene_.device.gfc_parameter = static_cast<std::uint8_t>(scene_.random.Below(3U));
            Store(slot, ConfigField::kGfcParameter, 0U, scene_.device.gfc_parameter);
        }
        else
        {
            Load();
        }
        return;
    }
    switch (scene_.random.Below(7U))
    {
    case 5U:
        RegisterFields(slot);
        break;
    case 6U:
    {
        // One after the other: compilers differ in the order in which they evaluate arguments.
        const std::uint8_t sub = static_cast<std::uint8_t>(scene_.random.Between(plan.map_count + 1U, 255U));
        Store(slot, ConfigField::kMapEntry, sub, scene_.random.Next());
        break;
    }
    case 0U:
        Store(slot, ConfigField::kSct, 0U, scene_.device.plans[slot].sct_ms);
        break;
    case 1U:
        Store(slot, ConfigField::kSignature, 0U, scene_.random.Next());
        break;
    case 2U:
        scene_.configuration_valid = scene_.random.Chance(700U) ? kConfigurationValidValue : std::uint8_t{0U};
        Store(slot, ConfigField::kConfigurationValid, 0U, scene_.configuration_valid);
        break;
    case 3U:
        Store(slot, ConfigField::kMapCount, 0U, scene_.random.Below(scene_.random.Chance(500U) ? 20U : 256U));
        Store(slot, ConfigField::kMapCount, 0U, scene_.device.plans[slot].map_count);
        break;
    default:
        Store(slot, ConfigField::kDirection, 0U, 0U);
        Store(slot, ConfigField::kDirection, 0U, scene_.device.plans[slot].direction);
        break;
    }
    if (scene_.random.Chance(500U))
    {
        Recheck(slot);
    }
    ValidateSlot(slot);
    compare_.Slot(slot);
}

} // namespace counterpoint::differential
