// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_FORWARDING_HPP
#define VERIFICATION_CONFORMANCE_FORWARDING_HPP

#include "safety_core/contract/channel.hpp"

namespace counterpoint::conformance
{

/// A channel that passes everything on to another; tests of the machinery override what shall go wrong.
class Forwarding : public Channel
{
  public:
    explicit Forwarding(Channel& inner) noexcept : inner_{inner}
    {
    }

    void Restart(const DeviceConfig& config) noexcept override
    {
        inner_.Restart(config);
    }
    void Store(const ConfigItem& item) noexcept override
    {
        inner_.Store(item);
    }
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override
    {
        return inner_.Load(address);
    }
    [[nodiscard]] ChannelRoom Room() const noexcept override
    {
        return inner_.Room();
    }
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override
    {
        inner_.SetFields(slot, fields);
    }
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override
    {
        return inner_.Digest(slot, before);
    }
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override
    {
        return inner_.Validate(slot);
    }
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override
    {
        return inner_.Recheck(slot);
    }
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override
    {
        inner_.OnFrame(frame, stamp);
    }
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override
    {
        return inner_.OnCycle(input);
    }
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override
    {
        return inner_.Held(slot);
    }
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override
    {
        return inner_.View(slot);
    }
    void Demote(SlotIndex slot) noexcept override
    {
        inner_.Demote(slot);
    }
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override
    {
        return inner_.Commit(agreement, examine);
    }
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override
    {
        return inner_.Answer(challenge);
    }
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override
    {
        return inner_.Prepare(slot);
    }
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override
    {
        return inner_.OnConfirm(frame, stamp);
    }
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override
    {
        return inner_.InverseFrame(slot);
    }
    void OnTransmitFault(SlotIndex slot, const counterpoint::TransmitFault& fault) noexcept override
    {
        inner_.OnTransmitFault(slot, fault);
    }

  protected:
    ~Forwarding() noexcept = default;

  private:
    Channel& inner_;
};

} // namespace counterpoint::conformance

#endif
