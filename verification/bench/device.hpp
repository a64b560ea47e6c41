// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_DEVICE_HPP
#define VERIFICATION_BENCH_DEVICE_HPP

#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "verification/bench/safety_setup.hpp"
#include "verification/bench/surroundings.hpp"

#include <cstdint>

namespace counterpoint::bench
{

enum class FrameSide : std::uint8_t
{
    kInvalid = 0U,
    kNormal = 1U,
    kInverse = 2U,
};

/// The kernel with the SRDOs of SafetySetup. Drives its own time, 1 ms a cycle. Without canopen/device on purpose: what
/// is measured is the kernel and the channels alone; ServiceNode is the whole device.
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
    void ConfirmNext() noexcept;
    [[nodiscard]] StampedFrame NextFrame(SlotIndex slot, FrameSide side) noexcept;
    [[nodiscard]] CycleCall NextCall() noexcept;

    SafetySetup setup_{};
    BenchPorts ports_{};
    BenchOutput output_{};
    BenchWatchdog watchdog_{};
    BenchApplication application_{};
    channel_a::StorageFor<kMaxSrdoCount> storage_a_{};
    channel_b::StorageFor<kMaxSrdoCount> storage_b_{};
    channel_a::Channel channel_a_{storage_a_.Handle()};
    channel_b::Channel channel_b_{storage_b_.Handle()};
    CauseWindows windows_[kMaxSrdoCount]{};
    Kernel kernel_;
    std::uint32_t now_us_{1000000U};
    std::uint32_t offset_us_{0U};
    std::uint32_t data_{0U};
    bool well_{true};
};

} // namespace counterpoint::bench

#endif
