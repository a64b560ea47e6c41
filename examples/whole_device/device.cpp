// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "device.hpp"

namespace whole_device
{
using namespace counterpoint;

namespace
{
constexpr std::uint16_t kDataSetError = 0x6310U;

bool IsSound(const cia301::LoadReport& report)
{
    return (report.finding == cia301::StoreFinding::kSound) && (report.refused == 0U);
}
} // namespace

void Drive::Cycle(const SrdoMask open) noexcept
{
    if (dictionary::GetReceivedDataOfSrdo1Command(open) != 1U)
    {
        dictionary::SetSpeed(0U); // Elsewhere the getter answers the safe value, which is 0.
        return;
    }
    const std::uint16_t speed = dictionary::GetSpeed();
    const std::uint16_t setpoint = dictionary::GetSetpoint();
    const std::uint16_t step = dictionary::GetStep();
    if (speed < setpoint)
    {
        dictionary::SetSpeed(static_cast<std::uint16_t>(((setpoint - speed) > step) ? speed + step : setpoint));
    }
    else
    {
        dictionary::SetSpeed(static_cast<std::uint16_t>(((speed - setpoint) > step) ? speed - step : setpoint));
    }
}

RefreshAnswer Drive::OnRefresh(CommunicationIndex /*index*/) noexcept
{
    return RefreshAnswer::kReady; // Of a producer: this device has none.
}

void Drive::OnSrdoEvent(CommunicationIndex /*index*/) noexcept
{
}

void Drive::OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept
{
}

void Drive::OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept
{
}

void Drive::OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept
{
}

Device::Device(const Hardware& hardware) noexcept
    : kernel_{KernelParts{a_, b_, hardware.can, hardware.output, hardware.watchdog, watch_, nullptr, &windows_[0]}},
      services_{cia301::NodeId{dictionary::kNodeId},
                device::ServiceParts{emergency_, hardware.can, dictionary_,
                                     device::ServiceRooms{{supervised_, 1U},
                                                          {tpdos_, 1U},
                                                          {rpdos_, 1U},
                                                          {sdo_buffer_, dictionary::kLongestObjectBytes}}}},
      stored_entries_{dictionary::kEntryTable, dictionary_, services_.tpdos, services_.rpdos,
                      dictionary::DefaultsOfNode()},
      stored_safety_{kernel_, dictionary::NodeNow()},
      store_{cia301::StoreParts{hardware.memory, parts_, 2U, {scratch_, kScratchBytes}}},
      whole_{device::DeviceParts{kernel_, watch_, dictionary_, services_, *this,
                                 device::FrameRoom{safety_frames_, kSafetyFrames},
                                 device::FrameRoom{service_frames_, kServiceFrames}, dictionary::kSrdoCount}}
{
    AttachServices();
    static_cast<void>(store_.Mount()); // Whether there is a set: Load tells what matters.
}

/// Objects that a service keeps itself; all others are in the generated table.
void Device::AttachServices() noexcept
{
    generated::StoredObjects& objects = dictionary::Objects();
    static_cast<void>(objects.Attach({0x1001U, 0x1003U}, {&services_.objects, &services_.objects}));
    static_cast<void>(objects.Attach({0x1010U, 0x1011U}, {&store_objects_, &store_objects_}));
    static_cast<void>(objects.Attach({0x1014U, 0x1017U}, {&services_.objects, &services_.objects}));
    static_cast<void>(objects.Attach({0x1200U, 0x1200U}, {&services_.sdo_port, nullptr}));
    static_cast<void>(objects.Attach({0x1400U, 0x1BFFU}, {&services_.pdos, &services_.pdos}));
}

void Device::Cycle(const CycleCall& call) noexcept
{
    whole_.Cycle(call);
    store_.OnCycle();
}

/// Only a restart with all start-up tests leads out of the device safe state, and this device has none (hal/api and
/// selftest have).
device::LoadResult Device::OnResetNode() noexcept
{
    const bool is_safe = (started_ == StartResult::kStarted) && (kernel_.DeviceState().fault != DeviceFault::kNone);
    started_ = is_safe ? StartResult::kInvalid : kernel_.Start(dictionary::Device(), FlowCallback::kOff);
    dictionary::ResetApplication();
    groups_ = cia301::kAllGroups;
    return (started_ == StartResult::kStarted) ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

/// First what the file says, then what was saved of it. A set that was lost or is refused leaves 13FEh without A5h: no
/// SRDO works until a configuration is written and saved again, and an emergency says so.
device::LoadResult Device::OnResetCommunication() noexcept
{
    dictionary::ResetCommunication();
    const generated::PresetReply services = dictionary::Objects().Preset({0x1000U, 0x1FFFU});
    const generated::ConfigureReply safety = dictionary::Configure(kernel_);
    if ((services.abort != cia301::SdoAbort::kNone) || (safety.abort != AbortCode::kNone))
    {
        return device::LoadResult::kFailed; // The file and this program do not belong together.
    }
    if (IsSound(store_.Load(groups_)))
    {
        emergency_.Clear(kDataSetError);
    }
    else
    {
        emergency_.Raise(cia301::EmergencyError{kDataSetError, 0U, {}});
    }
    groups_ = cia301::kCommunicationGroup;
    return device::LoadResult::kLoaded;
}

bool Device::IsStoring() const noexcept
{
    return store_.IsBusy();
}

} // namespace whole_device
