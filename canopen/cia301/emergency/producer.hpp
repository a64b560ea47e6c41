// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_EMERGENCY_PRODUCER_HPP
#define CANOPEN_CIA301_EMERGENCY_PRODUCER_HPP

#include "canopen/cia301/base/abort_code.hpp"
#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{

constexpr std::uint8_t kEmergencyRoom = 9U;    ///< Where the owner gives none.
constexpr std::uint8_t kLongestHistory = 254U; ///< Entries of 1003h: as many as an object has sub-indices.

/// Room for 1003h, kept by reference; what is beyond kLongestHistory is not used.
struct ErrorHistory
{
    std::uint32_t* errors;
    std::uint8_t count; ///< 0: the device keeps none.
};

/// Whether an error may use the places that are kept free for urgent ones.
enum class EmergencyUrgency : std::uint8_t
{
    kUsual = 0U,
    kUrgent = 0x5AU,
};

/// An error of the device.
struct EmergencyError
{
    std::uint16_t code;         ///< Emergency error code, not 0.
    std::uint8_t register_bits; ///< Bits of 1001h; the generic bit is added.
    std::uint8_t details[5];    ///< Manufacturer's bytes; the first two are in 1003h too.
    std::uint16_t source{0U};   ///< Tells errors of one code apart: a node, a PDO. [SRS_EMCY_007]
    EmergencyUrgency urgency{EmergencyUrgency::kUsual};
    bool is_untold{false}; ///< For the producer: its message has found no room yet.
};

/// A message on its way.
struct EmergencyMessage
{
    std::uint8_t bytes[8];
};

/// Room for errors that are active at once and for messages that wait, kept by reference. The last place of each is for
/// an urgent error. With one place more than the device has sources no error is lost. [SRS_EMCY_010]
struct EmergencyRoom
{
    EmergencyError* active;
    EmergencyMessage* waiting;
    std::uint16_t count; ///< Number of places of each; 0: there is no room, and the producer takes its own.
};

/// Value of a sub-index of 1003h, or why there is none.
struct HistoryReading
{
    SdoAbort abort;
    std::uint32_t value;
};

/// Emergency messages with 1001h, 1003h, 1014h and 1015h. Poll at least once in 2^30 us. Not reentrant.
class EmergencyProducer
{
  public:
    /// @brief With kEmergencyRoom places of its own for active errors and for messages.
    EmergencyProducer(NodeId node, const ErrorHistory& history) noexcept;
    /// @brief With the places of `room`.
    EmergencyProducer(NodeId node, const ErrorHistory& history, const EmergencyRoom& room) noexcept;
    EmergencyProducer(const EmergencyProducer&) = delete;
    EmergencyProducer& operator=(const EmergencyProducer&) = delete;
    ~EmergencyProducer() = default;

    /// @brief Reset communication: 1014h and 1015h as at power-on; errors stay, urgent ones are told again.
    /// O(room^2) [SRS_EMCY_008]
    void ResetCommunication(NodeId node) noexcept;
    /// @brief An error appeared; nothing happens if its code is active already for its source. O(room) [SRS_EMCY_001,
    /// SRS_EMCY_010]
    void Raise(const EmergencyError& error) noexcept;
    /// @brief The error of this code and source is gone; nothing happens if it is not active. O(room) [SRS_EMCY_001]
    void Clear(std::uint16_t code, std::uint16_t source = 0U) noexcept;
    /// @brief Whether any error is active. O(1)
    [[nodiscard]] bool HasErrors() const noexcept
    {
        return active_count_ > 0U;
    }
    /// @brief The next emergency message, if one waits and state, 1014h and 1015h allow it to be sent. O(room)
    /// [SRS_EMCY_003, SRS_EMCY_004, SRS_EMCY_005, SRS_EMCY_150]
    [[nodiscard]] FrameToSend Poll(NodeState state, Instant now) noexcept;

    /// @brief Error register 1001h.
    [[nodiscard]] std::uint8_t Register() const noexcept;
    /// @brief 1003h by sub-index: 0 is the number of errors, 1 the newest error. [SRS_EMCY_002]
    [[nodiscard]] HistoryReading History(std::uint8_t sub) const noexcept;
    /// @brief Writes 1003h:00: 0 clears the history, every other value is refused with kValueRange.
    [[nodiscard]] SdoAbort WriteHistory(std::uint8_t count) noexcept;
    /// @brief COB-ID 1014h. [SRS_EMCY_003]
    [[nodiscard]] std::uint32_t CobId() const noexcept;
    /// @brief Writes 1014h; kNone where it was accepted.
    [[nodiscard]] SdoAbort WriteCobId(std::uint32_t value) noexcept;
    /// @brief The same for a value of a configuration: also while it is on. O(1) [SRS_OBD_016]
    [[nodiscard]] SdoAbort LoadCobId(std::uint32_t value) noexcept;
    /// @brief 1015h: least time between two messages, in 100 us. [SRS_EMCY_004]
    [[nodiscard]] std::uint16_t InhibitTime() const noexcept;
    /// @brief Writes 1015h.
    void SetInhibitTime(std::uint16_t time_100us) noexcept;
    /// @brief Number of errors and messages for which there was no room; stays at 255.
    [[nodiscard]] std::uint8_t Dropped() const noexcept;

  private:
    [[nodiscard]] std::uint16_t RoomFor(EmergencyUrgency urgency) const noexcept;
    [[nodiscard]] std::uint16_t Find(std::uint16_t code, std::uint16_t source) const noexcept;
    [[nodiscard]] bool Queue(std::uint16_t code, const EmergencyError& error) noexcept;
    void TellUntold() noexcept;
    void Remember(const EmergencyError& error) noexcept;

    EmergencyError own_active_[kEmergencyRoom];
    EmergencyMessage own_waiting_[kEmergencyRoom];
    EmergencyRoom room_;   ///< The first `active_count_`; the first `waiting_count_`, the oldest at 0.
    ErrorHistory history_; ///< The first `history_count_`, the newest at 0.
    std::uint32_t cob_id_;
    std::uint16_t inhibit_100us_;
    std::uint16_t active_count_;
    std::uint16_t waiting_count_;
    std::uint8_t history_count_;
    std::uint8_t dropped_;
    bool is_inhibited_;  ///< One was sent at `sent_`.
    bool is_end_untold_; ///< The end of an error has found no room.
    Instant sent_;
};

} // namespace counterpoint::cia301

#endif
