// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "channel_b/objects.hpp"

#include "channel_b/words.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

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
