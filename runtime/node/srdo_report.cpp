// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/srdo_report.hpp"

#include "canopen/cia306/safety/safety_configuration.hpp"
#include "runtime/device/names.hpp"
#include "safety_core/kernel/limits.hpp"

#include <cstddef>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint8_t kSrvtSub = 3U;
constexpr std::uint8_t kCobIdSub1 = 5U;

std::string Milliseconds(const std::uint32_t us)
{
    return MillisecondsText(Nanoseconds{us} * kNanosecondsPerMicrosecond);
}

/// Of a consumer: whatever happens on the bus.
Limit LimitOf(const DeviceConfig& config, const SrdoModel& srdo)
{
    return ComputeLimit(config, srdo.times, FaultClass::kBusNextNormal);
}

std::string OffText(const SrdoModel& srdo)
{
    return "SRDO " + std::to_string(srdo.number) + " off";
}

std::string TextOf(const DeviceConfig& config, const SrdoModel& srdo)
{
    const std::string name = "SRDO " + std::to_string(srdo.number);
    if (srdo.direction == kDirectionConsumer)
    {
        const Limit limit = LimitOf(config, srdo);
        return name + " consumer " + IdentifierText(srdo.cob_id_1) +
               (limit.result == Result::kSuccessful
                    ? ", safe within " + Milliseconds(limit.us) + " of the last good normal frame"
                    : ", without a limit: its times are too long");
    }
    if (srdo.direction == kDirectionProducer)
    {
        return name + " producer " + IdentifierText(srdo.cob_id_1) + ", every " + std::to_string(srdo.times.sct_ms) +
               " ms";
    }
    return OffText(srdo);
}

/// The SRDO as the kernel has it now; `of_file` is what the file says of it.
SrdoModel ConfiguredSrdo(Kernel& kernel, const SrdoModel& of_file)
{
    const CommunicationIndex index = CommunicationIndexOf(of_file.number);
    const ParametersReply parameters = kernel.GetParameters(index);
    SrdoModel srdo = of_file;
    srdo.direction = parameters.direction;
    srdo.times.sct_ms = parameters.refresh_ms;
    srdo.times.srvt_ms = static_cast<std::uint8_t>(ToValue(kernel.ReadObject({index.value, kSrvtSub}).data));
    srdo.cob_id_1 = ToValue(kernel.ReadObject({index.value, kCobIdSub1}).data);
    return srdo;
}
} // namespace

SrdoReport::SrdoReport(const DeviceModel& model, const DeviceConfig& config, NodeReport& report)
    : model_(model), config_(config), report_(report), told_(model.Srdos().size())
{
}

void SrdoReport::TellFile(const std::uint64_t at_ns)
{
    for (std::size_t slot = 0U; slot < told_.size(); ++slot)
    {
        const SrdoModel& srdo = model_.Srdos()[slot];
        told_[slot] = OffText(srdo); // Of one that is off nothing is said.
        Tell(at_ns, srdo);
    }
}

/// Why a store was refused is told elsewhere; what was told of the file does not hold then.
void SrdoReport::TellSaved(Kernel& kernel, const std::uint64_t at_ns)
{
    if (IsValid(kernel))
    {
        TellConfigured(kernel, at_ns);
        return;
    }
    for (SrdoModel srdo : model_.Srdos())
    {
        srdo.direction = kDirectionOff;
        Tell(at_ns, srdo);
    }
}

void SrdoReport::TellConfigured(Kernel& kernel, const std::uint64_t at_ns)
{
    for (const SrdoModel& of_file : model_.Srdos())
    {
        Tell(at_ns, ConfiguredSrdo(kernel, of_file));
    }
}

// Compared is what was told, not the file: times that go back to those of the file are news behind others.
void SrdoReport::Follow(Kernel& kernel, const std::uint64_t at_ns, const bool is_told_invalid)
{
    const bool is_valid = IsValid(kernel);
    if (!is_valid && !is_told_invalid)
    {
        report_.Tell(at_ns, "configuration does not hold, 0x13FE:00 is not 0xA5: SRDOs are off",
                     "configuration_invalid", {{"srdo", 0U}});
    }
    if (is_valid)
    {
        TellConfigured(kernel, at_ns);
        return;
    }
    for (std::size_t slot = 0U; slot < told_.size(); ++slot)
    {
        told_[slot] = OffText(model_.Srdos()[slot]); // The line above, or that of the kernel, has told it.
    }
}

/// A plain device has no 13FEh, and nothing that is off.
bool SrdoReport::IsValid(Kernel& kernel) const
{
    const ObjectReading valid = kernel.ReadObject({cia306::kConfigurationValidIndex, 0U});
    return told_.empty() || (valid.abort == AbortCode::kNone && ToValue(valid.data) == kConfigurationValidValue);
}

void SrdoReport::Tell(const std::uint64_t at_ns, const SrdoModel& srdo)
{
    const std::string text = TextOf(config_, srdo);
    std::string& told = told_.at(model_.SlotOf(srdo.number).value_or(0U));
    if (text == told)
    {
        return;
    }
    told = text;
    const bool is_consumer = srdo.direction == kDirectionConsumer;
    const bool is_producer = srdo.direction == kDirectionProducer;
    const Limit limit = LimitOf(config_, srdo);
    const nlohmann::ordered_json limit_us =
        (limit.result == Result::kSuccessful) ? nlohmann::ordered_json(limit.us) : nlohmann::ordered_json();
    report_.Tell(at_ns, text, "srdo",
                 {{"srdo", srdo.number},
                  {"consumer", is_consumer},
                  {"limit_us", is_consumer ? limit_us : nlohmann::ordered_json(0U)},
                  {"refresh_ms", is_producer ? srdo.times.sct_ms : 0U}});
}
} // namespace counterpoint::runtime
