// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/transfers.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/names.hpp"

#include <algorithm>
#include <chrono>

namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;

constexpr std::size_t kLongestAnswer = 65536U;
/// 1 January 1984 in days since 1970.
constexpr std::int64_t kFirstDay = 5113;
} // namespace

std::string SdoAbortText(const SdoAbort abort)
{
    return AbortText(static_cast<AbortCode>(static_cast<std::uint32_t>(abort)));
}

NodeTransfers::NodeTransfers(OptionalServices& services, NodeReport& report) : services_(services), report_(report)
{
}

std::string NodeTransfers::SendTime(const cia301::NodeState state, const Instant now)
{
    using Milliseconds = std::chrono::milliseconds;
    constexpr std::int64_t kMsOfDay = 86400000;
    const std::int64_t ms =
        std::chrono::duration_cast<Milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
    const cia301::TimeOfDay time{static_cast<std::uint32_t>(ms % kMsOfDay),
                                 static_cast<std::uint16_t>(ms / kMsOfDay - kFirstDay)};
    return services_.Time().Send(time, {state, now})
               ? ""
               : "time: not sent, expected 0x1012:00 with bit 30, and PRE-OPERATIONAL or "
                 "OPERATIONAL";
}

std::string NodeTransfers::StartTransfer(const NodeOrder& order, const Instant now)
{
    cia301::SdoClientPort* const port = services_.ClientOf(order.node);
    const std::string what = (order.kind == OrderKind::kRead) ? "read" : "write";
    if (port == nullptr)
    {
        return what + ": no SDO client of node " + std::to_string(order.node) +
               ", expected 0x1280 to 0x12FF with both COB-IDs valid and this node-ID in sub-index 3";
    }
    if (std::any_of(running_.begin(), running_.end(), [port](const Transfer& each) { return each.port == port; }))
    {
        return what + ": a transfer with node " + std::to_string(order.node) + " runs, expected its end";
    }
    Transfer& transfer = running_.emplace_back(Transfer{port, order, {}});
    if (order.kind == OrderKind::kRead)
    {
        transfer.bytes.assign(kLongestAnswer, 0U);
        static_cast<void>(port->Client().StartUpload(order.object, {transfer.bytes.data(), kLongestAnswer},
                                                     cia301::SdoMode::kNormal, now));
    }
    else
    {
        transfer.bytes.assign(order.size_bytes, 0U);
        cia301::ToLittleEndian(order.value, transfer.bytes.data(), order.size_bytes);
        static_cast<void>(port->Client().StartDownload(order.object, {transfer.bytes.data(), order.size_bytes},
                                                       cia301::SdoMode::kNormal, now));
    }
    return "";
}

void NodeTransfers::Look(const std::uint64_t now_ns)
{
    const auto has_ended = [this, now_ns](const Transfer& transfer)
    {
        const bool is_over = transfer.port->Client().State() != cia301::SdoClientState::kBusy;
        if (is_over)
        {
            Tell(transfer, now_ns);
        }
        return is_over;
    };
    running_.remove_if(has_ended);
}

void NodeTransfers::Tell(const Transfer& transfer, const std::uint64_t now_ns)
{
    const cia301::SdoOutcome outcome = transfer.port->Client().Outcome();
    const bool is_read = transfer.order.kind == OrderKind::kRead;
    const std::string what = std::string(is_read ? "read" : "write") + " node " + std::to_string(transfer.order.node) +
                             " " + ObjectText(transfer.order.object);
    nlohmann::ordered_json details{{"node", transfer.order.node},
                                   {"object", ObjectText(transfer.order.object)},
                                   {"abort", static_cast<std::uint32_t>(outcome.abort)}};
    std::string text = what + ": done";
    if (outcome.abort != SdoAbort::kNone)
    {
        text = what + ": " + SdoAbortText(outcome.abort) + (outcome.by_server ? " by the server" : " by this node");
    }
    else if (is_read)
    {
        const std::size_t count = outcome.size_bytes;
        const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(count, sizeof(std::uint64_t)));
        const std::uint64_t value = cia301::FromLittleEndian(transfer.bytes.data(), shown);
        text = what + " = " + (count <= shown ? std::to_string(value) + ", " : "") + std::to_string(count) +
               " bytes: " + BytesText(transfer.bytes.data(), count);
        details["size_bytes"] = count;
        details["value"] = value;
    }
    report_.Tell(now_ns, text, is_read ? "read" : "written", details);
}
} // namespace counterpoint::runtime
