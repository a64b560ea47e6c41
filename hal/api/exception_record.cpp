// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/api/exception_record.hpp"

namespace counterpoint::hal
{

namespace
{

constexpr std::uint32_t kPolynomial = 0xEDB88320U;
constexpr std::uint32_t kStart = 0xFFFFFFFFU;
constexpr std::uint32_t kMost = 0xFFFFFFFFU;
constexpr std::uint32_t kWordBits = 32U;

/// Bit by bit: it runs once an exception, and in an exception tables may be what is broken.
[[nodiscard]] std::uint32_t Continue(const std::uint32_t before, const std::uint32_t word) noexcept
{
    std::uint32_t crc = before ^ word;
    for (std::uint32_t bit = 0U; bit < kWordBits; ++bit)
    {
        crc = (crc >> 1U) ^ (kPolynomial & (0U - (crc & 1U)));
    }
    return crc;
}

/// ECBB4B55h for a record of zeroes, so that zero-filled storage does not fit.
[[nodiscard]] std::uint32_t SealOf(const ExceptionRecord& record) noexcept
{
    std::uint32_t crc = Continue(kStart, static_cast<std::uint32_t>(record.cause));
    crc = Continue(crc, record.address_low);
    crc = Continue(crc, record.address_high);
    return ~Continue(crc, record.count);
}

} // namespace

ExceptionMemory::ExceptionMemory(ExceptionStorage& storage) noexcept : storage_(storage)
{
}

void ExceptionMemory::Record(const ExceptionCause cause, const std::uint64_t address) noexcept
{
    const std::uint32_t before = Read().count;
    const std::uint32_t count = (before == kMost) ? before : (before + 1U);
    storage_.record = ExceptionRecord{cause, static_cast<std::uint32_t>(address & 0xFFFFFFFFU),
                                      static_cast<std::uint32_t>(address >> kWordBits), count};
    storage_.seal = SealOf(storage_.record);
}

ExceptionRecord ExceptionMemory::Read() const noexcept
{
    if (storage_.seal != SealOf(storage_.record))
    {
        return ExceptionRecord{ExceptionCause::kNone, 0U, 0U, 0U};
    }
    return storage_.record;
}

void ExceptionMemory::Clear() noexcept
{
    storage_.record = ExceptionRecord{ExceptionCause::kNone, 0U, 0U, 0U};
    storage_.seal = SealOf(storage_.record);
}

} // namespace counterpoint::hal
