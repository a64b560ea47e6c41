// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_CROSS_LINK_HPP
#define HAL_HOST_CROSS_LINK_HPP

#include "hal/api/cross_link.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace counterpoint::host
{

/// True time of a simulation in microseconds.
using LinkInstant = std::uint64_t;

/// What one direction of the wire does to frames. Frequencies in a million frames.
struct WireFaults
{
    std::uint32_t loss_ppm{0U};
    std::uint32_t most_lost_in_a_row{1'000'000'000U}; ///< After so many the next one gets through.
    std::uint32_t repeat_ppm{0U};                     ///< The frame comes a second time, after a delay of its own.
    std::uint32_t flip_ppm{0U};                       ///< One to three bits of the frame, at random places.
    std::uint32_t shortest_us{0U};
    std::uint32_t longest_us{0U}; ///< Each frame's delay is its own: later frames may overtake.
    bool is_cut{false};           ///< Nothing gets in; what is under way arrives.
};

/// The two ends of a wire.
enum class WireEnd : std::uint8_t
{
    kFirst = 0U,
    kSecond = 1U,
};

/// A wire between two CPUs in one process, controlled by a test. The same seed gives the same faults. [SRS_LNK_021]
class HostWire
{
  public:
    /// @brief Without faults and delay at first.
    explicit HostWire(std::uint64_t seed);

    /// @brief The side of one CPU. Lives as long as the wire.
    [[nodiscard]] hal::CrossLink& End(WireEnd end) noexcept
    {
        return ends_[static_cast<std::size_t>(end)];
    }
    /// @brief What happens to frames that this end sends from now on.
    [[nodiscard]] WireFaults& Faults(WireEnd sender) noexcept
    {
        return ends_[static_cast<std::size_t>(sender)].faults;
    }
    /// @brief Frames sent from now on are sent at `now`; Receive gives what arrived until `now`.
    void SetNow(const LinkInstant now) noexcept
    {
        now_ = now;
    }
    /// @brief When the frame arrived that this end received last.
    [[nodiscard]] LinkInstant ArrivedAt(WireEnd end) const noexcept
    {
        return ends_[static_cast<std::size_t>(end)].arrived_at;
    }

  private:
    struct Flight
    {
        LinkInstant arrives;
        hal::LinkFrame frame;
    };
    class Side final : public hal::CrossLink
    {
      public:
        [[nodiscard]] hal::LinkStatus Send(const hal::LinkFrame& frame) noexcept override;
        [[nodiscard]] hal::LinkStatus Receive(hal::LinkFrame& frame) noexcept override;

        HostWire* wire{nullptr};
        Side* other{nullptr};
        WireFaults faults{};
        std::vector<Flight> incoming{}; ///< Ascending by arrival.
        LinkInstant arrived_at{0U};
        std::uint32_t lost_in_a_row{0U};
    };

    [[nodiscard]] std::uint32_t Below(std::uint32_t end) noexcept;
    [[nodiscard]] bool Happens(std::uint32_t ppm) noexcept;
    void Carry(Side& from, const hal::LinkFrame& frame);

    std::uint64_t random_;
    LinkInstant now_{0U};
    std::array<Side, 2U> ends_{};
};

} // namespace counterpoint::host

#endif
