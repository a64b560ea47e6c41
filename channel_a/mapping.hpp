// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_MAPPING_HPP
#define CHANNEL_A_MAPPING_HPP

#include "channel_a/storage.hpp"
#include "channel_a/voice.hpp"

#include <cstddef>
#include <cstdint>

// From the entries of a mapping to steps: the only source that knows what entries name.
namespace counterpoint::channel_a
{

constexpr std::uint32_t kEntriesPerStep = 2U; ///< The normal one, then the inverse one.

/// The mapping of one SRDO. A static one has no steps: they are worked out at every use.
struct Mapping
{
    const std::uint32_t* entries;
    Step* steps;                ///< Null: a static mapping.
    std::uint32_t count;        ///< As loops and signature use it: at most `limit`, whatever is stored.
    std::uint32_t stored_count; ///< 138xh sub 0.
    std::uint32_t limit;
};

/// No object: without a single bit.
inline constexpr MappableObject kNothing{0U, 0U, 0U, MapAccess::kNone, nullptr};

[[nodiscard]] inline std::uint32_t Lesser(const std::uint32_t one, const std::uint32_t other) noexcept
{
    return (one < other) ? one : other;
}

[[nodiscard]] inline Mapping MappingOf(const Voice& voice, const std::size_t slot) noexcept
{
    const StaticMap& map = voice.config->srdos[slot].map; // MISRA D-002
    if (map.entries != nullptr)
    {
        return Mapping{map.entries, nullptr, Lesser(map.count, kMaxMapEntries), map.count, kMaxMapEntries};
    }
    const Storage& storage = voice.storage;
    const std::size_t first = slot * storage.map_entries;
    const std::uint32_t stored = storage.counts[slot]; // MISRA D-002
    const std::uint32_t limit = voice.config->map_entries;
    return Mapping{storage.entries + first, storage.steps + (first / kEntriesPerStep), // MISRA D-002
                   Lesser(stored, limit), stored, limit};
}

/// @brief The object at a place; kNothing where there is none.
[[nodiscard]] inline const MappableObject& ObjectAt(const DeviceConfig& config, const std::uint32_t place) noexcept
{
    return (place < config.object_count) ? config.objects[place] : kNothing; // MISRA D-002
}

/// @brief The step of a pair of entries whose bits begin at `first_bit`, by a search for both objects.
[[nodiscard]] Step WorkedOut(const DeviceConfig& config, const std::uint32_t* entries, std::uint32_t pair,
                             std::uint32_t first_bit) noexcept;

/// @brief The same, as it is kept, or worked out where the mapping is static.
[[nodiscard]] inline Step StepAt(const DeviceConfig& config, const Mapping& mapping, const std::uint32_t pair,
                                 const std::uint32_t first_bit) noexcept
{
    if (mapping.steps != nullptr)
    {
        return mapping.steps[pair]; // MISRA D-002
    }
    return WorkedOut(config, mapping.entries, pair, first_bit);
}

/// @brief The rules of the mapping; keeps its steps and what follows from them.
[[nodiscard]] ConfigFault Resolve(const DeviceConfig& config, Record& record, const Mapping& mapping) noexcept;
/// @brief Whether an entry names an object that an entry of another mapping names, too. [SRS_CFG_037]
[[nodiscard]] bool SharesObject(const DeviceConfig& config, const Record& record, const Mapping& mapping,
                                const Mapping& other) noexcept;
/// @brief Whether the steps still are those of the entries. O(entries) [SRS_CFG_030]
[[nodiscard]] bool HoldsSteps(const DeviceConfig& config, const Record& record, const Mapping& mapping) noexcept;

} // namespace counterpoint::channel_a

#endif
