// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_ASSEMBLY_HPP
#define RUNTIME_DEVICE_ASSEMBLY_HPP

#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia306/file/device.hpp"
#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "hal/api/watchdog_timer.hpp"
#include "runtime/device/lss.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/objects/hooks.hpp"
#include "runtime/device/objects/objects.hpp"
#include "runtime/device/objects/optional_services.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Runs an assembly: is told what happens at the resets of the device, and what its services hear. Called within calls
/// of the assembly's device.
class AssemblyOwner : public cia301::TimeListener, public cia301::EmergencyListener
{
  public:
    /// @brief Reset node: the kernel is about to be started.
    virtual void OnStart() noexcept = 0;
    /// @brief The kernel refused the device, which stays in INITIALISATION.
    virtual void OnNoStart(StartResult result) noexcept = 0;
    /// @brief The values of the file were loaded; values that were stored are to be loaded now. `groups` are groups of
    /// cia301::ParameterStore.
    virtual void OnLoaded(std::uint8_t groups) noexcept = 0;
    /// @brief Whether a store reads the objects at present: a reset waits for its end.
    [[nodiscard]] virtual bool IsSaving() const noexcept
    {
        return false;
    }
    /// @brief The kernel refused a value of the file.
    virtual void OnRefused(const ConfigurationWrite& write, AbortCode code) noexcept = 0;
    /// @brief Communication was reset: states and values count as not told yet. `refusals`: values of the file that
    /// services refused.
    virtual void OnResetCommunication(const std::vector<cia306::Finding>& refusals) noexcept = 0;

  protected:
    AssemblyOwner() noexcept = default;
    ~AssemblyOwner() noexcept = default;
    AssemblyOwner(const AssemblyOwner&) = default;
    AssemblyOwner& operator=(const AssemblyOwner&) = default;
};

/// What the kernel and the services are given. Each may be a shipped part or a tap in front of one. All outlive it.
struct AssemblyParts
{
    Channel& channel_a;
    Channel& channel_b;
    hal::CanPorts& can;
    hal::SafetyOutput& output;
    hal::Watchdog& watchdog;
    Application& application;
    SelfTestPart* self_test; ///< Null: the device has none.
    AssemblyOwner& owner;
    /// Null: a device with NMT alone, without boot-up message; only its SRDOs are of interest.
    const cia306::Device* file;
    FlowWatch* flow{nullptr};                 ///< Null: the kernel's own flow monitor.
    std::uint32_t domain_bytes{kDomainBytes}; ///< Room of a DOMAIN that can be written.
};

/// Dictionary and services of a device of a DCF, and the KernelWatch that makes emergencies of the kernel's errors.
class ServiceAssembly
{
  public:
    /// @brief `kernel` need not be there yet. Throws cia306::InputError.
    ServiceAssembly(const DeviceModel& model, const DeviceConfig& config, Kernel& kernel, const AssemblyParts& parts);
    ServiceAssembly(const ServiceAssembly&) = delete;
    ServiceAssembly& operator=(const ServiceAssembly&) = delete;

    /// @brief Supply off: no error is active any more.
    void PowerOff() noexcept;

  private:
    DeviceObjects objects_;
    std::vector<std::uint32_t> history_;             ///< 1003h.
    std::vector<cia301::EmergencyError> errors_;     ///< Room for all that may be wrong at once,
    std::vector<cia301::EmergencyMessage> messages_; ///< and for telling it.
    cia301::EmergencyProducer emergency_;
    device::KernelWatch watch_;
    device::SafetyObjects facade_;
    cia301::NoObjects no_safety_{}; ///< Instead of it, for a plain device.
    cia301::Dictionary dictionary_;
    device::Services services_;
    OptionalServices optional_;
    std::unique_ptr<DeviceLss> lss_; ///< Null: none.
    std::vector<device::QueuedFrame> room_;

    friend class DeviceAssembly;
};

