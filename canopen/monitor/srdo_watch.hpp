// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_SRDO_WATCH_HPP
#define CANOPEN_MONITOR_SRDO_WATCH_HPP

#include "canopen/monitor/recording.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace counterpoint::monitor
{
/// What is wrong with a pair, in the words of semantics section 2.
enum class Cause : std::uint8_t
{
    kLength = 0U,
    kInverseFirst = 1U,
    kNormalTwice = 2U,
    kNotInverse = 3U,
    kSrvt = 4U,
    kSct = 5U,
    kRemote = 6U, ///< A remote frame with an identifier of the pair, which nobody may send.
    kGfc = 7U,    ///< No SRDO follows a GFC; belongs to no pair.
};
constexpr std::size_t kCauseCount = 8U;

/// "not inverse", "SCT expired"
[[nodiscard]] const char* CauseName(Cause cause) noexcept;

/// One violation as a watch sees it.
struct Breach
{
    Time time{0}; ///< Time of the frame, or at which the limit expired.
    Cause cause{Cause::kLength};
    std::string details;
};

/// Is told of violations.
class BreachSink
{
  public:
    /// @brief `watch` is the number that the watch was given.
    virtual void OnBreach(std::size_t watch, const Breach& breach) = 0;

  protected:
    BreachSink() = default;
    ~BreachSink() = default;
    BreachSink(const BreachSink&) = default;
    BreachSink& operator=(const BreachSink&) = default;
};

/// Least, mean and greatest of a set of times, and their distribution: each bin is a fortieth of the limit wide, and
/// the last one takes all that is greater.
struct TimeStatistics
{
    static constexpr std::size_t kBinsToLimit = 40U;
    static constexpr std::size_t kBins = 61U;

    Time limit{0};
    std::size_t count{0U};
    Time least{0};
    Time greatest{0};
    long double sum{0.0L};
    std::array<std::size_t, kBins> bins{};

    /// @brief Adds a time.
    void Add(Time time) noexcept;
    /// @brief The mean; 0 without a time.
    [[nodiscard]] Time Mean() const noexcept;
};

/// Limits of one consumer, or of a producer that nobody consumes.
struct WatchSetup
{
    std::uint32_t normal_id{0U};
    std::uint32_t inverse_id{0U};
    std::uint32_t bits{0U}; ///< Length of the normal data in bits.
    Time sct{0};
    Time srvt{0};
    bool is_late{false}; ///< 5F05h: late detection.
};

/// One SRDO as a consumer sees it, by the rules SRS_CONS_003, SRS_CONS_004, SRS_CONS_005, SRS_CONS_006, SRS_CONS_007,
/// SRS_CONS_008, SRS_CONS_009, SRS_CONS_010, SRS_CONS_011, SRS_CONS_012 and the clock of the recording. The rest of a
/// pair that was discarded is no violation of its own. [SRS_MON_005, SRS_MON_006, SRS_MON_007]
class SrdoWatch
{
  public:
    /// @brief `number` is told with each violation; `sink` is kept by reference.
    SrdoWatch(std::size_t number, const WatchSetup& setup, BreachSink& sink);

    /// @brief The watch begins at `now`. Until SRVT has passed, an inverse frame may be the rest of a pair that was not
    /// seen.
    void Begin(Time now) noexcept;
    /// @brief A plain or remote frame with one of the identifiers.
    void OnFrame(const LogFrame& frame);
    /// @brief Reports a limit that has expired before `now`.
    void Advance(Time now);
    /// @brief Producer or consumer left OPERATIONAL: nothing is held or awaited; the inverse frame of a pair that has
    /// begun may be under way. [SRS_MON_009]
    void Stop(Time now) noexcept;
    /// @brief Nothing comes behind `now`: a time without a valid pair that is longer than SCT by then is a cycle, too.
    void End(Time now) noexcept;
    /// @brief The next time at which a limit may have expired; the greatest time: none can.
    [[nodiscard]] Time Deadline() const noexcept;

    /// @brief Limits and identifiers.
    [[nodiscard]] const WatchSetup& Setup() const noexcept
    {
        return setup_;
    }
    /// @brief Number of valid pairs.
    [[nodiscard]] std::size_t PairCount() const noexcept
    {
        return pairs_;
    }
    /// @brief Times from the normal frame of a valid pair to that of the next one, whatever came between.
    /// [SRS_MON_010]
    [[nodiscard]] const TimeStatistics& Cycle() const noexcept
    {
        return cycle_;
    }
    /// @brief Times from normal to inverse frame.
    [[nodiscard]] const TimeStatistics& Srvt() const noexcept
    {
        return srvt_;
    }

  private:
    void Report(Time time, Cause cause, const std::string& details);
    void TakeNormal(const LogFrame& frame);
    void TakeInverse(const LogFrame& frame);
    [[nodiscard]] bool IsLateInverse(const LogFrame& frame);
    [[nodiscard]] int WrongBit(const LogFrame& normal, const LogFrame& inverse) const noexcept;
    [[nodiscard]] bool MayBeExchanged(const LogFrame& normal) noexcept;
    [[nodiscard]] bool IsOfFitting(const LogFrame& inverse);

    std::size_t number_;
    WatchSetup setup_;
    BreachSink& sink_;
    std::uint8_t length_; ///< Bytes of a frame.
    std::optional<LogFrame> pending_;
    std::optional<Time> held_;        ///< Normal frame of the last valid pair, while SCT is supervised.
    std::optional<Time> last_good_;   ///< Likewise, for the cycle, whether or not it is supervised.
    bool has_remainder_{false};       ///< The inverse frame of a discarded pair may still come.
    std::optional<Time> overdue_;     ///< Normal frame whose inverse frame did not come in time, and may still come.
    std::optional<LogFrame> early_;   ///< Inverse frame told as first, whose normal frame may still come.
    std::optional<LogFrame> fitting_; ///< A normal frame that fits it: its rest, or the first one of the next pair.
    std::optional<Time> blind_until_; ///< Likewise, because the normal frame was not seen.
    std::size_t pairs_{0U};
    TimeStatistics cycle_;
    TimeStatistics srvt_;
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_SRDO_WATCH_HPP
