// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_FIRMWARE_SIMULATED_BOARD_HPP
#define VERIFICATION_TARGET_FIRMWARE_SIMULATED_BOARD_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog_timer.hpp"

namespace counterpoint::target
{

/// A CAN port whose bus is a scenario: keeps what is sent until the scenario's time has come to confirm it.
class SimulatedCan final : public hal::CanPorts
{
  public:
    [[nodiscard]] hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief The oldest frame that is not confirmed yet; kind kInvalid if there is none.
    [[nodiscard]] CanFrame Waiting() const noexcept;
    /// @brief The oldest frame was on the bus.
    void Confirm() noexcept;
    void SetBusOff(bool is_off) noexcept;
    /// @brief Frames taken since the start, and the last of them.
    [[nodiscard]] std::uint32_t Sent() const noexcept;
    [[nodiscard]] const CanFrame& Last() const noexcept;

  private:
    [[nodiscard]] hal::TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;

    static constexpr std::uint32_t kPlaces = 8U;
    CanFrame frames_[kPlaces]{};
    CanFrame last_{};
    std::uint32_t written_{0U};
    std::uint32_t read_{0U};
    bool is_bus_off_{false};
};

/// The real gate on the scenario's time.
class SimulatedOutput final : public hal::SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const hal::PermitSet& permits) noexcept override;
    void SetTime(Instant now) noexcept;
    [[nodiscard]] SrdoMask Open() noexcept;

  private:
    hal::OutputGate gate_{};
    Instant now_{0U};
};

/// The real rule of the watchdog on the scenario's time.
class SimulatedWatchdog final : public hal::Watchdog
{
  public:
    void Start(Instant now) noexcept;
    void SetTime(Instant now) noexcept;
    [[nodiscard]] hal::WatchdogQuestion Question() noexcept override;
    void Answer(const hal::WatchdogAnswer& answer) noexcept override;
    [[nodiscard]] bool IsAlive() const noexcept;

  private:
    hal::WatchdogTimer timer_{};
    Instant now_{0U};
};

} // namespace counterpoint::target

#endif
