// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/parts.hpp"

#include <string>

// Faults of nodes: parts, memory, clocks, inputs, controllers. What each key may hold is the schema's.
namespace counterpoint::simulator
{
namespace
{
constexpr std::int32_t kStoppedPpm = -1000000;
constexpr std::uint32_t kLastBitOfByte = 7U;

bool IsChannel(const Part part)
{
    return part == Part::kChannelA || part == Part::kChannelB;
}

ConfigAddress ReadConfigAddress(const YamlValue& value)
{
    Fields fields(value, "config");
    ConfigAddress address{0U, ConfigField::kInvalid, 0U};
    address.field = fields.Require("field").Choice(kConfigFieldWords);
    const bool is_of_device = address.field >= ConfigField::kGfcParameter;
    if (!is_of_device)
    {
        address.slot = SrdoNumber(fields.Require("srdo"));
    }
    if (address.field == ConfigField::kMapEntry)
    {
        address.sub = static_cast<std::uint8_t>(fields.Require("entry").Checked());
    }
    fields.Close();
    return address;
}

void ReadBitFlip(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("part").Choice(kMemoryWords);
    fault.at = fields.Require("at").Duration();
    const auto offset = fields.Find("offset");
    if (offset)
    {
        fault.offset = offset->Checked();
    }
    if (IsChannel(fault.part))
    {
        if (const auto config = fields.Find("config"))
        {
            fault.config = ReadConfigAddress(*config);
        }
    }
    if (fault.part == Part::kSetup || fault.part == Part::kSafeValue)
    {
        const auto srdo = fields.Find("srdo");
        fault.srdo = srdo ? SrdoNumber(*srdo) : std::uint8_t{0U};
    }
    if (fault.offset && fault.config)
    {
        fields.Value().Refuse("both 'offset' and 'config'", "one of them, or neither for a bit chosen by the seed");
    }
    if (const auto bit = fields.Find("bit"))
    {
        fault.bit = static_cast<std::uint8_t>(bit->Checked());
        if (!fault.config && fault.bit > kLastBitOfByte)
        {
            bit->Refuse(runtime::Shown(bit->Node().scalar), "a number from 0 to 7");
        }
    }
}

void ReadStuckBit(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("part").Choice(kLiveWords);
    fault.at = fields.Require("at").Duration(); // It never ends.
    const auto offset = fields.Find("offset");
    if (offset)
    {
        fault.offset = offset->Checked();
    }
    if (const auto bit = fields.Find("bit"))
    {
        fault.bit = static_cast<std::uint8_t>(bit->Checked());
    }
    fault.level = fields.Require("level").Choice(kLevelWords);
}

void ReadPartFault(Fields& fields, FaultSetup& fault)
{
    const YamlValue part = fields.Require("part");
    fault.part = (fault.kind == FaultKind::kAlwaysGood) ? part.Choice(kGoodPartWords) : part.Choice(kPartWords);
    if (fault.kind == FaultKind::kHung)
    {
        fault.at = fields.Require("at").Duration(); // It never ends.
        return;
    }
    if (fault.kind == FaultKind::kSkipped || fault.kind == FaultKind::kDoubled)
    {
        fault.call = fields.Require("call").Choice(kCallWords);
        const auto count = fields.Find("count");
        fault.times = count ? count->Checked() : static_cast<std::uint32_t>(kCountRange.highest);
    }
    ReadSpan(fields, fault);
}

void ReadClock(Fields& fields, FaultSetup& fault)
{
    const Side side = fields.Require("counter").Choice(kCounterWords);
    fault.hits_counter_a = side != Side::kSecond;
    fault.hits_counter_b = side != Side::kFirst;
    const bool is_stopped = fields.Require("stopped").Choice(kYesWords);
    const auto ppm = fields.Find("ppm");
    const auto jump = fields.Find("jump");
    const int effects = (is_stopped ? 1 : 0) + (ppm ? 1 : 0) + (jump ? 1 : 0);
    if (effects != 1 || (ppm && ppm->PartsPerMillion() == 0))
    {
        fields.Value().Refuse("clock fault without an effect of its own", "one of 'stopped: true', 'ppm' and 'jump'");
    }
    fault.rate_ppm = ppm ? ppm->PartsPerMillion() : kStoppedPpm;
    if (jump)
    {
        fault.jump = jump->SignedDuration();
        fault.at = fields.Require("at").Duration(); // It does not last.
        return;
    }
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

void ReadNotInverse(Fields& fields, FaultSetup& fault)
{
    fault.object = fields.Require("object").Object();
    const YamlValue bits = fields.Require("bits");
    fault.bits = ReadBytes(bits, {0U, 63U});
    if (fault.bits.empty())
    {
        bits.Refuse("an empty list", "one bit or more");
    }
    ReadSpan(fields, fault);
}

void ReadFrozenInput(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("input").Choice(kInputWords);
    if (fault.part == Part::kNone) // The wire that both channels share.
    {
        fault.part = Part::kAcknowledgeA;
        fault.second_part = Part::kAcknowledgeB;
    }
    ReadSpan(fields, fault);
}

void ReadController(Fields& fields, FaultSetup& fault)
{
    const auto controller = fields.Find("controller");
    fault.controller = controller ? controller->Checked() : 0U;
    ReadSpan(fields, fault);
}
} // namespace

void ReadNodeFault(Fields& fields, const Scenario& scenario, FaultSetup& fault)
{
    fault.node = CpuNamed(scenario, fields.Require("node"));
    switch (fault.kind)
    {
    case FaultKind::kClock:
        ReadClock(fields, fault);
        return;
    case FaultKind::kCycle:
        ReadCycle(fields, fault);
        return;
    case FaultKind::kNotInverse:
        ReadNotInverse(fields, fault);
        return;
    case FaultKind::kBitFlip:
        ReadBitFlip(fields, fault);
        return;
    case FaultKind::kStuckBit:
        ReadStuckBit(fields, fault);
        return;
    case FaultKind::kStandstill:
        fault.at = fields.Require("at").Duration();
        return;
    case FaultKind::kBusOff:
    case FaultKind::kUnplugged:
        ReadController(fields, fault);
        return;
    case FaultKind::kQueueOverflow:
        fault.capacity = fields.Require("capacity").Checked();
        ReadSpan(fields, fault);
        return;
    case FaultKind::kFrozenInput:
        ReadFrozenInput(fields, fault);
        return;
    case FaultKind::kPermit:
        fault.part = fields.Require("party").Choice(kPermitWords);
        fault.how = fields.Require("how").Choice(kPermitHowWords);
        ReadSpan(fields, fault);
        return;
    case FaultKind::kWatchdog:
        fault.part = Part::kWatchdog;
        fault.how = fields.Require("how").Choice(kWatchdogHowWords);
        ReadSpan(fields, fault);
        return;
    default:
        ReadPartFault(fields, fault);
        return;
    }
}
} // namespace counterpoint::simulator
