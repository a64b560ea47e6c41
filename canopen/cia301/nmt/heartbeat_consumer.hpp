// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_HEARTBEAT_CONSUMER_HPP
#define CANOPEN_CIA301_NMT_HEARTBEAT_CONSUMER_HPP

#include "canopen/cia301/base/abort_code.hpp"
#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{

/// What the consumer tells of a supervised node.
enum class HeartbeatEvent : std::uint8_t
{
    kInvalid = 0U,
    kStarted = 1U, ///< First heartbeat: supervision runs.
    kChanged = 2U, ///< Another state than before.
    kBootUp = 3U,  ///< The node restarted: supervision waits.
    kLost = 4U,    ///< Silence above the time: supervision waits.
};

/// Is told what happens to supervised nodes. It may read the consumer, but not change it.
class HeartbeatListener
{
  public:
    /// @brief `state` is the state byte that the node sent; with kLost the one of its last heartbeat.
    virtual void OnHeartbeat(NodeId node, HeartbeatEvent event, std::uint8_t state) noexcept = 0;

  protected:
    HeartbeatListener() noexcept = default;
    ~HeartbeatListener() noexcept = default;
    HeartbeatListener(const HeartbeatListener&) = default;
    HeartbeatListener& operator=(const HeartbeatListener&) = default;
};

/// One sub-index of 1016h and what is known of its node. Zero-filled at first.
struct SupervisedNode
{
    std::uint32_t config;
    Instant last;
    std::uint8_t state;
    bool is_running;
};

/// Room for the entries of 1016h, kept by reference.
struct SupervisedNodes
{
    SupervisedNode* nodes;
    std::uint8_t count;
};

/// Supervises other nodes by their heartbeats, as 1016h says. Call Poll at least once in 2^30 us. Not reentrant.
class HeartbeatConsumer
{
  public:
    HeartbeatConsumer(const SupervisedNodes& room, HeartbeatListener& listener) noexcept;

    /// @brief Writes 1016h, sub-index 1 to count; supervision of this entry waits anew. O(count) [SRS_HB_003]
    [[nodiscard]] SdoAbort Write(std::uint8_t sub, std::uint32_t value) noexcept;
    /// @brief The same for a value of a configuration: nodes may be there twice until EndLoad. O(1) [SRS_OBD_016]
    [[nodiscard]] SdoAbort Load(std::uint8_t sub, std::uint32_t value) noexcept;
    /// @brief The configuration is whole: of two entries of one node the later one is 0. O(count^2)
    void EndLoad() noexcept;
    /// @brief Reads 1016h, sub-index 1 to count; 0 elsewhere.
    [[nodiscard]] std::uint32_t Value(std::uint8_t sub) const noexcept;
    /// @brief A frame from the bus. O(count) [SRS_HB_004, SRS_HB_005, SRS_HB_006]
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Tells the listener who was lost. O(1), O(count) when somebody may be [SRS_HB_004]
    void Poll(Instant now) noexcept;

  private:
    [[nodiscard]] SdoAbort Judge(std::uint8_t sub, std::uint32_t value) const noexcept;
    void Take(SupervisedNode& node, std::uint8_t state, Instant now) noexcept;
    void Look(Instant now) noexcept;

    SupervisedNodes room_;
    HeartbeatListener& listener_;
    Instant looked_;          ///< When all entries were looked at.
    std::uint32_t silent_us_; ///< So long after `looked_` nobody can be lost; a heartbeat only puts it off.
};

} // namespace counterpoint::cia301

#endif
