// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_OBJECTS_HPP
#define CHANNEL_B_OBJECTS_HPP

#include "channel_b/storage.hpp"
#include "channel_b/words.hpp"
#include "safety_core/contract/configuration.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// The mappable objects of the device, looked up by mapping entries. A place is their number in the device's table.
class Objects
{
  public:
    void Restart(const DeviceConfig& config) noexcept
    {
        x_objects = Column<const MappableObject>{config.objects};
        x_count = config.object_count;
    }

    /// @brief Place of the first object that is not before the one that the entry names.
    [[nodiscard]] std::uint32_t Find(std::uint32_t entry) const noexcept
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
    /// @brief Whether there is an object at the place.
    [[nodiscard]] bool IsThere(std::uint32_t place) const noexcept
    {
        return place < x_count;
    }

    /// @brief Whether there is an object at the place, with index, sub-index and length as the entry says, that an SRDO
    /// of this access may map. [SRS_CFG_027]
    [[nodiscard]] bool IsNamed(std::uint32_t place, std::uint32_t entry, MapAccess access) const noexcept
    {
        if (!IsThere(place))
        {
            return false;
        }
        const MappableObject& object = x_objects[place];
        return (EntryOf(object) == entry) && (object.access == access);
    }

    /// @brief Where the object lies, and behind it.
    [[nodiscard]] std::uint8_t* Begin(std::uint32_t place) const noexcept
    {
        return x_objects[place].place;
    }

    [[nodiscard]] std::uint8_t* End(std::uint32_t place) const noexcept
    {
        const MappableObject& object = x_objects[place];
        return &Column<std::uint8_t>{object.place}[BytesFor(object.length_bits)];
    }

    /// @brief The value of an object; 0 where there is none. Bits of the last byte above the length do not count.
    /// [SRS_CFG_036]
    [[nodiscard]] std::uint64_t Read(std::uint32_t place) const noexcept
    {
        if (!IsThere(place))
        {
            return 0U;
        }
        const MappableObject& object = x_objects[place];
        return Packed({object.place}, object.length_bits) & LowBits(object.length_bits);
    }

    /// @brief The lowest bits of the word become the value of an object, and bits of its last byte above the length 0;
    /// nothing where there is none. [SRS_CFG_036]
    void Write(std::uint32_t place, std::uint64_t word) const noexcept
    {
        if (!IsThere(place))
        {
            return;
        }
        const MappableObject& object = x_objects[place];
        Unpack(word & LowBits(object.length_bits), {object.place}, object.length_bits);
    }

  private:
    /// The entry that names the object.
    [[nodiscard]] static std::uint32_t EntryOf(const MappableObject& object) noexcept
    {
        return (std::uint32_t{object.index} << 16U) | (std::uint32_t{object.sub} << 8U) | object.length_bits;
    }

    Column<const MappableObject> x_objects{nullptr};
    std::uint32_t x_count{0U};
};

} // namespace counterpoint::channel_b

#endif
