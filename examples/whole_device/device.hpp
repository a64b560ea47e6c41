// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_WHOLE_DEVICE_DEVICE_HPP
#define EXAMPLES_WHOLE_DEVICE_DEVICE_HPP

#include "dictionary/object_dictionary.hpp"

#include "canopen/cia301/store/stored_parts.hpp"
#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "channel_a/channel.hpp"
#include "channel_a/storage.hpp"
#include "channel_b/channel.hpp"
#include "channel_b/storage.hpp"

#include <cstdint>

namespace whole_device
{

/// The board: four interfaces of hal/api, each with an implementation of yours. They outlive the device.
struct Hardware
{
    counterpoint::hal::CanPorts& can;
    counterpoint::hal::SafetyOutput& output;
    counterpoint::hal::Watchdog& watchdog;
    counterpoint::hal::ParameterMemory& memory;
};

/// What the drive does with its objects, and what the kernel tells it.
class Drive final : public counterpoint::Application
{
  public:
    /// @brief Behind each cycle of the device: the speed goes a step towards the setpoint of RPDO 1 while the released
    /// command is 1, and is 0 at once when it is not. `open` is what the output gate lets through.
    static void Cycle(counterpoint::SrdoMask open) noexcept;

    counterpoint::RefreshAnswer OnRefresh(counterpoint::CommunicationIndex index) noexcept override;
    void OnSrdoEvent(counterpoint::CommunicationIndex index) noexcept override;
    void OnSrdoError(counterpoint::CommunicationIndex index, counterpoint::SrdoCause cause) noexcept override;
    void OnConfigurationInvalid(counterpoint::CommunicationIndex index) noexcept override;
    void OnDeviceFault(const counterpoint::DeviceFaultReport& report) noexcept override;
};

/// A drive with everything that a CANopen Safety device has: SRDO, SDO, PDOs, heartbeat, emergencies, store. The same
/// source on host and target: no heap, no library but Counterpoint. Its tables and values are generated from
/// whole_device.dcf.
class Device final : private counterpoint::device::Owner
{
  public:
    /// @brief Off until `Whole().PowerOn`.
    explicit Device(const Hardware& hardware) noexcept;

    /// @brief For frames, cycles and power-on.
    [[nodiscard]] counterpoint::device::Device& Whole() noexcept
    {
        return whole_;
    }
    /// @brief One cycle of safety, services and store.
    void Cycle(const counterpoint::CycleCall& call) noexcept;

  private:
    static constexpr std::uint8_t kHistory = 2U; ///< Entries of 1003h.
    static constexpr std::uint32_t kSafetyFrames = (2U * dictionary::kSrdoCount) + 2U;
    static constexpr std::uint32_t kServiceFrames = 16U;
    static constexpr std::uint32_t kScratchBytes = 64U; ///< Of the store: the largest item.

    [[nodiscard]] counterpoint::device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] counterpoint::device::LoadResult OnResetCommunication() noexcept override;
    [[nodiscard]] bool IsStoring() const noexcept override;
    void AttachServices() noexcept;

    Drive drive_{};
    counterpoint::StartResult started_{counterpoint::StartResult::kInvalid};
    std::uint8_t groups_{0U}; ///< Those that the next reset communication loads.

    // The kernel and its two channels.
    counterpoint::channel_a::StorageFor<dictionary::kSrdoCount, dictionary::kMapEntries> storage_a_{};
    counterpoint::channel_b::StorageFor<dictionary::kSrdoCount, dictionary::kMapEntries> storage_b_{};
    counterpoint::channel_a::Channel a_{storage_a_.Handle()};
    counterpoint::channel_b::Channel b_{storage_b_.Handle()};
    std::uint32_t history_[kHistory]{};
    counterpoint::cia301::EmergencyProducer emergency_{counterpoint::cia301::NodeId{dictionary::kNodeId},
                                                       counterpoint::cia301::ErrorHistory{history_, kHistory}};
    counterpoint::device::KernelWatch watch_{emergency_, drive_}; ///< Makes emergencies of what the kernel tells.
    counterpoint::CauseWindows windows_[dictionary::kSrdoCount]{};
    counterpoint::Kernel kernel_;

    // The object dictionary: the generated table, and behind it the objects that the kernel owns.
    counterpoint::device::SafetyObjects safety_objects_{kernel_, dictionary::kEntryTable};
    counterpoint::cia301::Dictionary dictionary_{dictionary::kEntryTable, safety_objects_};

    // The services, each in room of this device.
    counterpoint::cia301::SupervisedNode supervised_[1]{};
    counterpoint::cia301::PdoField rpdo_fields_[1]{};
    counterpoint::cia301::PdoField tpdo_fields_[1]{};
    counterpoint::cia301::Rpdo rpdos_[1]{{1U, counterpoint::cia301::PdoMap{rpdo_fields_, 1U}}};
    counterpoint::cia301::Tpdo tpdos_[1]{
        {1U, counterpoint::cia301::PdoTrigger::kChange, counterpoint::cia301::PdoMap{tpdo_fields_, 1U}}};
    std::uint8_t sdo_buffer_[dictionary::kLongestObjectBytes]{};
    counterpoint::device::Services services_;

    // What 1010h keeps: entries of the table, and the safety configuration.
    counterpoint::cia301::StoredEntries stored_entries_;
    counterpoint::cia301::StoredSafety stored_safety_;
    counterpoint::cia301::StoredPart* parts_[2]{&stored_entries_, &stored_safety_};
    std::uint8_t scratch_[kScratchBytes]{};
    counterpoint::cia301::ParameterStore store_;
    counterpoint::cia301::StoreObjects store_objects_{store_};

    counterpoint::device::QueuedFrame safety_frames_[kSafetyFrames]{};
    counterpoint::device::QueuedFrame service_frames_[kServiceFrames]{};
    counterpoint::device::Device whole_;
};

} // namespace whole_device

#endif
