// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWINS_PLAIN_RECORD_HPP
#define VERIFICATION_TWINS_PLAIN_RECORD_HPP

#include "safety_core/contract/channel.hpp"
#include "verification/twins/voice.hpp"

#include <cstdint>
#include <vector>

namespace counterpoint::twins::plain
{

/// The values of one SRDO as they are stored.
struct Stored
{
    std::uint8_t direction{0U};
    std::uint8_t transmission_type{0U};
    std::uint8_t srvt_ms{0U};
    std::uint16_t sct_ms{0U};
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::uint8_t map_count{0U};
    std::uint32_t entries[kMaxMapEntries]{};
    std::uint16_t signature{0U};
};

/// One object of this channel's side, or a dummy.
struct Part
{
    std::uint8_t* place{nullptr}; ///< Null: a dummy.
    std::uint32_t bits{0U};
};

/// The bytes of a frame, and what is mapped of them.
struct Bytes
{
    std::uint8_t at[kMaxPayloadBytes]{};
};

/// A consumer from entering OPERATIONAL on.
struct Reception
{
    bool is_pending{false};
    Bytes pending{};
    std::uint32_t pending_us{0U};
    bool is_too_old{false}; ///< Late detection: SRVT of the pending frame has expired.
    bool is_held{false};
    Bytes held{}; ///< As the normal frame.
    std::uint32_t held_us{0U};
    std::uint32_t ordinal{0U};
    bool is_fresh{false};
    bool is_written{false};
    bool had_pair_or_fault{false};
    bool had_pair{false};
    bool had_fault{false};
    bool is_late_told{false};
    std::uint32_t entered_us{0U};
};

/// A producer from entering OPERATIONAL on.
struct Transmission
{
    std::uint32_t entered_us{0U};
    std::uint32_t next_us{0U}; ///< Of the refresh.
    std::uint32_t base_us{0U}; ///< From where an application that sends too rarely is found.
    bool is_refresh_due{false};
    bool is_requested{false};
    bool is_in_flight{false};
    bool is_inverse_awaited{false};
    Bytes sent{};
    std::uint32_t since_us{0U};
    std::uint32_t ordinal{0U};
};

/// The acknowledge of one slot.
struct Button
{
    bool bit{true};
    bool level{true};
    bool is_waiting{false};
    bool is_edge{false}; ///< In this call.
    std::uint32_t edge_us{0U};
};

/// Everything about one SRDO.
struct Record
{
    SrdoSetup setup{};
    StaticFields fields{};
    Stored stored{};
    std::uint32_t* entries{nullptr}; ///< The stored map entries.
    bool is_resolved{false};
    bool is_sound{false}; ///< The last Validate or Recheck found no fault.
    std::vector<Part> parts{};
    std::uint32_t bits{0U};

