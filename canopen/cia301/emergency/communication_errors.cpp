// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/emergency/communication_errors.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint16_t kErrorBehaviour = 0x1029U;
constexpr std::uint8_t kCommunicationBit = 0x10U; ///< Of 1001h.
constexpr std::uint8_t kToPreOperational = 0U;
constexpr std::uint8_t kToStopped = 2U;
constexpr std::uint32_t kErrors = 11U;

struct ErrorKind
{
    std::uint16_t code; ///< 0: told only when it is over.
    bool leaves_operational;
};

/// By number.
constexpr ErrorKind kKinds[kErrors] = {
    {0U, false},      {0x8110U, false}, {0x8120U, false}, {0x8130U, true},  {0x8130U, true},  {0U, true},
    {0x8150U, false}, {0x8210U, false}, {0x8220U, false}, {0x8240U, false}, {0x8250U, false},
};
constexpr std::uint16_t kRecovered = 0x8140U;

const ErrorKind& KindOf(const CommunicationError error) noexcept
{
    const std::uint32_t number = static_cast<std::uint32_t>(error);
    return kKinds[(number < kErrors) ? number : 0U];
}

EmergencyError MessageOf(const std::uint16_t code, const std::uint16_t source) noexcept
{
    const auto low = static_cast<std::uint8_t>(source & 0xFFU);
    const auto high = static_cast<std::uint8_t>(source >> 8U);
    return EmergencyError{code, kCommunicationBit, {low, high, 0U, 0U, 0U}, source};
}

} // namespace

CommunicationErrors::CommunicationErrors(EmergencyProducer& emergency, NmtSlave& slave) noexcept
    : emergency_(emergency), slave_(slave), behaviour_{}
{
}

void CommunicationErrors::Raise(const CommunicationError error, const std::uint16_t source) noexcept
{
    const ErrorKind& kind = KindOf(error);
    if (kind.code != 0U)
    {
        emergency_.Raise(MessageOf(kind.code, source));
    }
    if (kind.leaves_operational)
    {
        OnDeviceError(1U);
    }
}

void CommunicationErrors::Clear(const CommunicationError error, const std::uint16_t source) noexcept
{
    if (error == CommunicationError::kBusOff)
    {
        // Nothing could be sent while it lasted: the message and its end follow each other.
        emergency_.Raise(MessageOf(kRecovered, source));
        emergency_.Clear(kRecovered, source);
    }
    else
    {
        emergency_.Clear(KindOf(error).code, source);
    }
}

void CommunicationErrors::OnDeviceError(const std::uint8_t error_class) noexcept
{
    if ((error_class >= 1U) && (error_class <= kErrorClasses))
    {
        const std::uint8_t behaviour = behaviour_[error_class - 1U];
        if (behaviour == kToPreOperational)
        {
            static_cast<void>(slave_.Leave(NodeState::kPreOperational));
        }
        else if (behaviour == kToStopped)
        {
            static_cast<void>(slave_.Leave(NodeState::kStopped));
        }
    }
}

void CommunicationErrors::OnHeartbeat(const NodeId node, const HeartbeatEvent event, std::uint8_t) noexcept
{
    if (event == HeartbeatEvent::kLost)
    {
        Raise(CommunicationError::kHeartbeat, node.value);
    }
    else if ((event == HeartbeatEvent::kStarted) || (event == HeartbeatEvent::kBootUp))
    {
        Clear(CommunicationError::kHeartbeat, node.value);
    }
}

void CommunicationErrors::Reset() noexcept
{
    for (std::uint8_t& behaviour : behaviour_)
    {
        behaviour = kToPreOperational;
    }
}

ObjectValue CommunicationErrors::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kNone, kErrorClasses, 1U};
    if (address.index != kErrorBehaviour)
    {
        value.abort = SdoAbort::kObjectUnknown;
    }
    else if (address.sub > kErrorClasses)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (address.sub > 0U)
    {
        value.value = behaviour_[address.sub - 1U];
    }
    return value;
}

SdoAbort CommunicationErrors::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    SdoAbort abort = Fetch(address).abort;
    if ((abort == SdoAbort::kNone) && (address.sub == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && (value > kToStopped))
    {
        abort = SdoAbort::kValueRange;
    }
    else if (abort == SdoAbort::kNone)
    {
        behaviour_[address.sub - 1U] = static_cast<std::uint8_t>(value);
    }
    return abort;
}

} // namespace counterpoint::cia301
