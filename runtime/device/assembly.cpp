// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/device/assembly.hpp"

#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/cia306/text/input_error.hpp"
#include "safety_core/comparator/comparator_self_test.hpp"
#include "safety_core/kernel/clock_supervisor.hpp"
#include "safety_core/kernel/limits.hpp"

#include <algorithm>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kServiceFrames = 256U;
constexpr std::uint16_t kHistory = 0x1003U;
constexpr std::uint32_t kCyclesOfDiscrepancy = 5U;
constexpr std::uint64_t kLongestIntervalUs = 0x3FFFFFFFU;

/// Those of 1300h to 13FFh, and the mappable ones.
DeviceObjects::IsKernels KernelsOf(const DeviceConfig& config)
{
    return [&config](const std::uint16_t index, const std::uint8_t sub)
    {
        const bool is_safety = index >= cia301::kFirstKernelIndex && index <= cia301::kLastKernelIndex;
        return is_safety || FindObject(config, KeyOf({index, sub})) != nullptr;
    };
}

} // namespace

ServiceAssembly::ServiceAssembly(const DeviceModel& model, const DeviceConfig& config, Kernel& kernel,
                                 const AssemblyParts& parts)
    : objects_(*parts.file, config.node_id, KernelsOf(config), parts.domain_bytes),
      history_(LastSubOf(*parts.file, kHistory)), errors_(device::EmergencyPlaces(config.srdo_count, objects_.Rooms())),
      messages_(errors_.size()),
      emergency_({config.node_id}, {history_.data(), static_cast<std::uint8_t>(history_.size())},
                 {errors_.data(), messages_.data(), static_cast<std::uint16_t>(errors_.size())}),
      watch_(emergency_, parts.application), facade_(kernel, objects_.Table()),
      dictionary_(objects_.Table(), model.Srdos().empty() ? static_cast<cia301::ForeignObjects&>(no_safety_)
                                                          : static_cast<cia301::ForeignObjects&>(facade_)),
      services_({config.node_id}, {emergency_, parts.can, dictionary_, objects_.Rooms()}),
      optional_(*parts.file, dictionary_, services_, {parts.owner, parts.owner},
                objects_.Rooms().sdo_buffer.size_bytes),
      room_(kServiceFrames)
{
}

void ServiceAssembly::PowerOff() noexcept
{
    while (emergency_.HasErrors())
    {
        emergency_.Clear(errors_.front().code, errors_.front().source);
    }
    if (lss_ != nullptr)
    {
        lss_->PowerOff();
        services_.lss = &lss_->Slave();
    }
}

DeviceAssembly::DeviceAssembly(DeviceModel& model, const DeviceConfig& config, const AssemblyParts& parts)
    : model_(model), config_(config), owner_(parts.owner),
      rest_((parts.file == nullptr) ? nullptr : std::make_unique<ServiceAssembly>(model, config, kernel_, parts)),
      bare_({config.node_id}, nullptr), told_((rest_ == nullptr) ? parts.application : rest_->watch_),
      windows_(config.srdo_count), kernel_({parts.channel_a, parts.channel_b, parts.can, parts.output, parts.watchdog,
                                            told_, parts.self_test, windows_.data(), parts.flow}),
      safety_room_(2U * config.srdo_count + 2U),
      device_((rest_ == nullptr)
                  ? device::Device(device::BareParts{kernel_, bare_, *this, SafetyRoom(), config.srdo_count})
                  : device::Device(device::DeviceParts{kernel_,
                                                       rest_->watch_,
                                                       rest_->dictionary_,
                                                       rest_->services_,
                                                       *this,
                                                       SafetyRoom(),
                                                       {rest_->room_.data(), kServiceFrames},
                                                       config.srdo_count}))
{
}

device::FrameRoom DeviceAssembly::SafetyRoom() noexcept
{
    return {safety_room_.data(), static_cast<std::uint32_t>(safety_room_.size())};
}

void DeviceAssembly::Connect(cia301::NumberHook* const store) noexcept
{
    rest_->objects_.Connect(
        rest_->services_, [this](const std::uint16_t index) { return rest_->optional_.HookOf(index); }, store);
}

void DeviceAssembly::UseLss(const cia306::Device& file, const cia305::LssSettings& settings, KeepLss keep)
{
    rest_->lss_ =
        std::make_unique<DeviceLss>(rest_->services_.outbox, file, settings, config_.node_id, std::move(keep));
    rest_->services_.lss = &rest_->lss_->Slave();
}

std::uint8_t DeviceAssembly::NodeId() const noexcept
{
    return (rest_->lss_ != nullptr) ? rest_->lss_->NodeId() : rest_->services_.node.value;
}

void DeviceAssembly::PowerOff() noexcept
{
    if (rest_ != nullptr)
    {
        rest_->PowerOff();
    }
    device_.PowerOff();
    new_node_id_ = 0U;
}

std::optional<std::uint8_t> DeviceAssembly::NewNodeId() const noexcept
{
    return (new_node_id_ == 0U) ? std::nullopt : std::optional(new_node_id_);
}

