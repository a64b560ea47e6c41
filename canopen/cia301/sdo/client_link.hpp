// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_CLIENT_LINK_HPP
#define CANOPEN_CIA301_SDO_CLIENT_LINK_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/sdo/server.hpp"

namespace counterpoint::cia301
{

/// Where a server is reached. The default one of a node: 600h and 580h + node-ID.
struct SdoConnection
{
    std::uint32_t request; ///< Identifier from client to server.
    std::uint32_t answer;  ///< Identifier from server to client.
    NodeId server;
};

/// What a client sends to its server, a frame at a time, which waits here until the sink takes it; and the marks.
///
/// After a transfer that the client gave up an answer may still be under way. The next transfer is therefore preceded
/// by one request that the server answers with a mark of its own (sub-index of 1000h): answers come in order, so that
/// nothing from before that mark is taken for an answer to what follows. [SRS_SDC_008]
class SdoClientLink
{
  public:
    SdoClientLink(FrameSink& sink, const SdoConnection& connection) noexcept;

    /// @brief Another server from now on; without a change nothing happens.
    void Connect(const SdoConnection& connection) noexcept;
    /// @brief The present server and its identifiers.
    [[nodiscard]] const SdoConnection& Connection() const noexcept
    {
        return connection_;
    }
    /// @brief The server restarted: nothing old is under way.
    void OnServerRestart() noexcept
    {
        is_sending_ = false;
        is_doubtful_ = false;
    }

    /// @brief Sets the time of the running call.
    void SetNow(const Instant now) noexcept
    {
        now_ = now;
    }
    /// @brief The server was heard now.
    void OnHeard() noexcept
    {
        last_ = now_;
    }
    /// @brief Time since the last frame of the server or to the server, in us.
    [[nodiscard]] std::uint32_t SilenceUs(const Instant now) const noexcept
    {
        return now.us - last_.us;
    }

    /// @brief Sends a request: command byte, object, 4 bytes of data.
    void Request(std::uint8_t command, const ObjectAddress& target, std::uint32_t value) noexcept;
    /// @brief Sends a frame, or keeps it until Flush finds room.
    void Emit(const SdoFrame& frame) noexcept;
    /// @brief Tries to send the frame that is kept. True: no frame is kept any more.
    [[nodiscard]] bool Flush() noexcept;
    /// @brief The frame that is kept is not sent any more.
    void Drop() noexcept
    {
        is_sending_ = false;
    }
    /// @brief Gives up what was asked of `target`: the server is told, and may have answered already.
    void Abort(const ObjectAddress& target, SdoAbort reason) noexcept;

    /// @brief Whether answers from before may be under way.
    [[nodiscard]] bool IsDoubtful() const noexcept
    {
        return is_doubtful_;
    }
    /// @brief The next transfer is about `target`: the mark that is sent before it must not look like a request for it.
    void OnBegin(const ObjectAddress& target) noexcept
    {
        stale_ = target;
    }
    /// @brief Sends the next mark.
    void SendMark() noexcept;
    /// @brief Whether this is the answer to the mark. If it is, nothing is in doubt any more.
    [[nodiscard]] bool TakeMark(const SdoFrame& answer) noexcept;
    /// @brief The object that the last mark asked for.
    [[nodiscard]] ObjectAddress Mark() const noexcept;

  private:
    FrameSink& sink_;
    SdoConnection connection_;
    SdoFrame waiting_;
    ObjectAddress stale_; ///< Object of the last request: no mark may look like it.
    Instant now_;         ///< Of the running call.
    Instant last_;        ///< Last frame of the server, or last one sent.
    std::uint8_t mark_;   ///< Sub-index of the last mark.
    bool is_sending_;     ///< `waiting_` found no room in the sink.
    bool is_doubtful_;    ///< Answers from before may be under way.
    bool has_given_up_;   ///< Ever: a server that is returned to is in doubt.
};

/// @brief Whether an answer names this object.
[[nodiscard]] bool IsFor(const SdoFrame& answer, const ObjectAddress& target) noexcept;

} // namespace counterpoint::cia301

#endif
