// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_SDO_SERVER_HPP
#define CANOPEN_CIA301_SDO_SERVER_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/sdo/block_rest.hpp"

#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

constexpr std::uint8_t kMaxBlockSize = 127U;
constexpr std::uint32_t kSegmentBytes = 7U;

/// The 8 bytes of an SDO frame.
struct SdoFrame
{
    std::uint8_t bytes[8];
};

/// Whether there is a frame to be sent.
enum class SdoPresence : std::uint8_t
{
    kNothing = 0U, ///< Nothing is to be sent.
    kFrame = 0x53U,
};

/// What is to be sent to the client now.
struct SdoAnswer
{
    SdoPresence presence;
    SdoFrame frame; ///< Only with kFrame.
};

/// What a server works with. `buffer` holds the value of one transfer that is not expedited, so it is as long as the
/// longest object.
struct SdoServerParts
{
    Dictionary& dictionary;
    Room buffer;
    std::uint32_t time_out_us; ///< 2 to 2^31 - 1.
    std::uint8_t block_size;   ///< Segments of a sub-block of a download, 1 to 127.
};

/// One SDO server: one client, one transfer at a time. It keeps its parts by reference, has no clock and sends nothing.
/// Not reentrant. Order of use: OnFrame for each received frame of 8 bytes of its COB-ID; Poll as often as frames can
/// be sent and at least once a cycle, until it answers kNothing.
///
/// Invariants: `position_` <= `length_` while uploading; nothing is written to the dictionary before the last byte of a
/// transfer is there; after an abort in either direction the phase is kIdle.
class SdoServer
{
  public:
    /// @brief No transfer runs at first.
    explicit SdoServer(const SdoServerParts& parts) noexcept;

    /// @brief A request of the client. Frames of another length than 8 are ignored. O(length of the object) at the
    /// begin of an upload and the end of a download, else O(block) [SRS_SDO_001, SRS_SDO_002, SRS_SDO_003, SRS_SDO_004,
    /// SRS_SDO_005, SRS_SDO_006, SRS_SDO_150, SRS_SDO_007, SRS_SDO_008, SRS_SDO_009, SRS_SDO_010, SRS_SDO_011,
    /// SRS_SDO_012, SRS_SDO_013, SRS_SDO_160]
    [[nodiscard]] SdoAnswer OnFrame(const SdoFrame& request, std::uint8_t length_bytes, Instant now) noexcept;
    /// @brief The next segment of a block upload, what a time-out demands, the end of a delayed write, or nothing. O(1)
    /// [SRS_SDO_007, SRS_SDO_010, SRS_SDO_017]
    [[nodiscard]] SdoAnswer Poll(Instant now) noexcept;
    /// @brief Ends a running transfer with an abort, which is to be sent; without a transfer there is nothing to send.
    /// [SRS_SDO_014, SRS_SDO_019]
    [[nodiscard]] SdoAnswer Close(SdoAbort reason) noexcept;
    /// @brief Whether a transfer is running.
    [[nodiscard]] bool IsBusy() const noexcept;

  private:
    enum class Phase : std::uint8_t
    {
        kIdle = 0U,
        kSegmentDownload = 1U,
        kSegmentUpload = 2U,
        kBlockDownload = 3U,    ///< Segments of a sub-block come.
        kBlockDownloadEnd = 4U, ///< The last segment came.
        kBlockUploadStart = 5U, ///< The client has not said start.
        kBlockUpload = 6U,      ///< Segments of a sub-block go.
        kBlockUploadAck = 7U,   ///< All of the sub-block went.
        kBlockUploadEnd = 8U,   ///< The CRC went.
        kDelayed = 9U,          ///< A hook is not ready; the value is in the buffer.
    };

    [[nodiscard]] SdoAnswer Dispatch(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer Begin(const SdoFrame& request) noexcept;
    void SetTarget(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer Abort(SdoAbort reason) noexcept;
    [[nodiscard]] SdoAnswer Cut(SdoAbort reason) noexcept;
    [[nodiscard]] SdoAnswer Answer(std::uint8_t command, std::uint32_t value) const noexcept;

    [[nodiscard]] SdoAnswer BeginDownload(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer DownloadExpedited(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAbort PrepareDownload(const SdoFrame& request, std::uint8_t mark) noexcept;
    [[nodiscard]] SdoAnswer DownloadSegment(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAbort Store(std::uint32_t size_bytes) noexcept;
    [[nodiscard]] SdoAnswer Finish(SdoAbort abort, const SdoAnswer& done) noexcept;
    [[nodiscard]] SdoAnswer AskAgain() noexcept;
    [[nodiscard]] SdoAnswer BeginUpload() noexcept;
    [[nodiscard]] SdoAnswer AnswerUpload() noexcept;
    [[nodiscard]] SdoAnswer UploadSegment(const SdoFrame& request) noexcept;

    [[nodiscard]] SdoAnswer BeginBlockDownload(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer BlockSegment(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAbort TakeSegment(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer AcknowledgeBlock() noexcept;
    [[nodiscard]] SdoAnswer EndBlockDownload(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer BeginBlockUpload(const SdoFrame& request) noexcept;
    [[nodiscard]] SdoAnswer NextSegment() noexcept;
    [[nodiscard]] SdoAnswer BlockAcknowledged(const SdoFrame& request) noexcept;

    Dictionary& dictionary_;
    Room buffer_;
    std::uint32_t time_out_us_;
    std::uint8_t own_block_size_;
    Phase phase_;
    ObjectAddress target_;
    Instant last_;            ///< Last frame of the client that went on with the transfer, or last segment sent.
    std::uint32_t length_;    ///< Stated length of a download (or kUnknownLength), length of an upload.
    std::uint32_t position_;  ///< Bytes received, or bytes acknowledged by the client.
    std::uint32_t crc_bytes_; ///< Bytes of the download that are in `crc_`.
    std::uint16_t crc_;
    std::uint8_t toggle_; ///< 0 or 10h.
    std::uint8_t sequence_;
    std::uint8_t block_size_;
    bool has_crc_;
    bool has_last_;    ///< The segment with the end mark came.
    SdoAbort refusal_; ///< Of a segment of this sub-block, told at its end; kNone: all were taken.
    bool is_repeated_; ///< The half time-out of this sub-block was used.
    BlockRest rest_;   ///< Of a transfer that was cut.
    DoubledSegment doubled_;
    SdoAnswer delayed_; ///< Follows when the hook has taken the value.
};

} // namespace counterpoint::cia301

#endif
