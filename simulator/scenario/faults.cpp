// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/parts.hpp"
#include "simulator/scenario/scenario.hpp"

#include <algorithm>
#include <map>
#include <string>

// Faults are read as the rows of fault_kinds.hpp say: each key by its function. Those of the functions that have a rule
// are here.
namespace counterpoint::simulator
{
namespace
{
void ReadFramesOf(Fields& fields, const Scenario& scenario, FrameChoice& choice)
{
    choice.srdo_of = NodeNamed(scenario, fields.Require("node"));
    fields.Into("srdo", choice.srdo);
    const Side side = fields.Require("which").Choice(kFrameSideWords);
    choice.has_normal = side != Side::kSecond;
    choice.has_inverse = side != Side::kFirst;
    fields.Close();
}

/// The key `until`, behind the key of the beginning.
void ReadEnd(Fields& fields, const char* const begin, const Nanoseconds from, Nanoseconds& until)
{
    if (fields.Into("until", until) && until <= from)
    {
        const YamlValue value = fields.Require("until");
        value.Refuse(runtime::Shown(value.Node().scalar), "a time after '" + std::string(begin) + "'");
    }
}

/// The keys `on` and `off`.
void ReadPattern(Fields& fields, Nanoseconds& on, Nanoseconds& off)
{
    const bool has_on = fields.Into("on", on);
    const bool has_off = fields.Into("off", off);
    if (has_on != has_off)
    {
        fields.Value().Refuse("an on/off pattern of one part", "both 'on' and 'off'");
    }
}

/// Without `count` one frame is hit: a window, a pattern or a turn that no second one can come to is a slip.
void RequireCount(Fields& fields)
{
    const runtime::YamlNode& written = fields.Value().Node();
    for (const char* const key : {"until", "on", "every"})
    {
        if (MemberOf(written, key) != nullptr && MemberOf(written, "count") == nullptr)
        {
            fields.Require(key).Refuse("key '" + std::string(key) + "' where one frame is hit",
                                       "key 'count' beside it");
        }
    }
}

ConfigAddress ReadConfigAddress(Fields& fields)
{
    ConfigAddress address{0U, ConfigField::kInvalid, 0U};
    address.field = fields.Require("field").Choice(kConfigFieldWords);
    const bool is_of_device = address.field >= ConfigField::kGfcParameter;
    if (!is_of_device)
    {
        fields.Need("srdo", address.slot);
    }
    if (address.field == ConfigField::kMapEntry)
    {
        fields.Need("entry", address.sub);
    }
    fields.Close();
    return address;
}

const FaultSection& SectionOfKind(const YamlValue& value)
{
    const std::string text = value.Text("one word");
    for (const FaultSection& section : kFaultSections)
    {
        if (section.kind && text == section.name)
        {
            return section;
        }
    }
    const std::string known = WordsOfFaults();
    value.Refuse(runtime::Shown(text) + cia306::DidYouMean(text, WordsIn(known)), "one of " + known);
}

std::optional<NodeIndex> FindNode(Fields& fields, const char* const key, const Scenario& scenario)
{
    const auto value = fields.Find(key);
    return value ? std::optional<NodeIndex>(CpuNamed(scenario, *value)) : std::nullopt;
}
} // namespace

namespace fault_keys
{
void ToNode(Fields& fields, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    fault.node = CpuNamed(scenario, fields.Require(key));
}

void ToTwoCpus(Fields& fields, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    const YamlValue node = fields.Require(key);
    fault.node = NodeNamed(scenario, node);
    if (!IsTwoCpus(scenario, node))
    {
        node.Refuse("node " + runtime::Shown(node.Node().scalar), "a node with 'structure: two_cpu'");
    }
}

void ToReceiver(Fields& fields, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    fault.frames.receiver = FindNode(fields, key, scenario);
}

/// Else it happens in the sender's controller or on the bus, for everybody: whose receivers were named, the key had no
/// effect. [SRS_SIM_075]
bool IsOfReceivers(const FaultKind& kind)
{
    return !std::holds_alternative<ControllerFault>(kind) && kind != FaultKind(FrameFault::kDuplicate);
}

void ToFrames(Fields& all, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    Fields fields = *all.Map(key);
    FrameChoice& choice = fault.frames;
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
    if (IsOfReceivers(fault.kind))
    {
        choice.receiver = FindNode(fields, "receiver", scenario);
        fields.Into("controller", choice.controller);
    }
    fields.Into("from", choice.from);
    ReadEnd(fields, "from", choice.from, choice.until);
    ReadPattern(fields, choice.on, choice.off);
    fields.Into("first", choice.first);
    fields.Into("every", choice.every);
    fields.Into("count", choice.count);
    RequireCount(fields);
    fields.Into("probability_ppm", choice.probability_ppm);
    fields.Close();
}

// A jump does not last.
void ToEnd(Fields& fields, const char* const /*key*/, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (!fields.Find("jump"))
    {
        ReadEnd(fields, "at", fault.at, fault.until);
    }
}

void ToPattern(Fields& fields, const char* const /*key*/, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (!fields.Find("jump"))
    {
        ReadPattern(fields, fault.on, fault.off);
    }
}

void ToLength(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fields.Into(key, fault.length);
    if (fault.bits.empty() && !fault.length)
    {
        fields.Value().Refuse("corruption that changes nothing", "key 'bits' or 'length'");
    }
}

void ToData(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    constexpr std::uint32_t kLastStandardIdentifier = 0x7FFU;
    if (fields.Into(key, fault.data) && fault.data.size() > kMaxPayloadBytes)
    {
        fields.Require(key).Refuse(std::to_string(fault.data.size()) + " bytes", "at most 8");
    }
    const bool is_short = fault.frame_kind == FrameKind::kData || fault.frame_kind == FrameKind::kRemote;
    if (is_short && fault.identifier > kLastStandardIdentifier)
    {
        fields.Value().Refuse("a frame of 11-bit identifier with identifier " + IdentifierText(fault.identifier),
                              "an identifier up to 0x7FF, or another 'kind'");
    }
    if (fault.kind == FaultKind(ForeignFault::kMasquerade) && fault.frame_kind == FrameKind::kFlexibleDataRate)
    {
        fields.Value().Refuse("masquerade with a CAN FD frame", "a kind that the nodes' controllers can send");
    }
}

void ToEvery(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fault.times > 1U && fields.Into(key, fault.by) && fault.by > runtime::kLongestTime / fault.times)
    {
        const YamlValue by = fields.Require(key);
        by.Refuse(runtime::Shown(by.Node().scalar),
                  "a time that fits " + std::to_string(fault.times) + " times into 10000000 s");
    }
    if (fault.times > 1U && fault.by == 0)
    {
        const std::string what = std::holds_alternative<LinkFault>(fault.kind) ? "messages" : "frames";
        fields.Value().Refuse("several " + what + " without key 'every'", "the time between two " + what);
    }
}

void ToLateness(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fault.how == Wrongness::kLate)
    {
        fields.Need(key, fault.by);
    }
}

