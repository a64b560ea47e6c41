// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_NODE_FIRMWARE_HPP
#define SIMULATOR_WORLD_NODE_FIRMWARE_HPP

#include "runtime/device/assembly.hpp"
#include "simulator/world/link_wire.hpp"
#include "simulator/world/node/inside.hpp"

#include "hal/host/can_ports.hpp"

#include <optional>

namespace counterpoint::simulator
{
/// What a node runs: kernel and services as an assembly, every call that reaches them, and what they tell of resets.
/// Nothing reaches a node that hangs or has no supply. [SRS_SIM_001, SRS_SIM_061, SRS_SIM_062]
class NodeFirmware final : public host::FrameSink, private runtime::AssemblyOwner
{
  public:
    /// @brief `ports` outlive it, too.
    NodeFirmware(const NodeInside& inside, hal::CanPorts& ports);

    [[nodiscard]] runtime::DeviceAssembly& Assembly() noexcept
    {
        return assembly_;
    }
    /// @brief Starts and commissions the kernel. Throws cia306::InputError.
    void Start();
    void PowerOff() noexcept;
    /// @brief Whether the kernel was started since the last call.
    [[nodiscard]] bool TakeRestart() noexcept;
    /// @brief Tells a new NMT state; in OPERATIONAL the configuration is followed.
    void FollowState();
    /// @brief As told last.
    [[nodiscard]] cia301::NodeState State() const noexcept
    {
        return state_;
    }

    void OnFrame(const StampedFrame& frame) override; // Of the controllers; the two below as well.
    void OnConfirm(const StampedFrame& frame) override;
    void OnOverflow() override
    {
        assembly_.Device().OnLoss();
    }
    /// @brief Of a CPU of two: the wire to the other one, which outlives it.
    void Join(LinkWire& wire) noexcept
    {
        wire_ = &wire;
    }
    /// @brief A message that came over it.
    void OnMessage(const hal::LinkFrame& frame);
    /// @brief Of a device with services.
    void OnBus(device::BusCondition condition) noexcept;
    /// @brief An NMT command that no frame of the bus carried.
    void Obey(cia301::NmtCommand command);
    void SendGfc();
    /// @brief Somebody writes into it, by no message of the bus; the journal tells whether it took the value. Of a node
    /// with services.
    void Store(const ObjectAddress& object, std::uint32_t value);
    /// @brief Another device of its kind stands here from the next reset on. Of a node with services.
    void SetSerial(std::uint32_t serial) noexcept
    {
        serial_ = serial;
    }
    /// @brief Before a cycle: the refresh of an application that sends by itself.
    void SendByApplication();
    void Cycle(const CycleCall& call);
    /// @brief Between two cycles, at `ServeAt`: services look at what the bus brought.
    void Serve();
    [[nodiscard]] Nanoseconds ServeAt() const noexcept
    {
        return serve_at_;
    }

  private:
    void OnStart() noexcept override; // Of the assembly; the six below as well.
    void OnNoStart(StartResult result) noexcept override;
    void OnLoaded(std::uint8_t groups) noexcept override;
    void OnRefused(const runtime::ConfigurationWrite& write, AbortCode code) noexcept override;
    void OnResetCommunication(const std::vector<cia306::Finding>& refusals) noexcept override;
    void OnTime(const cia301::TimeOfDay& time, Instant now) noexcept override;
    void OnEmergency(const cia301::ReceivedEmergency& emergency) noexcept override;
    void HandOver();

    NodeInside inside_;
    NodeProcessor& processor_;
    runtime::DeviceAssembly assembly_;
    LinkWire* wire_{nullptr};
    StartResult started_{StartResult::kStarted};               ///< What the kernel said last.
    std::optional<runtime::ConfigurationWrite> refused_write_; ///< The first one at this start.
    AbortCode refused_{AbortCode::kNone};
    std::optional<std::uint32_t> serial_; ///< 1018h:04 instead of the file's.
    cia301::NodeState state_{cia301::NodeState::kInvalid};
    device::BusCondition condition_{device::BusCondition::kActive};
    std::uint32_t cycles_to_send_{0U}; ///< Applications that send by themselves: cycles until the next refresh.
    std::uint32_t cycles_per_send_{0U};
    Nanoseconds serve_at_{kNever};
    bool has_restarted_{false};
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_NODE_FIRMWARE_HPP
