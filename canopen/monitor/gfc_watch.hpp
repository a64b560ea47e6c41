// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_MONITOR_GFC_WATCH_HPP
#define CANOPEN_MONITOR_GFC_WATCH_HPP

#include "canopen/monitor/network.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace counterpoint::monitor
{
/// Watches whether an SRDO follows each GFC. The frame does not tell its sender, so one of the devices that may send
/// GFC (1300h = 1) has to send an SRDO within its own shortest refresh time. [SRS_MON_016]
class GfcWatch
{
  public:
    /// @brief No GFC is open.
    explicit GfcWatch(const Network& network);

    /// @brief A data frame with an identifier of 11 bits.
    void OnFrame(const LogFrame& frame) noexcept;
    /// @brief Frames were missed: no SRDO is awaited any more.
    void Stop() noexcept;
    /// @brief The violation whose limit has expired before `now`, told once.
    [[nodiscard]] std::optional<Breach> Advance(Time now);
    /// @brief Until when an SRDO is awaited; the greatest time: none is.
    [[nodiscard]] Time Deadline() const noexcept;

  private:
    static constexpr std::uint32_t kGfc = 0x001U;
    static constexpr std::uint32_t kFirstSrdo = 0x101U;
    static constexpr std::size_t kSrdoIdentifiers = 0x80U;

    std::array<Time, kSrdoIdentifiers> limits_{}; ///< By the identifier of a normal frame; 0: it is none of a sender's.
    Time greatest_{0};                            ///< Of the limits; 0: no device may send GFC.
    std::optional<Time> open_;                    ///< Time of a GFC that no SRDO has followed.
};
} // namespace counterpoint::monitor

#endif // CANOPEN_MONITOR_GFC_WATCH_HPP