void ToWrongBits(Fields& fields, const char* const key, const Scenario& scenario, FaultSetup& fault)
{
    if (fault.how == Wrongness::kWrong)
    {
        BitsTo<&FaultSetup::bits>(fields, key, scenario, fault);
    }
}

void ToConfig(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fault.part != Part::kChannelA && fault.part != Part::kChannelB)
    {
        return;
    }
    if (auto config = fields.Map(key))
    {
        fault.config = ReadConfigAddress(*config);
        if (fault.offset)
        {
            fields.Value().Refuse("both 'offset' and 'config'", "one of them, or neither for a bit chosen by the seed");
        }
    }
}

void ToFlippedBit(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fields.Into(key, fault.bit) && !fault.config && fault.bit > kByteBits.highest)
    {
        const YamlValue bit = fields.Require(key);
        bit.Refuse(runtime::Shown(bit.Node().scalar), "a number from 0 to 7");
    }
}

void ToFlippedSrdo(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fault.part == Part::kSetup || fault.part == Part::kSafeValue)
    {
        fields.Into(key, fault.srdo);
    }
}

void ToCalls(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fault.times = kCounts.highest;
    fields.Into(key, fault.times);
}

void ToRate(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    constexpr std::int32_t kStoppedPpm = -1000000;
    const bool is_stopped = fields.Require("stopped").Choice(kYesWords);
    const auto ppm = fields.Find("ppm");
    const bool has_jump = fields.Into(key, fault.jump);
    const int effects = (is_stopped ? 1 : 0) + (ppm ? 1 : 0) + (has_jump ? 1 : 0);
    if (effects != 1 || (ppm && ppm->PartsPerMillion() == 0))
    {
        fields.Value().Refuse("clock fault without an effect of its own", "one of 'stopped: true', 'ppm' and 'jump'");
    }
    fault.rate_ppm = ppm ? ppm->PartsPerMillion() : kStoppedPpm;
}

void ToShift(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    Nanoseconds early = 0;
    const bool is_late = fields.Into("late", fault.by);
    if (fields.Into(key, early) == is_late)
    {
        fields.Value().Refuse("cycle fault", "either 'late' or 'early' with a time");
    }
    fault.by -= early;
}

void ToInput(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fault.part = fields.Require(key).Choice(kInputWords);
    if (fault.part == Part::kNone) // The wire that both channels share.
    {
        fault.part = Part::kAcknowledgeA;
        fault.second_part = Part::kAcknowledgeB;
    }
}

void ToWatchdog(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    fault.part = Part::kWatchdog;
    fault.how = fields.Require(key).Choice(kWatchdogHowWords);
}

void ToInserted(Fields& fields, const char* const key, const Scenario& /*scenario*/, FaultSetup& fault)
{
    if (fields.Require(key).Choice(kInsertedWords))
    {
        fields.Need("back", fault.back);
    }
}
} // namespace fault_keys

std::string WordsOfFaults()
{
    std::map<std::uint8_t, const char*> by_number;
    for (const FaultSection& section : kFaultSections)
    {
        if (section.kind)
        {
            by_number[NumberOf(*section.kind)] = section.name;
        }
    }
    std::string words;
    for (const auto& [number, word] : by_number)
    {
        words += (words.empty() ? "" : ", ") + std::string(word);
    }
    return words;
}

void ReadFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    const FaultSection& section = SectionOfKind(fields.Require("fault"));
    fault.kind = *section.kind;
    fault.name = section.name;
    fields.Extend(section.name);
    for (const KeySpec* const key : KeysOf(SectionNamed(section.name)))
    {
        if (key->read != nullptr)
        {
            key->read(fields, key->key, scenario, fault);
        }
    }
}
} // namespace counterpoint::simulator
