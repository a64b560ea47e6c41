// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_HAL_CONTRACT_TEST_FIFO_MODEL_HPP
#define TESTS_HAL_CONTRACT_TEST_FIFO_MODEL_HPP

#include "hal/api/watchdog_timer.hpp"
#include "registers.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

namespace port_fifo
{

/// The registers of the made-up controller, a bus with one other node, and time in whole microseconds. One at a time.
class FifoModel
{
  public:
    FifoModel();
    ~FifoModel();
    FifoModel(const FifoModel&) = delete;
    FifoModel(FifoModel&&) = delete;
    FifoModel& operator=(const FifoModel&) = delete;
    FifoModel& operator=(FifoModel&&) = delete;

    [[nodiscard]] std::uint32_t Read(std::uint32_t offset);
    void Write(std::uint32_t offset, std::uint32_t value);
    void Advance(std::uint32_t us);
    /// @brief The other node sends.
    void Send(const counterpoint::CanFrame& frame);
    /// @brief Reset of pins, watchdog and what comes with it.
    void Restart();
    [[nodiscard]] std::uint32_t Pins();
    [[nodiscard]] bool IsAlive();

    std::function<void()> interrupt{};
    bool bus_held{false};
    bool a_held{false};
    bool b_held{false};
    bool pin_held{false};
    bool interrupt_masked{false};
    std::uint32_t accesses{0U};
    std::deque<counterpoint::CanFrame> seen_by_peer{};

  private:
    struct Entry
    {
        counterpoint::CanFrame frame;
        std::uint32_t stamp;
    };
    struct OnBus
    {
        counterpoint::CanFrame frame;
        std::uint64_t end_us;
        std::optional<std::uint32_t> buffer;
    };

    [[nodiscard]] std::uint32_t ReadReceive(std::uint32_t offset) const;
    void Begin();
    void Finish();
    void Pass(std::uint64_t us);
    [[nodiscard]] bool IsAccepted(const counterpoint::CanFrame& frame) const;
    [[nodiscard]] counterpoint::CanFrame FrameOf(std::uint32_t buffer) const;

    std::array<std::uint32_t, 0x400U / 4U> plain_{};
    std::deque<Entry> received_{};
    std::deque<Entry> events_{}; ///< `frame.identifier` is the number of the buffer.
    std::deque<std::uint32_t> requests_{};
    std::deque<counterpoint::CanFrame> peer_{};
    std::optional<OnBus> on_bus_{};
    counterpoint::hal::WatchdogTimer watchdog_{};
    std::uint64_t now_us_{0U};
    std::uint64_t a_us_{1000U};
    std::uint64_t b_us_{1000U};
};

} // namespace port_fifo

#endif
