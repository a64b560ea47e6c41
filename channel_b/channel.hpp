// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHANNEL_HPP
#define CHANNEL_B_CHANNEL_HPP

#include "channel_b/storage.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// Channel B: owner of the inverse objects and sender of the inverse frame. DESIGN.md tells how it differs by design.
///
/// Invariants between two calls, while SRDOs are active (x_running is not 0):
/// - a budget that runs belongs to the latest normal frame of its slot: pending -> SRVT; only held -> SCT; with late
///   detection each has its own;
/// - pair_limit of a slot with nothing pending, held or in flight is kNothingRuns, so that it never counts as spent;
/// - state kReleased implies that a pair is held;
/// - Marks::committed are exactly the slots whose objects hold released data.
class Channel final : public counterpoint::Channel
{
  public:
    /// @brief The arrays outlive the channel. Restart is the first call.
    explicit Channel(const Storage& storage) noexcept : x_storage(storage)
    {
    }

    void Restart(const DeviceConfig& config) noexcept override;
    void Store(const ConfigItem& item) noexcept override;
    [[nodiscard]] ConfigItem Load(const ConfigAddress& address) const noexcept override;
    [[nodiscard]] ChannelRoom Room() const noexcept override;
    void SetFields(SlotIndex slot, const StaticFields& fields) noexcept override;
    [[nodiscard]] DeviceDigest Digest(SlotIndex slot, DeviceDigest before) const noexcept override;
    [[nodiscard]] CheckResult Validate(SlotIndex slot) noexcept override;
    [[nodiscard]] CheckResult Recheck(SlotIndex slot) noexcept override;
    void OnFrame(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CycleOutcome OnCycle(const CycleInput& input) noexcept override;
    [[nodiscard]] [[gnu::noinline]] HeldPair Held(SlotIndex slot) const noexcept override;
    [[nodiscard]] SrdoView View(SlotIndex slot) const noexcept override;
    void Demote(SlotIndex slot) noexcept override;
    void Commit(const Agreement& agreement) noexcept override;
    [[nodiscard]] Permit Answer(std::uint32_t challenge) const noexcept override;
    [[nodiscard]] PreparedPair Prepare(SlotIndex slot) noexcept override;
    [[nodiscard]] Confirmation OnConfirm(const CanFrame& frame, Instant stamp) noexcept override;
    [[nodiscard]] CanFrame InverseFrame(SlotIndex slot) noexcept override;
    void OnTransmitFault(SlotIndex slot, const TransmitFault& fault) noexcept override;

  private:
    /// Where a value of the configuration is kept; width 0 if it does not exist.
    struct Place
    {
        Column<std::uint8_t> bytes;
        std::uint32_t width;
    };

    /// What a call of OnCycle finds for all slots alike.
    struct Call
    {
        HalfMask late;       ///< All bits if the call is late, else none.
        HalfMask overflowed; ///< All bits if frames were lost, else none.
        HalfMask alarmed;    ///< Both, and a global fail-safe command.
        HalfMask entering;   ///< All bits if SRDOs become active in this call, else none.
        HalfMask leaving;    ///< All bits if they cease to be active, else none.
        HalfMask spent;      ///< All bits if the budget of some pair is, else none.
        HalfMask ended;      ///< Some bits if the phase of some slot is over, else none.
    };

    /// What it finds and does for one half of the slots.
    struct Half
    {
        Marks* marks;
        SlotIndex first;  ///< Slot 0 or 32.
        HalfMask spent;   ///< Slots whose pair has nothing left.
        HalfMask edges;   ///< Of the acknowledge inputs.
        HalfMask present; ///< All existing slots.
        HalfMask new_fault;
        HalfMask fresh;
        HalfMask due;
        HalfMask signalled;
    };

    // channel.cpp
    void ClearSlot(SlotIndex slot) noexcept;
    void TakeSetup(SlotIndex slot, const SrdoSetup& setup) noexcept;
    void ClearLookUp() noexcept;
    [[nodiscard]] SrdoState StateOf(SlotIndex slot) const noexcept;

    // census.cpp
    void ExamineMarks(const Half& half) noexcept;

    // activity.cpp
    void Enter(const Half& half) noexcept;
    void EnterSlot(SlotIndex slot, Stage stage) noexcept;
    [[nodiscard]] HalfMask Leave(const Half& half) noexcept;

    // cycle.cpp
    [[nodiscard]] HalfMask SpendPairs() noexcept;
    [[nodiscard]] HalfMask SpendPhases() noexcept;
    [[nodiscard]] HalfMask FindPhases() const noexcept;
    void AgePending(const Half& half) noexcept;
    void CloseWindows(const Half& half) noexcept;
    [[nodiscard]] HalfMask MissFirstPairs(const Half& half) noexcept;
    void Signal(Half& half, HalfMask slots) noexcept;
    void CycleHalf(const CycleInput& input, const Call& call, Half& half) noexcept;

    // consumer.cpp
    [[gnu::noinline]] void TakeSlowly(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    [[gnu::noinline]] void TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    void TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    void TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept;
    void TakeCommand(const CanFrame& frame) noexcept;
    void ExamineConsumers(const Call& call, const Half& half) noexcept;
    void Acknowledge(const Half& half) noexcept;
    void Release(const Half& half) noexcept;
    void ForgetCauses(SlotIndex first, HalfMask slots) noexcept;

    // faults.cpp
    [[gnu::noinline]] void Count(SlotIndex slot, SrdoCause cause) noexcept;
    void Record(SlotIndex slot, SrdoCause cause) noexcept;
    void Discard(SlotIndex slot) noexcept;
    [[gnu::cold]] void Fault(SlotIndex slot, SrdoCause cause) noexcept;
    void FaultEach(SlotIndex first, HalfMask slots, SrdoCause cause) noexcept;
    [[gnu::cold]] void Expire(SlotIndex slot) noexcept;
    void Ground(SlotIndex slot, Stage stage) noexcept;
    [[gnu::cold]] Confirmation Fail(SlotIndex slot, SrdoCause cause) noexcept;

    // producer.cpp
    [[nodiscard]] HalfMask AdvanceProducers(const CycleInput& input, const Call& call, const Half& half) noexcept;
    void AdvanceProvider(SlotIndex slot, HalfMask bit, Marks& marks) noexcept;
    void AdvanceApplication(SlotIndex slot, HalfMask bit, Marks& marks) noexcept;
    void EndPhases(const Half& half) noexcept;

    // configuration.cpp
    [[nodiscard]] ConfigFault CheckSignature(SlotIndex slot, std::uint16_t signature) const noexcept;
    [[nodiscard]] CheckResult Conclude(SlotIndex slot, ConfigFault fault, std::uint16_t signature) noexcept;
    [[nodiscard]] Place PlaceOf(const ConfigAddress& address) const noexcept;
    [[nodiscard]] ConfigFault CheckParameters(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsIdentifierInUse(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsTimingWrong(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsOfMapping(const ConfigAddress& address) const noexcept;
    [[nodiscard]] bool StoreEntry(const ConfigItem& item) noexcept;
    [[nodiscard]] bool StoreField(const ConfigItem& item) noexcept;
    [[nodiscard]] std::uint32_t LoadEntry(const ConfigAddress& address) const noexcept;

    // mapping.cpp
    [[nodiscard]] [[gnu::noinline]] Mapping MappingOf(SlotIndex slot) const noexcept;
    [[nodiscard]] [[gnu::noinline]] std::uint16_t Find(std::uint32_t entry) const noexcept;
    void Resolve(const Mapping& mapping, bool is_consumer) const noexcept;
    [[nodiscard]] bool AreFieldsRight(SlotIndex slot, const Mapping& mapping) const noexcept;
    [[nodiscard]] bool IsTableRight(SlotIndex slot, const Mapping& mapping) const noexcept;
    [[nodiscard]] ConfigFault CheckMapping(SlotIndex slot, const Mapping& mapping) noexcept;

    // objects.cpp
    void WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept;
    [[gnu::noinline]] void WriteFrom(SlotIndex slot, std::uint64_t data, std::uint32_t from) const noexcept;
    [[nodiscard]] [[gnu::noinline]] std::uint64_t ReadInverse(SlotIndex slot) const noexcept;
    [[nodiscard]] [[gnu::noinline]] std::uint64_t ReadFrom(SlotIndex slot, std::uint64_t data,
                                                           std::uint32_t from) const noexcept;
    [[nodiscard]] std::uint64_t SafeDataOf(SlotIndex slot) const noexcept;

    // signature.cpp
    [[nodiscard]] std::uint16_t SignatureOf(SlotIndex slot, const Mapping& mapping) const noexcept;

    Storage x_storage;
    const DeviceConfig* x_config{nullptr};
    HalfMask x_present[kHalves]{};  ///< All existing slots. MISRA D-001
    HalfMask x_levels[kHalves]{};   ///< Acknowledge inputs of the last OnCycle. MISRA D-001
    HalfMask x_running{0U};         ///< All bits while SRDOs are active, else none.
    HalfMask x_any_late{0U};        ///< Not 0 if some SRDO has late detection of SRVT.
    HalfMask x_gfc{0U};             ///< All bits if a global fail-safe command came since the last OnCycle, else none.
    std::uint32_t x_last_us{0U};    ///< The `now` of the last OnCycle: every budget and every stamp is relative to it.
    std::uint32_t x_elapsed_us{0U}; ///< Between the last two calls of OnCycle: what every budget is to be relieved of.
    std::uint32_t x_active_us{0U};  ///< Since entering OPERATIONAL.
    std::uint32_t x_late_us{0U};    ///< Longest time since the last OnCycle that is not late.
    std::uint32_t x_cycle{0U};
    CanPortId x_port[2U]{}; ///< Of the inverse frames, of the normal frames. MISRA D-001
    std::uint8_t x_count{0U};
    std::uint8_t x_map_entries{0U}; ///< Of each dynamic mapping.
};

} // namespace counterpoint::channel_b

#endif
