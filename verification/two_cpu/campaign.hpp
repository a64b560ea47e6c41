// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TWO_CPU_CAMPAIGN_HPP
#define VERIFICATION_TWO_CPU_CAMPAIGN_HPP

#include "verification/two_cpu/device.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace counterpoint::two_cpu
{

/// What is broken at a random moment.
enum class Breakage : std::uint8_t
{
    kCpuDead = 0U,          ///< One CPU does nothing any more.
    kLinkCut = 1U,          ///< Both directions of the link.
    kLinkHalfCut = 2U,      ///< One direction.
    kClockStops = 3U,       ///< One CPU's clock, and its cycles with it.
    kClockStands = 4U,      ///< One CPU's clock; its cycles go on.
    kFlippedData = 5U,      ///< A bit of the data that one CPU's channel holds.
    kDeaf = 6U,             ///< One CPU's channel gets no frames any more.
    kFrozenChannel = 7U,    ///< One CPU's channel says what it said last.
    kFrozenComparator = 8U, ///< One CPU's comparator says what it said last.
};
constexpr std::size_t kBreakages = 9U;
[[nodiscard]] const char* NameOf(Breakage breakage);

/// Runs of one kind.
struct Score
{
    std::uint32_t runs{0U};
    std::uint32_t late{0U};     ///< Not safe within the limit, or open again later.
    std::uint32_t not_open{0U}; ///< The output was not open when it broke: says nothing.
    std::uint32_t limit_us{0U};
    double longest_us{0.0}; ///< From breaking to the safe output, to a millisecond.
    double sum_us{0.0};
};

struct CampaignResult
{
    std::array<Score, kBreakages> scores{};
    std::uint64_t first_bad_seed{0U};

    [[nodiscard]] bool Holds() const;
};

/// @brief One run: start, run up, break, judge. The same for the same seed. [SRS_TWO_017, SRS_TWO_018]
void RunOnce(Breakage breakage, std::uint64_t seed, Score& score);
/// @brief `runs` runs, the kinds in turn.
[[nodiscard]] CampaignResult RunCampaign(std::uint32_t runs, std::uint64_t seed);

struct SoakResult
{
    std::array<DeviceFaultReport, 2U> faults{};
    std::array<LinkCounts, 2U> counts{};
    std::array<std::uint64_t, 2U> released{};
    std::array<std::uint64_t, 2U> sent{};
    std::array<std::uint64_t, 2U> consumer_errors{};
    std::array<std::uint64_t, 2U> producer_errors{};
    std::array<std::uint16_t, 2U> demotions{};
    std::uint64_t pairs_heard{0U};
    std::uint64_t pairs_bad{0U};
    std::uint64_t sensor_faults{0U};
    double seconds{0.0};
    bool is_open{false};

    [[nodiscard]] bool Holds() const;
};
/// @brief So many simulated seconds with drift and a bad link, and nothing broken. [SRS_TWO_016]
/// `sensor_faults_ppm`: pairs in a million that the sensor does not send as it should; they are no device faults
/// either.
[[nodiscard]] SoakResult RunSoak(double seconds, std::uint64_t seed, std::uint32_t sensor_faults_ppm);
/// @brief The device of soak and campaign: 100 ppm against each other, a message in 1000 lost.
[[nodiscard]] DeviceSetup UsualSetup(std::uint64_t seed);

} // namespace counterpoint::two_cpu

#endif
