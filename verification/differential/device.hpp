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
    kLengthExceeded,
    kSignature,
    kNeverValidated,
    kNone,
};

/// One SRDO of a random device, as it is going to be stored.
struct SlotPlan
{
    std::uint32_t cob_id_1;
    std::uint32_t cob_id_2;
    std::uint32_t entries[kMaxMapEntries];
    std::uint16_t sct_ms;
    std::uint8_t direction;
    std::uint8_t srvt_ms;
    std::uint8_t transmission_type;
    std::uint8_t map_count;
    std::uint8_t pairs;      ///< Objects of this SRDO: so many normal and so many inverse ones.
    std::uint8_t bytes;      ///< Sum of their lengths on each side; more than 8 with Flaw::kLengthExceeded.
    std::uint8_t lengths[8]; ///< Bytes of each pair of objects.
    Flaw flaw;
};

/// Memory of the mapped variables as one channel sees it. Normal objects of slot n from 32 n on, inverse ones 16
/// behind.
struct Memory
{
    static constexpr std::uint32_t kSlotBytes = 32U;
    static constexpr std::uint32_t kInverseAt = 16U;
    static constexpr std::uint8_t kFill = 0x66U;

    std::uint8_t bytes[kMaxSrdoCount * kSlotBytes];
    std::uint8_t spare[8]; ///< Of the object that no mapping may name.
    MappableObject objects[1024];

    void Fill() noexcept;
};

/// A random device: description, configuration, and for each channel its own memory, so that a write to the other
/// channel's objects shows.
class Device
{
  public:
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
    void MakeLengths(Random& random, SlotPlan& plan) noexcept;
    void MakeEntries(SlotIndex slot) noexcept;
    void MakeSetup(Random& random, SlotIndex slot, std::uint32_t& number) noexcept;
    void Spoil(Random& random, SlotIndex slot) noexcept;
    void SpoilIdentifier(Random& random, SlotPlan& plan) noexcept;
    void SpoilTiming(Random& random, SlotPlan& plan) noexcept;
    void SpoilEntry(Random& random, SlotIndex slot) noexcept;
    void MakeObjects(Memory& memory) noexcept;
    void AddObjects(Memory& memory, std::uint16_t first_index, std::uint32_t offset) noexcept;

    std::uint16_t object_count_{0U};
    std::uint8_t count_{0U};
};

} // namespace counterpoint::differential

#endif
