// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_CLOCKS_HPP
#define HAL_HOST_CLOCKS_HPP

#include "hal/api/clocks.hpp"
#include "hal/host/virtual/bit_rate.hpp"
#include "hal/host/virtual/bus.hpp"
#include "safety_core/contract/time.hpp"

#include <cstdint>

namespace counterpoint::host
{

/// Progress of a clock in millionths of the true one.
constexpr std::uint32_t kTrueRate = 1'000'000U;
constexpr std::uint32_t kStopped = 0U;
/// Greatest rate that a clock can have: a thousand times too fast.
constexpr std::uint32_t kGreatestRate = 1'000'000'000U;

/// A counter of microseconds as a function of bus time, piecewise linear, in integers: the reading is exact at every
/// instant, however often the rate was changed. Changes are made in ascending order of time. [SRS_HAL_010]
class HostClock
{
  public:
    /// @brief Reads `start_us` at bus time 0 and runs at the true rate.
    explicit HostClock(std::uint32_t start_us);

    /// @brief The reading at `at`, which is not before the last change.
    [[nodiscard]] Instant At(BusTime at) const;
    /// @brief From `at` on the clock runs at rate_ppm / 1 000 000 of the true rate: 1 000 100 is 100 ppm fast, 0 stands
    /// still, 2 000 000 runs twice as fast. At most kGreatestRate; more counts as that.
    void SetRate(BusTime at, std::uint32_t rate_ppm);
    /// @brief At `at` the reading jumps by so many microseconds, forward or back.
    void Jump(BusTime at, std::int32_t delta_us);

  private:
    struct Progress
    {
        std::uint64_t ns;
        std::uint64_t fraction; ///< Millionths of a nanosecond.
    };

    [[nodiscard]] Progress SinceOrigin(BusTime at) const;
    void Rebase(BusTime at);

    BusTime origin_{0};
    std::uint64_t base_ns_;
    std::uint64_t base_fraction_{0U}; ///< Millionths of a nanosecond.
    std::uint64_t rate_ppm_{kTrueRate};
};

/// The two counters of one device, read at the bus's present instant. A device whose clocks fail keeps them failed:
/// change them through A() and B().
class HostClocks final : public hal::Clocks
{
  public:
    /// @brief Both counters read `start` at bus time 0. `bus` outlives this.
    HostClocks(const VirtualBus& bus, const InstantPair& start);

    [[nodiscard]] InstantPair Now() noexcept override;
    /// @brief Both counters at bus time `at`, which is not before the last change.
    [[nodiscard]] InstantPair At(BusTime at) const;
    /// @brief The first counter, to be changed by faults.
    [[nodiscard]] HostClock& A()
    {
        return a_;
    }
    /// @brief The second counter, likewise.
    [[nodiscard]] HostClock& B()
    {
        return b_;
    }

  private:
    const VirtualBus& bus_;
    HostClock a_;
    HostClock b_;
};

} // namespace counterpoint::host

#endif
