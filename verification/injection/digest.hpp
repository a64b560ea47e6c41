// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_DIGEST_HPP
#define VERIFICATION_INJECTION_DIGEST_HPP

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace counterpoint::injection
{

/// 128 bits of a state: where two differ, so do the states, and two states that differ do not meet in one.
class Digest
{
  public:
    void Add(const std::uint64_t value)
    {
        first_ = Mix(first_ ^ value, 0x9E3779B97F4A7C15U);
        second_ = Mix(second_ + value, 0xD6E8FEB86659FD93U);
    }
    void Add(const std::uint8_t* const bytes, const std::size_t count)
    {
        std::size_t at = 0U;
        for (; (at + 8U) <= count; at += 8U)
        {
            std::uint64_t word = 0U;
            std::memcpy(&word, bytes + at, 8U);
            Add(word);
        }
        std::uint64_t rest = 0U;
        std::memcpy(&rest, bytes + at, count - at);
        Add(rest);
        Add(std::uint64_t{count});
    }
    bool operator==(const Digest& other) const
    {
        return (first_ == other.first_) && (second_ == other.second_);
    }
    /// @brief For a table.
    struct Hash
    {
        std::size_t operator()(const Digest& digest) const
        {
            return static_cast<std::size_t>(digest.first_);
        }
    };

  private:
    static std::uint64_t Mix(std::uint64_t value, const std::uint64_t factor)
    {
        value *= factor;
        return value ^ (value >> 29U);
    }

    std::uint64_t first_{0x243F6A8885A308D3U};
    std::uint64_t second_{0x13198A2E03707344U};
};

} // namespace counterpoint::injection

#endif
