// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_RECORD_HPP
#define CANOPEN_START_UP_CIA302_BOOT_RECORD_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/start_up/cia302/boot_states.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

constexpr std::uint32_t kResetUs = 1'000'000U; ///< From a reset to the boot-up message; CiA 302-2 leaves it open.

/// Time of a call: the counter's reading, and a count that does not wrap.
struct BootTime
{
    Instant now;
    std::uint64_t clock_us;
};

/// Makes a count that does not wrap of the counter's readings. Zero-filled at first.
struct BootClock
{
    std::uint64_t clock_us;
    Instant last;
    bool is_running;

    /// @brief Adds what the counter has advanced since the call before.
    [[nodiscard]] BootTime Tick(const Instant now) noexcept
    {
        clock_us += is_running ? (now.us - last.us) : 0U;
        last = now;
        is_running = true;
        return BootTime{now, clock_us};
    }
};

/// The boot of one slave. Zero-filled at first. `state` is changed by Next alone; all else is what is known besides.
struct BootRecord
{
    NodeStatus status;
    std::uint64_t began_us;   ///< When the boot began; 1F89h counts from here.
    std::uint64_t since_us;   ///< When the state began to wait.
    ConcisePosition position; ///< In 1F22h.
    std::uint32_t offset;     ///< In 1F20h.
    std::uint32_t next;       ///< In 1F20h, behind the object that is written.
    std::uint8_t value[8];    ///< Value that a transfer reads or writes.
    BootState state;
    std::uint8_t beats;    ///< NodeRecord::beats when the wait began.
    std::uint16_t checks;  ///< How often 1F57h was read.
    std::uint8_t updates;  ///< Updates that were begun since the last boot that ended well.
    char identity;         ///< Letter with which the boot found another device; 0: the expected one.
    bool is_transferring;  ///< The SDO of the state was handed over.
    bool is_fresh;         ///< Its boot-up message came in this boot: it is not asked for its state.
    bool is_resumed;       ///< Nothing is restored in this boot.
    bool is_updated;       ///< Software was downloaded in this boot.
    bool was_operational;  ///< The state check found it OPERATIONAL: letter L.
    bool is_booted;        ///< The last boot ended without letter, or with L.
    bool is_start_wanted;  ///< Application or master asked for its start, whatever 1F80h says.
    bool is_unread;        ///< Stopped because it ran and did not answer.
    bool is_start_owed;    ///< The NMT master gave up its start; it is to be verified and started again.
    bool is_start_waiting; ///< status.is_started is of a start that was not seen to be sent. [SRS_BOOT_800]
    bool is_end_waiting;   ///< It was started, and what takes it out of OPERATIONAL was not sent. [SRS_BOOT_820]
    bool is_held;          ///< A command holds it since: no start-up starts it before an order.
    bool is_extra;         ///< Configuration or verification alone runs: its end says nothing about the boot.

    /// @brief Whether the boot ended with an error.
    [[nodiscard]] bool HasFailed() const noexcept
    {
        const bool is_error = (status.letter != '\0') && (status.letter != 'L') && (status.letter != 'A');
        return is_error && !is_booted;
    }
    /// @brief A command was handed over, which waits or was sent. `status` has a start from then on; who looks at the
    /// slave from outside sees it when it was sent.
    void NoteCommand(const bool is_start, const bool is_starting, const bool is_leaving) noexcept
    {
        is_end_waiting = is_leaving && IsSeenStarted();
        is_start_waiting = is_start && is_starting && (is_start_waiting || !status.is_started);
        status.is_started = is_start;
    }
    /// @brief Whether the slave is started for who looks at it from outside.
    [[nodiscard]] bool IsSeenStarted() const noexcept
    {
        return is_end_waiting || (status.is_started && !is_start_waiting);
    }
    /// @brief Whether a boot runs, and not configuration or verification alone.
    [[nodiscard]] bool IsBooting() const noexcept
    {
        return status.is_busy && !is_extra;
    }
    /// @brief Whether the present state waits for the boot-up message.
    [[nodiscard]] bool IsAwaitingBootUp() const noexcept
    {
        return RowOf(state).wait == BootWait::kBootUp;
    }
};

/// One slave within one call.
struct BootJob
{
    NodeId node;
    BootRecord& record;
    const SlaveSetup& setup;
    const BootTime& time;

    /// @brief Whether the state has waited longer than the limit.
    [[nodiscard]] bool IsOver(const std::uint64_t limit_us) const noexcept
    {
        return (time.clock_us - record.since_us) > limit_us;
    }
};

/// What the work of a state came to; `letter` has a meaning with kFailed.
struct BootFinding
{
    BootEvent event;
    char letter;
};

/// @brief A finding without a letter.
[[nodiscard]] constexpr BootFinding Found(const BootEvent event) noexcept
{
    return BootFinding{event, '\0'};
}

/// @brief The boot ends with this letter.
[[nodiscard]] constexpr BootFinding Failed(const char letter) noexcept
{
    return BootFinding{BootEvent::kFailed, letter};
}

} // namespace counterpoint::cia302

#endif
