// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CHANNEL_A_CHANNEL_HPP
#define CHANNEL_A_CHANNEL_HPP

#include "channel_a/storage.hpp"
#include "channel_a/transitions.hpp"
#include "safety_core/contract/channel.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::channel_a
{

/// Controllers of the normal frames (0) and of the inverse frames (1).
struct Ports
{
    CanPortId of_half[2]; // MISRA D-001
};

/// Voice A: owns the normal objects and sends the normal frames. Contract: safety_core/contract/channel.hpp; how it
/// does it and why: DESIGN.md. Restart before anything else.
class Channel final : public counterpoint::Channel
{
  public:
    /// @brief `storage` may hold anything, zeros included; Restart fills it.
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
    /// What one OnCycle is about, for all slots.
    struct Cycle
    {
        Instant now;
        bool is_late;
        bool has_overflow;
        bool has_gfc;
        SrdoMask edges; ///< Acknowledge inputs that went from 0 to 1.
        SrdoMask left;  ///< Consumers that ceased to be active in this call.
        SrdoMask new_fault;
        SrdoMask due;
        SrdoMask signalled;
    };

    [[nodiscard]] Record& At(const SlotIndex slot) const noexcept
    {
        return storage_.records[slot]; // MISRA D-002
    }
    /// kNoSlot, which is not below the count, where no SRDO has this identifier.
    [[nodiscard]] SlotIndex SlotOfPlace(const std::uint32_t place) const noexcept
    {
        return static_cast<SlotIndex>(storage_.look_up[place >> 1U] - 1U); // MISRA D-002
    }
    [[nodiscard]] SrdoMask Consumers() const noexcept;

    // What follows every event, in one place.
    [[nodiscard]] const Cell& Step(Record& record, SrdoMask bit, Event event) noexcept;
    void MoveTo(SrdoMask bit, std::uint8_t group) noexcept;
    void Raise(Record& record, SrdoMask bit, Event event, SrdoCause given) noexcept;
    void Suffer(Record& record, SrdoMask bit, const Cell& cell, SrdoCause given) noexcept;
    static void Count(Record& record, SrdoCause cause) noexcept;
    void Report(Record& record, SrdoMask bit, SrdoCause cause) noexcept;
    void DropPair(Record& record, SrdoMask bit) noexcept;
    void Discard(Record& record, SrdoMask bit) noexcept;

    // Frames.
    void ReceiveOther(const CanFrame& frame) noexcept;
    void ReceiveLate(const CanFrame& frame, Instant stamp, SlotIndex slot) noexcept;
    void ReceiveInTime(const CanFrame& frame, Instant stamp, SlotIndex slot, Record& record) noexcept;
    void RaiseAt(SlotIndex slot, Event event) noexcept;
    void ReceiveNormal(const CanFrame& frame, Instant stamp, SlotIndex slot, Record& record) noexcept;
    void ReceiveInverse(const CanFrame& frame, SlotIndex slot, Record& record) noexcept;
    void Complete(Record& record, SrdoMask bit) noexcept;

    // The cycle.
    void FollowOperational(Cycle& cycle, bool is_active) noexcept;
    void Enter(Instant now) noexcept;
    void EnterSlot(SlotIndex slot) noexcept;
    void Leave(Cycle& cycle) noexcept;
    void ScanLimits(const Cycle& cycle) noexcept;
    void ServeSlot(Cycle& cycle, SlotIndex slot) noexcept;
    [[nodiscard]] std::uint32_t ServeConsumer(Cycle& cycle, Record& record, SrdoMask bit) noexcept;
    void ExamineConsumer(const Cycle& cycle, Record& record, SrdoMask bit) noexcept;
    void Acknowledge(const Cycle& cycle, Record& record, SrdoMask bit) noexcept;
    void ServeProducer(Cycle& cycle, Record& record, SrdoMask bit) noexcept;
    void StartProducing(Record& record) const noexcept;
    void ExamineSending(Instant now, Record& record, SrdoMask bit) noexcept;
    void Refresh(Record& record, SrdoMask bit) noexcept;
    void Arm(SrdoMask& due, Record& record, SrdoMask bit) noexcept;
    void Signal(Cycle& cycle, Record& record, SrdoMask bit, std::uint32_t extra) noexcept;

    // Transmission.
    static void StopProducing(Record& record) noexcept;
    [[nodiscard]] SlotIndex Finish(SlotIndex slot) noexcept;
    [[nodiscard]] SlotIndex GiveUp(SlotIndex slot, Event event, SrdoCause cause) noexcept;

    // Configuration and objects.
    [[nodiscard]] bool IsOfSlot(const ConfigAddress& address) const noexcept;
    void StoreOfSlot(const ConfigItem& item) noexcept;
    [[nodiscard]] std::uint32_t LoadOfSlot(const ConfigAddress& address) const noexcept;
    [[nodiscard]] bool IsInUse(SlotIndex slot, std::uint32_t identifier) const noexcept;
    [[nodiscard]] ConfigFault CheckCommunication(SlotIndex slot) const noexcept;
    [[nodiscard]] bool HasGoodTiming(const Record& record) const noexcept;
    [[nodiscard]] ConfigFault Resolve(Record& record) const noexcept;
    [[nodiscard]] std::uint16_t FindObject(std::uint32_t entry) const noexcept;
    [[nodiscard]] const MappableObject& ObjectAt(const Record& record, std::uint32_t position) const noexcept;
    [[nodiscard]] bool FitsEntry(const Record& record, std::uint32_t position) const noexcept;
    [[nodiscard]] bool FitsOthers(const Record& record, std::uint32_t position) const noexcept;
    [[nodiscard]] bool HoldsTable(const Record& record) const noexcept;
    void WriteObjects(const Record& record, const Octets& data) const noexcept;
    [[nodiscard]] bool ReadObjects(Record& record) const noexcept;

    Storage storage_;
    const DeviceConfig* config_{nullptr};
    SrdoMask groups_[kGroupCount]{}; // MISRA D-001
    SrdoMask existing_{0U};
    SrdoMask attention_{0U}; ///< Slots that the next OnCycle has to serve even if no limit expires.
    SrdoMask levels_{0U};    ///< Acknowledge inputs as the last OnCycle saw them.
    SrdoMask fresh_{0U};
    SrdoMask unwritten_{0U}; ///< The held pair was not written yet.
    SrdoMask committed_{0U}; ///< The objects hold a pair.
    Instant now_{0U};
    SrdoMask standing_{0U};     ///< Producers whose refresh stands still until the next OnCycle.
    std::uint32_t step_us_{0U}; ///< Between the last two calls of OnCycle.
    Instant entered_{0U};       ///< OPERATIONAL, by the OnCycle that saw it first.
    std::uint32_t cycle_{0U};
    std::uint32_t late_after_us_{0U};  ///< Since the OnCycle before.
    std::uint32_t first_delay_us_{0U}; ///< From OPERATIONAL to the first possible transmission.
    std::uint32_t ordinal_sum_{0U};
    Ports ports_{};
    std::uint8_t count_{0U};
    std::uint8_t gfc_parameter_{0U};
    std::uint8_t configuration_valid_{0U};
    std::uint8_t consumer_count_{0U};
    std::uint8_t producer_count_{0U};
    std::uint8_t off_count_{0U};
    bool is_active_{false}; ///< OPERATIONAL with a valid configuration.
    bool has_run_{false};
    bool may_send_{false}; ///< The first possible transmission has come.
    bool gfc_pending_{false};
};

} // namespace counterpoint::channel_a

#endif
