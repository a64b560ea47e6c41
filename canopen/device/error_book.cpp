// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/error_book.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint8_t kCommunicationBit = 0x10U;
constexpr std::uint8_t kManufacturerBit = 0x80U;

struct Code
{
    std::uint16_t code;
    std::uint8_t register_bits;
};

/// By Concern.
constexpr Code kCodes[kConcerns] = {
    {0x5000U, kManufacturerBit},  {0x6100U, kManufacturerBit},  {0x6200U, kManufacturerBit},
    {0x6300U, kManufacturerBit},  {0x7500U, kCommunicationBit}, {0x8100U, kCommunicationBit},
    {0x8110U, kCommunicationBit}, {0x8120U, kCommunicationBit}, {0x8130U, kCommunicationBit},
    {0x8140U, kCommunicationBit}, {0x8210U, kCommunicationBit}, {0x8250U, kCommunicationBit},
};

} // namespace

ErrorBook::ErrorBook(cia301::EmergencyProducer& emergency) noexcept : emergency_(emergency), sources_{}
{
}

void ErrorBook::Set(const Concern concern, const ErrorEvent& event) noexcept
{
    const auto which = static_cast<std::uint32_t>(concern);
    const std::uint32_t number = event.source.number;
    if ((which < kConcerns) && (number < (kWords * kWordBits)))
    {
        sources_[which][number / kWordBits] |= std::uint32_t{1U} << (number % kWordBits);
        const Code& code = kCodes[which];
        emergency_.Raise({code.code, code.register_bits, {event.source.number, event.detail, 0U, 0U, 0U}});
    }
}

void ErrorBook::End(const Concern concern, const ErrorSource source) noexcept
{
    const bool was_set = IsSet(concern);
    const std::uint32_t number = source.number;
    if (was_set && (number < (kWords * kWordBits)))
    {
        const auto which = static_cast<std::uint32_t>(concern);
        sources_[which][number / kWordBits] &= ~(std::uint32_t{1U} << (number % kWordBits));
        if (!IsSet(concern))
        {
            emergency_.Clear(kCodes[which].code);
        }
    }
}

void ErrorBook::EndAll(const Concern concern) noexcept
{
    if (IsSet(concern))
    {
        const auto which = static_cast<std::uint32_t>(concern);
        for (std::uint32_t& word : sources_[which])
        {
            word = 0U;
        }
        emergency_.Clear(kCodes[which].code);
    }
}

bool ErrorBook::IsSet(const Concern concern) const noexcept
{
    const auto which = static_cast<std::uint32_t>(concern);
    std::uint32_t any = 0U;
    for (std::uint32_t word = 0U; (which < kConcerns) && (word < kWords); ++word)
    {
        any |= sources_[which][word];
    }
    return any != 0U;
}

} // namespace counterpoint::device
