// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_DECODER_HPP
#define CANOPEN_MONITOR_DECODER_HPP

#include "canopen/monitor/analysis.hpp"
#include "canopen/monitor/error_control.hpp"
#include "canopen/monitor/network.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace counterpoint::monitor
{
/// Describes frames in the words of the DCFs of their devices. It remembers which object an SDO transfer is about. Both
/// arguments are kept by reference. [SRS_MON_004]
class Decoder
{
  public:
    Decoder(const Network& network, const Analysis& analysis) noexcept;

    /// @brief One line without its time. Frames are given in their order.
    [[nodiscard]] std::string Decode(const LogFrame& frame);

  private:
    /// The object that the transfer with a server is about.
    struct Transfer
    {
        std::uint16_t index{0U};
        std::uint8_t sub{0U};
        bool is_known{false};          ///< Its begin was seen.
        bool is_block{false};          ///< Segments of a block have a number in place of a command.
        bool is_upload{false};         ///< Of a block: the server sends the segments.
        bool has_last{false};          ///< Of a block: its last segment was seen.
        std::uint32_t last_number{0U}; ///< That segment's number.
    };

    [[nodiscard]] std::string Emergency(const LogFrame& frame) const;
    [[nodiscard]] std::string Nmt(const LogFrame& frame) const;
    [[nodiscard]] std::string Other(const LogFrame& frame) const;
    [[nodiscard]] std::string FlyingMaster(const LogFrame& frame) const;
    [[nodiscard]] std::string ErrorControlText(const LogFrame& frame);
    [[nodiscard]] std::string Pdo(const LogFrame& frame) const;
    [[nodiscard]] std::string Srdo(const LogFrame& frame) const;
    [[nodiscard]] std::string Sdo(const LogFrame& frame);
    [[nodiscard]] std::string SdoBegin(const LogFrame& frame, Transfer& transfer, bool is_request);
    [[nodiscard]] std::string SdoBlock(const LogFrame& frame, Transfer& transfer, bool is_request) const;
    [[nodiscard]] std::string SegmentOfBlock(const LogFrame& frame, Transfer& transfer) const;
    [[nodiscard]] std::string TransferText(const LogFrame& frame, const Transfer& transfer) const;
    [[nodiscard]] std::string ObjectText(std::uint8_t node_id, std::uint16_t index, std::uint8_t sub) const;
    [[nodiscard]] std::string FieldsText(const NodeModel& node, const std::vector<MappedField>& fields,
                                         const LogFrame& frame) const;

    const Network& network_;
    const Analysis& analysis_;
    std::array<Transfer, 128U> transfers_{};
    ErrorControl error_control_;
};

/// A value as the data type of its entry writes it; hexadecimal where there is none.
[[nodiscard]] std::string ValueText(const cia306::Entry* entry, std::uint64_t value, std::uint32_t bits);
/// "0609 0030h (value out of range)"
[[nodiscard]] std::string AbortText(std::uint32_t code);
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_DECODER_HPP
