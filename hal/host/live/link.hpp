// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_LINK_HPP
#define HAL_HOST_LIVE_LINK_HPP

#include "hal/host/live/bus.hpp"
#include "hal/host/live/poll.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace counterpoint::host
{

/// What Linux tells of a CAN interface.
struct LinkState
{
    int index{0};
    bool is_up{false};
    bool is_carrying{false};            ///< Its queue takes frames; just after bus-off it does not yet.
    std::optional<BusState> controller; ///< Empty: a virtual interface, which has no controller.
    std::uint8_t transmit_errors{0U};
    std::uint8_t receive_errors{0U};
    std::uint32_t restart_ms{0U}; ///< The kernel's own restart; 0: it has none.
};

/// @brief Reads one answer of the kernel (RTM_NEWLINK); empty: it is none. [SRS_LIVE_022]
[[nodiscard]] std::optional<LinkState> ReadLinkMessage(const std::uint8_t* bytes, std::size_t count);
/// @brief The message that asks the kernel for the state of an interface.
[[nodiscard]] std::vector<std::uint8_t> AskLinkMessage(int index);
/// @brief The message that starts a controller again after bus-off. [SRS_LIVE_022]
[[nodiscard]] std::vector<std::uint8_t> RestartLinkMessage(int index);
/// @brief The message that takes an interface up or down.
[[nodiscard]] std::vector<std::uint8_t> SwitchLinkMessage(int index, bool is_up);

/// State and orders of a CAN interface of Linux, by rtnetlink. Asking needs no rights; Restart and Switch need
/// CAP_NET_ADMIN. Throws LiveBusError when the system has no rtnetlink.
class LiveLink
{
  public:
    /// @brief Opens the connections to the kernel.
    LiveLink();
    /// @brief Readable when the state of some interface changed.
    [[nodiscard]] int Descriptor() const
    {
        return news_.Get();
    }
    /// @brief Takes all news. True: there were some, so that Ask may answer something new.
    [[nodiscard]] bool TakeNews();
    /// @brief The present state; empty: there is no such interface.
    [[nodiscard]] std::optional<LinkState> Ask(int index);
    /// @brief Restarts the controller after bus-off. Answers 0, or an errno.
    [[nodiscard]] int Restart(int index);
    /// @brief Takes the interface up or down. Answers 0, or an errno.
    [[nodiscard]] int Switch(int index, bool is_up);

  private:
    [[nodiscard]] int Order(const std::vector<std::uint8_t>& message);

    LiveFile news_;
    LiveFile orders_;
};

} // namespace counterpoint::host

#endif
