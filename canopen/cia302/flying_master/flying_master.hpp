// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_FLYING_MASTER_HPP
#define CANOPEN_CIA302_FLYING_MASTER_FLYING_MASTER_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"
#include "canopen/cia302/flying_master/heard.hpp"
#include "canopen/cia302/flying_master/times.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What a flying master tells its listener, by the numbers of the text.
enum class FlyingEvent : std::uint8_t
{
    kInvalid = 0U,
    kSlaveMode = 1U,          ///< With the active master.
    kForceNegotiation = 2U,   ///< 076h was sent: the active master has a lower priority.
    kPowerOnReset = 3U,       ///< Reset communication of all nodes was sent.
    kMasterMode = 4U,         ///< With the own level and node-ID.
    kConfigurationError = 5U, ///< With whoever claims to be master and must not.
};

/// Is told how the negotiation goes. [SRS_FLY_002, SRS_FLY_005, SRS_FLY_006, SRS_FLY_007, SRS_FLY_008, SRS_FLY_009,
/// SRS_FLY_010]
class FlyingMasterListener
{
  public:
    /// @brief `claim` has meaning with kSlaveMode, kMasterMode and kConfigurationError only, and is all 0 otherwise.
    virtual void OnFlyingMaster(FlyingEvent event, const MasterClaim& claim, Instant now) noexcept = 0;
    /// @brief Communication was reset, by the flying master itself or by a command: every role has ended, local objects
    /// may be written. May call Start, now or later. Not called at power-on.
    virtual void OnInitialising(Instant now) noexcept = 0;

  protected:
    FlyingMasterListener() noexcept = default;
    ~FlyingMasterListener() noexcept = default;
    FlyingMasterListener(const FlyingMasterListener&) = default;
    FlyingMasterListener& operator=(const FlyingMasterListener&) = default;
};

/// Whether a negotiation began, or why not.
enum class FlyingStart : std::uint8_t
{
    kInvalid = 0U,
    kStarted = 0x69U,
    kNotInitialising = 1U,
    kNode = 2U,     ///< The own node-ID is not 1 to 127.
    kPriority = 3U, ///< 1F90h:03 above 2.
    kSlots = 4U,    ///< 1F90h:04 is not above 127 x 1F90h:05, or the latter is 0.
    kNoBus = 5U,    ///< The controller of the manager is not on the bus.
};

/// When OnCycle will have something to do, if nothing is heard before.
struct FlyingDeadline
{
    bool is_set;
    Instant at;
};

/// @brief Whether `left` is set and comes before `right`, or the latter is not set.
[[nodiscard]] constexpr bool IsEarlier(const FlyingDeadline& left, const FlyingDeadline& right) noexcept
{
    constexpr std::uint32_t kHalfRange = 0x80000000U;
    const std::uint32_t lead_us = right.at.us - left.at.us;
    return left.is_set && (!right.is_set || ((lead_us > 0U) && (lead_us < kHalfRange)));
}

/// What a flying master works with; all kept by reference.
struct FlyingMasterParts
{
    const NetworkSetup& setup;      ///< Own node-ID, heartbeat consumer times.
    const FlyingMasterTimes& times; ///< 1F90h; copied by Start.
    const FlyingMasterOptions& options;
    cia301::FrameSink& sink;
    FlyingMasterListener& listener;
};

/// Negotiates with others who is the NMT master. It sends 071h to 076h and reset communication, nothing else: who is
/// master decides who may command, never that anything is started. Call OnCycle at least once a device slot, better
/// each ms, with the frames in between in bus order; frames of this device itself must not come back. Not reentrant.
class FlyingMaster
{
  public:
    /// @brief Power-on: waits for Start.
    explicit FlyingMaster(const FlyingMasterParts& parts) noexcept;

