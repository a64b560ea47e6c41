// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/objects.hpp"

#include "channel_b/words.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

namespace
{

/// The entry that names the object.
[[nodiscard]] std::uint32_t EntryOf(const MappableObject& object) noexcept
{
    return (std::uint32_t{object.index} << 16U) | (std::uint32_t{object.sub} << 8U) | object.length_bits;
}

} // namespace

void Objects::Restart(const DeviceConfig& config) noexcept
{
    x_objects = Column<const MappableObject>{config.objects};
    x_count = config.object_count;
}

std::uint32_t Objects::Find(std::uint32_t entry) const noexcept
{
    std::uint32_t low = 0U;
    std::uint32_t high = x_count;
    while (low < high) // Halves at each turn: at most 11 for 1024 objects.
    {
        const std::uint32_t middle = (low + high) / 2U;
        if ((EntryOf(x_objects[middle]) >> 8U) < (entry >> 8U))
        {
            low = middle + 1U;
        }
        else
        {
            high = middle;
        }
    }
    return low;
}

/// [SRS_CFG_027]
bool Objects::IsNamed(std::uint32_t place, std::uint32_t entry, MapAccess access) const noexcept
{
    if (!IsThere(place))
    {
        return false;
    }
    const MappableObject& object = x_objects[place];
    return (EntryOf(object) == entry) && (object.access == access);
}

} // namespace counterpoint::channel_b
