// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_COURSE_HPP
#define VERIFICATION_CAMPAIGN_COURSE_HPP

#include "verification/campaign/recording.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::campaign
{
struct Experiment;

/// Faults in time are tried on this grid. [SRS_CMG_020]
constexpr Nanoseconds kGrid = 50 * runtime::kNanosecondsPerMicrosecond;

/// @brief The cycle of the recording in which something that happens at this instant is seen.
[[nodiscard]] std::size_t CycleOf(const Recording& recording, Nanoseconds at);

/// Instants at which the kernel's cycle is called between two cycles of the recording.
struct Calls
{
    std::array<Nanoseconds, 2U> at{};
    std::size_t count{0U};
};

/// What the device receives: the recording, or what a fault of bus, counters or cycle makes of it. The frames of a
/// fault are on the bus and nowhere else: no part of the device is told of it. [SRS_CMG_020, SRS_CMG_023]
class Course
{
  public:
    explicit Course(const Recording& recording);

    /// @brief As recorded.
    void Clear();
    /// @brief As recorded, with this fault. `end` is the cycle behind the last one of the run; `seed` is for drawn
    /// data.
    void Disturb(const Experiment& fault, std::size_t end, std::uint64_t seed);

    /// @brief Where the frames of a cycle begin that no fault has reached yet.
    [[nodiscard]] std::size_t FirstFrameOf(std::size_t cycle) const;
    /// @brief The frame at this position, if it comes until `at`.
    [[nodiscard]] std::optional<RecordedFrame> FrameUntil(std::size_t position, Nanoseconds at) const;
    [[nodiscard]] Calls CallsIn(std::size_t cycle) const;
    /// @brief Whether behind this cycle, with so many frames gone, all comes as recorded.
    [[nodiscard]] bool IsOver(std::size_t cycle, std::size_t position) const;
    [[nodiscard]] InstantPair Stamp(const Nanoseconds at) const
    {
        return counters_.At(at);
    }

  private:
    void Replace(const Experiment& fault, std::size_t end, std::uint64_t seed);
    void ReplacePair(const Experiment& fault, std::uint64_t seed);
    void Lose(const Experiment& fault, std::size_t end);
    void Exchange(const Experiment& fault);
    void Move(std::size_t frame, Nanoseconds by, bool stays, std::optional<std::uint64_t> data);
    void Change(const Experiment& fault);
    void Settle(std::size_t from, std::size_t to);

    const Recording& recording_;
    std::size_t from_{0U};                 ///< Frames of the recording from here
    std::size_t to_{0U};                   ///< to before here are replaced
    std::vector<RecordedFrame> instead_{}; ///< by these.
    Counters counters_;
    bool has_counters_{false};
    const Experiment* timing_{nullptr};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_COURSE_HPP
