// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SAFETY_CORE_CROSSLINK_LINK_SUPERVISOR_HPP
#define SAFETY_CORE_CROSSLINK_LINK_SUPERVISOR_HPP

#include "safety_core/crosslink/link_message.hpp"

#include <cstdint>

namespace counterpoint
{

/// Zero-filled memory is a lost link.
enum class LinkState : std::uint8_t
{
    kLost = 0U,
    kWaiting = 0x35U, ///< No contact yet: nothing is released, nothing is a fault.
    kAlive = 0xC6U,
};

/// Messages since Restart, modular.
struct LinkCounts
{
    std::uint32_t taken;
    std::uint32_t lost;
    std::uint32_t repeated;
    std::uint32_t old;
    std::uint32_t late;
    std::uint32_t corrupt;
};

/// A time between two instants of the own clock, ends included.
struct Window
{
    Instant first;
    Instant last;
};

/// @brief Whether `instant` lies in the window. [SRS_TWO_002]
[[nodiscard]] inline bool Holds(const Window& window, const Instant instant) noexcept
{
    return (instant.us - window.first.us) <= (window.last.us - window.first.us);
}
/// @brief Whether `left` is not after `right`; instants are modular.
[[nodiscard]] inline bool IsNotAfter(const Instant left, const Instant right) noexcept
{
    return ((right.us - left.us) >> 31U) == 0U;
}

enum class TakeResult : std::uint8_t
{
    kDiscarded = 0U, ///< Repeated, old, or not fresh: tells nothing.
    kTaken = 0x69U,
};

/// Judges intact messages: sequence, freshness by echo, clock, time-out. [SRS_LNK_003, SRS_LNK_004, SRS_LNK_005,
/// SRS_LNK_006, SRS_LNK_007, SRS_LNK_011, SRS_LNK_012, SRS_LNK_210]
///
/// t        |--- window ---|...|--- window ---|...|   A drift that begins in a window may be too little in what is
/// drift          |------------------------------>|   left of it: it is found in the next one. A window is over with
///                 clock interval + time-out + cycle  the first message behind it, which may be a time-out away.
class LinkSupervisor
{
  public:
    /// @brief Waits for contact; nothing was heard or counted. CheckLinkConfig has found nothing in `config`.
    void Restart(const LinkConfig& config) noexcept;
    /// @brief Before each own message: its sequence number. Contact begins by an answer to one of this start.
    /// [SRS_LNK_011]
    void OnCompose(std::uint32_t sequence) noexcept;
    /// @brief A message that is intact, received at `received`. O(1)
    [[nodiscard]] TakeResult Take(const LinkMessage& message, Instant received) noexcept;
    /// @brief One that is not.
    void CountCorrupt() noexcept;
    /// @brief Once a cycle.
    void Examine(Instant now) noexcept;
    /// @brief From now on lost, with this reason if it is the first.
    void Lose(LinkFinding finding) noexcept;
    /// @brief What the next message gives as its echo.
    [[nodiscard]] LinkEcho Echo(Instant now) const noexcept;
    /// @brief When the message taken last was composed, by the own clock.
    [[nodiscard]] const Window& Composed() const noexcept
    {
        return composed_;
    }
    /// @brief Own sequence number that the message taken last echoes.
    [[nodiscard]] std::uint32_t Acknowledged() const noexcept
    {
        return acknowledged_;
    }
    /// @brief kLost before the first Restart, too.
    [[nodiscard]] LinkState State() const noexcept
    {
        return state_;
    }
    /// @brief There was contact, and nothing was found since.
    [[nodiscard]] bool IsAlive() const noexcept
    {
        return state_ == LinkState::kAlive;
    }
    /// @brief 0 while alive, something else otherwise.
    [[nodiscard]] std::uint32_t Spoiler() const noexcept
    {
        return static_cast<std::uint32_t>(state_) ^ static_cast<std::uint32_t>(LinkState::kAlive);
    }
    /// @brief Why the link is lost: the first reason. kNone while it is not, kInvalid before the first Restart.
    [[nodiscard]] LinkFinding Finding() const noexcept
    {
        return finding_;
    }
    /// @brief What became of the messages since Restart.
    [[nodiscard]] const LinkCounts& Counts() const noexcept
    {
        return counts_;
    }

  private:
    /// @brief Whether the message is newer than all heard; counts what it is not, and what is missing before it.
    [[nodiscard]] bool IsNext(const LinkMessage& message) noexcept;
    /// @brief Whether it answers an own message that was composed within the time-out; before contact, one of this
    /// start.
    [[nodiscard]] bool IsFresh(const LinkMessage& message, Instant received) const noexcept;
    /// @brief Loses the link where the progress of both clocks since the reference differs by more than the window's
    /// share of the tolerance; behind the window this message is the new reference. [SRS_LNK_007, SRS_LNK_211,
    /// SRS_LNK_212]
    void CompareClocks(const LinkMessage& message, Instant received) noexcept;

    LinkConfig config_{};
    std::uint32_t window_us_{0U};    ///< Two of them, and the messages that end them, fit into the clock interval.
    std::uint32_t tolerance_us_{0U}; ///< Within a window.
    LinkCounts counts_{};
    Window composed_{{0U}, {0U}};
    Instant echoed_{0U};      ///< Own stamp that the message taken last echoes.
    Instant heard_stamp_{0U}; ///< Stamp of the newest message heard, by the peer's clock, and when that was.
    Instant heard_at_{0U};
    std::uint32_t heard_sequence_{0U};
    std::uint32_t acknowledged_{0U};
    std::uint32_t composed_sequence_{0U}; ///< Of the own message composed last.
    std::uint32_t composed_count_{0U};    ///< Own messages since the first cycle of this start; of use until contact.
    std::uint32_t has_cycled_{0U};        ///< 1: Examine was called since Restart.
    Instant reference_own_{0U};           ///< Where the window began in which the clocks are compared.
    Instant reference_peer_{0U};
    std::uint8_t heard_{0U};
    LinkState state_{LinkState::kLost};
    LinkFinding finding_{LinkFinding::kInvalid};
};

} // namespace counterpoint

#endif
