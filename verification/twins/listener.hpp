// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_LISTENER_HPP
#define VERIFICATION_TWINS_LISTENER_HPP

#include "verification/differential/device.hpp"
#include "verification/twins/trace.hpp"
#include "verification/twins/voice.hpp"

#include <cstdint>

namespace counterpoint::twins
{

/// What the calls of the first place brought, for the second one.
struct Answers
{
    CheckResult checked{};
    CycleOutcome outcome{};
    PreparedPair prepared{};
    Confirmation confirmation{};
    SrdoMask found{0U};
};

/// The first channel of a differential run: the subject itself. Everything that it shows goes into the trace, what
/// belongs to its side made comparable: objects of the inverse side as their complement, a permit without the constant
/// of its party.
class First final : public Voice
{
  public:
    First(Channel& subject, Side side, Answers& answers, Trace& trace) noexcept;
    void Restart(const DeviceConfig& config) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override;
    /// @brief Where the run keeps its random device.
    void LookAt(differential::Device& device) noexcept
    {
        device_ = &device;
    }

  private:
    [[nodiscard]] differential::Memory& Objects() const noexcept;
    void MarkBits(SlotIndex slot) noexcept;
    void LookBefore() noexcept;
    void LookAfter() noexcept;

    static constexpr std::uint32_t kBytes = sizeof(differential::Memory::bytes);

    Side side_;
    Answers& answers_;
    Trace& trace_;
    differential::Device* device_{nullptr};
    std::uint8_t inverted_[kBytes]{}; ///< Bits that the subject's side has inverted.
    std::uint8_t before_[kBytes]{};
};

/// The second one says what the first one said, so that the run sees two that agree.
class Second final : public Voice
{
  public:
    Second(Channel& subject, Side side, const Answers& answers) noexcept
        : Voice{subject}, side_{side}, answers_{answers}
    {
    }
    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

  private:
    Side side_;
    const Answers& answers_;
};

} // namespace counterpoint::twins

#endif
