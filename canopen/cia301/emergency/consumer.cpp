// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/consumer.hpp"

#include "canopen/cia301/base/cob_id.hpp"
#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kObject = 0x1028U;
constexpr std::uint32_t kBelowOff = 0x7FFFFFFFU;
constexpr std::uint8_t kMessageBytes = 8U;

} // namespace

EmergencyConsumer::EmergencyConsumer(const EmergencySources& sources, EmergencyListener& listener) noexcept
    : sources_(sources), listener_(listener)
{
    ResetCommunication(NodeId{0U});
}

bool EmergencyConsumer::Wants(const std::uint32_t identifier) const noexcept
{
    bool is_wanted = false;
    for (std::uint8_t i = 0U; i < sources_.count; ++i)
    {
        is_wanted = is_wanted || (sources_.cob_ids[i] == identifier);
    }
    return is_wanted;
}

bool EmergencyConsumer::Uses(const std::uint32_t identifier) const noexcept
{
    return Wants(identifier);
}

void EmergencyConsumer::ResetCommunication(NodeId) noexcept
{
    for (std::uint8_t i = 0U; i < sources_.count; ++i)
    {
        sources_.cob_ids[i] = kCobOff;
    }
}

void EmergencyConsumer::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_message = (frame.kind == FrameKind::kData) && (frame.length_bytes == kMessageBytes);
    for (std::uint8_t i = 0U; is_message && (i < sources_.count); ++i)
    {
        // An identifier with bit 31 set is none that a frame could have.
        if ((frame.identifier == sources_.cob_ids[i]) && IsAllowed(Service::kEmergency, moment.state))
        {
            ReceivedEmergency emergency{NodeId{static_cast<std::uint8_t>(i + 1U)}, 0U, frame.data[2], {}};
            emergency.code = static_cast<std::uint16_t>(frame.data[0] | (frame.data[1] << 8U));
            for (std::uint32_t k = 0U; k < 5U; ++k)
            {
                emergency.details[k] = frame.data[3U + k];
            }
            listener_.OnEmergency(emergency);
        }
    }
}

void EmergencyConsumer::OnCycle(const Moment&) noexcept
{
}

ObjectValue EmergencyConsumer::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kNone, sources_.count, 1U};
    if (address.index != kObject)
    {
        value.abort = SdoAbort::kObjectUnknown;
    }
    else if (address.sub > sources_.count)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (address.sub > 0U)
    {
        value = ObjectValue{SdoAbort::kNone, sources_.cob_ids[address.sub - 1U], 4U};
    }
    return value;
}

SdoAbort EmergencyConsumer::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    const ObjectValue old = Fetch(address);
    const bool is_off = (value & kCobOff) != 0U;
    const bool is_usable = IsConfigurable(value & kBelowOff) || (value == kCobOff);
    const bool is_on = ((old.value & kCobOff) == 0U) && !is_off;
    const bool is_moved = is_on && (old.value != value) && !IsConfiguring();
    SdoAbort abort = old.abort;
    if ((abort == SdoAbort::kNone) && (address.sub == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && (!is_usable || is_moved))
    {
        abort = SdoAbort::kValueRange;
    }
    else if (abort == SdoAbort::kNone)
    {
        sources_.cob_ids[address.sub - 1U] = value;
    }
    return abort;
}

} // namespace counterpoint::cia301
