// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/bus.hpp"

#include "hal/host/live/address.hpp"
#include "hal/host/live/socketcan_bus.hpp"
#include "hal/host/live/socketcand/bus.hpp"
#include "hal/host/live/udp_bus.hpp"
#include "hal/host/virtual/frame_bits.hpp"

#include <algorithm>
#include <ctime>

namespace counterpoint::host
{
namespace
{

constexpr std::uint64_t kSecondNs = 1'000'000'000U;

bool IsFlexibleLength(const std::uint8_t length)
{
    constexpr std::uint8_t kLengths[]{12U, 16U, 20U, 24U, 32U, 48U, 64U};
    return (length <= kClassicalDataBytes) ||
           (std::find(std::begin(kLengths), std::end(kLengths), length) != std::end(kLengths));
}

FrameKind KindOf(const LiveFrame& frame)
{
    if (frame.error)
    {
        return FrameKind::kInvalid;
    }
    if (frame.fd)
    {
        return FrameKind::kFlexibleDataRate;
    }
    if (frame.extended)
    {
        return frame.remote ? FrameKind::kExtendedRemote : FrameKind::kExtended;
    }
    return frame.remote ? FrameKind::kRemote : FrameKind::kData;
}

} // namespace

std::unique_ptr<LiveBus> OpenLiveBus(const std::string& address, const LiveOptions& options)
{
    const LiveAddress parts = ParseLiveAddress(address);
    if (parts.kind == LiveKind::kUdp)
    {
        return std::make_unique<LiveUdpBus>(parts, options);
    }
    if (parts.kind == LiveKind::kSocketcand)
    {
        return std::make_unique<LiveSocketcandBus>(parts, options);
    }
    return std::make_unique<LiveSocketCanBus>(parts, options);
}

std::unique_ptr<LiveBus> OpenLiveBus(const std::string& address)
{
    return OpenLiveBus(address, LiveOptions{});
}

bool IsSendable(const LiveFrame& frame)
{
    const std::uint32_t greatest = frame.extended ? kGreatestExtendedIdentifier : kGreatestStandardIdentifier;
    const bool fits = frame.fd ? IsFlexibleLength(frame.length_bytes) : (frame.length_bytes <= kClassicalDataBytes);
    const bool is_one_kind = !frame.error && !(frame.fd && frame.remote);
    return fits && is_one_kind && (frame.identifier <= greatest);
}

bool Passes(const std::vector<IdentifierFilter>& filters, const LiveFrame& frame)
{
    const auto matches = [&frame](const IdentifierFilter& filter)
    {
        return (filter.extended == frame.extended) &&
               ((filter.identifier & filter.mask) == (frame.identifier & filter.mask));
    };
    return frame.error || filters.empty() || std::any_of(filters.begin(), filters.end(), matches);
}

CanFrame ToCanFrame(const LiveFrame& frame, const CanPortId port)
{
    CanFrame result{};
    result.identifier = frame.identifier;
    result.kind = KindOf(frame);
    result.port = port;
    // A longer frame keeps its wrong length, which a channel judges; only what fits is copied.
    result.length_bytes = frame.length_bytes;
    std::copy_n(frame.data, std::min(kMaxPayloadBytes, frame.length_bytes), result.data);
    return result;
}

LiveFrame FromCanFrame(const CanFrame& frame)
{
    LiveFrame result{};
    result.identifier = frame.identifier;
    result.length_bytes = std::min(frame.length_bytes, kClassicalDataBytes);
    result.extended = (frame.kind == FrameKind::kExtended) || (frame.kind == FrameKind::kExtendedRemote);
    result.remote = (frame.kind == FrameKind::kRemote) || (frame.kind == FrameKind::kExtendedRemote);
    result.fd = frame.kind == FrameKind::kFlexibleDataRate;
    std::copy_n(frame.data, std::size_t{result.length_bytes}, result.data);
    return result;
}

std::uint64_t LiveNow()
{
    timespec now{};
    static_cast<void>(::clock_gettime(CLOCK_MONOTONIC, &now));
    return (static_cast<std::uint64_t>(now.tv_sec) * kSecondNs) + static_cast<std::uint64_t>(now.tv_nsec);
}

int MillisecondsUntil(const std::uint64_t time_ns)
{
    constexpr std::uint64_t kMillisecondNs = 1'000'000U;
    const std::uint64_t now_ns = LiveNow();
    return (now_ns < time_ns) ? static_cast<int>((time_ns - now_ns) / kMillisecondNs) + 1 : 0;
}

} // namespace counterpoint::host
