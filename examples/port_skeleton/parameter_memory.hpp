// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_SKELETON_PARAMETER_MEMORY_HPP
#define EXAMPLES_PORT_SKELETON_PARAMETER_MEMORY_HPP

#include "hal/api/parameter_memory.hpp"
#include "parts.hpp"

namespace port_skeleton
{

/// Flash, EEPROM or FRAM with two banks that are erased apart from each other.
class ParameterMemory final : public counterpoint::hal::ParameterMemory
{
  public:
    /// @brief CONTRACT. Bytes of one bank, a multiple of 8.
    [[nodiscard]] std::uint32_t BankBytes() const noexcept override;
    /// @brief CONTRACT. Goes on with what is running as far as that needs no waiting. kReady only after what was
    /// programmed was read back equal.
    [[nodiscard]] counterpoint::hal::MemoryStatus Status() noexcept override;
    /// @brief CONTRACT. Starts it and returns. A power failure leaves any value in this bank, and the other one
    /// untouched.
    void Erase(counterpoint::hal::MemoryBank bank) noexcept override;
    /// @brief CONTRACT. Starts it and returns; a power failure leaves any value in this section alone.
    void Program(const counterpoint::hal::MemorySection& section, const std::uint8_t* from) noexcept override;
    /// @brief CONTRACT. False where the hardware reports an error of what it reads.
    [[nodiscard]] bool Read(const counterpoint::hal::MemorySection& section, std::uint8_t* to) noexcept override;

    /// @brief kThere with the body, and not before; kAbsent where the device does without.
    [[nodiscard]] PartState State() const noexcept;
};

} // namespace port_skeleton

#endif
