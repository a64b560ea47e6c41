// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/contract_test/checks.hpp"

namespace counterpoint::hal::contract
{

namespace
{

constexpr std::uint32_t kBytes = 2U * kProgramUnitBytes;
constexpr std::uint32_t kMostCycles = 20000U;
constexpr const char* kNoMemory = "the port has no parameter memory";
constexpr std::uint32_t kReady = static_cast<std::uint32_t>(MemoryStatus::kReady);
constexpr const char* kStatus = "status (0x69 ready)";

/// @brief The status when the operation has ended, or kBusy if it has not in 20000 cycles.
[[nodiscard]] std::uint32_t End(const PortUnderTest& port) noexcept
{
    MemoryStatus status = port.parts.parameters->Status();
    for (std::uint32_t cycle = 0U; (cycle < kMostCycles) && (status == MemoryStatus::kBusy); ++cycle)
    {
        PassCycles(port, 1U);
        status = port.parts.parameters->Status();
    }
    return static_cast<std::uint32_t>(status);
}

/// Both banks are erased, then each has bytes of its own. `patterns`: what the bytes of a bank begin with.
void Fill(const PortUnderTest& port, Check& check, const MemoryBank bank, std::uint8_t (&bytes)[kBytes]) noexcept
{
    port.parts.parameters->Erase(bank);
    check.EqualCode(kStatus, kReady, End(port));
    for (std::uint32_t byte = 0U; byte < kBytes; ++byte)
    {
        bytes[byte] = static_cast<std::uint8_t>((16U * static_cast<std::uint32_t>(bank)) + byte);
    }
    port.parts.parameters->Program(MemorySection{bank, kProgramUnitBytes, kBytes}, bytes);
    check.EqualCode(kStatus, kReady, End(port));
}

void ExpectBytes(const PortUnderTest& port, Check& check, const MemorySection& section, const std::uint32_t first,
                 const std::uint32_t step) noexcept
{
    std::uint8_t bytes[kBytes]{}; // MISRA D-001
    const bool is_read = port.parts.parameters->Read(section, bytes);
    check.Equal("read", 1U, is_read ? 1U : 0U);
    for (std::uint32_t byte = 0U; byte < section.count; ++byte)
    {
        check.EqualCode("byte", first + (step * byte), bytes[byte]);
    }
}

[[nodiscard]] bool Begin(const PortUnderTest& port, Check& check) noexcept
{
    const bool has_memory = (port.parts.parameters != nullptr) && (port.parts.parameters->BankBytes() != 0U);
    if (!has_memory)
    {
        check.NotShown(kNoMemory);
        return false;
    }
    check.Within("bytes of a bank", Span{4U * kProgramUnitBytes, 0xFFFFFFF8U}, port.parts.parameters->BankBytes());
    check.Equal("bytes of a bank beyond whole units", 0U, port.parts.parameters->BankBytes() % kProgramUnitBytes);
    return check.IsHeld();
}

} // namespace

void ImpossibleRegionIsRefused(const PortUnderTest& port, Check& check) noexcept
{
    if (port.parts.protection == nullptr)
    {
        check.NotShown("the port has no memory protection");
        return;
    }
    // No MPU protects 3 bytes from an odd address on.
    const std::uint8_t* const odd = reinterpret_cast<const std::uint8_t*>(&check) + 1U;
    const ProtectStatus status = port.parts.protection->Protect(MemoryRegion{odd, 3U, MemoryOwner::kKernel});
    const bool is_refused = (status == ProtectStatus::kRefused) || (status == ProtectStatus::kAbsent);
    check.Equal("3 bytes at an odd address refused", 1U, is_refused ? 1U : 0U);
}

void ProgrammedBytesAreRead(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    Settle(port);
    std::uint8_t bytes[kBytes]{}; // MISRA D-001
    Fill(port, check, MemoryBank::kFirst, bytes);
    Fill(port, check, MemoryBank::kSecond, bytes);
    ExpectBytes(port, check, MemorySection{MemoryBank::kFirst, kProgramUnitBytes, kBytes}, 0x10U, 1U);
    ExpectBytes(port, check, MemorySection{MemoryBank::kSecond, kProgramUnitBytes, kBytes}, 0x20U, 1U);
    ExpectBytes(port, check, MemorySection{MemoryBank::kSecond, 0U, kProgramUnitBytes}, 0xFFU, 0U);
}

void EraseTouchesOneBank(const PortUnderTest& port, Check& check) noexcept
{
    if (!Begin(port, check))
    {
        return;
    }
    Settle(port);
    std::uint8_t bytes[kBytes]{}; // MISRA D-001
    Fill(port, check, MemoryBank::kFirst, bytes);
    Fill(port, check, MemoryBank::kSecond, bytes);
    port.parts.parameters->Erase(MemoryBank::kFirst);
    check.EqualCode(kStatus, kReady, End(port));
    ExpectBytes(port, check, MemorySection{MemoryBank::kFirst, kProgramUnitBytes, kBytes}, 0xFFU, 0U);
    ExpectBytes(port, check, MemorySection{MemoryBank::kSecond, kProgramUnitBytes, kBytes}, 0x20U, 1U);
}

} // namespace counterpoint::hal::contract
