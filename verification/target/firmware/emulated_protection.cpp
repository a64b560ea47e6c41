// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/firmware/emulated_protection.hpp"

extern "C"
{
    // hal/tms570/start/tms570.ld
    extern const std::uint8_t region_non_safety[];
    extern const std::uint8_t region_non_safety_length[];
    extern const std::uint8_t memory_zero_start[];
}

namespace counterpoint::target
{
namespace
{
/// A register of the processor. Compilers disagree on the type behind std::uint32_t.
using Word = std::uint32_t;

// Access permissions (bits 10:8 of the access control register); XN forbids execution.
constexpr Word kPrivilegedOnly = 0x1U << 8U;
constexpr Word kUserReads = 0x2U << 8U;
constexpr Word kAllWrite = 0x3U << 8U;
constexpr Word kAllRead = 0x6U << 8U;
constexpr Word kNoExecute = 1U << 12U;
constexpr Word kNormalMemory = 0x8U; // TEX 001, C 0, B 0: not cached.

// Regions of a higher number win.
constexpr Word kEverything = 0U;
constexpr Word kFlash = 1U;
constexpr Word kRam = 2U;
constexpr Word kNonSafety = 3U;
constexpr Word kFirstParty = 4U;
constexpr Word kParties = 3U;

constexpr Word kFlashBits = 22U;
constexpr Word kRamBits = 19U;
constexpr Word kAllBits = 32U;
constexpr Word kLeastBits = 5U;

struct Region
{
    Word number;
    Word base;
    Word size_bits; ///< 2^n bytes.
    Word access;
};

Word AddressOf(const void* const place) noexcept
{
    return static_cast<Word>(reinterpret_cast<std::uintptr_t>(place));
}

void SetAccess(const Word number, const Word access) noexcept
{
    asm volatile("mcr p15, 0, %0, c6, c2, 0\n\tmcr p15, 0, %1, c6, c1, 4" : : "r"(number), "r"(access) : "memory");
}

void SetRegion(const Region& region) noexcept
{
    const Word size = ((region.size_bits - 1U) << 1U) | 1U;
    SetAccess(region.number, region.access);
    asm volatile("mcr p15, 0, %0, c6, c1, 0\n\tmcr p15, 0, %1, c6, c1, 2" : : "r"(region.base), "r"(size) : "memory");
}

/// 32 for what is no power of two.
Word BitsOf(const Word length) noexcept
{
    Word bits = kLeastBits;
    while ((bits < kAllBits) && ((Word{1U} << bits) != length))
    {
        ++bits;
    }
    return bits;
}

} // namespace

void EmulatedProtection::Start() noexcept
{
    SetRegion({kEverything, 0U, kAllBits, kPrivilegedOnly | kNoExecute});
    SetRegion({kFlash, 0U, kFlashBits, kAllRead | kNormalMemory});
    SetRegion({kRam, AddressOf(memory_zero_start), kRamBits, kUserReads | kNormalMemory | kNoExecute});
    SetRegion({kNonSafety, AddressOf(region_non_safety), BitsOf(AddressOf(region_non_safety_length)),
               kAllWrite | kNormalMemory | kNoExecute});
    Word control = 0U;
    asm volatile("mrc p15, 0, %0, c1, c0, 0" : "=r"(control));
    asm volatile("dsb\n\tmcr p15, 0, %0, c1, c0, 0\n\tisb" : : "r"(control | 1U) : "memory");
}

hal::ProtectStatus EmulatedProtection::Protect(const hal::MemoryRegion& region) noexcept
{
    const Word base = AddressOf(region.start);
    const Word bits = BitsOf(region.size_bytes);
    const Word party = static_cast<Word>(region.owner) - 1U;
    if ((bits == kAllBits) || ((base & (region.size_bytes - 1U)) != 0U) || (party >= kParties))
    {
        return hal::ProtectStatus::kRefused;
    }
    SetRegion({kFirstParty + party, base, bits, kAllRead | kNormalMemory | kNoExecute});
    return hal::ProtectStatus::kProtected;
}

void EmulatedProtection::Enter(const hal::MemoryOwner owner) noexcept
{
    for (Word party = 0U; party < kParties; ++party)
    {
        const bool is_owner = static_cast<Word>(owner) == (party + 1U);
        SetAccess(kFirstParty + party, (is_owner ? kUserReads : kAllRead) | kNormalMemory | kNoExecute);
    }
    asm volatile("isb" : : : "memory");
}

} // namespace counterpoint::target
