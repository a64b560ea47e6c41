// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_CONSUMER_HPP
#define VERIFICATION_THIRD_VOICE_CONSUMER_HPP

#include "safety_core/contract/srdo.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

// A plain, slow model of what docs/semantics.md says. Written from that text alone: who works here reads neither
// channel.
namespace counterpoint::third_voice
{
/// Time without a wrap: the model counts on; what the device is told is cut to 32 bits elsewhere.
using Time = std::int64_t;
constexpr Time kUsPerMs = 1000;
using Bytes = std::vector<std::uint8_t>;

/// What a consumer is told by its configuration.
struct ConsumerRules
{
    Time sct_us{0};
    Time srvt_us{0};
    std::size_t length_bytes{0U};
    std::uint64_t mask{0U}; ///< Mapped bits; the others of the last byte are sent 0 and 1.
    bool is_inversion_checked{true};
    bool is_late{false}; ///< SRVT is looked at when the inverse frame comes.
    bool is_automatic{false};
    Time acknowledge_window_us{0};
    bool is_one_reading_enough{false}; ///< A broken rule: a level counts at once.
    bool counts_behind_fault{false};   ///< A broken rule: a pair behind a fault that is not told yet starts SCT.
};

/// One reading of the acknowledge input: a level counts when two readings in a row agree. [semantics 3]
class AcknowledgeInput
{
  public:
    /// @brief Whether the settled level rose with this reading.
    bool Rises(bool level, bool is_one_enough);
    /// @brief All that it remembers.
    [[nodiscard]] Time Standing() const;

  private:
    bool last_{true}; ///< A constant 1 never acknowledges.
    bool settled_{true};
};

/// One observer's view of one consumer, by one counter. [semantics 1 to 3]
class Consumer
{
  public:
    void EnterOperational(const ConsumerRules& rules, Time now);
    void LeaveOperational();
    [[nodiscard]] bool IsActive() const;

    void OnNormal(const Bytes& data, Time stamp);
    void OnInverse(const Bytes& data, Time stamp);
    /// @brief An error that does not come from a frame: queue overflow, GFC, the other observer's fault.
    void Fail(SrdoCause cause);
    /// @brief The observers go on together: no fault of a frame, so that a normal frame may wait on; nothing is told.
    void Demote();
    /// @brief Limits at the instant of a call.
    void LookAtLimits(Time now);
    /// @brief No pair since entering OPERATIONAL, and no fault: told once.
    void LookAtWaiting(Time now);
    void LookAtAcknowledge(bool level, Time now);
    /// @brief Releases for its part where it may, and waits for the other observer with pair and edge.
    void Judge(Time now);
    /// @brief Its part was given, and the other one's not within the window.
    [[nodiscard]] bool IsAloneTooLong() const;
    /// @brief Whether that depends on where the window begins: with the edge, as the semantics say, or with the release
    /// that the edge gave.
    [[nodiscard]] bool IsOpen(Time now) const;
    /// @brief Both have released.
    void Settle();

    [[nodiscard]] SrdoState State() const;
    [[nodiscard]] bool HasNewFault() const;
    [[nodiscard]] std::uint64_t Data() const;
    [[nodiscard]] std::uint32_t Ordinal() const;
    /// @brief Causes that came up since the last call.
    [[nodiscard]] std::set<SrdoCause> TakeCauses();
    void EndCycle();
    /// @brief All that decides what it will do next, instants as ages at `now`: for whoever looks at each state once.
    [[nodiscard]] std::vector<Time> StandingAt(Time now) const;

  private:
    struct Half
    {
        std::uint64_t data{0U};
        Time stamp{0};
    };

    [[nodiscard]] bool IsAlone() const;
    [[nodiscard]] bool HasRightLength(const Bytes& data) const;
    void LookAtExpired(Time stamp, bool is_inverse);
    void Complete();

    ConsumerRules rules_{};
    bool is_active_{false};
    SrdoState state_{SrdoState::kOff};
    std::optional<Half> pending_; ///< A normal frame that waits for its inverse.
    std::optional<Half> held_;    ///< The last complete valid pair, since the last fault.
    std::uint32_t ordinal_{0U};
    Time entered_{0};
    bool has_told_waiting_{false};
    bool has_seen_pair_{false};
    bool has_new_fault_{false};
    bool is_settled_{false}; ///< Released by both.
    Time given_at_{0};       ///< Since when it has released for its part.
    AcknowledgeInput input_{};
    std::optional<Time> edge_; ///< Waits for the other observer's, and for a pair.
    std::set<SrdoCause> causes_;
};
} // namespace counterpoint::third_voice

#endif
