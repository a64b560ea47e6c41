// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_FLAT_LINK_HPP
#define VERIFICATION_CAMPAIGN_FLAT_LINK_HPP

#include "hal/api/cross_link.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace counterpoint::campaign
{
struct Experiment;

/// A message on its way.
struct Flight
{
    std::int64_t at; ///< ns; when it arrives.
    hal::LinkFrame message;
};

constexpr std::size_t kMostFlights = 24U;

/// The cross link between two CPUs, with the messages that are on their way. Plain memory in the region. [SRS_CMG_062]
class FlatLink
{
  public:
    /// @brief From one CPU (0, 1) to the other. `fault` is one of this way of the link, or null; `turn` says how many
    /// messages came since it began.
    void Send(std::size_t from, const hal::LinkFrame& message, std::int64_t now, const Experiment* fault,
              std::size_t turn) noexcept;
    /// @brief The next one for this CPU that arrives until then; null: none.
    [[nodiscard]] const Flight* Next(std::size_t to, std::int64_t until) const noexcept;
    /// @brief Takes that one away.
    void Drop(std::size_t to) noexcept;

    std::int64_t delay_ns{0}; ///< Of each message.

  private:
    /// From one CPU to the other, in the order of arrival; what is behind `count` is 0.
    struct Way
    {
        std::array<Flight, kMostFlights> flights;
        std::size_t count;
        hal::LinkFrame held; ///< Comes behind a later one.
        bool has_held;
    };

    /// Messages since the fault began, and how many are to come first, less one.
    struct Wait
    {
        std::size_t turn;
        std::size_t others;
    };

    static void SendBehind(Way& way, const hal::LinkFrame& message, std::int64_t at, const Wait& wait) noexcept;
    static void Depart(Way& way, const hal::LinkFrame& message, std::int64_t at) noexcept;

    std::array<Way, 2U> ways_{};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_FLAT_LINK_HPP
