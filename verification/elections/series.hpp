// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_ELECTIONS_SERIES_HPP
#define VERIFICATION_ELECTIONS_SERIES_HPP

#include "verification/elections/bound.hpp"
#include "verification/elections/world.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace counterpoint::elections
{

/// How much later than computed failovers were.
struct Lateness
{
    std::uint64_t runs{0U};
    Time least{0};
    Time greatest{0};

    void Add(Time late);
    void Add(const Lateness& other);
};

/// What a series of runs showed.
struct Tally
{
    std::uint64_t runs{0U};
    std::uint64_t with_loss{0U}; ///< Runs in which a frame was lost.
    std::uint64_t frames{0U};
    std::uint64_t collisions{0U};
    std::uint64_t bus_offs{0U};
    std::uint64_t configuration_errors{0U};
    std::uint64_t failures{0U};
    Time longest{0};           ///< Until rest, from the last power-on, join or failure, without a lost frame.
    Time longest_with_loss{0}; ///< The same with one.
    Time least_left{kNever};   ///< Least time between rest and its bound.
    Time longest_two{0};       ///< Two active masters on one bus.
    std::map<Time, std::uint64_t> late_us{}; ///< Failover: time above the computed one, rounded down to 100 us.
    std::map<Time, Lateness> failovers{};    ///< By the computed time.
    std::string first_failure{};

    void Add(const Tally& other);
};

/// One run that is to come to rest: what it is held against.
struct Trial
{
    const std::vector<MasterPlan>& masters;
    Loss loss;
    Time from;      ///< The last thing that happened.
    Time limit;     ///< Rest at latest so long after it.
    Time quiet;     ///< Nothing may change for so long behind the limit.
    Time limit_two; ///< For two masters on one bus.
    Time repair;    ///< Part of the limit: what a lost frame may cost. A frame is lost before it begins.
};

/// @brief Runs `world`, in which all has happened, up to the limit and through the quiet time, and adds what was seen;
/// returns the frames that were complete at the limit. A failure is described by the whole plan.
std::uint32_t Judge(World& world, const Trial& trial, Tally& tally);

enum class Preset : std::uint8_t
{
    kDefault = 0U,
    kSo1114 = 1U, ///< With the supervision that its application has to install.
};

/// @brief Heartbeat 1 s, consumer time 2.5 s, cycle 1 ms, 125 kbit/s.
[[nodiscard]] WorldPlan PlanOf(Preset preset);
/// @brief `count` masters with node-ID 1 to `count`, level and power-on as told, 1F90h else as by default.
[[nodiscard]] std::vector<MasterPlan> MastersOf(const std::vector<std::uint8_t>& levels,
                                                const std::vector<Time>& power_on);

/// Whose frames are lost, one in a run.
enum class Losses : std::uint8_t
{
    kNone = 0U,
    kForAll = 1U,     ///< Nobody hears the frame, though its sender takes it for sent.
    kForEachToo = 2U, ///< And each receiver by itself.
};

/// @brief Each clock is up to 200 ppm slow or fast, and its 32-bit counter turns over within the first 20 s.
void GiveClocks(std::vector<MasterPlan>& masters, std::uint64_t seed);

/// @brief Node-ID 127, 1, 126 and 2 instead, with their own 1F90h:06: the longest and the shortest slots, and
/// neighbours.
void GiveFarNodes(std::vector<MasterPlan>& masters, std::uint64_t number);

/// What makes the masters of run `number` of a series other ones.
using Adapt = std::function<void(std::vector<MasterPlan>& masters, std::uint64_t number)>;

/// @brief All priorities x all offsets of `offsets` of each but the first master x loss of each frame until rest.
/// [SRS_FLY_023]
[[nodiscard]] Tally Combinations(Preset preset, std::size_t count, const std::vector<Time>& offsets, Losses losses,
                                 const Adapt& adapt = {});
/// @brief 0, one tick, one slot, 1F90h:01, :02, :04 in both directions.
[[nodiscard]] std::vector<Time> OffsetsOfTheText();
/// @brief -8 s to 8 s in 10 ms steps.
[[nodiscard]] std::vector<Time> OffsetsInSlots();
/// @brief All priorities x all ways to split `count` masters in two x instants of joining x loss of each frame
/// afterwards until rest. [SRS_FLY_024]
[[nodiscard]] Tally Splits(Preset preset, std::size_t count, Losses losses, const Adapt& adapt = {});
/// @brief Each variant of FlyingMasterOptions by itself over the preset, but those that are known not to work: in all
/// of 2 and of 3 masters, in the first and third, in the second alone; and both presets beside each other. Offsets of
/// the text and splits; with kNone 2 masters only, else frames of 2 masters are lost. [SRS_FLY_016]
[[nodiscard]] Tally Variants(Preset preset, Losses losses);
/// @brief The active one of 2 to 4 masters fails at each ms of its heartbeat's period. [SRS_FLY_026]
[[nodiscard]] Tally Failovers(Preset preset);
/// @brief The active one of 2 to 127 masters fails, `count` times, each with other values of 1F90h, other heartbeats,
/// bit rates and traffic. [SRS_FLY_026]
[[nodiscard]] Tally FailoversDrawn(Preset preset, std::size_t count);
/// How many masters a seeded run has.
enum class Crowd : std::uint8_t
{
    kExactly = 0U, ///< As many as told.
    kUpTo = 1U,    ///< 2 up to as many as told.
};

/// @brief Runs `first` to `first` + `count` - 1 of a seed, with `greatest` masters or up to as many. [SRS_FLY_025]
[[nodiscard]] Tally Seeded(Preset preset, std::uint32_t seed, std::uint32_t first, std::uint32_t count, Crowd crowd,
                           std::size_t greatest, const Adapt& adapt = {});

} // namespace counterpoint::elections

#endif
