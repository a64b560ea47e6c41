// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/rules.hpp"

#include <map>

namespace counterpoint::cia306
{
namespace
{
constexpr std::uint64_t kHighestSub = 6U;
constexpr std::uint64_t kMaxDirection = 2U;
constexpr std::uint64_t kTransmissionType = 254U;
constexpr std::uint64_t kOtherTransmissionType = 255U; ///< Used by a certified device in the field.
constexpr std::uint64_t kMaxIdentifier = 0x7FFU;
constexpr std::uint64_t kFirstCobId = 0x101U;
constexpr std::uint64_t kLastCobId = 0x180U;
constexpr std::uint64_t kDefaultCobIdBase = 0xFFU;
constexpr std::uint8_t kMaxDefaultNodeId = 64U;
constexpr std::uint64_t kMicrosecondsPerMillisecond = 1000U;

std::string Decimal(const std::uint64_t number)
{
    return std::to_string(number);
}

void CheckFixed(const SrdoConfiguration& srdo, Findings& findings)
{
    const std::uint16_t index = srdo.CommunicationIndex();
    const bool is_other_count = srdo.highest_sub.value && !srdo.highest_sub.Is(kHighestSub);
    if (is_other_count)
    {
        findings.Tell(WhenOn(srdo), srdo.highest_sub.place, ObjectName(index, 0U),
                      {"highest sub-index " + Decimal(*srdo.highest_sub.value), "6"});
    }
    if (srdo.direction.value.value_or(0U) > kMaxDirection)
    {
        findings.Error(srdo.direction.place, ObjectName(index, 1U), "direction " + Decimal(*srdo.direction.value),
                       "0 (off), 1 (producer) or 2 (consumer)");
    }
    const std::string type = "transmission type " + Decimal(srdo.transmission_type.value.value_or(0U));
    if (srdo.transmission_type.value && !srdo.transmission_type.Is(kTransmissionType))
    {
        const bool is_other = srdo.transmission_type.Is(kOtherTransmissionType);
        findings.Error(srdo.transmission_type.place, ObjectName(index, 4U), type,
                       is_other ? "254; devices with 255 exist, this kernel refuses it" : "254");
    }
}

/// True when the COB-ID alone is right: what compares two of them says nothing about one that is wrong already.
bool CheckCobId(const std::string& object, const Field& cob_id, const bool is_normal, Findings& findings)
{
    if (!cob_id.value)
    {
        return false;
    }
    const std::string name = "COB-ID " + Hex(*cob_id.value, 3);
    if (*cob_id.value > kMaxIdentifier)
    {
        findings.Error(cob_id.place, object, name + " has reserved bits set", "bits 11 to 31 to be 0");
        return false;
    }
    const bool is_in_range = *cob_id.value >= kFirstCobId && *cob_id.value <= kLastCobId;
    if (!is_in_range)
    {
        findings.Error(cob_id.place, object, name, "a COB-ID from 0x101 to 0x180");
        return false;
    }
    const bool is_odd = (*cob_id.value & 1U) != 0U;
    if (is_odd != is_normal)
    {
        findings.Error(cob_id.place, object, name + (is_odd ? " is odd" : " is even"),
                       is_normal ? "an odd one for normal data" : "an even one for inverse data");
        return false;
    }
    return true;
}

void CheckCobIds(const SrdoConfiguration& srdo, Findings& findings)
{
    const std::uint16_t index = srdo.CommunicationIndex();
    // An SRDO that is off may have no identifiers yet: only the first one has defaults.
    const bool is_unassigned = srdo.direction.Is(0U) && srdo.cob_id_1.Is(0U) && srdo.cob_id_2.Is(0U);
    if (is_unassigned)
    {
        return;
    }
    const bool is_first_right = CheckCobId(ObjectName(index, 5U), srdo.cob_id_1, true, findings);
    const bool is_second_right = CheckCobId(ObjectName(index, 6U), srdo.cob_id_2, false, findings);
    const bool is_apart = is_first_right && is_second_right && *srdo.cob_id_2.value != *srdo.cob_id_1.value + 1U;
    if (is_apart)
    {
        findings.Error(srdo.cob_id_2.place, ObjectName(index, 6U), "COB-ID 2 " + Hex(*srdo.cob_id_2.value, 3),
                       Hex(*srdo.cob_id_1.value + 1U, 3) + " (COB-ID 1 + 1)");
    }
}

void CheckConsumerTimes(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    const std::uint64_t sct = *srdo.sct_ms.value;
    const std::uint64_t srvt = *srdo.srvt_ms.value;
    if (srvt == 0U)
    {
        findings.Error(srdo.srvt_ms.place, ObjectName(srdo.CommunicationIndex(), 3U), "SRVT 0 ms of a consumer",
                       "1 ms or more");
    }
    if (srvt >= sct)
    {
        findings.Error(srdo.srvt_ms.place, ObjectName(srdo.CommunicationIndex(), 3U), "SRVT " + Decimal(srvt) + " ms",
                       "less than the SCT of " + Decimal(sct) + " ms");
        return;
    }
    // [SRS_EDS_660]
    const std::uint64_t late_us = std::uint64_t{context.parameters.cycle_us} + context.parameters.cycle_tolerance_us;
    if (sct * kMicrosecondsPerMillisecond < late_us)
    {
        findings.Warning(srdo.sct_ms.place, ObjectName(srdo.CommunicationIndex(), 2U),
                         "SCT " + Decimal(sct) + " ms: it may expire between two calls, and is found by the later one",
                         "at least a cycle with its tolerance, " + Decimal(late_us) + " us");
    }
}

void CheckProducerTimes(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    const std::uint64_t sct = *srdo.sct_ms.value;
    const std::uint64_t srvt = *srdo.srvt_ms.value;
    const std::uint32_t cycle_us = context.parameters.cycle_us;
    const bool is_below_cycle = sct == 0U || sct * kMicrosecondsPerMillisecond < cycle_us;
    if (is_below_cycle)
    {
        findings.Error(srdo.sct_ms.place, ObjectName(srdo.CommunicationIndex(), 2U),
                       "refresh time " + Decimal(sct) + " ms",
                       "at least one cycle of " + Decimal(cycle_us) + " us (0x5F00:01)");
    }
    // Each cycle examines one refresh: calls that late leave some over for the calls behind them. [SRS_EDS_039]
    const std::uint64_t late_us = std::uint64_t{cycle_us} + context.parameters.cycle_tolerance_us;
    const bool is_called = context.parameters.Srdo(srdo.number).producer_form == kProviderCalled;
    if (is_called && !is_below_cycle && sct * kMicrosecondsPerMillisecond < late_us)
    {
        findings.Warning(srdo.sct_ms.place, ObjectName(srdo.CommunicationIndex(), 2U),
                         "refresh time " + Decimal(sct) + " ms: late calls put refreshes off, and nothing tells it",
                         "at least a cycle with its tolerance, " + Decimal(late_us) + " us");
    }
    if (srvt == 0U)
    {
        findings.Warning(srdo.srvt_ms.place, ObjectName(srdo.CommunicationIndex(), 3U),
                         "SRVT 0 ms of a producer: no confirmation comes in time", "1 ms or more");
    }
    if (srvt >= sct)
    {
        findings.Warning(srdo.srvt_ms.place, ObjectName(srdo.CommunicationIndex(), 3U), "SRVT " + Decimal(srvt) + " ms",
                         "less than the refresh time of " + Decimal(sct) + " ms");
    }
}

void CheckDefaultCobId(const CheckContext& context, const std::uint8_t sub, const std::uint64_t offset,
                       Findings& findings)
{
    const Entry* const entry = context.device.Find(kFirstCommunicationIndex, sub);
    const bool is_default = entry != nullptr && entry->default_value.IsSet() && context.node_id;
    if (!is_default)
    {
        return;
    }
    const ValueResult value = ParseValue(entry->default_value.text, entry->data_type, context.node_id);
    const std::uint64_t expected = kDefaultCobIdBase + offset + 2U * *context.node_id;
    const bool has_default = *context.node_id <= kMaxDefaultNodeId;
    if (has_default && value.value && value.value->bits != expected)
    {
        findings.Warning(entry->default_value.place, ObjectName(kFirstCommunicationIndex, sub),
                         "default COB-ID " + Hex(value.value->bits, 3),
                         Hex(expected, 3) + " for node-ID " + Decimal(*context.node_id) +
                             " (pre-defined connection set)");
    }
    const bool is_missing_set = !has_default && !entry->parameter_value.IsSet();
    if (is_missing_set)
    {
        findings.Warning(entry->default_value.place, ObjectName(kFirstCommunicationIndex, sub),
                         "default COB-ID with node-ID " + Decimal(*context.node_id),
                         "a ParameterValue: there is no default COB-ID above node-ID 64");
    }
}
} // namespace

void CheckCommunication(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings)
{
    CheckFixed(srdo, findings);
    CheckCobIds(srdo, findings);
    const bool has_times = srdo.sct_ms.value && srdo.srvt_ms.value;
    if (has_times && srdo.IsConsumer())
    {
        CheckConsumerTimes(context, srdo, findings);
    }
    if (has_times && srdo.IsProducer())
    {
        CheckProducerTimes(context, srdo, findings);
    }
    if (srdo.number == 1U)
    {
        CheckDefaultCobId(context, 5U, 0U, findings);
        CheckDefaultCobId(context, 6U, 1U, findings);
    }
}

void CheckIdentifiers(const SafetyConfiguration& configuration, Findings& findings)
{
    std::map<std::uint64_t, const SrdoConfiguration*> users;
    const auto check = [&](const SrdoConfiguration& srdo, const Field& cob_id, const std::uint8_t sub)
    {
        const bool is_unassigned = cob_id.value.value_or(0U) == 0U;
        if (is_unassigned)
        {
            return;
        }
        const auto [user, is_new] = users.emplace(*cob_id.value, &srdo);
        if (is_new || user->second == &srdo)
        {
            return;
        }
        const std::string object = ObjectName(srdo.CommunicationIndex(), sub);
        const std::string wrong =
            "COB-ID " + Hex(*cob_id.value, 3) + " is in use by SRDO " + Decimal(user->second->number);
        const bool is_off = srdo.direction.Is(0U);
        const bool is_other_off = user->second->direction.Is(0U);
        const bool are_on = !is_off && !is_other_off;
        const std::string reason = is_off && is_other_off ? ", both are off" : (are_on ? "" : ", one is off");
        findings.Tell(are_on ? Severity::kError : Severity::kWarning, cob_id.place, object,
                      {wrong + reason, "an identifier of its own"});
    };
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        check(srdo, srdo.cob_id_1, 5U);
        check(srdo, srdo.cob_id_2, 6U);
    }
}
} // namespace counterpoint::cia306
