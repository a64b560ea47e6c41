// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_PROGRAM_HPP
#define VERIFICATION_INJECTION_PROGRAM_HPP

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace counterpoint::injection
{

/// From `begin` up to but not including `end`.
struct Range
{
    std::uint32_t begin;
    std::uint32_t end;
};

/// The linked image and what is known of it: addresses of symbols, which code and which memory is faulted, and the
/// registers that each instruction reads. A text beside the image has it; run.py writes it.
class Program
{
  public:
    /// @brief Throws std::runtime_error where a file cannot be read or lacks a symbol.
    Program(const std::string& binary, const std::string& description);

    [[nodiscard]] const std::vector<std::uint8_t>& Code() const
    {
        return code_;
    }
    [[nodiscard]] std::uint32_t Symbol(const std::string& name) const;
    /// @brief Whether the instruction at this address belongs to what ships.
    [[nodiscard]] bool IsFaulted(std::uint32_t address) const
    {
        return (address < is_faulted_.size()) && is_faulted_[address];
    }
    /// @brief Bit n: the instruction at this address reads register n.
    [[nodiscard]] std::uint32_t Reads(std::uint32_t address) const;
    [[nodiscard]] const std::vector<Range>& Memory() const
    {
        return memory_;
    }
    /// @brief The first half word of the instruction; instructions are little-endian.
    [[nodiscard]] std::uint32_t HalfWord(const std::uint32_t address) const
    {
        return static_cast<std::uint32_t>(code_.at(address) | (code_.at(address + 1U) << 8U));
    }
    /// @brief 2 or 4.
    [[nodiscard]] std::uint32_t Length(const std::uint32_t address) const
    {
        return ((HalfWord(address) >> 11U) >= 0x1DU) ? 4U : 2U;
    }

  private:
    std::vector<std::uint8_t> code_{};
    std::vector<bool> is_faulted_{};
    std::map<std::string, std::uint32_t> symbols_{};
    std::map<std::uint32_t, std::uint32_t> reads_{};
    std::vector<Range> memory_{};
};

} // namespace counterpoint::injection

#endif
