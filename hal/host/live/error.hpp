// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_ERROR_HPP
#define HAL_HOST_LIVE_ERROR_HPP

#include "hal/host/live/bus.hpp"

#include <optional>
#include <string>

namespace counterpoint::host
{

/// What an error frame tells about the controller.
struct ErrorNews
{
    std::optional<BusState> state; ///< Empty: says nothing of it.
    bool is_bus_off{false};
    bool is_restart{false};  ///< The controller was started again after bus-off.
    bool is_overflow{false}; ///< The controller lost a received frame.
    bool has_counters{false};
    std::uint8_t transmit_errors{0U};
    std::uint8_t receive_errors{0U};
};

/// @brief Reads a frame that has `error` set; of any other frame nothing is told. [SRS_LIVE_021]
[[nodiscard]] ErrorNews ReadErrorFrame(const LiveFrame& frame);
/// @brief In words, for people: "bus-off", "error passive (transmitter); 130 transmit, 0 receive errors".
/// [SRS_LIVE_021]
[[nodiscard]] std::string DescribeErrorFrame(const LiveFrame& frame);

} // namespace counterpoint::host

#endif
