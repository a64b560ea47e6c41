// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_COMPARE_HPP
#define CANOPEN_CIA302_FLYING_MASTER_COMPARE_HPP

#include "canopen/cia302/flying_master/times.hpp"
#include "canopen/cia302/network/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// One flying master of a network and what it knows of the others, kept by reference.
struct FlyingMasterView
{
    const NetworkSetup* setup;
    const FlyingMasterTimes* times; ///< Its 1F90h.
};

/// What is different between two masters of one network, or wrong with one of them. The values and places are in
/// FlyingFinding.
enum class FlyingFindingKind : std::uint8_t
{
    kInvalid = 0U,
    kValue = 1U,        ///< Two masters have different values of an object.
    kContent = 2U,      ///< Different bytes: DCF, concise DCF, program. Values: place of the first one, or the lengths.
    kSafety = 3U,       ///< Another value of an object of the safety expectation.
    kPriority = 4U,     ///< 1F90h:03 of `first` above 2.
    kSlots = 5U,        ///< 1F90h:04 of `first` is not above 127 x 1F90h:05, or the latter is 0: their values.
    kSameNode = 6U,     ///< Two masters with one node-ID, or one that is not 1 to 127.
    kProfile = 7U,      ///< Another value of a profile's data: `sub` is an El6751Part, or 0: which profiles have some.
    kMissing = 8U,      ///< One of them has no such slave: values 1 and 0. No further finding for this slave.
    kUnknown = 9U,      ///< `second` is a master that is not in the network list of `first`.
    kNotFlying = 10U,   ///< 1F80h bit 5 of `first` is not set.
    kArming = 11U,      ///< Supervision by heartbeat begins otherwise.
    kOnlyFirst = 12U,   ///< Object of the safety expectation, with its value.
    kOnlySecond = 13U,  ///< The same.
    kPdo = 14U,         ///< Another value of a PDO's data, by the object and sub-index of the slave.
    kPlcOptional = 15U, ///< PLC Designer: optional or not.
    kPlcReset = 16U,    ///< PLC Designer: reset or not.
};

/// Parts of a slave's data for the EL6751 profile.
enum class El6751Part : std::uint8_t
{
    kProfiles = 0U, ///< Bit 0: there are data for EL6751, bit 1: for PLC Designer.
    kKind,
    kDeviceTypeChecked,
    kSyncPeriodWritten,
    kCobIdWritten,
    kTypeWritten,
    kStarted,
    kRestartedWithoutPdos,
    kConsumerLiteral,
    kNodeReaction,
    kRestart,
    kNetworkReaction,
    kLifeTimeFactor,
    kGuardTime,
    kCouplerPdos,
    kCouplerInhibit,
    kCouplerEvent,
    kRxCount,
    kTxCount,
};
constexpr std::uint8_t kEl6751Parts = 19U;

/// One finding. `slave` is 0 for objects of the master itself. Objects 1016h and 1017h with `sub` = `slave` stand for
/// the heartbeat times of that slave.
struct FlyingFinding
{
    FlyingFindingKind kind;
    std::uint8_t first; ///< Place among the masters that were compared.
    std::uint8_t second;
    NodeId slave;
    std::uint16_t index;
    std::uint8_t sub;
    std::uint64_t first_value;
    std::uint64_t second_value;
};

/// Is told of each finding.
class FlyingFindingListener
{
  public:
    /// @brief Called within CompareFlyingMasters only.
    virtual void OnFinding(const FlyingFinding& finding) noexcept = 0;

  protected:
    FlyingFindingListener() noexcept = default;
    ~FlyingFindingListener() noexcept = default;
    FlyingFindingListener(const FlyingFindingListener&) = default;
    FlyingFindingListener& operator=(const FlyingFindingListener&) = default;
};

/// @brief Compares each master with the first one: each of them has to run the same network in the same way if the
/// others fail. Nodes that are masters themselves are left out, as each knows the others only, but has to list them.
/// Safety expectations are ascending, as SafetyExpectation says. Returns how many findings were told. O(count x 127)
/// and the bytes of all contents. [SRS_FLY_022]
[[nodiscard]] std::uint32_t CompareFlyingMasters(const FlyingMasterView* masters, std::uint8_t count,
                                                 FlyingFindingListener& listener) noexcept;

} // namespace counterpoint::cia302

#endif
