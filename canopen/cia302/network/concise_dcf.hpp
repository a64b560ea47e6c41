// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_CONCISE_DCF_HPP
#define CANOPEN_CIA302_NETWORK_CONCISE_DCF_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What reading an entry came to.
enum class ConciseState : std::uint8_t
{
    kMalformed = 0U, ///< Ends inside an entry.
    kEntry = 1U,
    kEnd = 2U, ///< All entries were read.
};

/// Where the next entry begins. Zero-filled: the first one.
struct ConcisePosition
{
    std::uint32_t entry;  ///< Entries before it.
    std::uint32_t offset; ///< Bytes behind the count.
};

/// One entry of a concise DCF, and where the next one begins.
struct ConciseReading
{
    ConciseState state;
    ObjectAddress object; ///< Only with kEntry, as all below.
    cia301::Bytes value;  ///< Inside the DCF.
    ConcisePosition next;
};

/// @brief One entry of a concise DCF (1F22h): U32 count; each U16 index, U8 sub-index, U32 size, data. Null: no
/// entries. `at` is zero-filled, or `next` of the entry before. O(1)
[[nodiscard]] ConciseReading ReadConcise(const cia301::Bytes& dcf, const ConcisePosition& at) noexcept;
/// @brief Whether all entries can be read and nothing stands behind them. O(entries)
[[nodiscard]] bool IsConcise(const cia301::Bytes& dcf) noexcept;

} // namespace counterpoint::cia302

#endif
