// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/safety_gate/safety_gate.hpp"

namespace counterpoint::cia302
{
namespace
{

/// Differs in many bits from what memory holds by itself, and from node to node.
std::uint32_t PermitOf(const NodeId node) noexcept
{
    constexpr std::uint32_t kPattern = 0x5AC36900U;
    constexpr std::uint32_t kSpread = 0x00010101U;
    return kPattern ^ (std::uint32_t{node.value} * kSpread);
}

} // namespace

SafetyGate::SafetyGate(const NetworkSetup& setup, const SafetySlots& room, SdoPool& sdo) noexcept
    : setup_(setup), room_(room), sdo_(sdo), rule_(IdentityRule::kCia302)
{
    std::uint8_t used = 0U;
    for (std::uint8_t node = 1U; node <= kLastNode; ++node)
    {
        if (setup_.IsSafetySlave(NodeId{node}) && (used < room_.count))
        {
            room_.slots[used] = SafetySlot{NodeId{node}, 0U, SafetyCheck{}, false, {0U, 0U}};
            ++used;
        }
    }
    room_.count = used;
}

void SafetyGate::Use(const IdentityRule rule) noexcept
{
    rule_ = rule;
}

void SafetyGate::Verify(const NodeId node, const Instant /*now*/) noexcept
{
    static_cast<void>(Begin(node, SafetyTask::kVerify));
}

bool SafetyGate::Write(const NodeId node, const Instant /*now*/) noexcept
{
    return Begin(node, SafetyTask::kWrite);
}

/// The first object is asked for in the next cycle: the call may come from within an event.
bool SafetyGate::Begin(const NodeId node, const SafetyTask task) noexcept
{
    SafetySlot* const slot = setup_.IsSafetySlave(node) ? Find(node) : nullptr;
    const bool is_believed = (slot != nullptr) && !slot->is_doubted;
    if (is_believed)
    {
        Cancel(*slot);
        slot->permit = 0U;
        slot->check.Begin(SafetyOrder{setup_.Slave(node), rule_, task}, node);
    }
    return is_believed;
}

void SafetyGate::Doubt(const NodeId node) noexcept
{
    SafetySlot* const slot = Find(node);
    Close(node);
    if (slot != nullptr)
    {
        slot->is_doubted = true;
    }
}

void SafetyGate::Trust(const NodeId node) noexcept
{
    SafetySlot* const slot = Find(node);
    if (slot != nullptr)
    {
        slot->is_doubted = false;
    }
}

void SafetyGate::Renew(const NodeId node) noexcept
{
    const SafetySlot* const slot = Find(node);
    if ((slot != nullptr) && (slot->check.State() == CheckState::kBusy))
    {
        static_cast<void>(Begin(node, slot->check.Task()));
    }
}

bool SafetyGate::OnWritten(const NodeId node, const ObjectAddress& object) noexcept
{
    const SafetySlot* const slot = Find(node);
    const bool is_foreign = (slot != nullptr) && !slot->check.IsOwn(object);
    if (is_foreign)
    {
        Renew(node);
    }
    return is_foreign;
}

void SafetyGate::NoteDownload(const NodeId node, const ObjectAddress& object) noexcept
{
    SafetySlot* const slot = Find(node);
    if (slot != nullptr)
    {
        slot->download = object;
    }
}

ObjectAddress SafetyGate::LastDownload(const NodeId node) const noexcept
{
    const SafetySlot* const slot = Find(node);
    return (slot != nullptr) ? slot->download : ObjectAddress{0U, 0U};
}

void SafetyGate::OnCycle(const Instant now) noexcept
{
    for (std::uint8_t i = 0U; i < room_.count; ++i)
    {
        SafetySlot& slot = room_.slots[i];
        if (slot.check.State() == CheckState::kBusy)
        {
            slot.check.OnCycle(sdo_, now);
            slot.permit = (slot.check.State() == CheckState::kAlike) ? PermitOf(slot.node) : 0U;
        }
    }
}

void SafetyGate::Close(const NodeId node) noexcept
{
    SafetySlot* const slot = Find(node);
    if (slot != nullptr)
    {
        Cancel(*slot);
        slot->permit = 0U;
        slot->check = SafetyCheck{};
    }
}

GateState SafetyGate::State(const NodeId node) const noexcept
{
    GateState state = GateState::kOpen;
    if (setup_.IsSafetySlave(node))
    {
        const SafetySlot* const slot = Find(node);
        const CheckState check = (slot == nullptr) ? CheckState::kClosed : slot->check.State();
        const bool may_start = (check == CheckState::kAlike) && (slot->permit == PermitOf(node));
        state = (check == CheckState::kBusy) ? GateState::kBusy : GateState::kClosed;
        state = (check == CheckState::kDiffers) ? GateState::kDiffers : state;
        state = (check == CheckState::kFailed) ? GateState::kFailed : state;
        state = may_start ? GateState::kOpen : state;
        state = ((slot == nullptr) || slot->is_doubted) ? GateState::kFailed : state;
    }
    return state;
}

GateFinding SafetyGate::Finding(const NodeId node) const noexcept
{
    const SafetySlot* const slot = Find(node);
    const GateFinding none{{0U, 0U}, SdoAbort::kNone, 0U, 0U};
    const GateFinding no_slot{{0U, 0U}, SdoAbort::kOutOfMemory, 0U, 0U};
    const GateFinding in_doubt{{0U, 0U}, SdoAbort::kGeneral, 0U, 0U};
    const bool is_out_of_room = (slot == nullptr) && setup_.IsSafetySlave(node);
    GateFinding finding = is_out_of_room ? no_slot : none;
    if (slot != nullptr)
    {
        finding = slot->is_doubted ? in_doubt : slot->check.Finding();
    }
    return finding;
}

SafetySlot* SafetyGate::Find(const NodeId node) const noexcept
{
    SafetySlot* found = nullptr;
    for (std::uint8_t i = 0U; i < room_.count; ++i)
    {
        found = (room_.slots[i].node.value == node.value) ? &room_.slots[i] : found;
    }
    return found;
}

/// The connection goes back to the profile.
void SafetyGate::Cancel(const SafetySlot& slot) noexcept
{
    if (slot.check.HasTransfer() && (sdo_.State(slot.node) == TransferState::kBusy))
    {
        sdo_.Cancel(slot.node, SdoAbort::kGeneral);
    }
}

} // namespace counterpoint::cia302
