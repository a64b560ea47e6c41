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
constexpr std::uint32_t kAlways = 0x7FFFFFFFU;

bool IsChannel(const Part part)
{
    return part == Part::kChannelA || part == Part::kChannelB;
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

void ReadBitFlip(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("part").Choice(kMemoryWords);
    fields.Into("at", fault.at);
    fields.Into("offset", fault.offset);
    if (IsChannel(fault.part))
    {
        if (auto config = fields.Map("config"))
        {
            fault.config = ReadConfigAddress(*config);
        }
    }
    if (fault.part == Part::kSetup || fault.part == Part::kSafeValue)
    {
        fields.Into("srdo", fault.srdo);
    }
    if (fault.offset && fault.config)
    {
        fields.Value().Refuse("both 'offset' and 'config'", "one of them, or neither for a bit chosen by the seed");
    }
    if (fields.Into("bit", fault.bit) && !fault.config && fault.bit > kLastBitOfByte)
    {
        const YamlValue bit = fields.Require("bit");
        bit.Refuse(runtime::Shown(bit.Node().scalar), "a number from 0 to 7");
    }
}

void ReadStuckBit(Fields& fields, FaultSetup& fault)
{
    fault.part = fields.Require("part").Choice(kLiveWords);
    fields.Into("at", fault.at); // It never ends.
    fields.Into("offset", fault.offset);
    fields.Into("bit", fault.bit);
    fault.level = fields.Require("level").Choice(kLevelWords);
}

void ReadPartFault(Fields& fields, FaultSetup& fault)
{
    const YamlValue part = fields.Require("part");
    fault.part = (fault.kind == FaultKind::kAlwaysGood) ? part.Choice(kGoodPartWords) : part.Choice(kPartWords);
    if (fault.kind == FaultKind::kHung)
    {
        fields.Into("at", fault.at); // It never ends.
        return;
    }
    if (fault.kind == FaultKind::kSkipped || fault.kind == FaultKind::kDoubled)
    {
        fault.call = fields.Require("call").Choice(kCallWords);
        fault.times = kAlways;
        fields.Into("count", fault.times);
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
    if (fields.Into("jump", fault.jump))
    {
        fields.Into("at", fault.at); // It does not last.
        return;
    }
    ReadSpan(fields, fault);
}

void ReadCycle(Fields& fields, FaultSetup& fault)
{
    fields.Into("at", fault.at);
    Nanoseconds early = 0;
    const bool is_late = fields.Into("late", fault.by);
    if (fields.Into("early", early) == is_late)
    {
        fields.Value().Refuse("cycle fault", "either 'late' or 'early' with a time");
    }
    fault.by -= early;
}

void ReadNotInverse(Fields& fields, FaultSetup& fault)
{
    fields.Into("object", fault.object);
    ReadBits(fields, fault.bits);
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
        fields.Into("at", fault.at);
        return;
    case FaultKind::kBusOff:
    case FaultKind::kUnplugged:
        fields.Into("controller", fault.controller);
        ReadSpan(fields, fault);
        return;
    case FaultKind::kQueueOverflow:
        fields.Into("capacity", fault.capacity);
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
