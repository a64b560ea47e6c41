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

[[nodiscard]] Mapping MappingOf(const Voice& voice, std::size_t slot) noexcept;

/// @brief The object at a place; kNothing where there is none.
[[nodiscard]] inline const MappableObject& ObjectAt(const DeviceConfig& config, const std::uint32_t place) noexcept
{
    return (place < config.object_count) ? config.objects[place] : kNothing; // MISRA D-002
}

/// The steps of a slot, in order.
struct StepRange
{
    const Step* first;
    const Step* end;
};

/// @brief The steps of a static mapping, by a search for its objects; they are good until the next call.
[[nodiscard]] StepRange WorkedOut(Voice& voice, std::size_t slot) noexcept;

/// @brief The steps as they are kept, or worked out where the mapping is static.
[[nodiscard]] inline StepRange StepsOf(Voice& voice, const std::size_t slot) noexcept
{
    if (voice.config->srdos[slot].map.entries != nullptr) // MISRA D-002
    {
        return WorkedOut(voice, slot);
    }
    const Storage& storage = voice.storage;
    const std::uint32_t entries = Lesser(storage.counts[slot], storage.map_entries);            // MISRA D-002
    const Step* const first = storage.steps + (slot * (storage.map_entries / kEntriesPerStep)); // MISRA D-002
    return StepRange{first, first + (entries / kEntriesPerStep)};                               // MISRA D-002
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
