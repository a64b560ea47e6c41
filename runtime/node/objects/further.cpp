// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/objects/further.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/names.hpp"

#include <algorithm>
#include <chrono>

namespace counterpoint::runtime
{
namespace
{
using cia301::SdoAbort;
using cia306::Hex;
using runtime::ObjectText;

constexpr std::uint16_t kTime = 0x1012U;
constexpr std::uint16_t kHighResolution = 0x1013U;
constexpr std::uint16_t kSources = 0x1028U;
constexpr std::uint16_t kFirstServer = 0x1201U;
constexpr std::uint16_t kLastServer = 0x127FU;
constexpr std::uint16_t kFirstClient = 0x1280U;
constexpr std::uint16_t kLastClient = 0x12FFU;
constexpr std::uint32_t kSilenceUs = 1000000U;
constexpr std::uint8_t kBlock = 64U;
constexpr std::size_t kLongestAnswer = 65536U;
constexpr std::size_t kShownBytes = 32U;
/// 1 January 1984 in days since 1970.
constexpr std::int64_t kFirstDay = 5113;

/// Highest sub-index of a list; 0: the file has none.
std::size_t CountOf(const cia306::Device& file, const std::uint16_t index)
{
    const cia306::Object* const object = file.Find(index);
    return (object == nullptr || object->entries.empty()) ? 0U : object->entries.rbegin()->first;
}

std::string AbortText(const SdoAbort abort)
{
    return runtime::AbortText(static_cast<AbortCode>(static_cast<std::uint32_t>(abort)));
}

std::string BytesText(const std::vector<std::uint8_t>& bytes, const std::size_t count)
{
    std::string text;
    for (std::size_t place = 0U; place < std::min(count, kShownBytes); ++place)
    {
        text += (place == 0U ? "" : " ") + Hex(bytes[place], 2).substr(2U);
    }
    return text + (count > kShownBytes ? " ..." : "");
}
} // namespace

NodeFurther::Serving::Serving(cia301::Dictionary& dictionary, cia301::FrameSink& sink, const std::uint8_t number,
                              const std::uint32_t longest_bytes)
    : buffer(longest_bytes), server({dictionary, {buffer.data(), longest_bytes}, kSilenceUs, kBlock}),
      port(server, sink, cia301::SdoServerNumber{number}), index(static_cast<std::uint16_t>(kFirstServer - 1U + number))
{
}

NodeFurther::NodeFurther(const cia306::Device& file, cia301::Dictionary& dictionary, device::Services& services,
                         NodeReport& report, const std::uint32_t longest_bytes)
    : report_(report), sources_(std::min<std::size_t>(CountOf(file, kSources), 127U)), time_(services.outbox, *this),
      emergencies_({sources_.data(), static_cast<std::uint8_t>(sources_.size())}, *this)
{
    if (file.Find(kTime) != nullptr || file.Find(kHighResolution) != nullptr)
    {
        list_.push_back(&time_);
    }
    if (!sources_.empty())
    {
        list_.push_back(&emergencies_);
    }
    for (std::uint16_t index = kFirstServer; index <= kLastServer; ++index)
    {
        if (file.Find(index) != nullptr)
        {
            const auto number = static_cast<std::uint8_t>(index - kFirstServer + 1U);
            list_.push_back(&servers_.emplace_back(dictionary, services.outbox, number, longest_bytes).port);
        }
    }
    for (std::uint16_t index = kFirstClient; index <= kLastClient; ++index)
    {
        if (file.Find(index) != nullptr)
        {
            const auto number = static_cast<std::uint8_t>(index - kFirstClient);
            const cia301::SdoClientPortParts parts{services.outbox, number, kSilenceUs, kBlock};
            clients_.push_back({cia301::SdoClientPort{parts}, index});
            list_.push_back(&clients_.back().port);
        }
    }
    services.further = {list_.data(), static_cast<std::uint8_t>(list_.size())};
}

cia301::NumberHook* NodeFurther::HookOf(const std::uint16_t index) noexcept
{
    if (index == kTime || index == kHighResolution)
    {
        return &time_;
    }
    if (index == kSources)
    {
        return &emergencies_;
    }
    for (Serving& serving : servers_)
    {
        if (serving.index == index)
        {
            return &serving.port;
        }
    }
    for (Asking& asking : clients_)
    {
        if (asking.index == index)
        {
            return &asking.port;
        }
    }
    return nullptr;
}

std::string NodeFurther::SendTime(const cia301::NodeState state, const Instant now)
{
    using Milliseconds = std::chrono::milliseconds;
    constexpr std::int64_t kMsOfDay = 86400000;
    const std::int64_t ms =
        std::chrono::duration_cast<Milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
    const cia301::TimeOfDay time{static_cast<std::uint32_t>(ms % kMsOfDay),
                                 static_cast<std::uint16_t>(ms / kMsOfDay - kFirstDay)};
    return time_.Send(time, {state, now}) ? ""
                                          : "time: not sent, expected 0x1012:00 with bit 30, and PRE-OPERATIONAL or "
                                            "OPERATIONAL";
}

std::string NodeFurther::StartTransfer(const NodeOrder& order, const Instant now)
{
    const auto is_its = [&order](Asking& each)
    { return each.port.IsConnected() && each.port.Server().value == order.node; };
    const auto asking = std::find_if(clients_.begin(), clients_.end(), is_its);
    const std::string what = (order.kind == OrderKind::kRead) ? "read" : "write";
    if (asking == clients_.end())
    {
        return what + ": no SDO client of node " + std::to_string(order.node) +
               ", expected 0x1280 to 0x12FF with both COB-IDs valid and this node-ID in sub-index 3";
    }
    if (asking->is_asking)
    {
        return what + ": a transfer with node " + std::to_string(order.node) + " runs, expected its end";
    }
    asking->order = order;
    asking->is_asking = true;
    cia301::SdoClient& client = asking->port.Client();
    if (order.kind == OrderKind::kRead)
    {
        asking->bytes.assign(kLongestAnswer, 0U);
        static_cast<void>(
            client.StartUpload(order.object, {asking->bytes.data(), kLongestAnswer}, cia301::SdoMode::kNormal, now));
    }
    else
    {
        asking->bytes.assign(order.size_bytes, 0U);
        cia301::ToLittleEndian(order.value, asking->bytes.data(), order.size_bytes);
        static_cast<void>(client.StartDownload(order.object, {asking->bytes.data(), order.size_bytes},
                                               cia301::SdoMode::kNormal, now));
    }
    return "";
}

void NodeFurther::Look()
{
    for (Asking& asking : clients_)
    {
        if (asking.is_asking && asking.port.Client().State() != cia301::SdoClientState::kBusy)
        {
            asking.is_asking = false;
            Tell(asking);
        }
    }
}

void NodeFurther::Tell(Asking& asking)
{
    const cia301::SdoOutcome outcome = asking.port.Client().Outcome();
    const bool is_read = asking.order.kind == OrderKind::kRead;
    const std::string what = std::string(is_read ? "read" : "write") + " node " + std::to_string(asking.order.node) +
                             " " + ObjectText(asking.order.object);
    nlohmann::ordered_json details{{"node", asking.order.node},
                                   {"object", ObjectText(asking.order.object)},
                                   {"abort", static_cast<std::uint32_t>(outcome.abort)}};
    std::string text = what + ": done";
    if (outcome.abort != SdoAbort::kNone)
    {
        text = what + ": " + AbortText(outcome.abort) + (outcome.by_server ? " by the server" : " by this node");
    }
    else if (is_read)
    {
        const std::size_t count = outcome.size_bytes;
        const auto shown = static_cast<std::uint32_t>(std::min<std::size_t>(count, sizeof(std::uint64_t)));
        const std::uint64_t value = cia301::FromLittleEndian(asking.bytes.data(), shown);
        text = what + " = " + (count <= shown ? std::to_string(value) + ", " : "") + std::to_string(count) +
               " bytes: " + BytesText(asking.bytes, count);
        details["size"] = count;
        details["value"] = value;
    }
    report_.Tell(now_ns_, text, is_read ? "read" : "written", details);
}

void NodeFurther::OnTime(const cia301::TimeOfDay& time, const Instant now) noexcept
{
    static_cast<void>(now);
    report_.Tell(now_ns_, "time " + std::to_string(time.ms) + " ms of day " + std::to_string(time.days), "time",
                 {{"ms", time.ms}, {"days", time.days}});
}

void NodeFurther::OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept
{
    const std::vector<std::uint8_t> bytes(std::begin(emergency.details), std::end(emergency.details));
    report_.Tell(now_ns_,
                 "emergency of node " + std::to_string(emergency.node.value) + ": " + Hex(emergency.code, 4) +
                     ", register " + Hex(emergency.error_register, 2) + ", " + BytesText(bytes, bytes.size()),
                 "emergency",
                 {{"node", emergency.node.value}, {"code", emergency.code}, {"register", emergency.error_register}});
}
} // namespace counterpoint::runtime
