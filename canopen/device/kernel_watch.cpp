// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/device/kernel_watch.hpp"

namespace counterpoint::device
{
namespace
{

constexpr std::uint16_t kHardware = 0x5000U;
constexpr std::uint16_t kSoftware = 0x6100U;
constexpr std::uint16_t kApplication = 0x6200U;
constexpr std::uint16_t kConfiguration = 0x6300U;
constexpr std::uint16_t kModule = 0x7500U;
constexpr std::uint16_t kCommunication = 0x8100U;
constexpr std::uint16_t kLostFrames = 0x8110U;
constexpr std::uint16_t kLength = 0x8210U;
constexpr std::uint16_t kSrdo = 0x8250U;
constexpr std::uint16_t kSrdoCodes[kEmergenciesOfSrdo] = {kApplication, kCommunication, kLostFrames, kLength, kSrdo};

constexpr std::uint8_t kCommunicationBit = 0x10U; ///< Of 1001h.
constexpr std::uint8_t kManufacturerBit = 0x80U;
/// Sources beside the indices of SRDOs.
constexpr std::uint16_t kDevice = 0U;
constexpr std::uint16_t kConfigurationValidIndex = 0x13FEU;

std::uint8_t NumberOf(const CommunicationIndex index) noexcept
{
    return static_cast<std::uint8_t>((index.value - kFirstCommunication) + 1U);
}

std::uint8_t BitsOf(const std::uint16_t code) noexcept
{
    return (code >= kModule) ? kCommunicationBit : kManufacturerBit;
}

/// Whether a cause is an error to tell of, and what about.
struct Told
{
    bool is_told;
    std::uint16_t code;
};

Told CodeOf(const SrdoCause cause) noexcept
{
    Told told{true, kSrdo};
    switch (cause)
    {
    case SrdoCause::kLength:
        told.code = kLength;
        break;
    case SrdoCause::kQueueOverflow:
        told.code = kLostFrames;
        break;
    case SrdoCause::kTransmitQueue:
    case SrdoCause::kBusOff:
    case SrdoCause::kNoConfirmation:
    case SrdoCause::kWrongEcho:
        told.code = kCommunication;
        break;
    case SrdoCause::kRefreshMissed:
        told.code = kApplication;
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

std::uint16_t CodeOf(const DeviceFault fault) noexcept
{
    std::uint16_t code = kSoftware;
    switch (fault)
    {
    case DeviceFault::kSelfTest:
    case DeviceFault::kClock:
        code = kHardware;
        break;
    case DeviceFault::kApplication:
    case DeviceFault::kHandshake:
        code = kApplication;
        break;
    case DeviceFault::kConfiguration:
        code = kConfiguration;
        break;
    case DeviceFault::kCrossLink:
        code = kModule;
        break;
    case DeviceFault::kFrameOrder:
    case DeviceFault::kInvalid:
    case DeviceFault::kDisagreement:
    case DeviceFault::kUnmatched:
    case DeviceFault::kGuard:
    case DeviceFault::kComparator:
    case DeviceFault::kFlow:
    case DeviceFault::kLateCall:
    case DeviceFault::kOutput:
    case DeviceFault::kNone:
    default:
        break;
    }
    return code;
}

} // namespace

KernelWatch::KernelWatch(cia301::EmergencyProducer& emergency, Application& application) noexcept
    : emergency_(emergency), application_(application), device_code_(0U)
{
}

RefreshAnswer KernelWatch::OnRefresh(const CommunicationIndex index) noexcept
{
    return application_.OnRefresh(index);
}

// A pair was released, or confirmed: what was wrong with this SRDO is over.
void KernelWatch::OnSrdoEvent(const CommunicationIndex index) noexcept
{
    if (emergency_.HasErrors())
    {
        for (const std::uint16_t code : kSrdoCodes)
        {
            emergency_.Clear(code, index.value);
        }
    }
    application_.OnSrdoEvent(index);
}

void KernelWatch::OnSrdoError(const CommunicationIndex index, const SrdoCause cause) noexcept
{
    const Told told = CodeOf(cause);
    if (told.is_told)
    {
        const auto detail = static_cast<std::uint8_t>(cause);
        emergency_.Raise({told.code, BitsOf(told.code), {NumberOf(index), detail, 0U, 0U, 0U}, index.value});
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
    const std::uint8_t bits = BitsOf(kConfiguration);
    emergency_.Raise({kConfiguration, bits, {NumberOf(index), 0U, 0U, 0U, 0U}, kConfigurationValidIndex});
    application_.OnConfigurationInvalid(index);
}

void KernelWatch::OnDeviceFault(const DeviceFaultReport& report) noexcept
{
    device_code_ = CodeOf(report.fault);
    const auto detail = static_cast<std::uint8_t>(report.fault);
    emergency_.Raise(
        {device_code_, BitsOf(device_code_), {0U, detail, 0U, 0U, 0U}, kDevice, cia301::EmergencyUrgency::kUrgent});
    application_.OnDeviceFault(report);
}

void KernelWatch::OnFlow(const FlowCount& count) noexcept
{
    application_.OnFlow(count);
}

void KernelWatch::OnNotConfigured() noexcept
{
    const std::uint8_t bits = BitsOf(kConfiguration);
    emergency_.Raise({kConfiguration, bits, {0U, 0U, 0U, 0U, 0U}, kConfigurationValidIndex});
}

void KernelWatch::OnOperationalLeft() noexcept
{
    for (std::uint16_t number = 0U; number < kMaxSrdoCount; ++number)
    {
        for (const std::uint16_t code : kSrdoCodes)
        {
            emergency_.Clear(code, static_cast<std::uint16_t>(kFirstCommunication + number));
        }
    }
    emergency_.Clear(kConfiguration, kConfigurationValidIndex);
}

void KernelWatch::OnRestart() noexcept
{
    if (device_code_ != 0U)
    {
        emergency_.Clear(device_code_, kDevice);
        device_code_ = 0U;
    }
}

} // namespace counterpoint::device
