// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_RIG_HPP
#define VERIFICATION_THIRD_VOICE_RIG_HPP

#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "verification/third_voice/device.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace counterpoint::third_voice
{
/// Where both counters stand at the model's time 0.
struct Counters
{
    std::uint32_t a;
    std::uint32_t b;
    Drift drift;
};

/// The shipped kernel and channels, looked at from in front only.
class Rig final : private Application, private hal::CanPorts, private hal::SafetyOutput, private hal::Watchdog
{
  public:
    static constexpr std::uint8_t kSrdos = 4U;
    static constexpr std::uint8_t kEntries = 8U;

    /// @brief `config` has no places for its objects yet; the rig makes them.
    Rig(DeviceConfig& config, std::vector<MappableObject>& objects, const Counters& counters);

    [[nodiscard]] StartResult Start();
    [[nodiscard]] AbortCode Write(Address address, std::uint64_t value, std::size_t size);
    [[nodiscard]] std::uint32_t Read(Address address);
    void SetNmt(NmtState state, Time now);
    void OnFrame(const CanFrame& frame, Time stamp);
    void Cycle(Time now, SrdoMask acknowledge_a, SrdoMask acknowledge_b);
    void Put(Address address, std::uint64_t value);
    void RefuseNext(std::optional<SrdoCause> cause);
    void OnConfirm(const Sent& frame, Time stamp);
    [[nodiscard]] std::uint64_t Variable(Address address) const;
    [[nodiscard]] SrdoState StateOf(std::uint8_t number) const;
    [[nodiscard]] Kernel& Facade();
    [[nodiscard]] SrdoMask Open(Time now);
    [[nodiscard]] Seen TakeSeen();

  private:
    RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    [[nodiscard]] InstantPair At(Time time) const;

    DeviceConfig& config_;
    Counters counters_;
    std::map<Address, std::array<std::uint8_t, 8U>> memory_;
    std::map<Address, std::uint8_t> bits_;
    channel_a::StorageFor<kSrdos, kEntries> storage_a_{};
    channel_b::StorageFor<kSrdos, kEntries> storage_b_{};
    channel_a::Channel a_;
    channel_b::Channel b_;
    hal::OutputGate gate_{};
    hal::WatchdogTimer watchdog_{};
    Time now_{0};
    Seen seen_{};
    std::optional<SrdoCause> refused_;
    CauseWindows windows_[kSrdos]{};
    Kernel kernel_;
};

/// @brief What the objects of an SRDO hold.
[[nodiscard]] SrdoObjects ReadObjects(Rig& rig, std::uint8_t number);
} // namespace counterpoint::third_voice

#endif
