// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_CLIENT_TRANSFER_HPP
#define CANOPEN_CIA301_SDO_CLIENT_TRANSFER_HPP

#include "canopen/cia301/sdo/client_link.hpp"

namespace counterpoint::cia301
{

/// By which of the SDO protocols a value is transferred.
enum class SdoMode : std::uint8_t
{
    kInvalid = 0U,
    kNormal = 1U, ///< Expedited up to 4 bytes, else segments.
    kBlock = 2U,  ///< Blocks with CRC; a server may answer an upload as kNormal.
};

/// What a client is doing.
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

/// What a client transfers.
struct SdoJob
{
    ObjectAddress target;
    SdoMode mode;
    bool is_upload;
    Bytes source;            ///< What a download writes.
    Room room;               ///< Where an upload puts the value.
    std::uint8_t block_size; ///< Segments of a sub-block of an upload.
};

/// One transfer of a client, expedited, in segments or in blocks: what the client asks, and what follows from the
/// answers.
class SdoClientTransfer
{
  public:
    /// @brief Idle; has a copy of the link.
    explicit SdoClientTransfer(const SdoClientLink& link) noexcept;

    /// @brief kBusy from now on; nothing is sent before Begin.
    void Take(const SdoJob& job) noexcept;
    /// @brief Sends the first request of the job.
    void Begin() noexcept;
    /// @brief Takes a frame of the server.
    void OnAnswer(const SdoFrame& answer) noexcept;
    /// @brief Sends as many segments of the sub-block as the sink takes.
    void SendBlockSegments() noexcept;
    /// @brief Half of the time-out has passed without a frame: the received part of a sub-block is acknowledged, once
    /// for each sub-block.
    void OnHalfTimeOut() noexcept;
    /// @brief Ends the transfer with `reason`, and tells the server.
    void GiveUp(SdoAbort reason) noexcept;
    /// @brief Ends the transfer with `reason`, without telling the server.
    void Fail(SdoAbort reason, bool by_server) noexcept;

    /// @brief The connection to the server.
    [[nodiscard]] SdoClientLink& Link() noexcept
    {
        return link_;
    }
    /// @brief The same, to look at.
    [[nodiscard]] const SdoClientLink& Link() const noexcept
    {
        return link_;
    }
    /// @brief What the transfer is doing.
    [[nodiscard]] SdoClientState State() const noexcept
    {
        return state_;
    }
    /// @brief How it ended; has a meaning with kDone and kAborted.
    [[nodiscard]] const SdoOutcome& Outcome() const noexcept
    {
        return outcome_;
    }

  private:
    enum class Phase : std::uint8_t
    {
        kIdle = 0U,
        kDownloadBegin = 1U,   ///< Waits for 60h.
        kDownloadSegment = 2U, ///< Waits for 20h.
        kUploadBegin = 3U,     ///< Waits for 4xh.
        kUploadSegment = 4U,   ///< Waits for 0xh.
        kBlockDownloadBegin = 5U,
        kBlockDownload = 6U, ///< Segments go.
        kBlockDownloadAck = 7U,
        kBlockDownloadEnd = 8U,
        kBlockUploadBegin = 9U,
        kBlockUpload = 10U, ///< Segments come.
        kBlockUploadEnd = 11U,
    };

    void BeginDownload() noexcept;
    void Finish() noexcept;
    void OnFirst(const SdoFrame& answer) noexcept;
    [[nodiscard]] bool IsFirstAgain(const SdoFrame& answer) const noexcept;
    void OnRest(const SdoFrame& answer) noexcept;

    void SendSegment() noexcept;
    void OnSegmentTaken(const SdoFrame& answer) noexcept;
    void OnUploadBegin(const SdoFrame& answer) noexcept;
    void OnUploadSegment(const SdoFrame& answer) noexcept;

    void OnBlockDownloadBegin(const SdoFrame& answer) noexcept;
    void OnBlockAck(const SdoFrame& answer) noexcept;
    void OnBlockUploadBegin(const SdoFrame& answer) noexcept;
    void OnBlockSegment(const SdoFrame& answer) noexcept;
    void KeepBlockSegment(const SdoFrame& answer) noexcept;
    void AcknowledgeBlock() noexcept;
    void OnBlockUploadEnd(const SdoFrame& answer) noexcept;
    [[nodiscard]] SdoAbort CheckEnd(std::uint32_t size_bytes) const noexcept;

    SdoClientLink link_;
    SdoJob job_;
    Phase phase_;
    SdoClientState state_;
    SdoOutcome outcome_;
    std::uint32_t length_;    ///< Bytes of a download; stated bytes of an upload, or kUnknownLength.
    std::uint32_t position_;  ///< Bytes sent and, in blocks, acknowledged; or bytes received.
    std::uint32_t crc_bytes_; ///< Bytes of a block upload that are in `crc_`.
    std::uint16_t crc_;
    std::uint8_t toggle_;   ///< 0 or 10h.
    std::uint8_t sequence_; ///< Last segment of the sub-block.
    std::uint8_t block_size_;
    std::uint8_t first_; ///< Command of the first answer.
    bool is_begun_;      ///< Nothing came since the first answer.
    bool has_crc_;
    bool has_last_;    ///< The last segment went, or came in order.
    bool is_repeated_; ///< The half time-out of this sub-block was used.
};

} // namespace counterpoint::cia301

#endif
