// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/kernel_watch.hpp"

namespace counterpoint::device
{
namespace
{

constexpr Concern kSrdoConcerns[] = {Concern::kApplication, Concern::kCommunication, Concern::kLostFrames,
                                     Concern::kFrameLength, Concern::kSrdo};
constexpr Concern kDeviceConcerns[] = {Concern::kHardware,      Concern::kSoftware, Concern::kApplication,
                                       Concern::kConfiguration, Concern::kModule,   Concern::kCommunication};

/// The device's own entry in the book.
constexpr ErrorSource kDevice{0U};
/// An SRDO of this device and the device itself can have errors of one concern: numbers of SRDOs begin at 1.
ErrorSource SourceOf(const CommunicationIndex index) noexcept
{
    return ErrorSource{static_cast<std::uint8_t>((index.value - kFirstCommunication) + 1U)};
}

/// Whether a cause is an error to tell of, and what about.
struct Told
{
    bool is_told;
    Concern concern;
};

Told ConcernOf(const SrdoCause cause) noexcept
{
    Told told{true, Concern::kSrdo};
    switch (cause)
    {
    case SrdoCause::kLength:
        told.concern = Concern::kFrameLength;
        break;
    case SrdoCause::kQueueOverflow:
        told.concern = Concern::kLostFrames;
        break;
    case SrdoCause::kTransmitQueue:
    case SrdoCause::kBusOff:
    case SrdoCause::kNoConfirmation:
    case SrdoCause::kWrongEcho:
        told.concern = Concern::kCommunication;
        break;
    case SrdoCause::kRefreshMissed:
        told.concern = Concern::kApplication;
        break;
    case SrdoCause::kNotOperational:
    case SrdoCause::kGfc:
    case SrdoCause::kWaitingPastSct:
    case SrdoCause::kDemoted: // The other channel tells the cause.
    case SrdoCause::kNone:
        told.is_told = false;
        break;
    case SrdoCause::kInvalid:
    case SrdoCause::kInverseFirst:
    case SrdoCause::kNormalTwice:
    case SrdoCause::kNotInverse:
    case SrdoCause::kSrvt:
    case SrdoCause::kSct:
    case SrdoCause::kIdentifier:
    case SrdoCause::kLateCall:
    default:
        break;
    }
    return told;
}

Concern ConcernOf(const DeviceFault fault) noexcept
{
    Concern concern = Concern::kSoftware;
    switch (fault)
    {
    case DeviceFault::kSelfTest:
    case DeviceFault::kClock:
        concern = Concern::kHardware;
        break;
    case DeviceFault::kApplication:
    case DeviceFault::kHandshake:
        concern = Concern::kApplication;
        break;
    case DeviceFault::kConfiguration:
        concern = Concern::kConfiguration;
        break;
    case DeviceFault::kCrossLink:
        concern = Concern::kModule;
        break;
    case DeviceFault::kFrameOrder:
        concern = Concern::kCommunication;
        break;
    case DeviceFault::kInvalid:
    case DeviceFault::kDisagreement:
    case DeviceFault::kUnmatched:
    case DeviceFault::kGuard:
    case DeviceFault::kComparator:
    case DeviceFault::kFlow:
    case DeviceFault::kLateCall:
    case DeviceFault::kNone:
    default:
        break;
    }
    return concern;
}

} // namespace

KernelWatch::KernelWatch(ErrorBook& errors, Application& application) noexcept
    : errors_(errors), application_(application)
{
}

RefreshAnswer KernelWatch::OnRefresh(const CommunicationIndex index) noexcept
{
    return application_.OnRefresh(index);
}

// A pair was released, or confirmed: what was wrong with this SRDO is over.
void KernelWatch::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    for (const Concern concern : kSrdoConcerns)
    {
        errors_.End(concern, SourceOf(index));
    }
    application_.OnSrdoEvent(index);
}

void KernelWatch::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    const Told told = ConcernOf(cause);
    if (told.is_told)
    {
        errors_.Set(told.concern, ErrorEvent{SourceOf(index), static_cast<std::uint8_t>(cause)});
    }
    application_.OnSrdoError(index, cause);
}

void KernelWatch::OnGfc() noexcept
{
    application_.OnGfc();
}

void KernelWatch::OnGfcNotFollowed() noexcept
{
    application_.OnGfcNotFollowed();
}

void KernelWatch::OnConfigurationInvalid(const CommunicationIndex index) noexcept
{
    errors_.Set(Concern::kConfiguration, ErrorEvent{SourceOf(index), 0U});
    application_.OnConfigurationInvalid(index);
}

void KernelWatch::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    errors_.Set(ConcernOf(report.fault), ErrorEvent{kDevice, static_cast<std::uint8_t>(report.fault)});
    application_.OnDeviceFault(report);
}

void KernelWatch::OnFlow(const FlowCount& count) noexcept
{
    application_.OnFlow(count);
}

void KernelWatch::EndSrdoErrors() noexcept
{
    for (std::uint8_t number = 1U; number <= kMaxSrdoCount; ++number)
    {
        for (const Concern concern : kSrdoConcerns)
        {
            errors_.End(concern, ErrorSource{number});
        }
    }
}

void KernelWatch::EndDeviceFault() noexcept
{
    for (const Concern concern : kDeviceConcerns)
    {
        errors_.End(concern, kDevice);
    }
}

} // namespace counterpoint::device
