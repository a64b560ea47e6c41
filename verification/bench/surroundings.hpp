// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_BENCH_SURROUNDINGS_HPP
#define VERIFICATION_BENCH_SURROUNDINGS_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/output_gate.hpp"
#include "hal/api/watchdog.hpp"
#include "safety_core/kernel/application.hpp"
#include "verification/bench/safety_setup.hpp"

#include <cstdint>

/// What a measured kernel has around it.
namespace counterpoint::bench
{

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

} // namespace counterpoint::bench

#endif
