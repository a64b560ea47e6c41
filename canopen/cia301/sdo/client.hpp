// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_CLIENT_HPP
#define CANOPEN_CIA301_SDO_CLIENT_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia301/sdo/server.hpp"

namespace counterpoint::cia301
{

enum class SdoMode : std::uint8_t
{
    kInvalid = 0U,
    kNormal = 1U, ///< Expedited up to 4 bytes, else segments.
    kBlock = 2U,  ///< Blocks with CRC; a server may answer an upload as kNormal.
};

enum class SdoClientState : std::uint8_t
{
    kIdle = 0U,
    kBusy = 1U,
    kDone = 2U,    ///< See Outcome; a new transfer may start.
    kAborted = 3U, ///< See Outcome; a new transfer may start.
};

/// How a transfer ended.
struct SdoOutcome
{
    SdoAbort abort;           ///< kNone: done.
    bool by_server;           ///< The abort code came from the server.
    std::uint32_t size_bytes; ///< Bytes transferred.
};

/// Where a server is reached. The default one of a node: 600h and 580h + node-ID.
struct SdoConnection
{
    std::uint32_t request; ///< Identifier from client to server.
    std::uint32_t answer;  ///< Identifier from server to client.
    NodeId server;
};

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
///
/// After a transfer that the client gave up an answer may still be under way. The next transfer is therefore preceded
/// by one request that the server answers with a mark of its own (sub-index of 1000h): answers come in order, so that
/// nothing from before that mark is taken for an answer to what follows. [SRS_SDC_008]
class SdoClient
{
  public:
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
    /// @brief Gives a running transfer up with an abort. [SRS_SDC_009]
    void Cancel(SdoAbort reason) noexcept;
    /// @brief The server restarted (boot-up message): nothing old is under way; a running transfer has failed.
    /// [SRS_SDC_008]
    void OnServerRestart() noexcept;
    /// @brief Another server from now on; only while no transfer runs. Without a change of server nothing happens.
    [[nodiscard]] bool Connect(NodeId server) noexcept;
    /// @brief The same with identifiers of its own. [SRS_SDC_011]
    [[nodiscard]] bool Connect(const SdoConnection& connection) noexcept;

    [[nodiscard]] SdoClientState State() const noexcept;
    [[nodiscard]] const SdoOutcome& Outcome() const noexcept;
    [[nodiscard]] NodeId Server() const noexcept;

  private:
    enum class Phase : std::uint8_t
    {
        kIdle = 0U,
        kMark = 1U,            ///< Waits for the answer to the mark.
        kDownloadBegin = 2U,   ///< Waits for 60h.
        kDownloadSegment = 3U, ///< Waits for 20h.
        kUploadBegin = 4U,     ///< Waits for 4xh.
        kUploadSegment = 5U,   ///< Waits for 0xh.
        kBlockDownloadBegin = 6U,
        kBlockDownload = 7U, ///< Segments go.
        kBlockDownloadAck = 8U,
        kBlockDownloadEnd = 9U,
        kBlockUploadBegin = 10U,
        kBlockUpload = 11U, ///< Segments come.
        kBlockUploadEnd = 12U,
        kQueued = 13U, ///< A frame of the transfer before has not left yet.
    };

    [[nodiscard]] bool Start(const ObjectAddress& target, SdoMode mode, bool is_upload, Instant now) noexcept;
    void Begin() noexcept;
    void BeginDownload() noexcept;
    void SendMark() noexcept;
    void Request(std::uint8_t command, const ObjectAddress& target, std::uint32_t value) noexcept;
    void Emit(const SdoFrame& frame) noexcept;
    [[nodiscard]] bool Flush() noexcept;
    void Finish() noexcept;
    void GiveUp(SdoAbort reason) noexcept;
    void Fail(SdoAbort reason, bool by_server) noexcept;
    void Dispatch(const SdoFrame& answer) noexcept;
    void DispatchBegin(const SdoFrame& answer) noexcept;
    void DispatchRest(const SdoFrame& answer) noexcept;
    void OnMark(const SdoFrame& answer) noexcept;

    void SendSegment() noexcept;
    void OnSegmentTaken(const SdoFrame& answer) noexcept;
    void OnUploadBegin(const SdoFrame& answer) noexcept;
    void OnUploadSegment(const SdoFrame& answer) noexcept;

    void OnBlockDownloadBegin(const SdoFrame& answer) noexcept;
    void SendBlockSegments() noexcept;
    void OnBlockAck(const SdoFrame& answer) noexcept;
    void OnBlockUploadBegin(const SdoFrame& answer) noexcept;
    void OnBlockSegment(const SdoFrame& answer) noexcept;
    void KeepBlockSegment(const SdoFrame& answer) noexcept;
    void AcknowledgeBlock() noexcept;
    void OnBlockUploadEnd(const SdoFrame& answer) noexcept;
    [[nodiscard]] SdoAbort CheckEnd(std::uint32_t size_bytes) const noexcept;

    SdoClientParts parts_;
    SdoConnection connection_;
    Phase phase_;
    SdoClientState state_;
    SdoMode mode_;
    SdoOutcome outcome_;
    ObjectAddress target_;
    ObjectAddress stale_;     ///< Object of the last request: no mark may look like it.
    Bytes source_;            ///< Of a download.
    Room room_;               ///< Of an upload.
    Instant now_;             ///< Of the running call.
    Instant last_;            ///< Last frame of the server, or last one sent.
    std::uint32_t length_;    ///< Bytes of a download; stated bytes of an upload, or kUnknownLength.
    std::uint32_t position_;  ///< Bytes sent and, in blocks, acknowledged; or bytes received.
    std::uint32_t crc_bytes_; ///< Bytes of a block upload that are in `crc_`.
    std::uint16_t crc_;
    std::uint8_t toggle_;   ///< 0 or 10h.
    std::uint8_t sequence_; ///< Last segment of the sub-block.
    std::uint8_t block_size_;
    std::uint8_t mark_; ///< Sub-index of the last mark.
    bool is_upload_;
    bool has_crc_;
    bool has_last_;     ///< The last segment went, or came in order.
    bool is_repeated_;  ///< The half time-out of this sub-block was used.
    bool is_doubtful_;  ///< Answers from before may be under way.
    bool has_given_up_; ///< Ever: a server that is returned to is in doubt.
    bool is_sending_;   ///< `waiting_` found no room in the sink.
    SdoFrame waiting_;
};

} // namespace counterpoint::cia301

#endif