device::LoadResult DeviceAssembly::OnResetNode() noexcept
{
    model_.ResetVariables();
    if (rest_ != nullptr)
    {
        rest_->objects_.LoadApplication();
    }
    owner_.OnStart();
    const StartResult result = kernel_.Start(config_, FlowCallback::kOff);
    if (result != StartResult::kStarted)
    {
        owner_.OnNoStart(result);
        return device::LoadResult::kFailed;
    }
    for (const StaticTable& table : model_.StaticTables())
    {
        // What the kernel says of a mapping before its SRDO is configured is not looked at: 13FEh has the last word.
        static_cast<void>(kernel_.DefineStaticFields(CommunicationIndexOf(table.number), model_.FieldsOf(table)));
    }
    owner_.OnLoaded(cia301::kApplicationGroup | cia301::kManufacturerGroup);
    return device::LoadResult::kLoaded;
}

device::LoadResult DeviceAssembly::OnResetCommunication() noexcept
{
    if (rest_ != nullptr && rest_->services_.node.value != config_.node_id)
    {
        new_node_id_ = rest_->services_.node.value;
        return device::LoadResult::kFailed; // Silent until another device has been made.
    }
    if (rest_ != nullptr)
    {
        rest_->objects_.LoadCommunication();
    }
    owner_.OnResetCommunication((rest_ == nullptr) ? std::vector<cia306::Finding>{} : rest_->objects_.Refusals());
    if (!IsSafetyLoaded())
    {
        LoadSafety();
    }
    owner_.OnLoaded(cia301::kCommunicationGroup);
    return device::LoadResult::kLoaded;
}

bool DeviceAssembly::IsStoring() const noexcept
{
    return owner_.IsSaving();
}

/// Writing the same values again would withdraw 13FEh for a moment.
bool DeviceAssembly::IsSafetyLoaded() noexcept
{
    const auto& writes = model_.Writes();
    return std::all_of(writes.begin(), writes.end(),
                       [this, &writes](const ConfigurationWrite& write)
                       {
                           // Each object counts with the last value that it gets.
                           const auto same = [&write](const ConfigurationWrite& other)
                           { return other.object.index == write.object.index && other.object.sub == write.object.sub; };
                           const auto last = std::find_if(writes.rbegin(), writes.rend(), same);
                           const ObjectReading reading = kernel_.ReadObject(write.object);
                           return reading.abort == AbortCode::kNone && ToValue(reading.data) == last->value;
                       });
}

void DeviceAssembly::LoadSafety() noexcept
{
    for (const ConfigurationWrite& write : model_.Writes())
    {
        const AbortCode code = kernel_.WriteObject(write.object, DataOf(write));
        if (code != AbortCode::kNone)
        {
            owner_.OnRefused(write, code);
        }
    }
}

std::uint32_t DeviceAssembly::CyclesPerSend() noexcept
{
    std::uint32_t shortest = 0U;
    for (SlotIndex slot = 0U; slot < model_.Srdos().size(); ++slot)
    {
        const ParametersReply parameters = kernel_.GetParameters(CommunicationIndexOf(model_.NumberOf(slot)));
        const bool sends =
            parameters.direction == kDirectionProducer && config_.srdos[slot].form == ProducerForm::kApplicationSends;
        const std::uint32_t cycles = (parameters.refresh_ms * kMicrosecondsPerMillisecond) / config_.cycle_us;
        if (sends && (shortest == 0U || cycles < shortest))
        {
            shortest = std::max(cycles, std::uint32_t{1U});
        }
    }
    return shortest;
}

void DeviceAssembly::SendAll() noexcept
{
    for (SlotIndex slot = 0U; slot < config_.srdo_count; ++slot)
    {
        if (config_.srdos[slot].form == ProducerForm::kApplicationSends)
        {
            static_cast<void>(
                kernel_.Send(CommunicationIndexOf(model_.NumberOf(slot)))); // Consumers among them refuse.
        }
    }
}

DeviceConfig ConfigOf(const DeviceModel& model, const std::optional<std::uint32_t> cycle_us)
{
    DeviceConfig config = model.Config();
    if (cycle_us && *cycle_us != config.cycle_us)
    {
        for (const SrdoModel& srdo : model.Srdos())
        {
            if (srdo.direction == kDirectionProducer && *cycle_us > srdo.times.sct_ms * kMicrosecondsPerMillisecond)
            {
                throw cia306::InputError(model.File(), {},
                                         {"--cycle-us " + std::to_string(*cycle_us) + " for SRDO " +
                                              std::to_string(srdo.number) + ", which is sent every " +
                                              std::to_string(srdo.times.sct_ms) + " ms",
                                          "a cycle that is no longer"});
            }
        }
        // As many cycles as before: the self tests do about as much in each.
        const std::uint64_t cycles = config.diagnostic_interval_us / config.cycle_us;
        const std::uint64_t same_us = std::min<std::uint64_t>(cycles * *cycle_us, kLongestIntervalUs);
        config.cycle_us = *cycle_us;
        config.cycle_tolerance_us = *cycle_us;
        config.discrepancy_us = std::max(config.discrepancy_us, kCyclesOfDiscrepancy * *cycle_us);
        config.diagnostic_interval_us = std::max({config.diagnostic_interval_us, static_cast<std::uint32_t>(same_us),
                                                  2U * LateCycleUs(config) * config.srdo_count});
        config.test_interval_us = std::max(config.test_interval_us, ComparatorSelfTest::LongestRoundUs(config));
        config.clock_interval_us = std::max(config.clock_interval_us, ClockSupervisor::LeastIntervalUs(config));
        config.digest = 0U;
    }
    return config;
}

hal::WatchdogWindow WindowOf(const DeviceConfig& config) noexcept
{
    return {config.cycle_us / 2U, config.cycle_us + config.cycle_tolerance_us};
}
} // namespace counterpoint::runtime
