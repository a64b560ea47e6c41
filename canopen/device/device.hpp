// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_DEVICE_DEVICE_HPP
#define CANOPEN_DEVICE_DEVICE_HPP

#include "canopen/device/kernel_watch.hpp"
#include "canopen/device/safety_queue.hpp"
#include "canopen/device/services.hpp"

#include "safety_core/kernel/kernel.hpp"

#include <atomic>
#include <cstdint>

namespace counterpoint::device
{

/// Whether a device could be loaded.
enum class LoadResult : std::uint8_t
{
    kInvalid = 0U,
    kLoaded = 0x69U,
    kFailed = 1U,
};

/// Knows the power-on values of a device and what it has stored. Its functions are called within PowerOn, Serve and
/// Cycle.
class Owner
{
  public:
    /// @brief Reset node: start the kernel with all self tests, configure it, load the application objects. kFailed
    /// keeps the device in INITIALISATION.
    [[nodiscard]] virtual LoadResult OnResetNode() noexcept = 0;
    /// @brief Reset communication: load the objects of 1000h to 1FFFh, 1300h to 13FFh among them. The services are as
    /// at power-on already. kFailed as above. Where LSS gave another node-ID (Services::node), start the kernel with
    /// it.
    [[nodiscard]] virtual LoadResult OnResetCommunication() noexcept = 0;
    /// @brief Whether a store reads the objects at present: until it has ended no reset touches them. [SRS_DEV_025]
    [[nodiscard]] virtual bool IsStoring() const noexcept
    {
        return false;
    }

  protected:
    Owner() noexcept = default;
    ~Owner() noexcept = default;
    Owner(const Owner&) = default;
    Owner& operator=(const Owner&) = default;
};

/// What a device is made of; all outlive it. `watch` is the application of `kernel`; `dictionary` is that of
/// `services`, and what its table does not have it asks the kernel for.
struct DeviceParts
{
    Kernel& kernel;
    KernelWatch& watch;
    cia301::Dictionary& dictionary;
    Services& services;
    Owner& owner;
    FrameRoom safety_room;   ///< Two frames for each SRDO and two more.
    FrameRoom service_room;  ///< What may wait between two calls of Serve.
    std::uint8_t srdo_count; ///< Number of SRDOs of the kernel's device.
};

/// What a device without services is made of: as DeviceParts, with NoServices as `services`. [SRS_DEV_022]
struct BareParts
{
    Kernel& kernel;
    ServiceSet& services;
    Owner& owner;
    FrameRoom safety_room;
    std::uint8_t srdo_count;
    FrameRoom service_room{nullptr, 0U};
};

/// A whole CANopen Safety device: the kernel and the services of CiA 301 on one or two CAN controllers.
///
///     reception, in bus order:  OnFrame, OnConfirm, OnLoss      may interrupt all others
///     once a cycle:             Cycle
///     between cycles, optional: Serve                           shorter answers, inverse frames at once
///
/// No clock, no heap; times are those of counter A. Not reentrant but for the reception. [SRS_DEV_001, SRS_DEV_002,
/// SRS_DEV_003, SRS_DEV_004, SRS_DEV_005, SRS_DEV_006, SRS_DEV_007, SRS_DEV_008, SRS_DEV_009, SRS_DEV_010, SRS_DEV_011,
/// SRS_DEV_012, SRS_DEV_013, SRS_DEV_014, SRS_DEV_015, SRS_DEV_016, SRS_DEV_017, SRS_DEV_018]
class Device
{
  public:
    /// @brief A device with services; off until PowerOn.
    explicit Device(const DeviceParts& parts) noexcept;
    /// @brief A device without services; off until PowerOn.
    explicit Device(const BareParts& parts) noexcept;

    /// @brief Supply on: INITIALISATION, boot-up message, and the state that 1F80h leads to. kLoaded: the device came
    /// up, or waits for a node-ID or for the end of a store. [SRS_DEV_002, SRS_DEV_019, SRS_DEV_025]
    [[nodiscard]] LoadResult PowerOn(Instant now) noexcept;
    /// @brief Supply off, of a device whose memory outlives it: frames that wait and the NMT state are gone, and
    /// PowerOn begins anew. [SRS_DEV_023]
    void PowerOff() noexcept;

    /// @brief A received frame. O(1) [SRS_DEV_005, SRS_DEV_007]
    void OnFrame(const StampedFrame& frame) noexcept;
    /// @brief A frame of this device was on the bus. O(1)
    void OnConfirm(const StampedFrame& frame) noexcept;
    /// @brief The hardware layer lost frames. [SRS_DEV_008]
    void OnLoss() noexcept;

    /// @brief The condition of the CAN controller; tell every change. Not from an interrupt. [SRS_DEV_016]
    void OnBus(BusCondition condition) noexcept;
    /// @brief Safety frames to the kernel, its cycle, then Serve. [SRS_DEV_006]
    void Cycle(const CycleCall& call) noexcept;
    /// @brief Safety frames to the kernel, then the services. O(frames that wait + services)
    void Serve(Instant now) noexcept;
    /// @brief Safety frames to the kernel and no more: what Serve and Cycle begin with. O(frames that wait)
    void HandOver() noexcept;

    /// @brief NMT state of the device.
    [[nodiscard]] cia301::NodeState State() const noexcept;

  private:
    static constexpr std::uint32_t kCommandRoom = 8U;

    [[nodiscard]] bool TakeLostOthers() noexcept;
    void Settle() noexcept;
    void Initialise() noexcept;
    [[nodiscard]] LoadResult Load() noexcept;
    void ApplyState() noexcept;
    void AdmitSrdos() noexcept;

    BareParts parts_;
    QueuedFrame command_frames_[kCommandRoom];
    SafetyQueue safety_;
    FrameRing commands_;
    FrameRing others_;
    NmtState kernel_state_;
    BusCondition bus_;
    bool is_failed_;  ///< The owner could not load; only PowerOn tries again.
    bool is_waiting_; ///< For a node-ID.
    std::atomic<bool> has_lost_others_;
};

} // namespace counterpoint::device

#endif
