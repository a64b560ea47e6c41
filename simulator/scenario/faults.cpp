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
constexpr std::uint32_t kLastStandardIdentifier = 0x7FFU;

std::optional<NodeIndex> FindNode(Fields& fields, const char* key, const Scenario& scenario)
{
    const auto value = fields.Find(key);
    return value ? std::optional<NodeIndex>(CpuNamed(scenario, *value)) : std::nullopt;
}

void ReadFramesOf(Fields& fields, const Scenario& scenario, FrameChoice& choice)
{
    choice.srdo_of = NodeNamed(scenario, fields.Require("node"));
    fields.Into("srdo", choice.srdo);
    const Side side = fields.Require("which").Choice(kFrameSideWords);
    choice.has_normal = side != Side::kSecond;
    choice.has_inverse = side != Side::kFirst;
    fields.Close();
}

void ReadWindow(Fields& fields, const char* const begin, Nanoseconds& from, Nanoseconds& until, Nanoseconds& on,
                Nanoseconds& off)
{
    fields.Into(begin, from);
    if (fields.Into("until", until) && until <= from)
    {
        const YamlValue value = fields.Require("until");
        value.Refuse(runtime::Shown(value.Node().scalar), "a time after '" + std::string(begin) + "'");
    }
    const bool has_on = fields.Into("on", on);
    const bool has_off = fields.Into("off", off);
    if (has_on != has_off)
    {
        fields.Value().Refuse("an on/off pattern of one part", "both 'on' and 'off'");
    }
}

void ReadFrames(Fields& fields, const Scenario& scenario, FrameChoice& choice)
{
    if (fields.Into("identifier", choice.identifiers) && choice.identifiers.empty())
    {
        fields.Require("identifier").Refuse("an empty list", "one COB-ID or more");
    }
    if (auto srdo = fields.Map("srdo"))
    {
        ReadFramesOf(*srdo, scenario, choice);
        if (!choice.identifiers.empty())
        {
            fields.Value().Refuse("both 'identifier' and 'srdo'", "one of them");
        }
    }
    choice.sender = FindNode(fields, "sender", scenario);
    choice.receiver = FindNode(fields, "receiver", scenario);
    fields.Into("controller", choice.controller);
    ReadWindow(fields, "from", choice.from, choice.until, choice.on, choice.off);
    ReadTurns(fields, choice);
    fields.Close();
}

void ReadData(Fields& fields, FaultSetup& fault)
{
    if (fields.Into("data", fault.data) && fault.data.size() > kMaxPayloadBytes)
    {
        fields.Require("data").Refuse(std::to_string(fault.data.size()) + " bytes", "at most 8");
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

void ReadForeignFrame(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    fields.Into("at", fault.at);
    fields.Into("identifier", fault.identifier);
    fault.frame_kind = fields.Require("kind").Choice(kFrameKindWords);
    ReadData(fields, fault);
    RequireIdentifier(fields, fault);
    fields.Into("times", fault.times);
    if (fields.Into("every", fault.by) && fault.by > runtime::kLongestTime / fault.times)
    {
        const YamlValue by = fields.Require("every");
        by.Refuse(runtime::Shown(by.Node().scalar),
                  "a time that fits " + std::to_string(fault.times) + " times into 10000000 s");
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
    fields.Into("bits", fault.bits);
    fields.Into("length", fault.length);
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
        fields.Need("by", fault.by);
    }
    if (fault.how == Wrongness::kWrong)
    {
        ReadBits(fields, fault.bits);
    }
}

void ReadBabbling(Fields& fields, FaultSetup& fault)
{
    ReadSpan(fields, fault);
    fields.Into("identifier", fault.identifier);
    ReadData(fields, fault);
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
    fields.Into("times", fault.times);
    fields.Into("after", fault.by);
    fields.Into("by", fault.by);
    fields.Into("gap", fault.gap);
    fields.Into("as", fault.identifier);
    fields.Into("bit", fault.bit);
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

void ReadSpan(Fields& fields, FaultSetup& fault)
{
    ReadWindow(fields, "at", fault.at, fault.until, fault.on, fault.off);
}

void ReadTurns(Fields& fields, FrameChoice& choice)
{
    fields.Into("first", choice.first);
    fields.Into("every", choice.every);
    fields.Into("count", choice.count);
    fields.Into("probability_ppm", choice.probability_ppm);
}

void ReadFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    fault.kind = KindNamed(fields.Require("fault"));
    fields.Extend(Name(fault.kind));
    fault.name = Name(fault.kind);
    fields.Into("name", fault.name);
    fault.is_optional = fields.Require("optional").Choice(kYesWords);
    if (auto frames = fields.Map("frames"))
    {
        ReadFrames(*frames, scenario, fault.frames);
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
}
} // namespace counterpoint::simulator