    bool is_active{false};
    SrdoState state{SrdoState::kOff};
    SrdoCause cause{SrdoCause::kNone};
    std::uint16_t errors{0U};
    std::uint32_t recorded{0U}; ///< Signals of the next OnCycle.
    std::uint32_t told{0U};     ///< Signals of the last one.
    bool is_fault_reported{false};
    bool has_fault{false}; ///< To be reported by the next OnCycle.
    bool is_committed{false};
    bool is_safe{true};       ///< The last that was written is the safe value.
    bool is_otherwise{false}; ///< The last Commit read something else than was written.
    Reception reception{};
    Transmission transmission{};
    Button button{};
};

/// What all parts of the channel need.
struct Common
{
    DeviceConfig config{};
    Side side{Side::kNormal};
    std::uint8_t gfc_parameter{0U};
    std::uint8_t configuration_valid{0U};
    bool is_operational{false};
    bool has_committed{false}; ///< Since the last OnCycle.
    bool has_cycled{false};
    bool has_gfc{false};
    std::uint32_t now_us{0U};      ///< Of the last OnCycle.
    std::uint32_t previous_us{0U}; ///< Of the one before.
    std::uint32_t cycle{0U};
};

[[nodiscard]] inline bool IsConsumer(const Record& record) noexcept
{
    return record.stored.direction == kDirectionConsumer;
}
[[nodiscard]] inline bool IsProducer(const Record& record) noexcept
{
    return record.stored.direction == kDirectionProducer;
}
[[nodiscard]] inline std::uint32_t LengthOf(const Record& record) noexcept
{
    return (record.bits + 7U) / 8U;
}

// payload.cpp
/// @brief Bits of a byte of the payload that are mapped.
[[nodiscard]] std::uint8_t MappedOf(const Record& record, std::uint32_t byte) noexcept;
[[nodiscard]] Payload PayloadOf(const Bytes& bytes) noexcept;
[[nodiscard]] Bytes BytesOf(const Payload& payload) noexcept;
[[nodiscard]] Bytes ReadObjects(const Record& record, Side side) noexcept;
void WriteObjects(const Record& record, Side side, const Bytes& normal) noexcept;

// consumer.cpp
void RecordFault(Record& record, SrdoCause cause) noexcept;
void RecordAs(Record& record, SrdoCause cause, SrdoCause signalled) noexcept;
void CountFault(Record& record, SrdoCause cause) noexcept;
void TakeFrame(Common& common, Record& record, const CanFrame& frame, std::uint32_t stamp_us) noexcept;
void EnterConsumer(Record& record, std::uint32_t now_us) noexcept;
void LeaveConsumer(Record& record) noexcept;
void FollowButton(const Common& common, Record& record, bool bit) noexcept;
void CycleConsumer(const Common& common, Record& record, bool is_late, bool is_lossy) noexcept;
void DemoteConsumer(const Record& judged, Record& record, Record& counted) noexcept;
[[nodiscard]] bool CommitConsumer(const Common& common, Record& record, bool is_agreed, bool is_matched) noexcept;
/// @brief Whether an object holds something else than was written, if it is looked at.
[[nodiscard]] bool ReadBack(const Common& common, const Record& record, const Record& read, bool is_written,
                            bool is_examined) noexcept;

// producer.cpp
void EnterProducer(const Common& common, Record& record) noexcept;
void LeaveProducer(Record& record) noexcept;
/// @brief `records` are all of them.
void CycleProducer(const Common& common, Record* records, const CycleInput& input, SlotIndex slot,
                   bool was_active) noexcept;
[[nodiscard]] bool IsDue(const Common& common, const Record& record) noexcept;
/// @brief Whether a refresh fell due that Prepare has not used up; asked once in a cycle, behind IsDue.
[[nodiscard]] bool IsRefreshWaiting(Record& record) noexcept;
[[nodiscard]] PreparedPair PreparePair(const Common& common, Record& record) noexcept;
[[nodiscard]] ConfirmStep Confirm(Record& record, const CanFrame& frame, std::uint32_t stamp_us) noexcept;
[[nodiscard]] CanFrame InverseOf(const Common& common, const Record& record) noexcept;
void FailTransmission(Record& record, SrdoCause cause) noexcept;

// stored.cpp
void SetDefaults(const DeviceConfig& config, Record& record) noexcept;
void Store(Common& common, Record* records, const ConfigItem& item) noexcept;
[[nodiscard]] std::uint32_t Load(const Common& common, const Record* records, const ConfigAddress& address) noexcept;
[[nodiscard]] std::uint32_t RoomOf(const Common& common, const Record& record) noexcept;
[[nodiscard]] std::uint32_t CountOf(const Record& record) noexcept;
/// @brief Entries that exist of those that the map count says.
[[nodiscard]] std::uint32_t ExistingOf(const Common& common, const Record& record) noexcept;
/// @brief The map count for the rules.
[[nodiscard]] std::uint32_t DeclaredOf(const Common& common, const Record& record) noexcept;
[[nodiscard]] std::uint32_t EntryOf(const Record& record, std::uint32_t number) noexcept;

// signature.cpp
[[nodiscard]] std::uint16_t SignatureOf(const Common& common, const Record& record) noexcept;
[[nodiscard]] std::uint32_t DigestOf(const Common& common, const Record& record, bool is_first,
                                     std::uint32_t before) noexcept;

// rules.cpp
[[nodiscard]] CheckResult ValidateRecord(const Common& common, Record* records, SlotIndex slot) noexcept;
[[nodiscard]] CheckResult RecheckRecord(const Common& common, Record& record) noexcept;

} // namespace counterpoint::twins::plain

#endif