    /// @brief The application lets the negotiation begin, with 1F90h as it is now. [SRS_FLY_002]
    [[nodiscard]] FlyingStart Start(Instant now) noexcept;
    /// @brief The device resets itself or went bus-off: every role ends, then as OnInitialising. [SRS_FLY_019]
    void Reset(Instant now) noexcept;
    /// @brief A frame from the bus. O(1)
    void OnFrame(const CanFrame& frame, Instant now) noexcept;
    /// @brief Does what is due; one step of the negotiation at most. O(1)
    void OnCycle(Instant now) noexcept;
    /// @brief The application's heartbeat consumer lost `node`. It matters if that node is the active master.
    /// [SRS_FLY_012]
    void OnHeartbeatLost(NodeId node, Instant now) noexcept;
    /// @brief Asks by 075h who else could be master. False: the sink is full. [SRS_FLY_018]
    [[nodiscard]] bool FindCapable() noexcept;

    /// @brief Whether 074h was heard since the last FindCapable.
    [[nodiscard]] bool HasFoundCapable() const noexcept
    {
        return has_found_capable_;
    }
    /// @brief Where the negotiation stands.
    [[nodiscard]] FlyingState State() const noexcept
    {
        return state_;
    }
    /// @brief Whether this device is the active master.
    [[nodiscard]] bool IsActiveMaster() const noexcept
    {
        return state_ == FlyingState::kMaster;
    }
    /// @brief Whether the device has to stay in INITIALISATION, without boot-up message and heartbeat.
    [[nodiscard]] bool IsInitialising() const noexcept;
    /// @brief The active master, in kSlave and kMaster; all 0 elsewhere.
    [[nodiscard]] MasterClaim Master() const noexcept
    {
        return master_;
    }
    /// @brief How many 076h were sent because a master of lower priority was heard, since this device was master or
    /// slave for a whole negotiation time without a negotiation. [SRS_FLY_010]
    [[nodiscard]] std::uint8_t Restarts() const noexcept
    {
        return restarts_;
    }
    /// @brief When OnCycle has something to do next, for an owner that sleeps until then.
    [[nodiscard]] FlyingDeadline Next() const noexcept;

  private:
    void React(FlyingReaction reaction, const CanFrame& frame, Instant now) noexcept;
    void ReactToClaim(FlyingReaction reaction, const MasterClaim& claim, Instant now) noexcept;
    void Join(bool is_asking, Instant now) noexcept;
    void Answer(std::uint32_t delay_us, Instant now) noexcept;
    void RunNegotiation(Instant now) noexcept;
    void RunQuestion(Instant now) noexcept;
    void RunMaster(Instant now) noexcept;
    void RunSlave(Instant now) noexcept;
    void EndRace(Instant now) noexcept;
    void SendReset(Instant now) noexcept;

    void Enter(FlyingInput input, Instant now, std::uint32_t time_us) noexcept;
    void Force(const MasterClaim& claim, FlyingEvent event, Instant now) noexcept;
    void Initialise(Instant now) noexcept;
    void Follow(const MasterClaim& claim, Instant now) noexcept;
    void WatchMaster(Instant now) noexcept;
    void Lose(Instant now) noexcept;

    FlyingMasterParts parts_;
    FlyingMasterTimes times_;
    MasterClaim master_;
    FlyingState state_;
    FlyingDeadline main_;   ///< End of the step; cyclic message of a master; heartbeat that a slave waits for.
    FlyingDeadline second_; ///< Answer that a master owes; 073h of a slave, or the answer to it; 073h in a race.
    Instant race_begin_;    ///< Only in kRace.
    Instant rest_begin_;    ///< Only in kSlave and kMaster.
    std::uint8_t restarts_;
    bool is_first_pass_; ///< Nobody reset the network since power-on.
    bool has_asked_;     ///< 073h of a slave or in a race is out.
    bool tells_force_;   ///< With the 076h that is to leave.
    bool owes_capable_;  ///< 074h is to leave.
    bool has_found_capable_;
};

} // namespace counterpoint::cia302

#endif
