// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_VOICE_HPP
#define VERIFICATION_TWINS_VOICE_HPP

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::twins
{

/// The objects that a channel owns: A the normal ones, B the inverse ones.
enum class Side : std::uint8_t
{
    kNormal,
    kInverse,
};

/// A channel that hands every call on to another one. What is made of a call is changed by overriding it.
class Voice : public Channel
{
  public:
    explicit Voice(Channel& subject) noexcept : subject_{subject}
    {
    }
    void Restart(const DeviceConfig& config) noexcept override
    {
        subject_.Restart(config);
    }
    void Store(const ConfigItem& item) noexcept override
    {
        subject_.Store(item);
    }
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        return subject_.Load(address);
    }
    [[nodiscard]] ChannelRoom Room() const noexcept override
    {
        return subject_.Room();
    }
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override
    {
        subject_.SetFields(slot, fields);
    }
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        return subject_.Digest(slot, before);
    }
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override
    {
        return subject_.Validate(slot);
    }
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override
    {
        return subject_.Recheck(slot);
    }
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        subject_.OnFrame(frame, stamp);
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        return subject_.OnCycle(input);
    }
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override
    {
        return subject_.Held(slot);
    }
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override
    {
        return subject_.View(slot);
    }
    void Demote(SlotIndex slot) noexcept override
    {
        subject_.Demote(slot);
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        return subject_.Commit(agreement, examine);
    }
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override
    {
        return subject_.Answer(challenge);
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        return subject_.Prepare(slot);
    }
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        return subject_.OnConfirm(frame, stamp);
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        return subject_.InverseFrame(slot);
    }
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override
    {
        subject_.OnTransmitFault(slot, fault);
    }

  protected:
    ~Voice() noexcept = default;
    [[nodiscard]] Channel& Subject() const noexcept
    {
        return subject_;
    }

  private:
    Channel& subject_;
};

} // namespace counterpoint::twins

#endif
