// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_THIRD_VOICE_CONSUMER_HPP
#define VERIFICATION_THIRD_VOICE_CONSUMER_HPP

#include "safety_core/contract/srdo.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

// A plain, slow model of what docs/semantics.md says. Written from that text alone: who works here reads neither
// channel.
namespace counterpoint::third_voice
{
/// Time without a wrap: the model counts on; what the device is told is cut to 32 bits elsewhere.
using Time = std::int64_t;
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
};

/// One reading of the acknowledge input: a level counts when two readings in a row agree. [semantics 3]
class AcknowledgeInput
{
  public:
    /// @brief Whether the settled level rose with this reading.
    bool Rises(bool level);

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
    void Fail(SrdoCause cause, Time now);
    /// @brief Limits at the instant of a call.
    void LookAtLimits(Time now);
    void LookAtAcknowledge(bool level, Time now);
    /// @brief Whether this observer would release now; what the other says is the caller's affair.
    [[nodiscard]] bool MayRelease(Time now) const;
    void Release();

    [[nodiscard]] SrdoState State() const;
    [[nodiscard]] bool HasNewFault() const;
    [[nodiscard]] std::uint64_t Data() const;
    [[nodiscard]] std::uint32_t Ordinal() const;
    [[nodiscard]] SrdoCause FirstCause() const;
    /// @brief Causes signalled since the last call, in the order in which they came up.
    [[nodiscard]] std::vector<SrdoCause> TakeSignals();
    void EndCycle();

  private:
    struct Half
    {
        std::uint64_t data{0U};
        Time stamp{0};
    };

    [[nodiscard]] bool HasRightLength(const Bytes& data) const;
    void Signal(SrdoCause cause, Time now);
    void LookAtExpired(Time stamp);
    void Complete(const Half& half);

    ConsumerRules rules_{};
    bool is_active_{false};
    SrdoState state_{SrdoState::kOff};
    std::optional<Half> pending_; ///< A normal frame that waits for its inverse.
    std::optional<Half> held_;    ///< The last complete valid pair, since the last fault.
    std::uint32_t ordinal_{0U};
    Time entered_{0};
    bool has_told_waiting_{false};
    bool has_seen_pair_{false};
    SrdoCause first_cause_{SrdoCause::kNone};
    bool has_new_fault_{false};
    bool needs_acknowledge_{true}; ///< Interlock: survives every NMT transition.
    AcknowledgeInput input_{};
    std::optional<Time> edge_;
    std::map<SrdoCause, Time> told_at_;
    std::vector<SrdoCause> signals_;
};
} // namespace counterpoint::third_voice

#endif
