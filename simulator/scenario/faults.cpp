// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

#include <string>

// Faults that hit or bring frames; those of nodes are in node_faults.cpp. What each key may hold is in the
// schema.
namespace counterpoint::simulator
{
namespace
{
constexpr Range kByteRange{0U, 255U};
constexpr std::uint32_t kLastStandardIdentifier = 0x7FFU;

std::optional<NodeIndex> FindNode(Fields& fields, const char* key, const Scenario& scenario)
{
    const auto value = fields.Find(key);
    return value ? std::optional<NodeIndex>(CpuNamed(scenario, *value)) : std::nullopt;
}

void ReadIdentifiers(const YamlValue& value, FrameChoice& choice)
{
    if (value.Node().kind != runtime::YamlKind::kSequence)
    {
        choice.identifiers.push_back(value.Checked());
        return;
    }
    for (const YamlValue& item : value.Items("a list of COB-IDs"))
    {
        choice.identifiers.push_back(item.Checked());
    }
    if (choice.identifiers.empty())
    {
        value.Refuse("an empty list", "one COB-ID or more");
    }
}

void ReadFramesOf(const Scenario& scenario, const YamlValue& value, FrameChoice& choice)
{
    Fields fields(value, "frames_of");
    choice.srdo_of = NodeNamed(scenario, fields.Require("node"));
    choice.srdo = SrdoNumber(fields.Require("srdo"));
    const Side side = fields.Require("which").Choice(kFrameSideWords);
    choice.has_normal = side != Side::kSecond;
    choice.has_inverse = side != Side::kFirst;
    fields.Close();
}

FrameChoice ReadFrames(const Scenario& scenario, const YamlValue& value)
{
    Fields fields(value, "frames");
    FrameChoice choice;
    if (const auto identifier = fields.Find("identifier"))
    {
        ReadIdentifiers(*identifier, choice);
    }
    if (const auto srdo = fields.Find("srdo"))
    {
        ReadFramesOf(scenario, *srdo, choice);
        if (!choice.identifiers.empty())
        {
            value.Refuse("both 'identifier' and 'srdo'", "one of them");
        }
    }
    choice.sender = FindNode(fields, "sender", scenario);
    choice.receiver = FindNode(fields, "receiver", scenario);
    const auto controller = fields.Find("controller");
    choice.controller = controller ? controller->Checked() : 0U;
    choice.from = fields.Require("from").Duration();
    if (const auto until = fields.Find("until"))
    {
        choice.until = until->Duration();
        if (choice.until <= choice.from)
        {
            until->Refuse(runtime::Shown(until->Node().scalar), "a time after 'from'");
        }
    }
    ReadPattern(fields, choice.on, choice.off);
    choice.first = fields.Require("first").Checked();
    choice.every = fields.Require("every").Checked();
    choice.count = fields.Require("count").Checked();
    choice.probability_ppm = fields.Require("probability_ppm").Checked();
    fields.Close();
    return choice;
}

std::vector<std::uint8_t> ReadData(Fields& fields)
{
    const auto data = fields.Find("data");
    if (!data)
    {
        return {};
    }
    std::vector<std::uint8_t> bytes = ReadBytes(*data, kByteRange);
    if (bytes.size() > kMaxPayloadBytes)
    {
        data->Refuse(std::to_string(bytes.size()) + " bytes", "at most 8");
    }
    return bytes;
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

void ReadForeignFrame(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    fault.identifier = fields.Require("identifier").Checked();
    fault.frame_kind = fields.Require("kind").Choice(kFrameKindWords);
    fault.data = ReadData(fields);
    RequireIdentifier(fields, fault);
    fault.times = fields.Require("times").Checked();
    if (const auto by = fields.Find("every"))
    {
        fault.by = by->Lasting();
        if (fault.by > runtime::kLongestTime / fault.times)
        {
            by->Refuse(runtime::Shown(by->Node().scalar),
                       "a time that fits " + std::to_string(fault.times) + " times into 10000000 s");
        }
    }
    if (fault.times > 1U && fault.by == 0)
    {
        fields.Value().Refuse("several frames without key 'every'", "the time between two frames");
    }
    if (fault.kind == FaultKind::kInsertion)
    {
        fault.frames.receiver = FindNode(fields, "receiver", scenario);
        return;
    }
    fault.node = CpuNamed(scenario, fields.Require("node"));
}

void ReadCorruption(Fields& fields, FaultSetup& fault)
{
    if (const auto bits = fields.Find("bits"))
    {
        fault.bits = ReadBytes(*bits, {0U, 63U});
    }
    if (const auto length = fields.Find("length"))
    {
        fault.length = static_cast<std::uint8_t>(length->Checked());
    }
    if (fault.bits.empty() && !fault.length)
    {
        fields.Value().Refuse("corruption that changes nothing", "key 'bits' or 'length'");
    }
}

void ReadConfirmation(Fields& fields, FaultSetup& fault)
{
    fault.how = fields.Require("how").Choice(kConfirmationHowWords);
    if (fault.how == Wrongness::kLate)
    {
        fault.by = fields.Require("by").Lasting();
    }
    if (fault.how == Wrongness::kWrong)
    {
        const YamlValue bits = fields.Require("bits");
        fault.bits = ReadBytes(bits, {0U, 63U});
        if (fault.bits.empty())
        {
            bits.Refuse("an empty list", "one bit or more");
        }
    }
}

void ReadBabbling(Fields& fields, FaultSetup& fault)
{
    ReadSpan(fields, fault);
    fault.identifier = fields.Require("identifier").Checked();
    fault.data = ReadData(fields);
}

/// What a fault on chosen frames does to them: what its section has of these keys.
void ReadEffect(Fields& fields, FaultSetup& fault)
{
    if (fault.kind == FaultKind::kCorruption)
    {
        ReadCorruption(fields, fault);
        return;
    }
    if (fault.kind == FaultKind::kConfirmation)
    {
        ReadConfirmation(fields, fault);
        return;
    }
    if (fields.Has("times"))
    {
        fault.times = fields.Require("times").Checked();
    }
    if (fields.Has("after"))
    {
        fault.by = fields.Require("after").Duration();
    }
    if (fields.Has("by"))
    {
        fault.by = fields.Require("by").Lasting();
    }
    if (fields.Has("gap"))
    {
        fault.gap = fields.Require("gap").Duration();
    }
    if (fields.Has("as"))
    {
        fault.identifier = fields.Require("as").Checked();
    }
    if (fields.Has("bit"))
    {
        fault.bit = static_cast<std::uint8_t>(fields.Require("bit").Checked());
    }
}

FaultKind KindNamed(const YamlValue& value)
{
    const std::string text = value.Text("one word");
    for (const FaultKindRow& row : kFaultKinds)
    {
        if (text == row.text)
        {
            return row.meaning;
        }
    }
    value.Refuse(runtime::Shown(text), "one of " + WordsOf<kFaultKinds>());
}
} // namespace

void ReadPattern(Fields& fields, Nanoseconds& on, Nanoseconds& off)
{
    const auto there = fields.Find("on");
    const auto gone = fields.Find("off");
    if (static_cast<bool>(there) != static_cast<bool>(gone))
    {
        fields.Value().Refuse("an on/off pattern of one part", "both 'on' and 'off'");
    }
    on = there ? there->Lasting() : 0;
    off = gone ? gone->Lasting() : 0;
}

std::vector<std::uint8_t> ReadBytes(const YamlValue& value, const Range& range)
{
    std::vector<std::uint8_t> bytes;
    for (const YamlValue& item : value.Items("a list of numbers"))
    {
        bytes.push_back(static_cast<std::uint8_t>(item.Number(range)));
    }
    return bytes;
}

void ReadSpan(Fields& fields, FaultSetup& fault)
{
    fault.at = fields.Require("at").Duration();
    if (const auto until = fields.Find("until"))
    {
        fault.until = until->Duration();
        if (fault.until <= fault.at)
        {
            until->Refuse(runtime::Shown(until->Node().scalar), "a time after 'at'");
        }
    }
    ReadPattern(fields, fault.on, fault.off);
}

FaultSetup ReadFault(const Scenario& scenario, const YamlValue& value)
{
    Fields fields(value, "fault");
    FaultSetup fault;
    fault.source = value.Where();
    fault.kind = KindNamed(fields.Require("fault"));
    fields.Extend(Name(fault.kind));
    const auto name = fields.Find("name");
    fault.name = name ? name->Text("a text") : std::string(Name(fault.kind));
    fault.is_optional = fields.Require("optional").Choice(kYesWords);
    if (fields.Has("frames"))
    {
        fault.frames = ReadFrames(scenario, fields.Require("frames"));
        ReadEffect(fields, fault);
    }
    else if (fault.kind == FaultKind::kInsertion || fault.kind == FaultKind::kMasquerade)
    {
        ReadForeignFrame(fields, scenario, fault);
    }
    else if (fault.kind == FaultKind::kBabbling)
    {
        ReadBabbling(fields, fault);
    }
    else if (RowOf(fault.kind).site == FaultSite::kLink)
    {
        ReadLinkFault(fields, scenario, fault);
    }
    else
    {
        ReadNodeFault(fields, scenario, fault);
    }
    fields.Close();
    return fault;
}
} // namespace counterpoint::simulator
