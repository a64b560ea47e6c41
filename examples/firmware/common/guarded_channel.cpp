// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "examples/firmware/common/guarded_channel.hpp"

namespace counterpoint::firmware
{
namespace
{

/// The owner's turn: from here to the end of the block.
class Turn
{
  public:
    Turn(hal::MemoryProtection& protection, const hal::MemoryOwner owner) noexcept : protection_{protection}
    {
        protection_.Enter(owner);
    }
    ~Turn()
    {
        protection_.Enter(hal::MemoryOwner::kKernel);
    }

    Turn(const Turn&) = delete;
    Turn(Turn&&) = delete;
    Turn& operator=(const Turn&) = delete;
    Turn& operator=(Turn&&) = delete;

  private:
    hal::MemoryProtection& protection_;
};

} // namespace

void GuardedChannel::Restart(const DeviceConfig& config) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.Restart(config);
}

void GuardedChannel::Store(const ConfigItem& item) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.Store(item);
}

ConfigItem GuardedChannel::Load(const ConfigAddress& address) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Load(address);
}

ChannelRoom GuardedChannel::Room() const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Room();
}

void GuardedChannel::SetFields(const SlotIndex slot, const StaticFields& fields) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.SetFields(slot, fields);
}

DeviceDigest GuardedChannel::Digest(const SlotIndex slot, const DeviceDigest before) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Digest(slot, before);
}

CheckResult GuardedChannel::Validate(const SlotIndex slot) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Validate(slot);
}

CheckResult GuardedChannel::Recheck(const SlotIndex slot) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Recheck(slot);
}

void GuardedChannel::OnFrame(const CanFrame& frame, const Instant stamp) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.OnFrame(frame, stamp);
}

CycleOutcome GuardedChannel::OnCycle(const CycleInput& input) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.OnCycle(input);
}

HeldPair GuardedChannel::Held(const SlotIndex slot) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Held(slot);
}

SrdoView GuardedChannel::View(const SlotIndex slot) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.View(slot);
}

void GuardedChannel::Demote(const SlotIndex slot) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.Demote(slot);
}

SrdoMask GuardedChannel::Commit(const Agreement& agreement, const SrdoMask examine) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Commit(agreement, examine);
}

Permit GuardedChannel::Answer(const std::uint32_t challenge) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Answer(challenge);
}

PreparedPair GuardedChannel::Prepare(const SlotIndex slot) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.Prepare(slot);
}

Confirmation GuardedChannel::OnConfirm(const CanFrame& frame, const Instant stamp) noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.OnConfirm(frame, stamp);
}

CanFrame GuardedChannel::InverseFrame(const SlotIndex slot) const noexcept
{
    const Turn turn{protection_, owner_};
    return channel_.InverseFrame(slot);
}

void GuardedChannel::OnTransmitFault(const SlotIndex slot, const TransmitFault& fault) noexcept
{
    const Turn turn{protection_, owner_};
    channel_.OnTransmitFault(slot, fault);
}

} // namespace counterpoint::firmware
