// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_SDO_POOL_HPP
#define CANOPEN_CIA302_NETWORK_SDO_POOL_HPP

#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>
#include <utility>

namespace counterpoint::cia302
{

using cia301::Room;
using cia301::SdoAbort;
using cia301::SdoMode;
using cia301::SdoOutcome;

/// What the transfer of a node is doing.
enum class TransferState : std::uint8_t
{
    kIdle = 0U,
    kBusy = 1U,
    kDone = 2U,
    kFailed = 3U, ///< Aborted by the server, or no answer to any of the tries: see Outcome.
};

/// @brief Whether the slave answered a read, with more bytes than there was room for. [SRS_BOOT_480, SRS_PLC_480]
[[nodiscard]] constexpr bool IsTooLong(const SdoOutcome& outcome) noexcept
{
    return (outcome.abort == SdoAbort::kOutOfMemory) && !outcome.by_server;
}

/// One SDO client and the transfer that it was given.
struct SdoLane
{
    cia301::SdoClient client;
    TransferState state;
    ObjectAddress object;
    Room room;   ///< Of an upload.
    Bytes value; ///< Of a download.
    SdoMode mode;
    bool is_upload;
    std::uint8_t tries_left;
    std::uint8_t idle_cycles; ///< Cycles since the end; its user takes the outcome in the next cycle at the latest.
};

/// Times of all clients. CiA 302 names none: 100 ms and 3 tries are usual, slow devices need 2000 ms.
struct SdoTimes
{
    std::uint32_t time_out_us; ///< Silence that ends a try, 2 to 2^30.
    std::uint8_t tries;        ///< 1 to 255; only silence is tried again, an abort never.
};

/// Cycles after the end of a transfer, after which a lane may be given to another node.
constexpr std::uint8_t kSettled = 2U;

/// Where the lanes of a pool are; see SdoLanes.
struct SdoLaneRoom
{
    SdoLane* lanes;
    std::uint8_t count;
};

/// Room for `Count` lanes: as many slaves are served at the same time.
template <std::uint8_t Count> class SdoLanes
{
  public:
    SdoLanes(cia301::FrameSink& sink, const SdoTimes& times) noexcept
        : SdoLanes(sink, times, std::make_integer_sequence<std::uint8_t, Count>{})
    {
    }
    /// @brief The lanes for SdoPool; valid as long as this stands.
    [[nodiscard]] SdoLaneRoom All() noexcept
    {
        return SdoLaneRoom{lanes_, Count};
    }

  private:
    template <std::uint8_t... Index>
    SdoLanes(cia301::FrameSink& sink, const SdoTimes& times, std::integer_sequence<std::uint8_t, Index...>) noexcept
        : lanes_{Lane(sink, times, Index)...}
    {
    }
    [[nodiscard]] static SdoLane Lane(cia301::FrameSink& sink, const SdoTimes& times, const std::uint8_t index) noexcept
    {
        const NodeId node{static_cast<std::uint8_t>(index + 1U)};
        return SdoLane{cia301::SdoClient{cia301::SdoClientParts{sink, node, times.time_out_us, 127U}},
                       TransferState::kIdle,
                       ObjectAddress{0U, 0U},
                       Room{nullptr, 0U},
                       Bytes{nullptr, 0U},
                       SdoMode::kInvalid,
                       false,
                       0U,
                       kSettled};
    }

    SdoLane lanes_[Count];
};

/// The SDO connections to all slaves: one transfer a slave at a time, many slaves at the same time. A node has a lane
/// from its first transfer on; with fewer lanes than nodes an idle one changes hands. Late answers to a transfer that
/// was given up are never taken for answers to a later one (see SdoClient). Not reentrant. [SRS_NMM_030, SRS_NMM_031,
/// SRS_NMM_032]
class SdoPool
{
  public:
    SdoPool(const SdoLaneRoom& room, const SdoTimes& times) noexcept;

    /// @brief Reads an object into `room`, kept until the end. False: this node is busy, or all lanes are.
    [[nodiscard]] bool Upload(NodeId node, const ObjectAddress& object, const Room& room, SdoMode mode,
                              Instant now) noexcept;
    /// @brief Writes an object from `value`, kept until the end. False: this node is busy, or all lanes are.
    [[nodiscard]] bool Download(NodeId node, const ObjectAddress& object, const Bytes& value, SdoMode mode,
                                Instant now) noexcept;
    /// @brief The running transfer of this node is not tried again: its first silence is its end.
    void TryOnce(NodeId node) noexcept;
    /// @brief State of the node's last transfer; kIdle if its lane was given to another node.
    [[nodiscard]] TransferState State(NodeId node) const noexcept;
    /// @brief How the node's last transfer ended; has a meaning with kDone and kFailed. `abort` is kTimeOut with
    /// !by_server if nobody answered.
    [[nodiscard]] SdoOutcome Outcome(NodeId node) const noexcept;
    /// @brief Whether any transfer ran at the last OnCycle, or less than a time-out before it.
    [[nodiscard]] bool IsBusy() const noexcept
    {
        return quiet_us_ < times_.time_out_us;
    }
    /// @brief Silence that ends a try, in us.
    [[nodiscard]] std::uint32_t TimeOutUs() const noexcept
    {
        return times_.time_out_us;
    }
    /// @brief Gives a running transfer up; it is kFailed with this reason.
    void Cancel(NodeId node, SdoAbort reason) noexcept;
    /// @brief The boot-up message of a node: its running transfer is kFailed with kNoConnection.
    void OnBootUp(NodeId node) noexcept;

    /// @brief A frame from the bus. O(lanes)
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Sends, watches times, tries again. Once a cycle. O(lanes)
    void OnCycle(Instant now) noexcept;

  private:
    [[nodiscard]] SdoLane* Find(NodeId node) const noexcept;
    [[nodiscard]] SdoLane* Claim(NodeId node) noexcept;
    static void Begin(SdoLane& lane, Instant now) noexcept;
    static void Settle(SdoLane& lane, Instant now) noexcept;

    SdoLaneRoom room_;
    SdoTimes times_;
    Instant last_;           ///< OnCycle.
    std::uint32_t quiet_us_; ///< Since a transfer ran, up to the time-out.
};

} // namespace counterpoint::cia302

#endif
