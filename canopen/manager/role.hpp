// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MANAGER_ROLE_HPP
#define CANOPEN_MANAGER_ROLE_HPP

#include "canopen/manager/listener.hpp"
#include "canopen/manager/own_device.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Who lets the negotiation begin whenever the device is initialising.
enum class NegotiationBy : std::uint8_t
{
    kManager = 0U,     ///< The manager, in the next cycle.
    kApplication = 1U, ///< The application, by StartNegotiation; the device stays in INITIALISATION until then.
};

/// What the role works with; all kept by reference.
struct RoleParts
{
    const NetworkSetup& setup;
    NodeTable& table;
    NmtMaster& nmt;
    OwnDevice& own;
    ManagerListener& listener;
};

/// Whether this device commands the network: without a flying master from Begin on, with one while the negotiation made
/// it the active master. The profile is begun and ended by it. [SRS_MGR_002, SRS_MGR_210,
/// SRS_MGR_211, SRS_MGR_212]
class ManagerRole final : public FlyingMasterListener
{
  public:
    /// @brief Commands nothing before Begin.
    explicit ManagerRole(const RoleParts& parts) noexcept;

    /// @brief The profile, kept by reference. Before Begin, which does nothing without one.
    void Use(StartUp& profile) noexcept;
    /// @brief The flying master, kept by reference, which has this as its listener; and who lets it begin. Before
    /// Begin. [SRS_FLY_027]
    void Use(FlyingMaster& flying, NegotiationBy by = NegotiationBy::kManager) noexcept;

    /// @brief The device restarts. It commands the network from then on, or negotiates first if it is a flying master.
    void Begin(Instant now) noexcept;
    /// @brief Ends profile and negotiation.
    void End() noexcept;
    /// @brief A frame from the bus, before any other part has it.
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Once a cycle.
    void OnCycle(Instant now) noexcept;
    /// @brief The controller went bus-off or is gone, or is back. [SRS_FLY_150]
    void OnBus(bool is_there, Instant now) noexcept;
    /// @brief A node, perhaps the active master, is silent.
    void OnHeartbeatLost(NodeId node, Instant now) noexcept;
    /// @brief The active master alone was commanded to reset itself: from the next cycle on it negotiates as any
    /// other device does after a reset. [SRS_FLY_151]
    void OnOwnReset() noexcept;
    /// @brief The application lets the negotiation begin. kInvalid: there is no flying master. [SRS_FLY_027]
    [[nodiscard]] FlyingStart StartNegotiation(Instant now) noexcept;

    /// @brief A command of the application, by the profile: see StartUp::Command.
    [[nodiscard]] NmtAnswer Command(NmtCommand command, NodeId node, Instant now) noexcept;
    /// @brief Begins the start-up of one slave again: see StartUp::Boot. False as that, and while this device does not
    /// command the network.
    [[nodiscard]] bool Boot(NodeId node, Instant now) noexcept;
    /// @brief Start-up of one slave without a reset: see StartUp::Resume. False as Boot.
    [[nodiscard]] bool Resume(NodeId node, Instant now) noexcept;

    /// @brief Sends the commands that wait, whatever the inhibit time. For an owner that ends the device in an orderly
    /// way and cannot wait for them any longer. [SRS_NMM_520]
    void Finish(const Instant now) noexcept
    {
        parts_.nmt.Finish(now);
    }
    /// @brief The commands that wait, to look at.
    [[nodiscard]] const NmtMaster& Commands() const noexcept
    {
        return parts_.nmt;
    }
    /// @brief Whether it is between Begin, with a profile, and End.
    [[nodiscard]] bool IsRunning() const noexcept
    {
        return is_running_;
    }
    /// @brief Whether the controller is on the bus.
    [[nodiscard]] bool IsOnBus() const noexcept
    {
        return !is_off_bus_;
    }
    /// @brief Whether this is a flying master that has not begun to negotiate.
    [[nodiscard]] bool IsInitialising() const noexcept;
    /// @brief The profile; null before Use.
    [[nodiscard]] StartUp* Profile() const noexcept
    {
        return profile_;
    }
    /// @brief The profile while this device commands the network, else null.
    [[nodiscard]] StartUp* Leading() const noexcept
    {
        return is_leading_ ? profile_ : nullptr;
    }
    /// @brief The flying master; null where there is none.
    [[nodiscard]] const FlyingMaster* Flying() const noexcept
    {
        return flying_;
    }

    void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept override;
    void OnInitialising(Instant now) noexcept override;

  private:
    void Lead(bool is_leader, Instant now) noexcept;
    void FollowFlying(Instant now) noexcept;
    void RunFlying(Instant now) noexcept;
    void TellLost(NodeId master, Instant now) noexcept;
    void TryNegotiation(Instant now) noexcept;
    void UnwatchAll() noexcept;

    RoleParts parts_;
    StartUp* profile_;
    FlyingMaster* flying_; ///< Null: none.
    NegotiationBy negotiation_;
    bool is_running_;
    bool is_leading_;  ///< The profile was begun.
    bool is_to_start_; ///< The negotiation is to be started in the next cycle.
    bool is_refused_;  ///< The listener was told that the negotiation cannot start.
    bool is_off_bus_;  ///< No negotiation begins.
    bool is_to_reset_; ///< This device was commanded to reset itself.
    bool is_owing_;    ///< The active master: 071h, or what it sends cyclically, had no room in the sink.
};

} // namespace counterpoint::cia302

#endif
