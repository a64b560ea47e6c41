// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/simulator/names.hpp"
#include "verification/simulator/scenario_parts.hpp"

#include "hal/host/bus_fault.hpp"

#include <string>

namespace counterpoint::simulator
{
namespace
{
constexpr Range kIdentifierRange{0U, 0x1FFFFFFFU};
constexpr std::uint32_t kLastStandardIdentifier = 0x7FFU;
constexpr Range kBitRange{0U, 63U};
constexpr Range kLengthRange{0U, 8U};
constexpr Range kByteRange{0U, 255U};
constexpr Range kTimesRange{1U, 1000U};
constexpr Range kCopiesRange{1U, host::ReceptionList::kCapacity - 1U};
constexpr Range kOffsetRange{0U, 0xFFFFFFU};
constexpr Range kBitOfByteRange{0U, 7U};
constexpr Range kEntryRange{1U, 16U};
constexpr std::int32_t kStoppedPpm = -1000000;

constexpr Word<ChannelCall> kCallWords[] = {{"OnCycle", ChannelCall::kOnCycle}, {"OnFrame", ChannelCall::kOnFrame}};
constexpr Word<bool> kYesWords[] = {{"true", true}, {"false", false}};
constexpr Word<bool> kCounterWords[] = {{"a", true}, {"b", false}};

std::optional<NodeIndex> FindNode(Fields& fields, const char* key, const Scenario& scenario)
{
    const auto value = fields.Find(key);
    return value ? std::optional<NodeIndex>(NodeNamed(scenario, *value)) : std::nullopt;
}

std::optional<std::uint32_t> FindNumber(Fields& fields, const char* key, const Range& range)
{
    const auto value = fields.Find(key);
    return value ? std::optional<std::uint32_t>(static_cast<std::uint32_t>(value->Number(range))) : std::nullopt;
}

FrameChoice ReadFrames(const Scenario& scenario, const ScenarioValue& value)
{
    Fields fields(value, "a choice of frames");
    FrameChoice choice;
    choice.identifier = FindNumber(fields, "identifier", kIdentifierRange);
    choice.sender = FindNode(fields, "sender", scenario);
    choice.receiver = FindNode(fields, "receiver", scenario);
    if (const auto from = fields.Find("from"))
    {
        choice.from = from->Duration();
    }
    if (const auto until = fields.Find("until"))
    {
        choice.until = until->Duration();
        if (choice.until <= choice.from)
        {
            until->Refuse(Shown(until->Node().scalar), "a time after 'from'");
        }
    }
    choice.first = FindNumber(fields, "first", kCountRange).value_or(1U);
    choice.count = FindNumber(fields, "count", kCountRange).value_or(1U);
    if (const auto probability = fields.Find("probability_ppm"))
    {
        choice.probability_ppm = static_cast<std::uint32_t>(probability->Number({1U, 1000000U}));
    }
    fields.Close();
    return choice;
}

std::vector<std::uint8_t> ReadBytes(const ScenarioValue& value, const Range& range, const std::string& expected)
{
    std::vector<std::uint8_t> bytes;
    for (const ScenarioValue& item : value.Items(expected))
    {
        bytes.push_back(static_cast<std::uint8_t>(item.Number(range)));
    }
    return bytes;
}

void ReadCorruption(Fields& fields, FaultSetup& fault)
{
    if (const auto bits = fields.Find("bits"))
    {
        fault.bits = ReadBytes(*bits, kBitRange, "a list of bits from 0 to 63");
    }
    if (const auto length = FindNumber(fields, "length", kLengthRange))
    {
        fault.length = static_cast<std::uint8_t>(*length);
    }
    if (fault.bits.empty() && !fault.length)
    {
        fields.Value().Refuse("corruption that changes nothing", "key 'bits' or 'length'");
    }
}

void RequireIdentifier(const Fields& fields, const FaultSetup& fault)
{
    const bool is_short = fault.frame_kind == FrameKind::kData || fault.frame_kind == FrameKind::kRemote;
    if (is_short && fault.identifier > kLastStandardIdentifier)
    {
        fields.Value().Refuse("a frame of 11-bit identifier with identifier " + IdentifierText(fault.identifier),
                              "an identifier up to 0x7FF, or another 'kind'");
    }
    if (fault.kind == FaultKind::kMasquerade && fault.frame_kind == FrameKind::kFlexibleDataRate)
    {
        fields.Value().Refuse("masquerade with a CAN FD frame", "a kind that the nodes' controllers can send");
    }
}

void ReadForeignFrame(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    fault.identifier = static_cast<std::uint32_t>(fields.Require("identifier").Number(kIdentifierRange));
    if (const auto kind = fields.Find("kind"))
    {
        fault.frame_kind = kind->Choice(kFrameKindWords);
    }
    const auto data = fields.Find("data");
    if (data)
    {
        fault.data = ReadBytes(*data, kByteRange, "a list of at most 8 bytes");
        if (fault.data.size() > kMaxPayloadBytes)
        {
            data->Refuse(std::to_string(fault.data.size()) + " bytes", "at most 8");
        }
    }
    RequireIdentifier(fields, fault);
    fault.times = FindNumber(fields, "times", kTimesRange).value_or(1U);
    if (const auto by = fields.Find("every"))
    {
        fault.by = by->Lasting();
        if (fault.by > kLongestTime / fault.times)
        {
            by->Refuse(Shown(by->Node().scalar),
                       "a time that fits " + std::to_string(fault.times) + " times into 10000000 s");
        }
    }
    if (fault.times > 1U && fault.by == 0)
    {
        fields.Value().Refuse("several frames without key 'every'", "the time between two frames");
    }
}

void ReadBusFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    if (fault.kind == FaultKind::kInsertion)
    {
        ReadForeignFrame(fields, fault);
        fault.frames.receiver = FindNode(fields, "receiver", scenario);
        return;
    }
    if (fault.kind == FaultKind::kMasquerade)
    {
        ReadForeignFrame(fields, fault);
        fault.node = NodeNamed(scenario, fields.Require("node"));
        return;
    }
    fault.frames = ReadFrames(scenario, fields.Require("frames"));
    if (fault.kind == FaultKind::kCorruption)
    {
        ReadCorruption(fields, fault);
    }
    if (fault.kind == FaultKind::kRepetition)
    {
        fault.times = FindNumber(fields, "times", kCopiesRange).value_or(1U);
        const auto by = fields.Find("after");
        fault.by = by ? by->Duration() : 0;
    }
    if (fault.kind == FaultKind::kDelay)
    {
        fault.by = fields.Require("by").Lasting();
    }
    if (fault.kind == FaultKind::kAddressing)
    {
        fault.identifier = static_cast<std::uint32_t>(fields.Require("as").Number({0U, 0x7FFU}));
    }
}

void ReadSpan(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    if (const auto until = fields.Find("until"))
    {
        fault.until = until->Duration();
        if (fault.until <= fault.at)
        {
            until->Refuse(Shown(until->Node().scalar), "a time after 'at'");
        }
    }
}

ConfigAddress ReadConfigAddress(const ScenarioValue& value)
{
    Fields fields(value, "a configuration value");
    ConfigAddress address{0U, ConfigField::kInvalid, 0U};
    address.field = fields.Require("field").Choice(kConfigFieldWords);
    const bool is_of_device = address.field >= ConfigField::kGfcParameter;
    if (!is_of_device)
    {
        address.slot = SrdoNumber(fields.Require("srdo"));
    }
    if (address.field == ConfigField::kMapEntry)
    {
        address.sub = static_cast<std::uint8_t>(fields.Require("entry").Number(kEntryRange));
    }
    fields.Close();
    return address;
}

void ReadBitFlip(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    fault.offset = FindNumber(fields, "offset", kOffsetRange);
    if (const auto config = fields.Find("config"))
    {
        fault.config = ReadConfigAddress(*config);
    }
    if (fault.offset && fault.config)
    {
        fields.Value().Refuse("both 'offset' and 'config'", "one of them, or neither for a bit chosen by the seed");
    }
    const Range bits = fault.config ? Range{0U, 31U} : kBitOfByteRange;
    fault.bit = static_cast<std::uint8_t>(FindNumber(fields, "bit", bits).value_or(0U));
}

void RequireParts(const Fields& fields, const FaultSetup& fault, const bool fits, const char* expected)
{
    if (!fits)
    {
        fields.Value().Refuse(std::string(Name(fault.kind)) + " with part " + Name(fault.part), expected);
    }
}

void ReadPartFault(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("part").Choice(kPartWords);
    const bool is_channel = fault.part == Part::kChannelA || fault.part == Part::kChannelB;
    if (fault.kind == FaultKind::kBitFlip)
    {
        RequireParts(fields, fault, is_channel, "channel_a or channel_b");
        ReadBitFlip(fields, fault);
        return;
    }
    if (fault.kind == FaultKind::kSkipped || fault.kind == FaultKind::kDoubled)
    {
        RequireParts(fields, fault, is_channel, "channel_a or channel_b");
        const auto call = fields.Find("call");
        fault.call = call ? call->Choice(kCallWords) : ChannelCall::kOnCycle;
        fault.times =
            FindNumber(fields, "count", kCountRange).value_or(static_cast<std::uint32_t>(kCountRange.highest));
    }
    if (fault.kind == FaultKind::kNotCalled)
    {
        RequireParts(fields, fault, !is_channel, "comparator, flow_monitor or guard");
    }
    if (fault.kind == FaultKind::kAlwaysGood)
    {
        RequireParts(fields, fault, fault.part == Part::kComparator, "comparator");
    }
    if (fault.kind == FaultKind::kHung)
    {
        fault.at = fields.Require("at").Duration(); // It never ends.
        return;
    }
    ReadSpan(fields, fault);
}

void ReadClock(Fields& fields, FaultSetup& fault)
{
    fault.is_counter_a = fields.Require("counter").Choice(kCounterWords);
    const auto stopped = fields.Find("stopped");
    const auto ppm = fields.Find("ppm");
    const bool is_stopped = stopped && stopped->Choice(kYesWords);
    if (is_stopped == static_cast<bool>(ppm))
    {
        fields.Value().Refuse("clock fault without an effect of its own", "either 'stopped: true' or 'ppm'");
    }
    fault.rate_ppm = ppm ? ppm->PartsPerMillion() : kStoppedPpm;
    ReadSpan(fields, fault);
}

void ReadCycle(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    const auto late = fields.Find("late");
    const auto early = fields.Find("early");
    if (static_cast<bool>(late) == static_cast<bool>(early))
    {
        fields.Value().Refuse("cycle fault", "either 'late' or 'early' with a time");
    }
    fault.by = late ? late->Lasting() : -early->Lasting();
}

void ReadNodeFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    fault.node = NodeNamed(scenario, fields.Require("node"));
    if (fault.kind == FaultKind::kClock)
    {
        ReadClock(fields, fault);
    }
    else if (fault.kind == FaultKind::kCycle)
    {
        ReadCycle(fields, fault);
    }
    else if (fault.kind == FaultKind::kNotInverse)
    {
        fault.object = fields.Require("object").Object();
        const ScenarioValue bits = fields.Require("bits");
        fault.bits = ReadBytes(bits, kBitRange, "a list of bits from 0 to 63");
        if (fault.bits.empty())
        {
            bits.Refuse("an empty list", "one bit or more");
        }
        ReadSpan(fields, fault);
    }
    else
    {
        ReadPartFault(fields, fault);
    }
}
} // namespace

FaultSetup ReadFault(const Scenario& scenario, const ScenarioValue& value)
{
    Fields fields(value, "a fault");
    FaultSetup fault;
    fault.source = value.Where();
    fault.kind = fields.Require("fault").Choice(kFaultWords);
    const auto name = fields.Find("name");
    fault.name = name ? name->Text("a text") : std::string(Name(fault.kind));
    if (IsBusFault(fault.kind))
    {
        ReadBusFault(fields, scenario, fault);
    }
    else
    {
        ReadNodeFault(fields, scenario, fault);
    }
    fields.Close();
    return fault;
}
} // namespace counterpoint::simulator
