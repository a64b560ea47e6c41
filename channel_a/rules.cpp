// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_a/rules.hpp"

#include "channel_a/objects.hpp"
#include "channel_a/slot.hpp"

namespace counterpoint::channel_a
{
namespace
{

// Whether an SRDO has this identifier or the one after it.
bool HasOneOf(const Record& record, const std::uint32_t first) noexcept
{
    bool has_one = false;
    for (const std::uint32_t own : record.values.cob_id)
    {
        if ((own == first) || (own == (first + 1U)))
        {
            has_one = true;
        }
    }
    return has_one;
}

// [SRS_CFG_024]
bool IsInUse(const Voice& voice, const std::size_t slot, const std::uint32_t first) noexcept
{
    bool is_in_use = false;
    for (std::size_t other = 0U; other < voice.count; ++other)
    {
        const Record& record = At(voice, other);
        const bool is_other = (other != slot) && (record.grants.Of(Grant::kDirection) != kDirectionOff);
        if (is_other && HasOneOf(record, first))
        {
            is_in_use = true;
        }
    }
    return is_in_use;
}

// The identifiers of normal frames are odd. [SRS_CFG_023]
bool HasGoodIdentifiers(const Record& record) noexcept
{
    const std::uint32_t first = record.values.cob_id[kNormalHalf];
    if ((first < kFirstSrdoIdentifier) || (first >= kLastSrdoIdentifier) || ((first % 2U) == 0U))
    {
        return false;
    }
    return record.values.cob_id[kInverseHalf] == (first + 1U);
}

// [SRS_CFG_025]
bool HasGoodTiming(const Voice& voice, const Record& record) noexcept
{
    const std::uint32_t sct_ms = record.values.sct_ms;
    const std::uint32_t srvt_ms = record.values.srvt_ms;
    if (record.grants.Of(Grant::kDirection) == kDirectionConsumer)
    {
        return (srvt_ms != 0U) && (srvt_ms < sct_ms);
    }
    return SctUs(record) >= voice.config->cycle_us;
}

ConfigFault CheckCommunication(const Voice& voice, const std::size_t slot) noexcept
{
    const Record& record = At(voice, slot);
    if (record.grants.Of(Grant::kDirection) > kDirectionConsumer)
    {
        return ConfigFault::kDirection; // [SRS_CFG_021]
    }
    if (record.values.transmission_type != kTransmissionTypeAsynchronous)
    {
        return ConfigFault::kTransmissionType; // [SRS_CFG_022]
    }
    if (!HasGoodIdentifiers(record))
    {
        return ConfigFault::kIdentifier;
    }
    if (IsInUse(voice, slot, record.values.cob_id[kNormalHalf]))
    {
        return ConfigFault::kIdentifierInUse;
    }
    return HasGoodTiming(voice, record) ? ConfigFault::kNone : ConfigFault::kTiming;
}

// Two consumers would write one object, or a consumer what a producer sends. [SRS_CFG_037]
bool SharesWithLower(const Voice& voice, const std::size_t slot, const Mapping& mapping) noexcept
{
    const Record& record = At(voice, slot);
    const bool is_consumer = record.grants.Of(Grant::kDirection) == kDirectionConsumer;
    bool shares = false;
    for (std::size_t lower = 0U; lower < slot; ++lower)
    {
        const std::uint8_t direction = At(voice, lower).grants.Of(Grant::kDirection);
        const bool may_not = (direction == kDirectionConsumer) || (is_consumer && (direction != kDirectionOff));
        if (may_not && SharesObject(*voice.config, record, mapping, MappingOf(voice, lower)))
        {
            shares = true;
        }
    }
    return shares;
}

// Every rule in its order but the signature. [SRS_CFG_020]
ConfigFault CheckRules(const Voice& voice, const std::size_t slot, const Mapping& mapping) noexcept
{
    if (At(voice, slot).grants.Of(Grant::kDirection) == kDirectionOff)
    {
        return ConfigFault::kNone;
    }
    ConfigFault fault = CheckCommunication(voice, slot);
    if (fault == ConfigFault::kNone)
    {
        fault = Resolve(*voice.config, At(voice, slot), mapping);
    }
    if ((fault == ConfigFault::kNone) && SharesWithLower(voice, slot, mapping))
    {
        fault = ConfigFault::kMapping;
    }
    return fault;
}

} // namespace

CheckResult ValidateSlot(Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    const Mapping mapping = MappingOf(voice, slot);
    record.grants.Set(Grant::kResolved, kNo);
    record.grants.Set(Grant::kChecked, kNo);
    CheckResult result{CheckRules(voice, slot, mapping), SignatureOf(record, mapping)};
    if ((result.fault == ConfigFault::kNone) && (result.signature != record.values.signature))
    {
        result.fault = ConfigFault::kSignature; // [SRS_CFG_029]
    }
    if (result.fault != ConfigFault::kNone)
    {
        return result;
    }
    record.grants.Set(Grant::kChecked, kYes);
    if (record.grants.Of(Grant::kDirection) != kDirectionOff)
    {
        record.grants.Set(Grant::kResolved, kYes);
    }
    if (record.grants.Of(Grant::kDirection) == kDirectionConsumer)
    {
        WriteObjects(voice, slot, record.safe);
        TakeOut(voice.committed, slot); // The objects hold no pair any more. [SRS_REL_002]
        SetPermitted(voice, PermittedOf(voice) & voice.committed);
    }
    return result;
}

// [SRS_CFG_030]
CheckResult RecheckSlot(const Voice& voice, const std::size_t slot) noexcept
{
    Record& record = At(voice, slot);
    const Mapping mapping = MappingOf(voice, slot);
    CheckResult result{ConfigFault::kNone, SignatureOf(record, mapping)};
    if (result.signature != record.values.signature)
    {
        result.fault = ConfigFault::kSignature;
    }
    else if ((record.grants.Of(Grant::kDirection) != kDirectionOff) && !HoldsSteps(*voice.config, record, mapping))
    {
        result.fault = ConfigFault::kTable;
    }
    else
    {
        // Nothing found.
    }
    record.grants.Set(Grant::kChecked, (result.fault == ConfigFault::kNone) ? kYes : kNo);
    return result;
}

} // namespace counterpoint::channel_a