/// A device of a DCF: kernel, dictionary, services, and what joins them. On a host there is no other composition of
/// these parts; the simulator puts its taps into AssemblyParts. [SRS_NODE_001, SRS_SIM_001]
class DeviceAssembly final : private device::Owner
{
  public:
    /// @brief All arguments outlive it. Throws cia306::InputError.
    DeviceAssembly(DeviceModel& model, const DeviceConfig& config, const AssemblyParts& parts);

    /// @brief From now on the objects of services lead to the services; 1010h and 1011h to `store` (null: nothing is
    /// saved). Call once, before power-on, for a device with services.
    void Connect(cia301::NumberHook* store) noexcept;
    /// @brief An LSS slave with these settings gives the node-ID. `keep`: see KeepLss. Call once, before power-on, for
    /// a device with services. Throws cia306::InputError.
    void UseLss(const cia306::Device& file, const cia305::LssSettings& settings, KeepLss keep);
    /// @brief Supply off: what the services had in memory is gone.
    void PowerOff() noexcept;
    /// @brief The shortest refresh time of producers that the application sends by itself, in cycles; 0: it sends none.
    [[nodiscard]] std::uint32_t CyclesPerSend() noexcept;
    /// @brief Sends all SRDOs that the application sends by itself.
    void SendAll() noexcept;

    /// @brief The kernel.
    [[nodiscard]] Kernel& Core() noexcept
    {
        return kernel_;
    }
    /// @brief What the kernel has as its application.
    [[nodiscard]] Application& Told() noexcept
    {
        return told_;
    }
    /// @brief The object dictionary. Of a device with services only, like Services, Optional and Objects.
    [[nodiscard]] cia301::Dictionary& Dictionary() noexcept
    {
        return rest_->dictionary_;
    }
    /// @brief The services of every CANopen device.
    [[nodiscard]] device::Services& Services() const noexcept
    {
        return rest_->services_;
    }
    /// @brief The services that only some devices have.
    [[nodiscard]] OptionalServices& Optional() noexcept
    {
        return rest_->optional_;
    }
    /// @brief The present node-ID; 0: LSS has not given one yet.
    [[nodiscard]] std::uint8_t NodeId() const noexcept;
    /// @brief The device, for frames and cycles.
    [[nodiscard]] device::Device& Device() noexcept
    {
        return device_;
    }
    /// @brief The objects of the file.
    [[nodiscard]] DeviceObjects& Objects() noexcept
    {
        return rest_->objects_;
    }
    /// @brief The node-ID, if LSS gave another one and communication was reset: a new device with this node-ID has to
    /// be made.
    [[nodiscard]] std::optional<std::uint8_t> NewNodeId() const noexcept;

  private:
    [[nodiscard]] device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override;
    [[nodiscard]] bool IsStoring() const noexcept override;
    [[nodiscard]] device::FrameRoom SafetyRoom() noexcept;
    [[nodiscard]] bool IsSafetyLoaded() noexcept;
    void LoadSafety() noexcept;

    DeviceModel& model_;
    const DeviceConfig& config_;
    AssemblyOwner& owner_;
    std::unique_ptr<ServiceAssembly> rest_; ///< Null: NMT alone.
    device::NoServices bare_;               ///< Instead of them.
    Application& told_;
    std::vector<CauseWindows> windows_; ///< One for each SRDO.
    Kernel kernel_;
    std::vector<device::QueuedFrame> safety_room_;
    device::Device device_;
    std::uint8_t new_node_id_{0U};
};

/// @brief The configuration of the model. With another cycle time it is another device than that of the file: no digest
/// is expected, and times that must be some cycles long are made so. Throws cia306::InputError.
[[nodiscard]] DeviceConfig ConfigOf(const DeviceModel& model, std::optional<std::uint32_t> cycle_us);
/// @brief When the watchdog of such a device is to be served.
[[nodiscard]] hal::WatchdogWindow WindowOf(const DeviceConfig& config) noexcept;
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_ASSEMBLY_HPP
