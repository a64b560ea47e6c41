// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_HOST_FAKE_CAN_KERNEL_HPP
#define TESTS_HAL_HOST_FAKE_CAN_KERNEL_HPP

#include "tests/hal/host/system_calls.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <linux/can.h>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::host
{

/// What the kernel of Linux does for a raw socket of SocketCAN and for the two sockets of rtnetlink beside it, so that
/// a bus of an interface can be tested where the kernel has no CAN: interfaces that go down, are off the bus, are
/// removed, refuse frames. verification/vm shows the same code with the kernel itself.
class FakeCanKernel final : public SystemModel
{
  public:
    struct Interface
    {
        int index{7};
        bool is_up{true};
        bool is_carrying{true};
        /// The driver's word of its controller: CAN_STATE_ERROR_ACTIVE (0) to CAN_STATE_STOPPED (4); empty: kind vcan.
        std::optional<std::uint8_t> state{};
        std::uint8_t transmit_errors{0U};
        std::uint8_t receive_errors{0U};
    };

    /// A frame comes in, or back with `is_own`.
    void Arrive(const canfd_frame& frame, bool is_own = false, std::size_t bytes = CAN_MTU);
    void Arrive(std::uint32_t identifier, bool is_own = false);
    /// The next reading of the raw socket fails once.
    void FailReading(int failure);
    /// Some interface changed: the kernel tells it.
    void TellNews();

    std::optional<int> Socket(int domain, int type) override;
    std::optional<int> Bind(int file, const sockaddr& address) override;
    std::optional<int> SetOption(int file, int level, int option, const void* value, socklen_t bytes) override;
    std::optional<ssize_t> Send(int file, const void* bytes, std::size_t count) override;
    std::optional<ssize_t> Receive(int file, void* bytes, std::size_t room) override;
    std::optional<ssize_t> ReceiveMessage(int file, msghdr& message) override;
    std::optional<unsigned> IndexOf(const char* name) override;
    void OnClose(int file) override;

    std::map<std::string, Interface> interfaces{{"can0", Interface{}}};
    std::vector<canfd_frame> sent{};
    std::vector<std::size_t> sent_bytes{};
    std::vector<can_filter> filters{};
    std::deque<int> send_failures{};            ///< errno of the next frames that are sent, in order; 0: it is taken.
    std::deque<int> order_answers{};            ///< errno of the next orders of rtnetlink, in order; then 0.
    std::vector<std::string> orders{};          ///< "restart 7", "up 7", "down 7".
    int refused_option{-1};                     ///< Option of the raw socket that the kernel does not know.
    int socket_failure{0};                      ///< errno with which raw sockets are refused.
    bool is_link_mute{false};                   ///< rtnetlink takes orders and questions, and answers nothing.
    bool is_link_gone{false};                   ///< rtnetlink takes nothing.
    bool is_link_strange{false};                ///< rtnetlink answers with something else.
    bool is_news_empty{false};                  ///< News are messages without a byte.
    bool restarts{true};                        ///< A restart that is taken ends bus-off.
    std::uint32_t dropped{0U};                  ///< Frames that nobody took in time, as the next frame tells.
    std::optional<std::uint64_t> hardware_ns{}; ///< Stamp of the controller that the next frames have.

  private:
    enum class Kind : std::uint8_t
    {
        kRaw,
        kNews,
        kOrders,
    };
    struct Coming
    {
        canfd_frame frame;
        std::size_t bytes;
        bool is_own;
        int failure; ///< Not 0: no frame, but this errno.
    };

    [[nodiscard]] bool Is(int file, Kind kind) const;
    [[nodiscard]] int FileOf(Kind kind) const;
    [[nodiscard]] Interface* Find(int index);
    void Obey(int index, const std::uint8_t* bytes, std::size_t count);
    void Put(const Coming& coming);

    std::map<int, Kind> files_{};
    std::array<int, 3> latest_{-1, -1, -1}; ///< By kind: that of the bus that was opened last.
    std::deque<Coming> coming_{};
    std::vector<std::uint8_t> answer_{};
};

} // namespace counterpoint::host

#endif
