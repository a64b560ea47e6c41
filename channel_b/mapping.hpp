// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_MAPPING_HPP
#define CHANNEL_B_MAPPING_HPP

#include "channel_b/objects.hpp"
#include "channel_b/settings.hpp"
#include "channel_b/storage.hpp"
#include "channel_b/words.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// A mapping as it counts: of the program (static), or as stored.
struct Mapping
{
    Column<const std::uint32_t> entries;
    Column<const std::uint16_t> places; ///< Of a dynamic mapping; null of a static one.
    std::uint8_t declared;              ///< Map count as set.
    std::uint8_t count; ///< Entries that count: what is declared above those that exist does not. [SRS_CFG_020]
};

/// The mappings of all slots: what their entries name, whether they may, and the data of an SRDO as one word.
class Mappings
{
  public:
    Mappings(const MappingColumns& columns, const Settings& settings, std::uint8_t room) noexcept
        : x_columns(columns), x_settings(settings), x_room(room)
    {
    }

    void Restart(const DeviceConfig& config) noexcept;

    [[nodiscard]] bool IsStatic(SlotIndex slot) const noexcept
    {
        return x_settings.Setup(slot).map.entries != nullptr;
    }

    [[nodiscard]] Mapping Of(SlotIndex slot) const noexcept;
    /// @brief Keeps an entry of an existing slot; whether there is such an entry to be written.
    [[nodiscard]] bool StoreEntry(SlotIndex slot, std::uint8_t sub, std::uint32_t value) noexcept;
    [[nodiscard]] std::uint32_t LoadEntry(SlotIndex slot, std::uint8_t sub) const noexcept;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept
    {
        x_columns.fields[slot] = fields;
    }

    /// @brief All rules of the mapping; finds the places of its entries.
    [[nodiscard]] ConfigFault Resolve(SlotIndex slot) noexcept;
    /// @brief Whether each entry leads to the object that it names, with its length and access, or to none if it is a
    /// dummy; the objects of a static mapping one behind the other from the registered fields on.
    [[nodiscard]] bool IsRight(SlotIndex slot) const noexcept;
    /// @brief Whether the two below are still those of the entries.
    [[nodiscard]] bool IsMeasured(SlotIndex slot) const noexcept;
    /// @brief A word of which the mapped bits are set, ...
    [[nodiscard]] std::uint64_t MappedBits(SlotIndex slot) const noexcept
    {
        return x_columns.mapped[slot];
    }

    /// @brief ... and how many bytes they take in a frame.
    [[nodiscard]] std::uint8_t LengthBytes(SlotIndex slot) const noexcept
    {
        return x_columns.length_bytes[slot];
    }

    [[nodiscard]] std::uint64_t ReadInverse(SlotIndex slot) const noexcept;
    void WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept;
    /// @brief The complement of the safe value.
    [[nodiscard]] std::uint64_t InverseOfSafe(SlotIndex slot) const noexcept
    {
        return ~WordOf(x_settings.Setup(slot).safe_value);
    }

    /// @brief Whether the inverse objects hold these data. What a dummy has of them is not looked for; an entry that
    /// leads neither to an object nor to a dummy holds nothing.
    [[nodiscard]] bool HoldsInverse(SlotIndex slot, std::uint64_t data) const noexcept;

  private:
    void FindPlaces(SlotIndex slot, const Mapping& mapping) noexcept;
    [[nodiscard]] bool IsPairAllowed(const Mapping& mapping, std::uint32_t index) const noexcept;
    [[nodiscard]] bool IsShared(SlotIndex slot) const noexcept;
    /// A static mapping has no places of its own: what it names is looked up each time.
    [[nodiscard]] std::uint32_t PlaceOf(const Mapping& mapping, std::uint32_t index) const noexcept
    {
        return (mapping.places.first != nullptr) ? mapping.places[index] : x_objects.Find(mapping.entries[index]);
    }

    [[nodiscard]] std::size_t FirstEntryOf(SlotIndex slot) const noexcept
    {
        return std::size_t{slot} * x_room;
    }

    MappingColumns x_columns;
    const Settings& x_settings;
    Objects x_objects{};
    std::uint8_t x_room;        ///< Entries of a slot in the storage.
    std::uint8_t x_entries{0U}; ///< Of them those of the device.
};

} // namespace counterpoint::channel_b

#endif
