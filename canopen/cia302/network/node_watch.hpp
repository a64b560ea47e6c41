// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_NODE_WATCH_HPP
#define CANOPEN_CIA302_NETWORK_NODE_WATCH_HPP

#include "canopen/cia302/network/answer_watch.hpp"
#include "canopen/cia302/network/setup.hpp"
#include "safety_core/contract/can_frame.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// The last emergency message of a node.
struct EmergencyRecord
{
    std::uint16_t code;
    std::uint8_t error_register;
    std::uint8_t details[5];
    std::uint32_t count;  ///< Number of messages since the begin.
    std::uint32_t untold; ///< How many messages were not told since the last one that was.
    Instant told;         ///< When the last one was told; only with `has_told`.
    bool has_told;
};

/// What is watched of one node. Zero-filled at first.
struct WatchedNode
{
    EmergencyRecord emergency;
    std::uint16_t fault; ///< First emergency code of 5000h to 7FFFh that the device has not taken back; 0: none.
    AskedNode asked;
    Instant window;     ///< Begin of the window in which signs of life are counted.
    std::uint8_t signs; ///< In it.
    bool is_duplicate;  ///< Suspected since the last OnReset.
    bool has_own_time;  ///< It refused 1017h, and has taken none since: how often it sends heartbeats nobody has set.
};

/// Is told what concerns the whole network, beside start-up and supervision.
class NodeWatchListener
{
  public:
    /// @brief An emergency message; of a storm one each kEmergencyGapUs, the last one always. `untold` counts those
    /// left out before it.
    virtual void OnEmergency(NodeId node, const EmergencyRecord& emergency, Instant now) noexcept = 0;
    /// @brief More signs of life or answers than one device sends, or one of the manager's own node-ID. Once until
    /// OnReset.
    virtual void OnDuplicate(NodeId node, Instant now) noexcept = 0;

  protected:
    NodeWatchListener() noexcept = default;
    ~NodeWatchListener() noexcept = default;
    NodeWatchListener(const NodeWatchListener&) = default;
    NodeWatchListener& operator=(const NodeWatchListener&) = default;
};

constexpr std::uint32_t kEmergencyGapUs = 100'000U;

/// Emergency messages, and node-IDs that two devices have. Two devices with one node-ID answer SDOs with each other's
/// values; they show themselves by heartbeats that come too often: kWindowSigns in kWindowPeriods producer times, where
/// one device sends eleven, counted anew from each boot-up message, unless it refused that time (1017h); and by second
/// answers, see AnswerWatch. Not reentrant. [SRS_MGR_010, SRS_MGR_011, SRS_MGR_015, SRS_MGR_083, SRS_MGR_224]
class NodeWatch
{
  public:
    static constexpr std::uint8_t kWindowPeriods = 10U;
    static constexpr std::uint8_t kWindowSigns = 18U;

    /// @brief `nodes` has kNodeRoom elements; all kept by reference.
    NodeWatch(const NetworkSetup& setup, WatchedNode* nodes, NodeWatchListener& listener) noexcept;

    /// @brief A frame from the bus, never one of this device itself. O(127)
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Tells the last emergency message of a storm that has ended. Once a cycle. O(127)
    void OnCycle(Instant now) noexcept;
    /// @brief A frame of this device was on the bus. Without these calls second answers are not seen. As OnFrame
    void OnSent(const CanFrame& frame) noexcept;
    /// @brief The heartbeat time of the node is not known any more: its heartbeats are counted from the next one on.
    /// O(1)
    void CountAnew(NodeId node) noexcept;
    /// @brief Frames were lost, perhaps those that asked: what was asked of all nodes, and how often they answered and
    /// showed themselves, is counted from here on. O(127)
    void OnLost() noexcept;
    /// @brief One node, or all with node 0, was reset: what was suspected may be over. O(127)
    void OnReset(NodeId node) noexcept;
    /// @brief Who tells an emergency by this frame; node 0: it is none, or nobody's. O(127) [SRS_MGR_025]
    [[nodiscard]] NodeId EmergencySender(const CanFrame& frame) const noexcept;
    /// @brief `node` is 1 to 127, checked by the caller.
    [[nodiscard]] const WatchedNode& Of(NodeId node) const noexcept;

  private:
    void OnEmergency(NodeId node, const CanFrame& frame, Instant now) noexcept;
    void Tell(NodeId node, Instant now) noexcept;
    void OnSign(NodeId node, std::uint8_t byte, Instant now) noexcept;
    void OnReset(const CanFrame& frame) noexcept;
    void OnAnswer(NodeId node, const CanFrame& frame, Instant now) noexcept;
    void OnTime(NodeId node, const CanFrame& frame) noexcept;
    void Suspect(NodeId node, Instant now) noexcept;

    const NetworkSetup& setup_;
    WatchedNode* nodes_;
    NodeWatchListener& listener_;
};

} // namespace counterpoint::cia302

#endif
