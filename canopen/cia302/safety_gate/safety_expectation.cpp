// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Whether an expectation names every part of the SRDOs that it has: an empty one would agree with every device.
#include "canopen/cia302/safety_gate/safety_check.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint16_t kGfc = 0x1300U;
constexpr std::uint16_t kFirstSettings = 0x1301U;
constexpr std::uint16_t kFirstMapping = 0x1381U;
constexpr std::uint16_t kSignatures = 0x13FFU; ///< Behind it stands what it does not cover.

/// How many parts of each SRDO were met.
struct Parts
{
    std::uint8_t settings[kMaxSrdoCount]; ///< Without sub-index 0.
    std::uint8_t entries[kMaxSrdoCount];  ///< Count included, without those above it.
    std::uint8_t counts[kMaxSrdoCount];   ///< Value of 138xh sub-index 0.
    bool signatures[kMaxSrdoCount + 1U];  ///< By sub-index.
};

bool IsAscending(const SafetyExpectation& expectation) noexcept
{
    bool is_ascending = true;
    for (std::uint16_t i = 1U; i < expectation.count; ++i)
    {
        const std::uint32_t before = KeyOf(expectation.objects[i - 1U].address).value;
        is_ascending = is_ascending && (before < KeyOf(expectation.objects[i].address).value);
    }
    return is_ascending;
}

/// Of 1 to 8 bytes.
std::uint64_t GreatestOf(const std::uint8_t size_bytes) noexcept
{
    constexpr std::uint32_t kByteBits = 8U;
    return ~std::uint64_t{0U} >> (kByteBits * (sizeof(std::uint64_t) - size_bytes));
}

/// Whether the value fits its object, and nobody would write what is a part of a program. [SRS_SFS_671]
bool Fits(const ExpectedObject& object) noexcept
{
    const std::uint8_t size = SizeOf(object.address);
    const bool is_parameter = (object.address.index > kSignatures);
    return (size > 0U) && (object.value <= GreatestOf(size)) && (!is_parameter || object.is_fixed);
}

std::uint8_t Increment(const std::uint8_t count) noexcept
{
    return static_cast<std::uint8_t>(count + 1U);
}

/// An object that Fits.
void Count(Parts& parts, const ExpectedObject& object) noexcept
{
    const std::uint16_t index = object.address.index;
    const std::uint8_t sub = object.address.sub;
    if (index > kSignatures)
    {
        // A parameter belongs to no SRDO.
    }
    else if (index == kSignatures)
    {
        parts.signatures[sub] = true;
    }
    else if (index >= kFirstMapping)
    {
        const std::uint16_t place = static_cast<std::uint16_t>(index - kFirstMapping);
        parts.counts[place] = (sub == 0U) ? static_cast<std::uint8_t>(object.value) : parts.counts[place];
        parts.entries[place] = (sub <= parts.counts[place]) ? Increment(parts.entries[place]) : parts.entries[place];
    }
    else if (index != kGfc)
    {
        std::uint8_t& settings = parts.settings[index - kFirstSettings];
        settings = (sub > 0U) ? Increment(settings) : settings;
    }
    else
    {
        // 1300h belongs to no SRDO.
    }
}

/// Sub-indices differ, so that as many as there are to be are all of them: entries above the count are left out.
bool IsWhole(const Parts& parts, const std::uint32_t place) noexcept
{
    return (parts.settings[place] == kCommunicationSubs) && (parts.entries[place] == (parts.counts[place] + 1U)) &&
           parts.signatures[place + 1U];
}

bool IsAbsent(const Parts& parts, const std::uint32_t place) noexcept
{
    return (parts.settings[place] == 0U) && (parts.entries[place] == 0U);
}

/// No entry of a mapping above its count but fixed ones: `objects` is ascending, so the count comes before its entries.
bool AreEntriesCounted(const SafetyExpectation& expectation) noexcept
{
    bool are_counted = true;
    std::uint16_t mapping = 0U;
    std::uint64_t count = 0U;
    for (std::uint16_t i = 0U; i < expectation.count; ++i)
    {
        const ExpectedObject& object = expectation.objects[i];
        const bool is_mapping = (object.address.index >= kFirstMapping) && (object.address.index < kSignatures);
        if (is_mapping && (object.address.sub == 0U))
        {
            mapping = object.address.index;
            count = object.value;
        }
        else if (is_mapping)
        {
            are_counted =
                are_counted && (object.address.index == mapping) && ((object.address.sub <= count) || object.is_fixed);
        }
        else
        {
            // No part of a mapping.
        }
    }
    return are_counted;
}

} // namespace

bool IsUsable(const SafetyExpectation& expectation) noexcept
{
    Parts parts{};
    bool is_usable = (expectation.objects != nullptr) && IsAscending(expectation) && AreEntriesCounted(expectation);
    for (std::uint16_t i = 0U; is_usable && (i < expectation.count); ++i)
    {
        is_usable = Fits(expectation.objects[i]);
        if (is_usable)
        {
            Count(parts, expectation.objects[i]);
        }
    }
    std::uint32_t srdos = 0U;
    for (std::uint32_t place = 0U; place < kMaxSrdoCount; ++place)
    {
        srdos += IsAbsent(parts, place) ? 0U : 1U;
        is_usable = is_usable && (IsAbsent(parts, place) || IsWhole(parts, place));
    }
    return is_usable && (srdos > 0U);
}

} // namespace counterpoint::cia302
