// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_BUS_HPP
#define HAL_HOST_LIVE_BUS_HPP

#include "safety_core/contract/can_frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace counterpoint::host
{

constexpr std::size_t kLiveDataBytes = 64U;
constexpr std::uint8_t kClassicalDataBytes = 8U;
/// Frames that a bus keeps for the system when its queue is full.
constexpr std::size_t kLiveQueueFrames = 64U;
constexpr std::uint32_t kReconnectAfterMs = 500U;
constexpr std::uint32_t kQuestionMs = 20U; ///< See LiveOptions::oldest_ms.
/// Longer than a connection stands still that goes on by itself.
constexpr std::uint32_t kAnswerMs = 5000U;

/// One frame of a bus in real time. Bytes behind `length_bytes` have no meaning; a remote frame has no data.
struct LiveFrame
{
    std::uint32_t identifier{0U};  ///< 11 or 29 bits; of an error frame its classes (error.hpp reads them).
    std::uint8_t length_bytes{0U}; ///< 0 to 8, with `fd` one of the lengths of CAN FD up to 64.
    bool extended{false};          ///< Identifier of 29 bits.
    bool remote{false};
    bool fd{false};
    bool error{false}; ///< Not from the wire: what the controller tells about the bus.
    bool own{false};   ///< Came back after this bus object sent it: it was on the bus.
    std::uint8_t data[kLiveDataBytes]{};
    std::uint64_t time_ns{0U}; ///< CLOCK_MONOTONIC of reception; the kernel's receive stamp where there is one.
};

/// What became of a frame that was to be sent.
enum class SendResult : std::uint8_t
{
    kInvalid = 0U,
    kSent = 0x69U,   ///< Taken; goes out in the order of the calls.
    kQueueFull = 1U, ///< Not taken: kLiveQueueFrames wait already.
    kBusOff = 2U,    ///< Not taken.
    kDown = 3U,      ///< Not taken: the interface is down, or the connection is lost.
    kRefused = 4U,   ///< Not a frame that this bus can carry.
};

/// State of a bus, as far as its controller or the system tells.
enum class BusState : std::uint8_t
{
    kInvalid = 0U,
    kActive = 0x3CU,
    kWarning = 1U,
    kPassive = 2U,
    kBusOff = 3U,
    kDown = 4U,
};

/// State now and counts since the bus was opened. What a kind of bus cannot know stays 0.
struct BusHealth
{
    BusState state{BusState::kInvalid};
    std::uint8_t transmit_errors{0U}; ///< Error counters as the controller told them last.
    std::uint8_t receive_errors{0U};
    std::uint32_t bus_offs{0U};
    std::uint32_t restarts{0U};
    std::uint32_t error_frames{0U};
    std::uint32_t lost_frames{0U};    ///< Received by system or controller, dropped because nobody took them.
    std::uint32_t malformed{0U};      ///< Received, but no frame.
    std::uint32_t dropped_frames{0U}; ///< Accepted by Send, thrown away at bus-off or interface down.
    std::uint32_t waiting{0U};        ///< Accepted by Send, not yet taken by the system.
    std::uint32_t reconnects{0U};     ///< Lost connections that were opened again.
    std::uint32_t stale_frames{0U};   ///< Received, but perhaps older than LiveOptions::oldest_ms.
    /// Restarts by policy that the system refused: no rights, or it restarts by itself.
    std::uint32_t refused_restarts{0U};
    /// How often the bus went away (bus-off or down), also where it was back before anybody looked at `state`.
    std::uint32_t absences{0U};
    BusState absence{BusState::kInvalid}; ///< What the last of them was.
};

/// @brief Whether a bus in that state carries nothing.
[[nodiscard]] constexpr bool IsAway(const BusState state)
{
    return (state == BusState::kBusOff) || (state == BusState::kDown);
}

/// What happens after bus-off.
enum class RestartPolicy : std::uint8_t
{
    kInvalid = 0U,
    kManual = 1U, ///< Bus-off stays until Restart is called.
    kTimed = 2U,  ///< Restart `restart_after_ms` after bus-off.
};

/// Lets frames pass whose identifier equals `identifier` in the bits of `mask`, and has the same width.
struct IdentifierFilter
{
    std::uint32_t identifier{0U};
    std::uint32_t mask{0U};
    bool extended{false};
};

/// How a bus is opened.
struct LiveOptions
{
    RestartPolicy restart{RestartPolicy::kManual};
    std::uint32_t restart_after_ms{0U};
    /// A lost connection is opened again after so long, and so long after each attempt that fails; 0: it stays lost.
    std::uint32_t reconnect_after_ms{kReconnectAfterMs};
    /// Empty: every frame. Own frames pass by the same rule; error frames always pass.
    std::vector<IdentifierFilter> filters;
    /// A frame of others that a connection may have held for longer is left aside and counted; 0: none is. Of use where
    /// frames have the time of their reading: call Receive every kQuestionMs, also when the descriptor is quiet.
    std::uint32_t oldest_ms{0U};
    /// With `oldest_ms`: a connection whose server owes an answer for so long counts as lost.
    std::uint32_t answer_ms{kAnswerMs};
};

/// Says in one sentence what could not be opened, and why.
class LiveBusError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// A CAN bus in real time, for one thread. Nothing blocks. Call Receive until it returns false each time the descriptor
/// is readable, because that also sends what waits and carries out the restart policy. [SRS_LIVE_003, SRS_LIVE_004,
/// SRS_LIVE_005]
class LiveBus
{
  public:
    LiveBus() = default;
    virtual ~LiveBus() = default;
    LiveBus(const LiveBus&) = delete;
    LiveBus(LiveBus&&) = delete;
    LiveBus& operator=(const LiveBus&) = delete;
    LiveBus& operator=(LiveBus&&) = delete;

    /// @brief Takes a frame for transmission.
    [[nodiscard]] virtual SendResult Send(const LiveFrame& frame) = 0;
    /// @brief Takes the next frame; false: there is none now.
    [[nodiscard]] virtual bool Receive(LiveFrame& frame) = 0;
    /// @brief For poll (POLLIN): readable when Receive has something to give or to do. Owned by the bus.
    [[nodiscard]] virtual int Descriptor() const = 0;
    /// @brief State and counts.
    [[nodiscard]] virtual BusHealth Health() const = 0;
    /// @brief What was wrong with the last of Health().malformed, as a sentence; empty: nothing is known of it.
    [[nodiscard]] virtual std::string Problem() const
    {
        return {};
    }
    /// @brief The address by which the bus was opened.
    [[nodiscard]] virtual std::string Name() const = 0;
    /// @brief Leaves bus-off now. False: this bus cannot, or not at present.
    [[nodiscard]] virtual bool Restart() = 0;
};

/// @brief Opens `can0` or `socketcan:can0`, `socketcand:HOST:PORT/can0`, `udp:239.74.163.2:43113[?bitrate=N]`. Throws
/// LiveBusError. [SRS_LIVE_001]
[[nodiscard]] std::unique_ptr<LiveBus> OpenLiveBus(const std::string& address, const LiveOptions& options);
/// @brief The same with default options.
[[nodiscard]] std::unique_ptr<LiveBus> OpenLiveBus(const std::string& address);

/// @brief Whether a bus can carry the frame: an identifier within its width, a length of its format, no error frame.
[[nodiscard]] bool IsSendable(const LiveFrame& frame);
/// @brief Whether a frame passes the filters; without filters each one does.
[[nodiscard]] bool Passes(const std::vector<IdentifierFilter>& filters, const LiveFrame& frame);
/// @brief The frame as the kernel takes it, received by `port`; an error frame has kind kInvalid.
[[nodiscard]] CanFrame ToCanFrame(const LiveFrame& frame, CanPortId port);
/// @brief The frame as a live bus takes it.
[[nodiscard]] LiveFrame FromCanFrame(const CanFrame& frame);
/// @brief CLOCK_MONOTONIC, the clock of LiveFrame::time_ns.
[[nodiscard]] std::uint64_t LiveNow();
/// @brief Milliseconds from now until `time_ns`, rounded up, as poll takes them.
[[nodiscard]] int MillisecondsUntil(std::uint64_t time_ns);

} // namespace counterpoint::host

#endif
