// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_ZYNQMP_TWO_CPU_CORE_HPP
#define VERIFICATION_TARGET_ZYNQMP_TWO_CPU_CORE_HPP

#include "canopen/device/device.hpp"
#include "hal/api/cross_link.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/kernel/limits.hpp"
#include "verification/target/zynqmp/two_cpu/times.hpp"

#include <cstdint>

namespace counterpoint::two_cpu
{

/// NMT, to all nodes.
constexpr CanFrame kStartCommand{0U, FrameKind::kData, CanPortId::kFirst, 2U, {1U, 0U}};

/// @brief The one clock of this CPU: counter A beside channel A, counter B beside channel B. Peer compares moments of
/// the own channel with such of the other one's stand-in, so that both have to be of one counter; that the two counters
/// of the processor keep together is seen by its driver.
[[nodiscard]] InstantPair OwnClock(const InstantPair& counters) noexcept;

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

/// One processor of two: the one channel that its image has and a kernel, on the drivers of its board. SRDO 1 consumes
/// 101h/102h (automatic release), SRDO 2 produces 103h/104h. Composed as verification/two_cpu composes a CPU of the
/// host. [SRS_ZYN_013]
class Core final : private device::Owner
{
  public:
    Core() noexcept;

    /// @brief Start and configuration. False where the kernel refuses one of them.
    [[nodiscard]] bool PowerOn(Instant now) noexcept;
    /// @brief A frame of the bus, at its end.
    void OnBus(const StampedFrame& frame, bool is_own, Instant now) noexcept;
    /// @brief Frames were lost.
    void OnLoss() noexcept;
    /// @brief One cycle and the message for the other processor.
    void Cycle(const InstantPair& now, hal::LinkFrame& message) noexcept;
    /// @brief The greatest times that ComputeLimit gives for a lost link, a channel and a configuration.
    [[nodiscard]] std::uint32_t LimitOfLink() const noexcept;
    [[nodiscard]] std::uint32_t LimitOf(FaultClass fault) const noexcept;

    ProcessApplication application{};

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
