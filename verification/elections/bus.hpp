// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_BUS_HPP
#define VERIFICATION_ELECTIONS_BUS_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace counterpoint::elections
{

/// Microseconds of the simulated world; 0 is its beginning.
using Time = std::int64_t;
constexpr Time kNever = std::numeric_limits<Time>::max();
constexpr Time kMs = 1000;
constexpr Time kSecond = 1'000'000;

/// Who hears of frames.
class BusUser
{
  public:
    virtual ~BusUser() = default;
    /// @brief A frame is complete. `senders` are those who sent it, one or several at the same time.
    virtual void OnComplete(const CanFrame& frame, const std::vector<std::size_t>& senders) = 0;
    /// @brief A controller went bus-off; its frames are gone.
    virtual void OnBusOff(std::size_t node) = 0;
};

/// One CAN bus with the durations of real frames, light enough for millions of elections. What matters for an election
/// is as on the wire: frames that start at the same instant compete by identifier, equal ones are one frame, and two
/// with the same identifier and different data destroy each other again and again until their senders are bus-off. A
/// frame that nobody else could acknowledge waits. hal/host/virtual/bus.hpp is the complete model; a test compares
/// them.
class Bus
{
  public:
    /// @brief `bit_us`: duration of a bit, at least 1 us.
    Bus(BusUser& user, Time bit_us);

    /// @brief No frames, no errors.
    void Clear(std::size_t nodes);
    /// @brief Whether there was room in the node's queue.
    bool Submit(std::size_t node, const CanFrame& frame);
    /// @brief The node's queue is emptied.
    void Drop(std::size_t node);
    /// @brief Which nodes hear each other; a frame under way is destroyed and sent again.
    void Attach(std::size_t node, bool is_attached, Time now);
    /// @brief The node hangs on another part of the bus from now on, with what waits in its controller.
    void Move(std::size_t node, Bus& to, Time now);

    [[nodiscard]] Time Next() const;
    /// @brief The end of a frame at `now`: deliveries. Before the devices do something at `now`.
    void Finish(Time now);
    /// @brief The start of a frame at `now`, after the devices did something at `now`.
    void Arbitrate(Time now);

    [[nodiscard]] bool IsAttached(const std::size_t node) const
    {
        return attached_[node] != 0U;
    }
    [[nodiscard]] Time BitUs() const
    {
        return bit_us_;
    }
    /// @brief Complete frames and destroyed ones since Clear.
    [[nodiscard]] std::uint32_t Frames() const
    {
        return frames_;
    }
    [[nodiscard]] std::uint32_t Collisions() const
    {
        return collisions_;
    }

  private:
    struct Waiting
    {
        CanFrame frame;
        std::size_t node;
    };
    static constexpr std::size_t kQueue = 16U;

    void Choose();
    [[nodiscard]] std::uint16_t FirstDifference() const;
    void Destroy();

    BusUser& user_;
    Time bit_us_;
    std::vector<Waiting> waiting_{};
    std::vector<std::uint8_t> attached_{};
    std::vector<std::uint16_t> errors_{};
    std::vector<std::size_t> senders_{}; ///< Of the frame under way.
    CanFrame frame_{};
    Time free_at_{0};
    Time frame_end_{kNever};
    std::size_t attached_count_{0U};
    std::size_t ready_{0U}; ///< Waiting frames of attached nodes.
    std::uint32_t frames_{0U};
    std::uint32_t collisions_{0U};
    bool is_collision_{false};
};

} // namespace counterpoint::elections

#endif
