// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_CUT_MEMORY_HPP
#define TESTS_CANOPEN_CIA301_CUT_MEMORY_HPP

#include "hal/api/parameter_memory.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::cia301
{

/// Persistent memory whose power fails after so many changed bytes; the byte that is being changed then gets a value of
/// the test's choice. Checks what its users promise: alignment, erased cells, no use while busy.
class CutMemory final : public hal::ParameterMemory
{
  public:
    explicit CutMemory(std::uint32_t bank_bytes) : bank_bytes_(bank_bytes)
    {
        banks.fill(std::vector<std::uint8_t>(bank_bytes, std::uint8_t{0x00U}));
    }
    void PowerOn()
    {
        bytes_left = kEndless;
        is_off = false;
        busy_calls = 0;
        is_failed = false;
    }
    [[nodiscard]] std::uint32_t BankBytes() const noexcept override
    {
        return bank_bytes_;
    }
    [[nodiscard]] hal::MemoryStatus Status() noexcept override
    {
        hal::MemoryStatus status = is_failed ? hal::MemoryStatus::kFailed : hal::MemoryStatus::kReady;
        if (is_off || (busy_calls > 0))
        {
            busy_calls -= (busy_calls > 0) ? 1 : 0;
            status = hal::MemoryStatus::kBusy;
        }
        return status;
    }
    void Erase(hal::MemoryBank bank) noexcept override
    {
        Start();
        for (std::uint8_t& cell : Cells(bank))
        {
            Change(cell, 0xFFU);
        }
    }
    void Program(const hal::MemorySection& section, const std::uint8_t* from) noexcept override
    {
        Start();
        is_misused = is_misused || (((section.offset | section.count) % hal::kProgramUnitBytes) != 0U);
        is_misused = is_misused || ((section.offset + section.count) > bank_bytes_);
        for (std::uint32_t i = 0U; !is_misused && (i < section.count); ++i)
        {
            std::uint8_t& cell = Cells(section.bank)[section.offset + i];
            is_misused = is_misused || (!is_off && (cell != 0xFFU));
            Change(cell, from[i]);
        }
    }
    [[nodiscard]] bool Read(const hal::MemorySection& section, std::uint8_t* to) noexcept override
    {
        const bool is_inside = (section.offset + section.count) <= bank_bytes_;
        is_misused = is_misused || !is_inside || (busy_calls > 0);
        for (std::uint32_t i = 0U; is_inside && (i < section.count); ++i)
        {
            to[i] = Cells(section.bank)[section.offset + i];
        }
        return is_inside && !is_off;
    }

    static constexpr std::int64_t kEndless = 1000000;
    std::int64_t bytes_left{kEndless}; ///< Until power fails.
    std::uint8_t torn{0U};             ///< Value of the byte that was being changed.
    bool is_off{false};
    bool is_misused{false};
    bool is_failed{false}; ///< What the next operations end with.
    int busy_for{2};       ///< Times that an operation is still busy.
    int busy_calls{0};
    std::array<std::vector<std::uint8_t>, 2> banks{};

  private:
    std::vector<std::uint8_t>& Cells(hal::MemoryBank bank) noexcept
    {
        return banks[(bank == hal::MemoryBank::kFirst) ? 0U : 1U];
    }
    void Start() noexcept
    {
        is_misused = is_misused || (busy_calls > 0);
        busy_calls = busy_for;
    }
    void Change(std::uint8_t& cell, std::uint8_t value) noexcept
    {
        if (!is_off)
        {
            is_off = (bytes_left == 0);
            cell = is_off ? torn : value;
            --bytes_left;
        }
    }

    std::uint32_t bank_bytes_;
};

} // namespace counterpoint::cia301

#endif
