// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Raw profile of LLVM 19 (version 10): a header of 16 words of 64 bits, records of functions, counters, bits of MC/DC,
// names; each as it stands in memory, in the order of this processor. The sections have their names from the compiler.
#include "verification/target/coverage/profile.hpp"

#include "verification/target/target.hpp"

#include <cstdint>

extern "C"
{
    extern const char profile_data_start[] __asm__("__start___llvm_prf_data");
    extern const char profile_data_stop[] __asm__("__stop___llvm_prf_data");
    extern const char profile_counters_start[] __asm__("__start___llvm_prf_cnts");
    extern const char profile_counters_stop[] __asm__("__stop___llvm_prf_cnts");
    extern const char profile_bits_start[] __asm__("__start___llvm_prf_bits");
    extern const char profile_bits_stop[] __asm__("__stop___llvm_prf_bits");
    extern const char profile_names_start[] __asm__("__start___llvm_prf_names");
    extern const char profile_names_stop[] __asm__("__stop___llvm_prf_names");

    /// Every instrumented object asks for it, so that a library comes in. Here is none.
    extern const std::uint32_t profile_runtime __asm__("__llvm_profile_runtime");
    const std::uint32_t profile_runtime = 0U;
}

namespace counterpoint::target
{
namespace
{

constexpr std::uint64_t kMagic = 0xFF6C70726F665281U; // "lprofR": pointers of 32 bits.
constexpr std::uint64_t kVersion = 10U;
constexpr std::uint64_t kValueKindLast = 2U;
constexpr std::uint32_t kRecordBytes = 48U;
constexpr std::uint32_t kCounterBytes = 8U;
constexpr std::uint32_t kAlignment = 8U;

std::uint32_t AddressOf(const char* const place) noexcept
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(place));
}

std::uint32_t Padding(const std::uint32_t bytes) noexcept
{
    return (kAlignment - (bytes % kAlignment)) % kAlignment;
}

} // namespace

bool WriteProfile(const char* const path) noexcept
{
    const std::uint32_t data = AddressOf(profile_data_start);
    const std::uint32_t counters = AddressOf(profile_counters_start);
    const std::uint32_t bits = AddressOf(profile_bits_start);
    const std::uint32_t names = AddressOf(profile_names_start);
    const std::uint32_t data_bytes = AddressOf(profile_data_stop) - data;
    const std::uint32_t counter_bytes = AddressOf(profile_counters_stop) - counters;
    const std::uint32_t bit_bytes = AddressOf(profile_bits_stop) - bits;
    const std::uint32_t name_bytes = AddressOf(profile_names_stop) - names;
    const std::uint64_t header[]{kMagic,
                                 kVersion,
                                 0U, // No identity of the program.
                                 data_bytes / kRecordBytes,
                                 0U,
                                 counter_bytes / kCounterBytes,
                                 0U,
                                 bit_bytes,
                                 Padding(bit_bytes),
                                 name_bytes,
                                 counters - data,
                                 bits - data,
                                 names,
                                 0U, // No virtual tables.
                                 0U,
                                 kValueKindLast};
    constexpr char kZeroes[kAlignment]{};
    const Bytes parts[]{
        {header, sizeof header},         {profile_data_start, data_bytes}, {profile_counters_start, counter_bytes},
        {profile_bits_start, bit_bytes}, {kZeroes, Padding(bit_bytes)},    {profile_names_start, name_bytes},
        {kZeroes, Padding(name_bytes)}};
    return ((data_bytes % kRecordBytes) == 0U) && WriteFile(path, parts, sizeof(parts) / sizeof(parts[0]));
}

} // namespace counterpoint::target
