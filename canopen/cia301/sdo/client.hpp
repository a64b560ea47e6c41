// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_CLIENT_HPP
#define CANOPEN_CIA301_SDO_CLIENT_HPP

#include "canopen/cia301/sdo/client_transfer.hpp"

namespace counterpoint::cia301
{

/// The client's side of one connection. `time_out_us` is the silence that ends a transfer, 2 to 2^30.
struct SdoClientParts
{
    FrameSink& sink; ///< Kept by reference.
    NodeId server;   ///< Default connection: 600h and 580h + node-ID.
    std::uint32_t time_out_us;
    std::uint8_t block_size; ///< Segments of a sub-block of an upload, 1 to 127.
};

/// SDO client of one server: one transfer at a time, without heap and without waiting: Start..., then OnFrame for each
/// frame from the bus and OnCycle at least once a cycle, until State is kDone or kAborted. Not reentrant.
class SdoClient
{
  public:
    /// @brief Idle; no server is asked anything before a Start... call.
    explicit SdoClient(const SdoClientParts& parts) noexcept;

    /// @brief Reads an object into `room`, which is kept until the end. False: busy. [SRS_SDC_001, SRS_SDC_002,
    /// SRS_SDC_003, SRS_SDC_004, SRS_SDC_005]
    [[nodiscard]] bool StartUpload(const ObjectAddress& target, const Room& room, SdoMode mode, Instant now) noexcept;
    /// @brief Writes an object from `value`, which is kept until the end. False: busy. [SRS_SDC_001, SRS_SDC_002,
    /// SRS_SDC_003, SRS_SDC_004, SRS_SDC_005]
    [[nodiscard]] bool StartDownload(const ObjectAddress& target, const Bytes& value, SdoMode mode,
                                     Instant now) noexcept;
    /// @brief A frame from the bus; what is no answer of the server is ignored. [SRS_SDC_001, SRS_SDC_002, SRS_SDC_003,
    /// SRS_SDC_004, SRS_SDC_005, SRS_SDC_006, SRS_SDC_007]
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Sends what is to be sent until the sink is full, and watches the time. [SRS_SDC_006]
    void OnCycle(Instant now) noexcept;
    /// @brief Ends a running transfer with an abort, of which the server is told. Nothing without a transfer.
    /// [SRS_SDC_009]
    void Cancel(SdoAbort reason) noexcept;
    /// @brief Whether a transfer that is started waits for OnCycle before anything of it leaves; at first it does not.
    /// [SRS_SDC_210]
    void Hold(const bool is_held) noexcept
    {
        is_held_ = is_held;
    }
    /// @brief The server restarted (boot-up message): nothing old is under way; a running transfer has failed.
    /// [SRS_SDC_008]
    void OnServerRestart() noexcept;
    /// @brief Asks another server from now on, by its default identifiers. False: a transfer runs. With the present
    /// server nothing changes.
    [[nodiscard]] bool Connect(NodeId server) noexcept;
    /// @brief As above, with identifiers of its own. [SRS_SDC_011]
    [[nodiscard]] bool Connect(const SdoConnection& connection) noexcept;

    /// @brief What the transfer is doing.
    [[nodiscard]] SdoClientState State() const noexcept
    {
        return transfer_.State();
    }
    /// @brief How the last transfer ended; has a meaning with kDone and kAborted.
    [[nodiscard]] const SdoOutcome& Outcome() const noexcept
    {
        return transfer_.Outcome();
    }
    /// @brief Node-ID of the present server.
    [[nodiscard]] NodeId Server() const noexcept
    {
        return transfer_.Link().Connection().server;
    }

  private:
    enum class Phase : std::uint8_t
    {
        kIdle = 0U,
        kMark = 1U,    ///< Waits for the answer to the mark.
        kRunning = 2U, ///< The transfer began.
        kQueued = 3U,  ///< A frame of the transfer before has not left yet.
    };

    [[nodiscard]] bool Start(const SdoJob& job, Instant now) noexcept;
    void Begin() noexcept;
    void OnMark(const SdoFrame& answer) noexcept;
    void GiveUp(SdoAbort reason) noexcept;
    [[nodiscard]] bool IsBusy() const noexcept;

    SdoClientTransfer transfer_;
    Phase phase_;
    std::uint32_t time_out_us_;
    std::uint8_t block_size_;
    bool is_held_;
};

} // namespace counterpoint::cia301

#endif
