// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_BROKEN_HPP
#define VERIFICATION_TWINS_BROKEN_HPP

#include "verification/twins/broken_digest.hpp"
#include "verification/twins/plain/point.hpp"
#include "verification/twins/voice.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace counterpoint::twins
{

/// One named requirement and what breaks it, in front of a channel that keeps it or in the plain channel. What is not
/// set is left as it is; one that returns false leaves the call out.
struct Rule
{
    const char* requirement{""};
    std::string how{};
    bool is_plain{false}; ///< In the plain channel instead of in front of the subject.
    const plain::Point* point{nullptr};
    plain::Slip slip{plain::Slip::kNone};
    std::function<void(DeviceConfig&, SrdoSetup*)> config{};
    std::function<bool(ConfigItem&)> store{};
    std::function<void(ConfigItem&)> load{};
    std::function<bool(StaticFields&)> fields{};
    std::function<void(DeviceDigest&)> before{};
    std::function<void(DeviceDigest&)> digest{};
    std::function<DeviceDigest(const DigestSource&, DeviceDigest)> whole_digest{}; ///< Instead of the channel's.
    std::function<void(CheckResult&)> validated{};
    std::function<void(CheckResult&)> rechecked{};
    std::function<bool(CanFrame&, Instant&)> frame{};
    std::function<void(CycleInput&)> input{};
    std::function<void(CycleOutcome&)> outcome{};
    std::function<void(HeldPair&)> held{};
    std::function<void(SrdoView&)> view{};
    std::function<bool(SlotIndex)> demote{};
    std::function<bool(Agreement&)> commit{};
    std::function<void(SrdoMask&)> found{};
    std::function<void(Permit&)> permit{};
    std::function<void(PreparedPair&)> prepared{};
    std::function<bool(CanFrame&, Instant&)> confirmed{};
    std::function<void(Confirmation&)> confirmation{};
    std::function<void(CanFrame&)> inverse{};
    std::function<bool(TransmitFault&)> fault{};
};

/// @brief Every rule that can be broken, in a fixed order.
[[nodiscard]] const std::vector<Rule>& Rules();

/// A requirement mutant: a channel as it is, behind one that breaks one rule.
class Broken final : public Voice
{
  public:
    Broken(Channel& subject, const Rule& rule) noexcept;
    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] HeldPair Held(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    [[nodiscard]] SrdoMask Commit(const Agreement& agreement, SrdoMask examine) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) const noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

  private:
    const Rule& rule_;
    DeviceConfig config_{};
    SrdoSetup setups_[kMaxSrdoCount]{};
};

} // namespace counterpoint::twins

#endif
