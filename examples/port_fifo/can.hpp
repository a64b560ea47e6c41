// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_FIFO_CAN_HPP
#define EXAMPLES_PORT_FIFO_CAN_HPP

#include "clocks.hpp"
#include "hal/api/can_ports.hpp"
#include "registers.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <atomic>
#include <cstdint>

namespace port_fifo
{

/// What happened on the bus.
enum class EventKind : std::uint8_t
{
    kInvalid = 0U, ///< Read as a loss.
    kNothing = 1U,
    kLoss = 2U,
    kReceived = 0x3CU,
    kConfirmed = 0x5AU,
};

struct CanEvent
{
    EventKind kind;
    counterpoint::StampedFrame frame;
};

/// Identifiers that pass the filters.
struct FilterList
{
    const std::uint16_t* identifiers;
    std::uint8_t count; ///< At most kFilters.
};

/// The one CAN controller. The interrupt takes frames and transmit events out of the two FIFOs, the older one first,
/// and puts them with their stamps into a ring; the program takes them out before each cycle.
class Can final : public counterpoint::hal::CanPorts
{
  public:
    /// @brief `clocks` outlives this.
    explicit Can(Clocks& clocks) noexcept;

    /// @brief Filters set and read back, then on the bus. False: it stays off the bus and guarantees nothing.
    [[nodiscard]] bool Start(const FilterList& filters) noexcept;
    [[nodiscard]] counterpoint::hal::CanGuarantees Guarantees() const noexcept override;
    /// @brief The interrupt of the controller; not nested with itself.
    void OnInterrupt() noexcept;
    /// @brief The oldest event.
    [[nodiscard]] CanEvent Next() noexcept;

    static constexpr std::uint32_t kRoom = 32U;

  private:
    [[nodiscard]] counterpoint::hal::TransmitStatus DoTransmit(const counterpoint::CanFrame& frame) noexcept override;
    void TakeReceived(std::uint32_t timer, const counterpoint::InstantPair& now) noexcept;
    void TakeSent(std::uint32_t timer, const counterpoint::InstantPair& now) noexcept;
    void Put(const CanEvent& event) noexcept;

    Clocks& clocks_;
    counterpoint::CanFrame sent_[kBuffers]{};
    std::atomic<bool> in_flight_[kBuffers]{}; ///< Until its event was taken, whatever the hardware says of the buffer.
    CanEvent ring_[kRoom]{};
    std::atomic<std::uint32_t> put_{0U};   ///< Moved by the interrupt alone.
    std::atomic<std::uint32_t> taken_{0U}; ///< Moved by the program alone.
    std::atomic<bool> has_lost_{false};
    bool is_started_{false};
};

} // namespace port_fifo

#endif
