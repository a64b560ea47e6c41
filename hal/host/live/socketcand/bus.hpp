// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_SOCKETCAND_BUS_HPP
#define HAL_HOST_LIVE_SOCKETCAND_BUS_HPP

#include "hal/host/live/opened_bus.hpp"
#include "hal/host/live/socketcand/greeting.hpp"
#include "hal/host/live/socketcand/link.hpp"
#include "hal/host/live/socketcand/peer.hpp"

#include <cstdint>
#include <deque>
#include <string>

namespace counterpoint::host
{

/// A bus that a socketcand server offers: ours, or one by others. Frames have the time of their reading, because the
/// server's clock is not ours. With a server by others, own means that the server took the frame, not that it was on
/// the bus. A lost connection is opened again by the policy of the options. With LiveOptions::oldest_ms it asks the
/// server for an echo again and again: what comes behind an answer is younger than its question, and an answer that
/// does not come ends the connection. [SRS_LIVE_051] [SRS_LIVE_052] [SRS_LIVE_055] [SRS_LIVE_058] [SRS_LIVE_059]
/// [SRS_LIVE_581]
class LiveSocketcandBus final : public OpenedBus
{
  public:
    /// @brief Connects and greets the server. Throws LiveBusError.
    LiveSocketcandBus(const LiveAddress& address, const LiveOptions& options);

    [[nodiscard]] SendResult Send(const LiveFrame& frame) override;
    [[nodiscard]] bool Receive(LiveFrame& frame) override;

  private:
    [[noreturn]] void Refuse(const std::string& what) const;
    void Greet();
    void Begin();
    void Reconnect();
    void PlanReconnect();
    void Hand(const LiveFrame& frame);
    void SendWaiting();
    void NoteLoss();
    [[nodiscard]] bool Take(const SocketcandMessage& message, LiveFrame& frame);
    [[nodiscard]] bool IsStale(const LiveFrame& frame);
    void Ask();
    void TakeAnswer();
    void GiveUpOverdue();
    void Learn(const LiveFrame& frame);
    void LearnText(const std::string& text);

    std::uint64_t give_up_at_ns_; ///< On the connection that is being opened.
    SocketcandPeer peer_;
    SocketcandLink link_;
    SocketcandGreeting greeting_;
    /// Echoes that are to come: of frames sent to a server that does not tell own frames, and of questions (empty).
    std::deque<std::optional<LiveFrame>> unconfirmed_{};
    std::uint64_t asked_ns_{0U};    ///< The last question.
    bool is_asking_{false};         ///< It has no answer yet.
    std::uint64_t answered_ns_{0U}; ///< When the last question with an answer was sent.
    bool is_lost_{false};           ///< Until the greeting of the next connection is over.
    std::uint64_t retry_at_ns_{0U}; ///< Of the next connection.
};

} // namespace counterpoint::host

#endif
