// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHANNEL_HPP
#define CHANNEL_B_CHANNEL_HPP

#include "channel_b/storage.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::channel_b
{

/// Channel B: owner of the inverse objects and sender of the inverse frame. DESIGN.md tells how it differs by design.
///
/// Invariants between two calls, while SRDOs are active (x_active is not 0):
/// - a budget that runs belongs to the latest normal frame of its slot: pending -> SRVT; only held -> SCT;
/// - pair_limit of a slot with nothing pending, held or in flight is kNothingRuns, so that it never counts as spent;
/// - state kReleased implies that a pair is held;
/// - Marks::committed are exactly the slots whose objects hold released data.
class Channel final : public counterpoint::Channel
{
  public:
    /// @brief The arrays outlive the channel. Restart is the first call.
    explicit Channel(const Storage& storage) noexcept;

    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    void Commit(const Agreement& agreement) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    void Request(SlotIndex slot) noexcept override;
    void Hold(SlotIndex slot) noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    void Launch(SlotIndex slot) noexcept override;
    [[nodiscard]] CanFrame NextFrame(SlotIndex slot) noexcept override;
    [[nodiscard]] SlotIndex OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    void OnTransmitFault(SlotIndex slot, SrdoCause cause) noexcept override;

  private:
    /// Where a value of the configuration is kept; width 0 if it does not exist.
    struct Place
    {
        Column<std::uint8_t> bytes;
        std::uint8_t width;
    };

    /// Slots by state, of one look at all of them; a slot that is in none is off.
    struct Census
    {
        SrdoMask waiting;
        SrdoMask faulted;
        SrdoMask released;
        SrdoMask producers;
        SrdoMask corrupted; ///< State, direction, first cause or marks do not fit each other.
    };

    /// A mapping while it is being checked.
    struct Mapping
    {
        std::uint16_t table[kMaxMapEntries]; // MISRA D-001
        std::uint32_t length_bits;
        ConfigFault fault;
    };

    /// What the objects of a producer hold.
    struct ObjectData
    {
        std::uint64_t normal;
        std::uint64_t inverse;
    };

    // channel.cpp
    void ClearSlot(SlotIndex slot) noexcept;
    void TakeSetup(SlotIndex slot, const SrdoSetup& setup) noexcept;
    void ClearLookUp() noexcept;
    [[nodiscard]] SrdoState StateOf(SlotIndex slot) const noexcept;

    // census.cpp
    [[nodiscard]] Census TakeCensus() const noexcept;
    [[nodiscard]] Census SoundCensus() noexcept;
    void Repair(SlotIndex slot, Census& census) noexcept;

    // cycle.cpp
    [[nodiscard]] SrdoMask SpendPairs() noexcept;
    void SpendWindows() noexcept;
    [[nodiscard]] GuardView ViewGuard(const CycleInput& input) const noexcept;
    [[nodiscard]] SrdoMask SettleActivity(bool operational) noexcept;
    void Enter() noexcept;
    void EnterSlot(SlotIndex slot, SrdoState state) noexcept;
    [[nodiscard]] SrdoMask Leave() noexcept;
    [[nodiscard]] SrdoMask MissFirstPairs(const Census& census) noexcept;
    void Signal(SrdoMask slots) noexcept;

    // consumer.cpp
    void TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    void TakeLateFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    void TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    void TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept;
    void TakeCommand(const CanFrame& frame) noexcept;
    void ExamineConsumers(const CycleInput& input, SrdoMask spent, bool is_late, Census& census) noexcept;
    void Acknowledge(SrdoMask edges, const Census& census) noexcept;
    void Release(Census& census) noexcept;

    // faults.cpp
    void Count(SlotIndex slot, SrdoCause cause) noexcept;
    void Record(SlotIndex slot, SrdoCause cause) noexcept;
    void Discard(SlotIndex slot) noexcept;
    void Fault(SlotIndex slot, SrdoCause cause) noexcept;
    void FaultEach(SrdoMask slots, SrdoCause cause) noexcept;
    SlotIndex Fail(SlotIndex slot, SrdoCause cause) noexcept;

    // producer.cpp
    [[nodiscard]] SrdoMask AdvanceProducers(SrdoMask producers, SrdoMask spent) noexcept;
    SlotIndex ConfirmNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    SlotIndex ConfirmInverse(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    [[nodiscard]] std::uint32_t AbsenceUs(SlotIndex slot) const noexcept;
    void AdvanceProvider(SlotIndex slot) noexcept;
    void AdvanceApplication(SlotIndex slot) noexcept;
    [[nodiscard]] ObjectData ReadObjects(SlotIndex slot) const noexcept;

    // configuration.cpp
    [[nodiscard]] Place PlaceOf(const ConfigAddress& address) const noexcept;
    [[nodiscard]] ConfigFault CheckParameters(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsIdentifierInUse(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsTimingWrong(SlotIndex slot) const noexcept;
    [[nodiscard]] Mapping CheckMapping(SlotIndex slot) const noexcept;
    [[nodiscard]] std::uint16_t Find(std::uint32_t entry) const noexcept;
    [[nodiscard]] bool IsEntryRight(std::uint16_t place, std::uint32_t entry, std::uint8_t direction) const noexcept;
    [[nodiscard]] bool IsTableRight(SlotIndex slot) const noexcept;
    void Resolve(SlotIndex slot, const Mapping& mapping) noexcept;
    void WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept;

    // signature.cpp
    [[nodiscard]] std::uint16_t SignatureOf(SlotIndex slot) const noexcept;

    Storage x_storage;
    const DeviceConfig* x_config{nullptr};
    SrdoMask x_present{0U};         ///< All existing slots.
    SrdoMask x_active{0U};          ///< x_present while SRDOs are active, else 0.
    SrdoMask x_levels{0U};          ///< Acknowledge inputs of the last OnCycle.
    SrdoMask x_gfc{0U};             ///< Slots that a global fail-safe command reached since the last OnCycle.
    std::uint32_t x_last_us{0U};    ///< The `now` of the last OnCycle: every budget and every stamp is relative to it.
    std::uint32_t x_elapsed_us{0U}; ///< Between the last two calls of OnCycle: what every budget is to be relieved of.
    std::uint32_t x_late_us{0U};    ///< Longest time since the last OnCycle that is not late.
    std::uint32_t x_cycle{0U};
    std::uint8_t x_count{0U};
};

} // namespace counterpoint::channel_b

#endif
