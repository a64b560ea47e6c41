// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/differential/reached.hpp"

namespace counterpoint::differential
{

namespace
{
constexpr const char* kNames[] = {
    "accepted pairs",
    "committed pairs",
    "automatic recoveries",
    "interlock recoveries",
    "acknowledged causes",
    "held pairs",
    "confirmed normal frames",
    "inverse frames",
    "sent pairs",
    "prepared, ready",
    "prepared, sides not inverse",
    "prepared, not producer",
    "guard configured",
    "guard unconfigured",
    "guard stale",
    "state off",
    "state waiting",
    "state faulted",
    "state producer",
    "state released",
    "cause length",
    "cause inverse first",
    "cause normal twice",
    "cause not inverse",
    "cause SRVT",
    "cause SCT",
    "cause identifier",
    "cause queue overflow",
    "cause late call",
    "cause not operational",
    "cause GFC",
    "cause demoted",
    "producer not inverse",
    "producer transmit queue",
    "producer bus-off",
    "producer no confirmation",
    "producer refresh missed",
    "producer wrong echo",
    "waiting past SCT",
    "config fault direction",
    "config fault type",
    "config fault identifier",
    "config fault identifier in use",
    "config fault timing",
    "config fault mapping",
    "config fault length",
    "config fault signature",
    "config fault table",
    "config fault none",
    "mapping fault by a dummy",
    "mapping fault by a shared object",
    "objects shared by producers",
    "mapping fault by static fields",
    "late detection, SRVT",
    "late detection, SCT",
    "late detection, released",
    "frames with an unused bit wrong",
    "accepted pairs of odd bits",
    "accepted pairs with dummies",
    "accepted pairs, static mapping",
    "accepted pairs, > 16 entries",
    "sent pairs of odd bits",
    "sent pairs, static mapping",
    "sent pairs, > 16 entries",
    "device digests",
    "refreshes that wait",
    "refreshes that wait for a pair in flight",
};
static_assert((sizeof(kNames) / sizeof(kNames[0])) == kItemCount, "one name an item");

struct CauseItem
{
    SrdoCause cause;
    Item item;
};

constexpr CauseItem kConsumerCauses[] = {
    {SrdoCause::kLength, Item::kCauseLength},
    {SrdoCause::kInverseFirst, Item::kCauseInverseFirst},
    {SrdoCause::kNormalTwice, Item::kCauseNormalTwice},
    {SrdoCause::kNotInverse, Item::kCauseNotInverse},
    {SrdoCause::kSrvt, Item::kCauseSrvt},
    {SrdoCause::kSct, Item::kCauseSct},
    {SrdoCause::kIdentifier, Item::kCauseIdentifier},
    {SrdoCause::kQueueOverflow, Item::kCauseQueueOverflow},
    {SrdoCause::kLateCall, Item::kCauseLateCall},
    {SrdoCause::kNotOperational, Item::kCauseNotOperational},
    {SrdoCause::kGfc, Item::kCauseGfc},
    {SrdoCause::kWaitingPastSct, Item::kWaitingPastSct},
};

constexpr CauseItem kProducerCauses[] = {
    {SrdoCause::kNotInverse, Item::kProducerNotInverse},
    {SrdoCause::kTransmitQueue, Item::kProducerTransmitQueue},
    {SrdoCause::kBusOff, Item::kProducerBusOff},
    {SrdoCause::kNoConfirmation, Item::kProducerNoConfirmation},
    {SrdoCause::kRefreshMissed, Item::kProducerRefreshMissed},
    {SrdoCause::kWrongEcho, Item::kProducerWrongEcho},
};
} // namespace

const char* NameOf(Item item) noexcept
{
    return kNames[static_cast<std::uint8_t>(item)];
}

void Reached::AddState(SrdoState state) noexcept
{
    switch (state)
    {
    case SrdoState::kOff:
        Add(Item::kStateOff);
        break;
    case SrdoState::kWaiting:
        Add(Item::kStateWaiting);
        break;
    case SrdoState::kFaulted:
        Add(Item::kStateFaulted);
        break;
    case SrdoState::kProducer:
        Add(Item::kStateProducer);
        break;
    case SrdoState::kReleased:
        Add(Item::kStateReleased);
        break;
    case SrdoState::kInvalid:
        break;
    }
}

void Reached::AddFault(ConfigFault fault) noexcept
{
    if (fault == ConfigFault::kNone)
    {
        Add(Item::kFaultNone);
    }
    else if ((fault >= ConfigFault::kDirection) && (fault <= ConfigFault::kTable))
    {
        const std::uint8_t first = static_cast<std::uint8_t>(Item::kFaultDirection);
        Add(static_cast<Item>(static_cast<std::uint8_t>(first + static_cast<std::uint8_t>(fault) - 1U)));
    }
}

void Reached::AddGuard(GuardView guard) noexcept
{
    switch (guard)
    {
    case GuardView::kConfigured:
        Add(Item::kGuardConfigured);
        break;
    case GuardView::kUnconfigured:
        Add(Item::kGuardUnconfigured);
        break;
    case GuardView::kStale:
        Add(Item::kGuardStale);
        break;
    case GuardView::kInvalid:
        break;
    }
}

void Reached::AddSignals(std::uint32_t signals, bool is_producer) noexcept
{
    if (is_producer)
    {
        for (const CauseItem& known : kProducerCauses)
        {
            Add(known.item, (signals >> static_cast<std::uint8_t>(known.cause)) & 1U);
        }
        return;
    }
    for (const CauseItem& known : kConsumerCauses)
    {
        Add(known.item, (signals >> static_cast<std::uint8_t>(known.cause)) & 1U);
    }
}

std::uint32_t Reached::Missing() const noexcept
{
    std::uint32_t missing = 0U;
    for (const std::uint64_t count : counts_)
    {
        missing += (count == 0U) ? 1U : 0U;
    }
    return missing;
}

} // namespace counterpoint::differential
