// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_CONTRACT_TEST_CHECK_HPP
#define HAL_CONTRACT_TEST_CHECK_HPP

#include "hal/contract_test/contract_test.hpp"

#include <cstdint>

namespace counterpoint::hal::contract
{

/// Both ends included.
struct Span
{
    std::uint32_t least;
    std::uint32_t most;
};

/// One line of the report. The first thing that is not as expected decides; what comes after it is not written.
class Check
{
  public:
    /// @brief Writes the beginning of the line, before anything of the port is called.
    Check(const PortBench& bench, const char* part, const char* name) noexcept;

    /// @brief `what` must be this number.
    void Equal(const char* what, std::uint32_t expected, std::uint32_t got) noexcept;
    /// @brief `what` must be this number, written in hexadecimal digits.
    void EqualCode(const char* what, std::uint32_t expected, std::uint32_t got) noexcept;
    /// @brief `what` must lie in the span.
    void Within(const char* what, const Span& expected, std::uint32_t got) noexcept;
    /// @brief The bench lacks what this check needs.
    void NotShown(const char* why) noexcept;
    /// @brief Whether everything was as expected so far.
    [[nodiscard]] bool IsHeld() const noexcept
    {
        return verdict_ == Verdict::kHeld;
    }
    /// @brief Ends the line and counts it.
    void End(ContractCount& count) const noexcept;

  private:
    enum class Verdict : std::uint8_t
    {
        kInvalid = 0U,
        kHeld = 0x69U,
        kBroken = 1U,
        kNotShown = 2U,
    };

    void BeginBroken(const char* what) noexcept;
    void Write(const char* text) const noexcept;

    const PortBench& bench_;
    Verdict verdict_{Verdict::kHeld};
};

/// @brief Decimal digits, or eight hexadecimal ones behind 0x.
void WriteNumber(const PortBench& bench, std::uint32_t value) noexcept;
void WriteCode(const PortBench& bench, std::uint32_t value) noexcept;

} // namespace counterpoint::hal::contract

#endif
