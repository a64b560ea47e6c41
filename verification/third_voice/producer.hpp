// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_PRODUCER_HPP
#define VERIFICATION_THIRD_VOICE_PRODUCER_HPP

#include "verification/third_voice/consumer.hpp"

#include <cstdint>
#include <optional>
#include <set>

namespace counterpoint::third_voice
{
/// What a producer is told by its configuration.
struct ProducerRules
{
    Time delay_us{0}; ///< From entering OPERATIONAL to the first transmission.
    Time refresh_us{0};
    Time late_cycle_us{0}; ///< A cycle with its tolerance.
    Time srvt_us{0};
    std::uint32_t cob_id_1{0U};
    std::uint32_t cob_id_2{0U};
    std::size_t length_bytes{0U};
    std::uint64_t mask{0U};          ///< Mapped bits; above them the normal frame has 0, the inverse one 1.
    bool is_called{false};           ///< The kernel calls before each refresh; else the application sends.
    bool is_refresh_skipped{false};  ///< Flaw: one that falls due while a pair is on its way does not wait.
    bool misses_standing{false};     ///< Flaw: one that stands is examined.
    bool misses_halted{false};       ///< Flaw: in level 2 the refresh is examined.
    bool any_request_will_do{false}; ///< Flaw: one that comes late, with the call itself, is none.
};

/// A frame that leaves the device.
struct Sent
{
    std::uint32_t identifier{0U};
    Bytes data;
};

/// What a confirmation leads to.
enum class Confirmed : std::uint8_t
{
    kNothing,
    kNormal, ///< The inverse frame leaves.
    kPair,   ///< The pair is sent.
};

/// One producer, as one channel sees it. [semantics 6]
class Producer
{
  public:
    void EnterOperational(const ProducerRules& rules, Time now);
    void LeaveOperational();
    [[nodiscard]] bool IsActive() const;
    /// @brief Comes with the next call.
    void Request();
    /// @brief Limits and refresh at the instant of a call. `is_standing`: the refresh moves on by the time since the
    /// call before, and is not examined.
    void Look(Time now, bool is_standing);
    /// @brief The same in level 2: nothing falls due or is missed.
    void LookHalted(Time now);
    /// @brief Whether a pair is to be sent now.
    [[nodiscard]] bool IsDue() const;
    /// @brief Whether a refresh fell due that no pair has used up.
    [[nodiscard]] bool IsRefreshWaiting() const;
    /// @brief When the next refresh falls due.
    [[nodiscard]] Time NextRefresh() const;
    /// @brief The last instant at which a pair of an application that sends is not late.
    [[nodiscard]] Time SilentUntil() const;
    /// @brief Both sides as the application left them: whether the normal frame leaves.
    [[nodiscard]] bool Prepare(std::uint64_t normal, std::uint64_t inverse, Time now);
    void Fail(SrdoCause cause);
    [[nodiscard]] Confirmed Confirm(const Sent& frame, Time stamp);
    [[nodiscard]] Sent Normal() const;
    [[nodiscard]] Sent Inverse() const;
    /// @brief How many refreshes fell due since OPERATIONAL was entered, missed ones included.
    [[nodiscard]] std::uint64_t Refreshes() const;
    /// @brief Causes that came up since the last call.
    [[nodiscard]] std::set<SrdoCause> TakeCauses();

  private:
    void LookAtFlight(Time now);
    void LookAtSilence(Time now);
    [[nodiscard]] Sent FrameOf(std::uint32_t identifier, std::uint64_t data) const;

    ProducerRules rules_{};
    bool is_active_{false};
    Time first_{0};
    Time next_{0};             ///< Refresh; keeps its phase.
    bool is_asked_{false};     ///< Since the last call.
    bool is_requested_{false}; ///< With a call.
    Time silent_since_{0};     ///< Where the application sends: the call that prepared, or told of a late pair.
    bool is_refresh_waiting_{false};
    std::uint64_t refreshes_{0U};
    std::optional<Time> looked_;          ///< The call before, since OPERATIONAL was entered.
    std::optional<std::uint64_t> flight_; ///< Normal data of the pair on its way.
    bool is_inverse_awaited_{false};
    Time since_{0}; ///< From when on the awaited frame has SRVT.
    std::set<SrdoCause> causes_;
};
} // namespace counterpoint::third_voice

#endif
