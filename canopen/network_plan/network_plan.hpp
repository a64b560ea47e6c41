// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_NETWORK_PLAN_NETWORK_PLAN_HPP
#define CANOPEN_NETWORK_PLAN_NETWORK_PLAN_HPP

#include "canopen/cia302/flying_master/options.hpp"
#include "canopen/cia302/flying_master/times.hpp"
#include "canopen/cia302/network/setup.hpp"
#include "canopen/cia306/text/place.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::network_plan
{
using cia306::Place;

/// Lines of the keys in the network file. A CPJ has none.
using KeyPlaces = std::map<std::string, Place>;

/// @brief The place of `key`, or `otherwise`.
[[nodiscard]] inline Place PlaceOf(const KeyPlaces& places, const std::string& key, const Place otherwise)
{
    const auto found = places.find(key);
    return (found == places.end()) ? otherwise : found->second;
}

/// The start-up profiles.
enum class StartProfile : std::uint8_t
{
    kCia302 = 1U,
    kEl6751 = 2U,
    kPlcDesigner = 3U,
};

/// 1F90h, and which of the known behaviours the flying master has.
struct FlyingPlan
{
    std::optional<std::uint16_t> timeout_ms;    ///< Sub-index 1.
    std::optional<std::uint16_t> delay_ms;      ///< 2
    std::optional<std::uint16_t> priority;      ///< 3
    std::optional<std::uint16_t> level_slot_ms; ///< 4
    std::optional<std::uint16_t> node_slot_ms;  ///< 5
    std::optional<std::uint16_t> detect_ms;     ///< 6
    cia302::FlyingMasterOptions options{cia302::DefaultFlyingMaster()};
    bool is_by_order{false}; ///< The first negotiation waits for the application.
    KeyPlaces places;
};

/// What an RxPDO carries until an order changes it.
struct OutputPlan
{
    Place place; ///< Of the network file.
    std::uint16_t number{0U};
    std::vector<std::uint8_t> bytes;
};

/// Software of a slave that is to be verified (1F81h bit 5), and what an update downloads.
struct SoftwarePlan
{
    std::optional<std::uint32_t> identification; ///< 1F55h.
    std::optional<std::uint32_t> date;           ///< 1F53h.
    std::optional<std::uint32_t> time;           ///< 1F54h.
    std::string program;                         ///< Path of 1F58h, usable from here; empty: none.
    bool may_update{false};                      ///< 1F81h bit 6.
};

/// What a network file says about one slave; what it leaves out follows from the DCF.
struct SlavePlan
{
    std::uint8_t node{0U};
    Place place; ///< Of the network file.
    KeyPlaces places;
    std::string name;
    std::string dcf; ///< Path, usable from here.
    std::optional<std::uint32_t> assignment;
    std::optional<bool> is_mandatory;
    std::optional<bool> is_kept_alive;
    std::optional<bool> is_booted;
    std::optional<bool> is_restored; ///< 1F81h bit 7.
    std::optional<std::uint8_t> restore_sub;
    std::optional<SoftwarePlan> software;
    std::optional<std::uint16_t> heartbeat_ms; ///< 1017h of the slave.
    std::optional<std::uint16_t> consumer_ms;  ///< 1016h of the manager.
    std::optional<cia302::Arming> arming;
    std::optional<std::uint16_t> guard_ms;
    std::optional<std::uint8_t> retry_factor;
    std::optional<std::uint32_t> device_type;
    std::optional<std::uint32_t> vendor_id;
    std::optional<std::uint32_t> product_code;
    std::optional<std::uint32_t> revision;
    std::optional<std::uint32_t> serial;
    std::optional<std::uint32_t> date;
    std::optional<std::uint32_t> time;
    std::optional<cia302::El6751Slave> el6751; ///< Options alone: PDOs and times follow from the rest.
    std::optional<std::uint32_t> coupler_pdos; ///< 5500h of a bus coupler; else as its DCF says.
    std::optional<cia302::PlcSlave> plc;
    std::vector<OutputPlan> outputs; ///< Of the EL6751 profile.
    bool is_configured{true};        ///< Gets the concise DCF that its DCF makes.
    bool writes_safety{false};       ///< The manager writes the safety configuration where it differs.
};

/// What a network file says about the manager.
struct ManagerPlan
{
    std::optional<std::uint8_t> node;
    Place place;
    KeyPlaces places;
    std::string dcf; ///< Empty: none.
    StartProfile profile{StartProfile::kCia302};
    bool is_profile_chosen{false};         ///< A scenario has chosen it, for a file with keys of several profiles.
    std::optional<std::uint32_t> start_up; ///< 1F80h.
    std::optional<std::uint32_t> boot_time_ms;
    std::optional<std::uint16_t> inhibit_100us;
    std::optional<std::uint32_t> sync_us;
    std::optional<std::uint16_t> heartbeat_ms; ///< 1017h of the manager itself.
    std::optional<std::uint32_t> sdo_time_out_ms;
    std::optional<std::uint8_t> sdo_tries;
    std::optional<cia302::El6751Times> el6751;
    std::optional<FlyingPlan> flying;
};

/// What a network file says.
struct NetworkPlan
{
    std::string file;
    std::string name;
    ManagerPlan manager;
    std::vector<SlavePlan> slaves;     ///< In the order of the file; each node once.
    std::vector<std::string> warnings; ///< FILE:LINE: what its reader left aside.
};
} // namespace counterpoint::network_plan

#endif // CANOPEN_NETWORK_PLAN_NETWORK_PLAN_HPP
