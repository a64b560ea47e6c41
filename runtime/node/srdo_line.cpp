// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/srdo_line.hpp"

#include "runtime/device/names.hpp"
#include "safety_core/kernel/limits.hpp"

#include <string>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint16_t kCommunicationBase = 0x1300U;
constexpr std::uint8_t kSrvtSub = 3U;
constexpr std::uint8_t kCobIdSub1 = 5U;

std::string Milliseconds(const std::uint32_t us)
{
    return runtime::MillisecondsText(runtime::Nanoseconds{us} * runtime::kNanosecondsPerMicrosecond);
}
} // namespace

void TellSrdo(NodeReport& report, const std::uint64_t at_ns, const DeviceConfig& config, const runtime::SrdoModel& srdo)
{
    const bool is_consumer = srdo.direction == kDirectionConsumer;
    const std::uint32_t limit_us = is_consumer ? ComputeLimit(config, srdo.times, FaultClass::kBus).us : 0U;
    std::string text = "SRDO " + std::to_string(srdo.number);
    if (is_consumer)
    {
        text += " consumer " + runtime::IdentifierText(srdo.cob_id_1) + ", safe within " + Milliseconds(limit_us) +
                " of the last good pair";
    }
    else if (srdo.direction == kDirectionProducer)
    {
        text += " producer " + runtime::IdentifierText(srdo.cob_id_1) + ", every " + std::to_string(srdo.times.sct_ms) +
                " ms";
    }
    else
    {
        text += " off";
    }
    report.Tell(at_ns, text, "srdo", {{"srdo", srdo.number}, {"consumer", is_consumer}, {"limit_us", limit_us}});
}

runtime::SrdoModel ConfiguredSrdo(Kernel& kernel, const runtime::SrdoModel& of_file)
{
    const auto index = static_cast<std::uint16_t>(kCommunicationBase + of_file.number);
    const ParametersReply parameters = kernel.GetParameters({index});
    runtime::SrdoModel srdo = of_file;
    srdo.direction = parameters.direction;
    srdo.times.sct_ms = parameters.refresh_ms;
    srdo.times.srvt_ms = static_cast<std::uint8_t>(ToValue(kernel.ReadObject({index, kSrvtSub}).data));
    srdo.cob_id_1 = ToValue(kernel.ReadObject({index, kCobIdSub1}).data);
    return srdo;
}

bool IsSameSrdo(const runtime::SrdoModel& one, const runtime::SrdoModel& other)
{
    const bool are_times = one.times.sct_ms == other.times.sct_ms && one.times.srvt_ms == other.times.srvt_ms;
    return one.direction == other.direction && one.cob_id_1 == other.cob_id_1 && are_times;
}
} // namespace counterpoint::runtime
