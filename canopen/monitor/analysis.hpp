// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_ANALYSIS_HPP
#define CANOPEN_MONITOR_ANALYSIS_HPP

#include "canopen/monitor/error_control.hpp"
#include "canopen/monitor/gfc_watch.hpp"
#include "canopen/monitor/network.hpp"
#include "canopen/monitor/srdo_watch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

namespace counterpoint::monitor
{
/// A violation, and the watches that see it. What is wrong with the frames alone is seen by each consumer of the pair;
/// a missing SRDO after a GFC by no watch.
struct Violation
{
    Breach breach;
    std::vector<std::size_t> watches;
};

/// What a frame is for, by its identifier.
enum class Service : std::uint8_t
{
    kNmt = 0U,
    kGfc = 1U,
    kSync = 2U,
    kEmergency = 3U,
    kTime = 4U,
    kSrdo = 5U,
    kPdo = 6U,
    kSdo = 7U,
    kErrorControl = 8U, ///< Boot-up, heartbeat, guarding.
    kLss = 9U,
    kOther = 10U,   ///< An identifier of 11 bits that no file names.
    kForeign = 11U, ///< Extended, CAN FD, error frames.
};
constexpr std::size_t kServiceCount = 12U;

/// Its name for people.
[[nodiscard]] const char* ServiceName(Service service) noexcept;

/// Supervises all SRDOs of a network, and GFC. [SRS_MON_005, SRS_MON_006, SRS_MON_007, SRS_MON_008, SRS_MON_009,
/// SRS_MON_010, SRS_MON_016, SRS_MON_710]
class Analysis final : private BreachSink
{
  public:
    using Listener = std::function<void(const Violation&)>;

    /// @brief `network` is kept by reference. Violations are told in the order of their times.
    Analysis(const Network& network, Listener listener);

    /// @brief Takes the next frame; its time is not before that of the frame before.
    void Take(const LogFrame& frame);
    /// @brief No frame came until `now`: limits that have expired are told.
    void Advance(Time now);
    /// @brief Frames from now until the next call of Take or Advance are not seen: no frame is awaited any more.
    /// [SRS_MON_120]
    void Interrupt() noexcept;

    /// @brief Nothing follows: times without a valid pair that are longer than SCT by now are cycles, too.
    void End() noexcept;

    /// @brief All watches, in the order of Network::Watches.
    [[nodiscard]] const std::deque<SrdoWatch>& Watches() const noexcept
    {
        return watches_;
    }
    /// @brief Violations of one watch by cause.
    [[nodiscard]] const std::array<std::size_t, kCauseCount>& CountsOf(std::size_t watch) const;
    /// @brief Number of frames by service.
    [[nodiscard]] const std::array<std::size_t, kServiceCount>& Frames() const noexcept
    {
        return frames_;
    }
    /// @brief Number of violations.
    [[nodiscard]] std::size_t ViolationCount() const noexcept
    {
        return violation_count_;
    }
    /// @brief Number of frames.
    [[nodiscard]] std::size_t FrameCount() const noexcept
    {
        return frame_count_;
    }
    /// @brief When the watching began: by the first frame, or by a look at the clock before it.
    [[nodiscard]] Time First() const noexcept
    {
        return first_;
    }
    /// @brief Until when it has come.
    [[nodiscard]] Time Last() const noexcept
    {
        return last_;
    }
    /// @brief Times of the first and the last frame; only with a FrameCount above 0.
    [[nodiscard]] std::pair<Time, Time> FrameTimes() const noexcept
    {
        return {first_frame_, last_frame_};
    }
    /// @brief What a frame is for.
    [[nodiscard]] Service ServiceOf(const LogFrame& frame) const noexcept;

  private:
    static constexpr std::uint32_t kIdentifiers = 0x800U;

    void OnBreach(std::size_t watch, const Breach& breach) override;
    void Tell();
    void Open(Time now);
    void FollowNodes(const LogFrame& frame);
    void StopNode(std::uint8_t node_id);

    const Network& network_;
    Listener listener_;
    std::deque<SrdoWatch> watches_;
    GfcWatch gfc_;
    ErrorControl error_control_;
    std::array<std::vector<std::size_t>, kIdentifiers> watches_of_;
    std::array<Service, kIdentifiers> services_;
    std::vector<std::array<std::size_t, kCauseCount>> counts_;
    std::array<std::size_t, kServiceCount> frames_{};
    std::vector<Violation> fresh_; ///< Seen since Tell.
    Time next_deadline_;           ///< Not after the deadline of any watch.
    bool has_begun_{false};
    bool is_blind_{true}; ///< What was before the next call was not seen.
    Time first_{0};
    Time last_{0};
    Time first_frame_{0};
    Time last_frame_{0};
    std::size_t frame_count_{0U};
    std::size_t violation_count_{0U};
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_ANALYSIS_HPP
