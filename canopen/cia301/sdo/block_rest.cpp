// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/sdo/block_rest.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint8_t kLastSegment = 0x80U;
constexpr std::uint8_t kSequenceMask = 0x7FU;
constexpr std::uint8_t kFirstBegin = 0x20U; ///< No request with a smaller number begins a transfer.
constexpr std::uint32_t kFrameBytes = 8U;

} // namespace

void BlockRest::Await(const std::uint8_t block_size) noexcept
{
    block_size_ = block_size;
    number_ = 0U;
    is_doubled_ = false;
    is_timed_ = false;
}

bool BlockRest::Takes(const std::uint8_t head, const Instant now) noexcept
{
    const std::uint8_t number = head & kSequenceMask;
    const bool is_same = (number == number_) && !is_doubled_;
    const bool is_in_order = (number > number_) || (number < kFirstBegin) || is_same;
    const bool is_rest = (number > 0U) && (number <= block_size_) && is_in_order;
    const bool is_last = ((head & kLastSegment) != 0U) || (number == block_size_);
    block_size_ = (is_rest && !is_last) ? block_size_ : std::uint8_t{0U};
    is_doubled_ = (number == number_);
    number_ = number;
    is_timed_ = true;
    last_ = now;
    return is_rest;
}

void BlockRest::Poll(const Instant now, const std::uint32_t pause_us) noexcept
{
    last_ = is_timed_ ? last_ : now;
    is_timed_ = true;
    block_size_ = ((now.us - last_.us) >= pause_us) ? std::uint8_t{0U} : block_size_;
}

void DoubledSegment::Await(const std::uint8_t* const bytes) noexcept
{
    for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
    {
        bytes_[i] = bytes[i];
    }
    is_awaited_ = true;
}

bool DoubledSegment::Takes(const std::uint8_t* const bytes) noexcept
{
    bool is_same = is_awaited_;
    for (std::uint32_t i = 0U; i < kFrameBytes; ++i)
    {
        is_same = is_same && (bytes_[i] == bytes[i]);
    }
    is_awaited_ = false;
    return is_same;
}

} // namespace counterpoint::cia301
