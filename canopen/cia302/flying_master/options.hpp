// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_OPTIONS_HPP
#define CANOPEN_CIA302_FLYING_MASTER_OPTIONS_HPP

#include <cstdint>

namespace counterpoint::cia302
{

/// What the active master sends each 1F90h:06, so that a second one shows itself.
enum class CyclicMessage : std::uint8_t
{
    kForce = 0U,       ///< 076h: nobody but an active master reacts.
    kNegotiation = 1U, ///< 072h, as SO-1114: standbys of other makes may begin a race.
};

/// What the active master does when it hears 076h.
enum class ForceReaction : std::uint8_t
{
    kResetAll = 0U, ///< Reset communication of all nodes, as SO-1114.
    kRace = 1U,     ///< 072h at once, no reset.
    kRestart = 2U,  ///< Step 1, no reset; so does everybody who negotiates.
};

/// When a device that joins finds an active master of its own level.
enum class EqualLevel : std::uint8_t
{
    kStaysSlave = 0U,
    kLowerNodeForces = 1U,
};

/// What a standby does when its master is lost.
enum class LossReaction : std::uint8_t
{
    kRestart = 0U,  ///< Step 1, no reset.
    kResetAll = 1U, ///< Reset communication of all nodes, then step 1.
    kRace = 2U,     ///< 072h at once, no reset.
};

/// Who watches the heartbeat of the active master, with which time.
enum class MasterWatch : std::uint8_t
{
    kInstalled = 0U,     ///< The flying master: consumer time of that node in the network setup, else `watch_ms`.
    kTwiceProducer = 1U, ///< As before, but else twice `own_producer_ms`.
    kApplication = 2U,   ///< The application, which calls OnHeartbeatLost.
};

/// What a standby does when it hears 072h or 076h.
enum class StandbyReaction : std::uint8_t
{
    kIgnores = 0U,
    kAsks = 1U,  ///< 073h: stays slave if it is answered, else races.
    kRaces = 2U, ///< At 072h; ignores 076h. Known of other makes: a cyclic 072h begins a race each time.
};

/// In what this device differs from others that follow the same text. All values zero, but for the numbers, are the
/// default preset.
struct FlyingMasterOptions
{
    CyclicMessage cyclic;
    ForceReaction on_force;
    EqualLevel equal_level;
    LossReaction on_loss;
    MasterWatch watch;
    StandbyReaction standby;
    bool negotiates_pre_operational; ///< Boot-up comes before the negotiation; else the device waits in INITIALISATION.
    bool keeps_slot;                 ///< 072h of others does not begin the waiting anew.
    bool ignores_claims;             ///< As active master it ignores 071h of others.
    bool answers_boot_up;            ///< As active master it answers a foreign boot-up message with 071h.
    std::uint8_t max_restarts;       ///< How many 076h are sent because of worse masters, see Restarts; 0: no limit.
    std::uint16_t watch_ms;          ///< See MasterWatch; above 0.
    std::uint16_t own_producer_ms;   ///< 1017h of this device, see MasterWatch.
};

/// @brief The default preset. [SRS_FLY_015]
[[nodiscard]] constexpr FlyingMasterOptions DefaultFlyingMaster() noexcept
{
    FlyingMasterOptions options{};
    options.max_restarts = 3U;
    options.watch_ms = 1500U;
    options.own_producer_ms = 500U;
    return options;
}

/// @brief Preset `so1114`: as the reference's text. [SRS_FLY_015]
[[nodiscard]] constexpr FlyingMasterOptions So1114FlyingMaster() noexcept
{
    FlyingMasterOptions options = DefaultFlyingMaster();
    options.cyclic = CyclicMessage::kNegotiation;
    options.watch = MasterWatch::kApplication;
    options.standby = StandbyReaction::kAsks;
    options.max_restarts = 0U;
    return options;
}

} // namespace counterpoint::cia302

#endif
