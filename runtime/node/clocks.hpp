// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_CLOCKS_HPP
#define RUNTIME_NODE_CLOCKS_HPP

#include "hal/api/clocks.hpp"

#include <cstdint>

namespace counterpoint::runtime
{
/// The counters of a live node: A is CLOCK_MONOTONIC, B is CLOCK_MONOTONIC_RAW. Both come from one crystal; time
/// services adjust only the first. Stamps of frames and instants of cycles are in order: a frame that the system
/// delivers late, by no more than `tolerance_us`, gets the stamp of the frame before it. [SRS_NODE_002]
class NodeClocks final : public hal::Clocks
{
  public:
    /// @brief `tolerance_us`: by how much a frame may be late.
    explicit NodeClocks(std::uint32_t tolerance_us);

    /// @brief Reads both counters, as close together as the scheduler allows.
    [[nodiscard]] InstantPair Now() noexcept override;
    /// @brief The last Now as the instant of a cycle: no later stamp is before it.
    [[nodiscard]] InstantPair Seal() noexcept;
    /// @brief The stamp of a frame that was received at `time_ns` of CLOCK_MONOTONIC.
    [[nodiscard]] InstantPair Stamp(std::uint64_t time_ns) noexcept;
    /// @brief CLOCK_MONOTONIC of the last Now.
    [[nodiscard]] std::uint64_t NowNs() const noexcept
    {
        return monotonic_ns_;
    }
    /// @brief Number of frames that were delivered behind a frame with a later stamp.
    [[nodiscard]] std::uint64_t LateCount() const noexcept
    {
        return late_count_;
    }
    /// @brief By how much one of them was late at the most, in us.
    [[nodiscard]] std::uint64_t LatestUs() const noexcept
    {
        return latest_us_;
    }

  private:
    [[nodiscard]] static InstantPair PairOf(std::uint64_t a_us, std::uint64_t b_us) noexcept;

    std::uint64_t tolerance_us_;
    std::uint64_t monotonic_ns_{0U};
    std::uint64_t ahead_ns_{0U}; ///< MONOTONIC_RAW minus MONOTONIC, modular.
    std::uint64_t newest_a_us_{0U};
    std::uint64_t newest_b_us_{0U};
    std::uint64_t late_count_{0U};
    std::uint64_t latest_us_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_CLOCKS_HPP
