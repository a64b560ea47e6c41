// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/report/diagram.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "runtime/manager/report/texts.hpp"

namespace counterpoint::runtime
{
namespace
{
constexpr std::size_t kMostRows = 3000U;
constexpr std::uint32_t kNodeMask = 0x7FU;
constexpr std::uint32_t kEmergencies = 0x80U;
constexpr std::uint32_t kAnswers = 0x580U;
constexpr std::uint32_t kRequests = 0x600U;
constexpr std::uint32_t kErrorControl = 0x700U;
constexpr std::uint8_t kCommandMask = 0xE0U;
constexpr std::uint8_t kUpload = 0x40U;
constexpr std::uint8_t kDownload = 0x20U;
constexpr std::uint8_t kAbort = 0x80U;

std::uint32_t NumberIn(const CanFrame& frame, const std::size_t first, const std::size_t count)
{
    std::uint32_t number = 0U;
    for (std::size_t byte = 0U; byte < count; ++byte)
    {
        number |= std::uint32_t{frame.data[first + byte]} << (8U * byte);
    }
    return number;
}

/// Bytes of an expedited value; 0: it comes in segments.
std::size_t ExpeditedBytes(const CanFrame& frame)
{
    const std::uint8_t command = frame.data[0];
    const bool is_expedited = (command & 0x02U) != 0U;
    return !is_expedited ? 0U : ((command & 0x01U) != 0U ? 4U - ((command >> 2U) & 0x03U) : 4U);
}

std::string ValueOf(const CanFrame& frame)
{
    const std::size_t bytes = ExpeditedBytes(frame);
    return (bytes == 0U) ? "..." : cia306::Hex(NumberIn(frame, 4U, bytes), 1);
}
} // namespace

void ManagerDiagram::Add(const DiagramRow& row)
{
    if (rows_.size() < kMostRows)
    {
        rows_.push_back(row);
    }
    else
    {
        ++left_out_;
    }
}

void ManagerDiagram::OnFrame(const CanFrame& frame, const bool is_sent, const std::uint64_t at_us)
{
    const auto node = static_cast<std::uint8_t>(frame.identifier & kNodeMask);
    const std::uint32_t function = frame.identifier & ~kNodeMask;
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    if (is_sent && function == kRequests && frame.length_bytes == 8U)
    {
        OnRequest(frame, node, at_us);
    }
    else if (!is_sent && function == kAnswers && frame.length_bytes == 8U)
    {
        OnAnswer(frame, node, at_us);
    }
    else if (!is_sent && function == kErrorControl && frame.length_bytes == 1U)
    {
        // Heartbeats are told by their changes: events.
        if (frame.data[0] == 0U)
        {
            GiveUp(node);
            Add({at_us, at_us, node, false, false, false, "boot-up"});
        }
    }
    else if (!is_sent && function == kEmergencies && node != 0U && frame.length_bytes == 8U)
    {
        Add({at_us, at_us, node, false, false, true, "emergency " + cia306::Hex(NumberIn(frame, 0U, 2U), 4)});
    }
    else
    {
        // No part of a boot-up.
    }
}

/// Segments belong to the transfer that began before.
void ManagerDiagram::OnRequest(const CanFrame& frame, const std::uint8_t node, const std::uint64_t at_us)
{
    const std::uint8_t command = frame.data[0] & kCommandMask;
    const auto index = static_cast<std::uint16_t>(NumberIn(frame, 1U, 2U));
    const std::string object = cia306::ObjectName(index, frame.data[3]);
    if (command == kUpload || command == kDownload)
    {
        const std::string label = (command == kUpload) ? "read " + object : "write " + object + " = " + ValueOf(frame);
        pending_.at(node) = {true, rows_.size()};
        Add({at_us, 0U, node, true, false, false, label, true});
    }
    else if (frame.data[0] == kAbort)
    {
        Add({at_us, at_us, node, true, false, true,
             "abort " + object + " " + AbortText(static_cast<cia301::SdoAbort>(NumberIn(frame, 4U, 4U)))});
        pending_.at(node).is_open = false;
    }
    else
    {
        // A segment or a block.
    }
}

void ManagerDiagram::OnAnswer(const CanFrame& frame, const std::uint8_t node, const std::uint64_t at_us)
{
    Pending& pending = pending_.at(node);
    if (!pending.is_open || pending.row >= rows_.size())
    {
        return;
    }
    DiagramRow& row = rows_[pending.row];
    row.until_us = at_us;
    const std::uint8_t command = frame.data[0] & kCommandMask;
    if (frame.data[0] == kAbort)
    {
        row.is_bad = true;
        row.label += ": abort " + cia306::Hex(NumberIn(frame, 4U, 4U), 8);
    }
    else if (command == kUpload)
    {
        row.label += ": " + ValueOf(frame);
    }
    else
    {
        row.label += ": done";
    }
    pending.is_open = false;
}

/// A request that a device got before it began anew is answered by nobody, and nobody is to blame.
void ManagerDiagram::GiveUp(const std::uint8_t node)
{
    Pending& pending = pending_.at(node);
    if (pending.is_open && pending.row < rows_.size())
    {
        rows_[pending.row].is_request = false;
        rows_[pending.row].label += ": given up at boot-up";
    }
    pending.is_open = false;
}

void ManagerDiagram::OnEvent(const ManagerEvent& event)
{
    const bool is_own_words = event.kind == "nmt";
    const bool is_shown =
        !event.text.empty() && event.kind != "boot_up" && event.kind != "emergency" && event.kind != "pdo";
    if (is_shown)
    {
        const bool is_bad = (event.kind == "status" && event.text != "started" && event.text.rfind("L:", 0U) != 0U &&
                             !event.word.empty()) ||
                            (event.kind == "gate" && event.text != "safety configuration verified") ||
                            event.kind == "heartbeat_lost" || event.kind == "guard_lost" || event.kind == "duplicate";
        Add({event.at_us, event.at_us, event.node, is_own_words, !is_own_words, is_bad, event.text});
    }
}
} // namespace counterpoint::runtime
