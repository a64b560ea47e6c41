// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_SELFTEST_MEMORY_SIGNATURE_HPP
#define SAFETY_CORE_SELFTEST_MEMORY_SIGNATURE_HPP

#include "safety_core/selftest/slice.hpp"

#include <cstdint>

namespace counterpoint::selftest
{

/// Where the expected signature comes from. [SRS_STS_002]
enum class SignatureSource : std::uint8_t
{
    kInvalid = 0U,
    kGiven = 0x69U, ///< From the setup: known when the image was made.
    kTaken = 0x96U, ///< The first complete pass after Restart takes it.
};

/// Which memory is signed, how many words a slice has (1 or more), and where the expected signature comes from.
struct SignatureSetup
{
    SpanList memory;
    std::uint16_t slice_words;
    SignatureSource source;
    std::uint32_t expected; ///< Only with kGiven.
};

/// CRC-32 over read-only memory, some words a call. Zero-filled, it fails. [SRS_STS_001, SRS_STS_002, SRS_STS_003]
class MemorySignature
{
  public:
    /// @brief Begins the first pass. The arrays of `setup` are kept by reference.
    void Restart(const SignatureSetup& setup) noexcept;
    /// @brief How many slices one pass takes; 0: the setup cannot be used. O(spans)
    [[nodiscard]] std::uint32_t SlicesAPass() const noexcept;
    /// @brief The next slice. Only with a setup that can be used. O(slice_words)
    [[nodiscard]] SliceResult Slice(const hal::MemoryAccess& memory) noexcept;
    /// @brief Slices done since Restart, modular.
    [[nodiscard]] std::uint32_t Done() const noexcept
    {
        return done_;
    }
    /// @brief Signature of the last complete pass.
    [[nodiscard]] std::uint32_t Value() const noexcept
    {
        return value_;
    }

  private:
    /// @brief Compares the CRC of the pass with what is expected, takes it as that in the first pass of kTaken, and
    /// begins anew.
    [[nodiscard]] SliceResult EndPass() noexcept;

    SignatureSetup setup_{{nullptr, 0U}, 0U, SignatureSource::kInvalid, 0U};
    std::uint32_t crc_{0U};
    std::uint32_t value_{0U};
    std::uint32_t word_{0U};
    std::uint32_t done_{0U};
    std::uint8_t span_{0U};
};

} // namespace counterpoint::selftest

#endif
