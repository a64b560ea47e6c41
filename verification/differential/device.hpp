// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_DIFFERENTIAL_DEVICE_HPP
#define VERIFICATION_DIFFERENTIAL_DEVICE_HPP

#include "safety_core/contract/configuration.hpp"
#include "verification/differential/random.hpp"

#include <cstdint>

namespace counterpoint::differential
{

/// What the generator makes wrong in the configuration of one SRDO.
enum class Flaw : std::uint8_t
{
    kDirection,
    kTransmissionType,
    kIdentifier,
    kIdentifierInUse,
    kTiming,
    kMapCount,
    kEntry,
    kDummy,  ///< A dummy entry where none may be, or of a wrong form.
    kShared, ///< The mapping of another SRDO; no flaw where both are producers.
    kFields, ///< A static mapping without its fields, or with other ones.
    kLengthExceeded,
    kSignature,
    kNeverValidated,
    kNone,
};

/// Entries of one mapping at most.
constexpr std::uint8_t kMostEntries = kMaxMapEntries;
constexpr std::uint8_t kMostPairs = 64U;

/// One SRDO of a random device, as it is going to be stored.
struct SlotPlan
{
    std::uint32_t cob_id_1;
    std::uint32_t cob_id_2;
    std::uint32_t entries[kMostEntries];
    std::uint16_t sct_ms;
    std::uint8_t direction;
    std::uint8_t srvt_ms;
    std::uint8_t transmission_type;
    std::uint8_t map_count;
    std::uint8_t pairs;               ///< Entries of this SRDO: so many normal and so many inverse ones.
    std::uint8_t bits;                ///< Sum of their lengths on each side; more than 64 with Flaw::kLengthExceeded.
    std::uint8_t lengths[kMostPairs]; ///< Bits of each pair of entries.
    std::uint8_t dummies[kMostPairs]; ///< Data type of a dummy pair; 0: a pair of objects.
    bool is_static;
    bool has_dummies;
    Flaw flaw;
};

[[nodiscard]] constexpr std::uint8_t BytesOf(std::uint32_t bits) noexcept
{
    return static_cast<std::uint8_t>((bits + 7U) / 8U);
}

/// Bits of the last byte of a value of this length.
[[nodiscard]] constexpr std::uint8_t LastByteMask(std::uint32_t bits) noexcept
{
    return static_cast<std::uint8_t>(((bits % 8U) == 0U) ? 0xFFU : ((1U << (bits % 8U)) - 1U));
}

/// Memory of the mapped variables as one channel sees it. Normal objects of slot n from 128 n on, inverse ones 64
/// behind, each in whole bytes without a gap.
struct Memory
{
    static constexpr std::uint32_t kSlotBytes = 128U;
    static constexpr std::uint32_t kInverseAt = 64U;
    static constexpr std::uint8_t kFill = 0x66U;

    std::uint8_t bytes[kMaxSrdoCount * kSlotBytes];
    std::uint8_t spare[8]; ///< Of the object that no mapping may name.
    MappableObject objects[1024];

    void Fill() noexcept;
    /// @brief The value of one side: the objects one behind the other, the first in the lowest bits.
    [[nodiscard]] Payload Read(SlotIndex slot, const SlotPlan& plan, bool is_inverse) const noexcept;
};

/// A random device: description, configuration, and for each channel its own memory, so that a write to the other
/// channel's objects shows.
class Device
{
  public:
    static constexpr std::uint16_t kUnmappableIndex = 0x4000U;

    void Make(Random& random) noexcept;

    DeviceConfig config_a{};
    DeviceConfig config_b{};
    SrdoSetup setups[kMaxSrdoCount]{};
    SlotPlan plans[kMaxSrdoCount]{};
    Memory memory_a{};
    Memory memory_b{};
    std::uint8_t gfc_parameter{0U};

  private:
    void MakeTimes(Random& random) noexcept;
    void MakeSlot(Random& random, SlotIndex slot, std::uint32_t pair_of_identifiers) noexcept;
    void MakeKind(Random& random, SlotPlan& plan) noexcept;
    void MakeLengths(Random& random, SlotPlan& plan) noexcept;
    void AddPair(Random& random, SlotPlan& plan, std::uint32_t bits) noexcept;
    [[nodiscard]] std::uint32_t MostPairs(Random& random, const SlotPlan& plan) const noexcept;
    void MakeEntries(SlotIndex slot) noexcept;
    void FixMapping(SlotIndex slot) noexcept;
    void MakeSetup(Random& random, SlotIndex slot, std::uint32_t& number) noexcept;
    void MakeObjects(Memory& memory) noexcept;
    void AddObjects(Memory& memory, std::uint16_t first_index, std::uint32_t offset) noexcept;

    std::uint16_t object_count_{0U};
    std::uint8_t count_{0U};
};

} // namespace counterpoint::differential

#endif
