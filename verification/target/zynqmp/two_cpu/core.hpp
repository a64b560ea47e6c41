// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_CORE_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_CORE_HPP

#include "canopen/device/device.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/limits.hpp"

#include <cstdint>

namespace counterpoint::two_cpu
{

constexpr std::uint32_t kCycleUs = 25000U;
constexpr std::uint32_t kToleranceUs = 12500U; ///< By which a cycle may be late.
constexpr std::uint32_t kLinkTimeoutUs = 300000U;
constexpr std::uint32_t kDiscrepancyUs = 400000U;
constexpr std::uint32_t kRefreshUs = 125000U;
constexpr std::uint16_t kSctMs = 400U;
constexpr std::uint8_t kSrvtMs = 250U;
/// The two processors look at their bus in turns.
constexpr std::uint32_t kStampToleranceUs = 5000U;

/// NMT, to all nodes.
constexpr CanFrame kStartCommand{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}};

/// The output of this processor by the rule of the gate. A driver's pins follow it.
class Output final : public hal::SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override
    {
        return gate.Challenge();
    }
    void Drive(const hal::PermitSet& permits) noexcept override
    {
        gate.Drive(permits, now);
    }
    hal::OutputGate gate{};
    Instant now{0U};
};

class Guard final : public hal::Watchdog
{
  public:
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override
    {
        return timer.Question();
    }
    void Answer(const hal::WatchdogAnswer& answer) noexcept override
    {
        timer.Answer(answer, now);
    }
    hal::WatchdogTimer timer{};
    Instant now{0U};
};

/// Both objects of the own pair, always the same value; the same on both processors.
class ProcessApplication final : public Application
{
  public:
    [[nodiscard]] RefreshAnswer OnRefresh(CommunicationIndex index) noexcept override;
    void OnSrdoEvent(CommunicationIndex index) noexcept override;
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override;
    void OnConfigurationInvalid(CommunicationIndex index) noexcept override;
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override;

    std::uint8_t tx_normal[2]{};
    std::uint8_t tx_inverse[2]{};
    std::uint8_t rx_normal[2]{};
    std::uint8_t rx_inverse[2]{};
    std::uint32_t received{0U};
    std::uint32_t sent{0U};
};

/// One processor of two: the one channel that its image has, a kernel, an output. SRDO 1 consumes 101h/102h (automatic
/// release), SRDO 2 produces 103h/104h. Composed as verification/two_cpu composes a CPU of the host. [SRS_ZYN_013]
class Core final : private device::Owner
{
  public:
    Core() noexcept;

    /// @brief Start and configuration. False where the kernel refuses one of them.
    [[nodiscard]] bool PowerOn(Instant now) noexcept;
    /// @brief A frame of the bus, at its end.
    void OnBus(const CanFrame& frame, bool is_own, Instant now) noexcept;
    /// @brief One cycle and the message for the other processor.
    void Cycle(Instant now, hal::LinkFrame& message) noexcept;
    /// @brief Whether the consumer's output is open: gate and watchdog.
    [[nodiscard]] bool IsOpen(Instant now) noexcept;
    /// @brief The greatest times that ComputeLimit gives for a lost link, a channel and a configuration.
    [[nodiscard]] std::uint32_t LimitOfLink() const noexcept;
    [[nodiscard]] std::uint32_t LimitOf(FaultClass fault) const noexcept;

    ProcessApplication application{};
    Output output{};
    Guard watchdog{};

  private:
    [[nodiscard]] static LinkConfig OwnLink() noexcept;
    [[nodiscard]] device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override;
    void Describe() noexcept;
    void Write(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size) noexcept;
    void SetUp(std::uint8_t number, std::uint16_t first_object, std::uint8_t direction) noexcept;

    MappableObject objects_[4]{};
    SrdoSetup setups_[2]{};
    DeviceConfig config_{};
    bool is_configured_{true}; ///< The kernel took every value.

  public:
    Peer peer;
    Kernel kernel;

  private:
    device::QueuedFrame frames_[6]{};
    device::NoServices services_;
    device::Device device_;
};

} // namespace counterpoint::two_cpu

#endif
