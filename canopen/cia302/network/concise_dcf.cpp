// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia302/network/concise_dcf.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia302
{
namespace
{

using cia301::Bytes;
using cia301::FromLittleEndian;

constexpr std::uint32_t kCountBytes = 4U;
constexpr std::uint32_t kHeadBytes = 7U;

std::uint32_t CountOf(const Bytes& dcf) noexcept
{
    return static_cast<std::uint32_t>(FromLittleEndian(dcf.data, kCountBytes));
}

} // namespace

ConciseReading ReadConcise(const Bytes& dcf, const ConcisePosition& at) noexcept
{
    ConciseReading reading{ConciseState::kMalformed, ObjectAddress{0U, 0U}, Bytes{nullptr, 0U}, at};
    const bool is_empty = (dcf.data == nullptr) || (dcf.size_bytes == 0U);
    if (is_empty || ((dcf.size_bytes >= kCountBytes) && (at.entry >= CountOf(dcf))))
    {
        reading.state = ConciseState::kEnd;
    }
    else if ((dcf.size_bytes >= kCountBytes) && (at.offset <= (dcf.size_bytes - kCountBytes)))
    {
        const std::uint32_t left = dcf.size_bytes - kCountBytes - at.offset;
        const std::uint8_t* const head = &dcf.data[kCountBytes + at.offset];
        const auto size =
            (left >= kHeadBytes) ? static_cast<std::uint32_t>(FromLittleEndian(&head[3], 4U)) : std::uint32_t{0U};
        if ((left >= kHeadBytes) && (size <= (left - kHeadBytes)))
        {
            reading.state = ConciseState::kEntry;
            reading.object = ObjectAddress{static_cast<std::uint16_t>(FromLittleEndian(&head[0], 2U)), head[2]};
            reading.value = Bytes{&head[kHeadBytes], size};
            reading.next = ConcisePosition{at.entry + 1U, at.offset + kHeadBytes + size};
        }
    }
    else
    {
        // Shorter than its count.
    }
    return reading;
}

bool IsConcise(const Bytes& dcf) noexcept
{
    ConcisePosition at{0U, 0U};
    ConciseReading reading = ReadConcise(dcf, at);
    while (reading.state == ConciseState::kEntry)
    {
        at = reading.next;
        reading = ReadConcise(dcf, at);
    }
    const bool is_empty = (dcf.data == nullptr) || (dcf.size_bytes == 0U);
    return (reading.state == ConciseState::kEnd) && (is_empty || (at.offset == (dcf.size_bytes - kCountBytes)));
}

} // namespace counterpoint::cia302
