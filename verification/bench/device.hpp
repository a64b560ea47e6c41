// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_DEVICE_HPP
#define VERIFICATION_BENCH_DEVICE_HPP

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "hal/api/output_gate.hpp"
#include "safety_core/kernel/kernel.hpp"

#include <cstdint>

namespace counterpoint::bench
{

constexpr std::uint32_t kCycleUs = 1000U;

/// Accepts every frame and keeps the last ones, so that the bench can confirm them.
class BenchPorts final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief The oldest frame that was not taken yet; kind kInvalid if there is none.
    [[nodiscard]] CanFrame Take() noexcept;

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    static constexpr std::uint32_t kPlaces = 4U;
    CanFrame frames_[kPlaces]{};
    std::uint32_t written_{0U};
    std::uint32_t read_{0U};
};

/// The real gate, without pins behind it.
class BenchOutput final : public hal::SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    void Advance(Instant now) noexcept;
    [[nodiscard]] SrdoMask Open() noexcept;

  private:
    hal::OutputGate gate_{};
    Instant now_{0U};
};

class BenchWatchdog final : public hal::Watchdog
{
  public:
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    [[nodiscard]] std::uint32_t WrongAnswers() const noexcept;

  private:
    std::uint32_t question_{1U};
    std::uint32_t wrong_{0U};
};

/// Callbacks with nothing in them: what an application does there is not the kernel's cost. Counts, to prove that the
/// measured thing happened.
class BenchApplication final : public Application
{
  public:
    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnGfc() noexcept override;
    void OnGfcNotFollowed() noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;
    void OnFlow(const FlowCount& count) noexcept override;
    [[nodiscard]] std::uint32_t Events() const noexcept;
    [[nodiscard]] std::uint32_t Errors() const noexcept;

  private:
    std::uint32_t events_{0U};
    std::uint32_t errors_{0U};
};

enum class DeviceRole : std::uint8_t
{
    kInvalid = 0U,
    kConsumers = 1U,
    kProducers = 2U,
};

struct DevicePlan
{
    DeviceRole role;
    std::uint8_t srdo_count;
    /// Diagnostic and test interval.
    std::uint32_t interval_us;
};

/// A number as an object holds it.
struct ObjectNumber
{
    std::uint32_t value;
    std::uint8_t size_bytes;
};

enum class FrameSide : std::uint8_t
{
    kInvalid = 0U,
    kNormal = 1U,
    kInverse = 2U,
};

/// A device whose SRDOs carry 8 bytes each: two objects of 32 bits normal, two inverse. Drives its own time, 1 ms a
/// cycle.
class Device
{
  public:
    Device() noexcept;
    /// @brief Configures, signs, starts and goes OPERATIONAL. False if anything was refused.
    [[nodiscard]] bool Start(const DevicePlan& plan) noexcept;

    /// @brief One measured cycle.
    void MeasuredCycle() noexcept;
    void UnmeasuredCycle() noexcept;
    /// @brief Both frames of a pair with new data, measured; they arrive within the running cycle.
    void MeasuredPair(SlotIndex slot) noexcept;
    /// @brief The application sends one producer's pair; both frames are confirmed. Takes two cycles.
    void MeasuredSend(SlotIndex slot) noexcept;
    /// @brief Signature and resolved mapping of one SRDO in both channels.
    void MeasuredCheck(SlotIndex slot) noexcept;
    /// @brief All pairs once, unmeasured, so that every consumer is released.
    void ReleaseAll() noexcept;

    [[nodiscard]] std::uint32_t Events() const noexcept;
    /// @brief True while nothing went wrong: no device fault, no error, no wrong answer, all checks passed.
    [[nodiscard]] bool IsWell() const noexcept;
    /// @brief Consumers whose outputs the gate holds open.
    [[nodiscard]] SrdoMask Open() noexcept;

  private:
    void Describe(const DevicePlan& plan) noexcept;
    [[nodiscard]] bool ConfigureSlot(std::uint8_t slot, const DevicePlan& plan) noexcept;
    [[nodiscard]] bool Write(const ObjectAddress& address, const ObjectNumber& number) noexcept;
    void ConfirmNext() noexcept;
    [[nodiscard]] StampedFrame NextFrame(SlotIndex slot, FrameSide side) noexcept;
    [[nodiscard]] CycleCall NextCall() noexcept;

    static constexpr std::uint32_t kObjectsEach = 4U;
    static constexpr std::uint32_t kObjects = kObjectsEach * kMaxSrdoCount;

    std::uint8_t places_[kObjects][4]{};
    MappableObject objects_[kObjects]{};
    SrdoSetup setups_[kMaxSrdoCount]{};
    DeviceConfig config_{};
    BenchPorts ports_{};
    BenchOutput output_{};
    BenchWatchdog watchdog_{};
    BenchApplication application_{};
    channel_a::StorageFor<kMaxSrdoCount> storage_a_{};
    channel_b::StorageFor<kMaxSrdoCount> storage_b_{};
    channel_a::Channel channel_a_{storage_a_.Handle()};
    channel_b::Channel channel_b_{storage_b_.Handle()};
    Kernel kernel_;
    std::uint32_t now_us_{1000000U};
    std::uint32_t offset_us_{0U};
    std::uint32_t data_{0U};
    bool well_{true};
};

} // namespace counterpoint::bench

#endif
