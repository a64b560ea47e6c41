// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_REPLAY_HPP
#define VERIFICATION_CAMPAIGN_REPLAY_HPP

#include "verification/campaign/runner.hpp"
#include "verification/campaign/session.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// Something that happened in a replayed experiment.
struct Moment
{
    Nanoseconds at{0};
    std::string who;
    std::string what;
};

/// For how long a lane of the picture was high.
struct Stretch
{
    Nanoseconds begin{0};
    Nanoseconds end{0};
};

/// One experiment of a campaign again, cycle by cycle. [SRS_CMG_044]
class Replay final : private CycleWatcher
{
  public:
    /// @brief Tries the experiment of this number, which is below Space::Size.
    Replay(Session& session, std::uint64_t number);

    [[nodiscard]] const Outcome& Found() const noexcept
    {
        return found_;
    }
    /// @brief The time line for a terminal, with the outcome in its last line.
    [[nodiscard]] std::string Text() const;
    /// @brief The time line with a picture, as one page without any other file.
    [[nodiscard]] std::string Page() const;

  private:
    /// What can be seen of the device behind a cycle.
    struct Sighting
    {
        SrdoMask open{0U};
        DeviceFault fault{DeviceFault::kNone};
        bool is_watchdog_alive{true};
        bool is_output_live{true};
        std::uint32_t sent{0U};
        std::vector<SrdoView> a{};
        std::vector<SrdoView> b{};
        std::vector<std::uint64_t> values{};
        std::vector<std::size_t> different{}; ///< Places that are not as without the fault.
    };

    void OnCycle(std::size_t cycle, const Sight& sight) override;
    [[nodiscard]] Sighting See(SrdoMask open) const;
    void Tell(const char* who, const std::string& what);
    void TellChannel(const char* who, const std::vector<SrdoView>& was, const std::vector<SrdoView>& is);
    void TellValues(const Sighting& is);
    void TellDevice(const Sighting& is);
    [[nodiscard]] std::string Title() const;
    /// @brief Of the picture: some time behind the last moment, or the end of the run.
    [[nodiscard]] Nanoseconds PictureEnd() const;
    [[nodiscard]] std::string Picture() const;
    [[nodiscard]] std::string Lane(const std::string& name, const std::vector<Stretch>& stretches, int row) const;

    Session& session_;
    std::uint64_t number_;
    Experiment experiment_;
    Nanoseconds begin_;
    Nanoseconds now_{0};
    Sighting last_{};
    bool is_overdue_{false}; ///< It was, once.
    bool is_bad_frame_{false};
    Wrong wrong_{Wrong::kNothing}; ///< What the judge said last.
    std::vector<std::size_t> told_different_{};
    std::vector<Moment> moments_{};
    std::vector<Stretch> open_{};
    std::vector<Stretch> open_without_{};
    Outcome found_{};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_REPLAY_HPP
