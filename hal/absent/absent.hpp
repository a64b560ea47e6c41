// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_ABSENT_ABSENT_HPP
#define HAL_ABSENT_ABSENT_HPP

#include "hal/api/can_ports.hpp"
#include "hal/api/memory_protection.hpp"
#include "hal/api/parameter_memory.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/api/watchdog.hpp"

#include <cstdint>

namespace counterpoint::hal
{

/// What a platform links in the place of hardware that it does not have: each service refuses. [SRS_HAL_006]
///
/// There are no absent clocks: no reading says "no time", and a platform without two counters has nobody who could call
/// the kernel.

/// No controller: refuses every frame with kRefused and guarantees nothing, so that Kernel::Start refuses too.
class AbsentCanPorts final : public CanPorts
{
  public:
    [[nodiscard]] CanGuarantees Guarantees() const noexcept override;

  private:
    [[nodiscard]] TransmitStatus DoTransmit(const CanFrame& frame) noexcept override;
};

/// No output: takes permits and never opens anything. Its challenge obeys the contract (never 0, never the one before).
class AbsentSafetyOutput final : public SafetyOutput
{
  public:
    [[nodiscard]] std::uint32_t Challenge() noexcept override;
    void Drive(const PermitSet& permits) noexcept override;
    /// @brief Always none.
    [[nodiscard]] SrdoMask Open() const noexcept;

  private:
    std::uint32_t challenge_{0U};
};

/// No watchdog: its questions mean nothing, answers are not looked at, and it is always tripped.
class AbsentWatchdog final : public Watchdog
{
  public:
    [[nodiscard]] WatchdogQuestion Question() noexcept override;
    void Answer(const WatchdogAnswer& answer) noexcept override;
    /// @brief Always false.
    [[nodiscard]] bool IsAlive() const noexcept;
};

/// No MPU: answers kAbsent for every region, so that nobody takes unprotected memory for protected.
class AbsentMemoryProtection final : public MemoryProtection
{
  public:
    [[nodiscard]] ProtectStatus Protect(const MemoryRegion& region) noexcept override;
    void Enter(MemoryOwner owner) noexcept override;
};

/// No parameter memory: no bytes, every operation has failed, nothing can be read. 1010h answers with an error, and
/// nothing is ever loaded. [SRS_HAL_016]
class AbsentParameterMemory final : public ParameterMemory
{
  public:
    [[nodiscard]] std::uint32_t BankBytes() const noexcept override;
    [[nodiscard]] MemoryStatus Status() noexcept override;
    void Erase(MemoryBank bank) noexcept override;
    void Program(const MemorySection& section, const std::uint8_t* from) noexcept override;
    [[nodiscard]] bool Read(const MemorySection& section, std::uint8_t* to) noexcept override;
};

} // namespace counterpoint::hal

#endif
