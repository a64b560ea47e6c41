// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_MANAGER_DRIVE_NODE_HPP
#define VERIFICATION_TARGET_MANAGER_DRIVE_NODE_HPP

#include "canopen/device/device.hpp"
#include "canopen/device/safety_objects.hpp"
#include "channel_a/channel.hpp"
#include "channel_b/channel.hpp"
#include "examples/actuator/actuator.hpp"
#include "verification/target/firmware/simulated_board.hpp"
#include "verification/target/manager/wire.hpp"

namespace counterpoint::target
{

/// In what the drive is not as the manager expects it; all zero: in nothing.
struct DriveDifference
{
    std::uint16_t sct_ms; ///< 1301h:02 with the signature that fits it; 0: as expected.
    std::uint32_t serial; ///< 1018h:04; 0: as expected.
};

/// The drive of examples/actuator as a whole device on the wire: kernel, both channels, the services of CiA 301.
class DriveNode final : public WireNode, private device::Owner
{
  public:
    explicit DriveNode(const DriveDifference& difference) noexcept;

    void Cycle(Instant now) noexcept override;
    [[nodiscard]] CanFrame Waiting() const noexcept override;
    void Sent(Instant now) noexcept override;
    void Hear(const CanFrame& frame, Instant now) noexcept override;

    [[nodiscard]] cia301::NodeState State() const noexcept
    {
        return device_.State();
    }
    /// @brief Outputs that are open now.
    [[nodiscard]] SrdoMask Open() noexcept
    {
        return output_.Open();
    }

  private:
    [[nodiscard]] device::LoadResult OnResetNode() noexcept override;
    [[nodiscard]] device::LoadResult OnResetCommunication() noexcept override;
    [[nodiscard]] bool ChangeSct() noexcept;
    void FillTable() noexcept;

    static constexpr std::uint32_t kEntries = 11U;
    static constexpr std::uint8_t kHistory = 8U;

    DriveDifference difference_;
    bool is_on_{false};
    Instant now_{0U};
    SimulatedCan can_{};
    SimulatedOutput output_{};
    SimulatedWatchdog watchdog_{};
    channel_a::StorageFor<1U> storage_a_{};
    channel_b::StorageFor<1U> storage_b_{};
    channel_a::Channel a_{storage_a_.Handle()};
    channel_b::Channel b_{storage_b_.Handle()};
    examples::Actuator actuator_{};
    std::uint32_t history_[kHistory]{};
    cia301::EmergencyProducer emergency_;
    device::KernelWatch watch_;
    Kernel kernel_;
    std::uint8_t identity_[5U][4U]{}; ///< 1018h:01 to :04, and 1000h.
    std::uint8_t identity_count_{4U};
    std::uint8_t digest_[4U]{}; ///< 5F04h
    cia301::Entry entries_[kEntries]{};
    device::SafetyObjects objects_;
    cia301::Dictionary dictionary_;
    cia301::SupervisedNode supervised_[1U]{};
    std::uint8_t sdo_buffer_[64U]{};
    device::QueuedFrame safety_frames_[4U]{};
    device::QueuedFrame service_frames_[16U]{};
    device::Services services_;
    device::Device device_;
};

} // namespace counterpoint::target

#endif
