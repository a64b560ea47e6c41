// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_B_CHANNEL_HPP
#define CHANNEL_B_CHANNEL_HPP

#include "channel_b/packed.hpp"
#include "channel_b/storage.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_b
{

/// Channel B: owner of the inverse objects and sender of the inverse frame. DESIGN.md tells how it differs by design.
///
/// Invariants between two calls, while SRDOs are active (x_running is not 0):
/// - a budget whose limit is not kNothingRuns belongs to the latest normal frame of its slot;
/// - Standing::kReleased implies that a pair is held;
/// - x_committed are exactly the slots whose objects hold released data.
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

    /// A mapping as it counts: of the program (static), or as stored.
    struct Mapping
    {
        Column<const std::uint32_t> entries;
        Column<std::uint16_t> table; ///< Places of the entries of a dynamic mapping; null of a static one.
        std::uint8_t declared;       ///< Map count as set.
        std::uint8_t count; ///< Entries that count: what is declared above those that exist does not. [SRS_CFG_020]
    };

    /// What data and objects do to each other.
    enum class Way : std::uint8_t
    {
        kRead,
        kWritten,
    };

    /// One call of OnCycle for one half of the slots: what it is told, and what it tells.
    struct Half
    {
        HalfMask bit; ///< Of the slot at hand.
        HalfMask edges;
        HalfMask requests;
        HalfMask stand;
        HalfMask busy; ///< Where there is more to do than to take the time.
        HalfMask released;
        HalfMask faulted;
        HalfMask waiting;
        HalfMask new_fault;
        HalfMask fresh;
        HalfMask due;
        HalfMask signalled;
        std::uint32_t ordinal_sum;
        std::uint32_t consumers;
        std::uint32_t producers;
    };

    // channel.cpp
    void TakeSetup(SlotIndex slot, const SrdoSetup& setup) noexcept;

    // cycle.cpp
    void Enter(SlotIndex slot, Row& row) noexcept;
    void Age(Row& row) const noexcept;
    [[gnu::noinline]] void Spend(SlotIndex first, Half& half) const noexcept;
    void ServeHalf(SlotIndex first, Half& half) noexcept;
    [[gnu::noinline]] void Serve(SlotIndex slot, Row& row, Half& half) noexcept;

    // consumer.cpp
    void ServeConsumer(Row& row, Half& half) const noexcept;
    void Release(Row& row, Half& half) const noexcept;
    [[gnu::noinline]] void Reject(SlotIndex slot, SrdoCause cause) noexcept;
    [[gnu::noinline]] void TakeFrame(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    [[gnu::noinline]] void TakeLate(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    [[gnu::always_inline]] void TakeNormal(SlotIndex slot, const CanFrame& frame, std::uint32_t since_call) noexcept;
    [[gnu::always_inline]] void TakeInverse(SlotIndex slot, const CanFrame& frame) noexcept;

    // producer.cpp
    [[nodiscard]] [[gnu::noinline]] PreparedPair PrepareSlowly(SlotIndex slot) const noexcept;
    [[nodiscard]] [[gnu::always_inline]] PreparedPair Launch(Row& row, std::uint64_t data) const noexcept;
    [[nodiscard]] [[gnu::noinline]] Confirmation Doubt(const CanFrame& frame) const noexcept;
    void ServeProducer(Row& row, Half& half) const noexcept;
    void AdvanceProvider(Row& row) const noexcept;
    void AdvanceApplication(Row& row) const noexcept;

    // configuration.cpp
    [[nodiscard]] Place PlaceOf(const ConfigAddress& address) const noexcept;
    [[nodiscard]] bool IsOfMapping(const ConfigAddress& address) const noexcept;
    [[nodiscard]] ConfigFault CheckParameters(SlotIndex slot) const noexcept;
    [[nodiscard]] bool IsIdentifierInUse(SlotIndex slot) const noexcept;

    // mapping.cpp
    [[nodiscard]] static bool IsStatic(const Mapping& mapping) noexcept
    {
        return mapping.table.first == nullptr;
    }
    [[nodiscard]] [[gnu::noinline]] Mapping MappingOf(SlotIndex slot) const noexcept;
    [[nodiscard]] [[gnu::noinline]] std::uint32_t Find(std::uint32_t entry) const noexcept;
    [[nodiscard]] [[gnu::noinline]] static std::uint32_t WordsOf(const Mapping& mapping) noexcept;
    void Resolve(const Mapping& mapping, bool may_be_dummy) const noexcept;
    [[nodiscard]] bool IsTableRight(SlotIndex slot, const Mapping& mapping) const noexcept;
    [[nodiscard]] ConfigFault CheckMapping(SlotIndex slot, const Mapping& mapping) const noexcept;

    // objects.cpp
    [[nodiscard]] [[gnu::noinline]] std::uint64_t ExchangeFrom(SlotIndex slot, std::uint32_t from, std::uint64_t data,
                                                               Way way) const noexcept;
    void WriteInverse(SlotIndex slot, std::uint64_t data) const noexcept;
    void WriteSafe(SlotIndex slot) const noexcept;

    // signature.cpp
    [[nodiscard]] std::uint16_t SignatureOf(const Row& row, const Mapping& mapping) const noexcept;

    Storage x_storage;
    const DeviceConfig* x_config{nullptr};
    Column<const MappableObject> x_objects{nullptr}; ///< Of the configuration.
    std::size_t x_object_count{0U};
    std::uint32_t x_count{0U};       ///< Slots.
    HalfMask x_levels[kHalves]{};    ///< Acknowledge inputs of the last OnCycle. MISRA D-001
    HalfMask x_released[kHalves]{};  ///< Released by the last OnCycle, and no fault since. MISRA D-001
    HalfMask x_committed[kHalves]{}; ///< The objects hold a released pair. MISRA D-001
    HalfMask x_unwritten[kHalves]{}; ///< The held pair has not been written into the objects. MISRA D-001
    HalfMask x_running{0U};          ///< All bits while SRDOs are active, else none.
    std::uint32_t x_alarms{0U};      ///< What this call of OnCycle, or the next one, finds for all slots alike.
    std::uint32_t x_last_us{0U};     ///< The `now` of the last OnCycle: every budget and every stamp is relative to it.
    std::uint32_t x_elapsed_us{0U};  ///< Between the last two calls of OnCycle: what every budget is to be relieved of.
    std::uint32_t x_active_us{0U};   ///< Since entering OPERATIONAL.
    std::uint32_t x_late_us{0U};     ///< Longest time since the last OnCycle that is not late.
    std::uint32_t x_cycle{0U};
    CanPortId x_port[2U]{};         ///< Of the inverse frames, of the normal frames. MISRA D-001
    std::uint8_t x_map_entries{0U}; ///< Of each dynamic mapping.
};

} // namespace counterpoint::channel_b

#endif
