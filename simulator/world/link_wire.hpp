// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_WORLD_LINK_WIRE_HPP
#define SIMULATOR_WORLD_LINK_WIRE_HPP

#include "simulator/faults/frame_selector.hpp"
#include "simulator/faults/random.hpp"
#include "simulator/scenario/scenario.hpp"

#include "hal/api/cross_link.hpp"

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace counterpoint::simulator
{
/// A message that has arrived.
struct LinkArrival
{
    NodeIndex receiver{0U};
    hal::LinkFrame frame{};
};

/// The wire between the two CPUs of a device, with its faults. [SRS_SIM_056, SRS_SIM_057]
class LinkWire
{
  public:
    /// @brief `first` is CPU A, the next node is CPU B. Both given outlive the wire.
    LinkWire(const Scenario& scenario, NodeIndex first, Journal& journal);

    /// @brief A CPU sends a message.
    void Send(NodeIndex sender, const hal::LinkFrame& frame, Nanoseconds now);
    /// @brief Sends a message that no CPU sent; `fault` is the index of the fault that inserts it.
    void Insert(std::size_t fault, Nanoseconds now);
    /// @brief When the next message arrives; kNever: none is under way.
    [[nodiscard]] Nanoseconds NextArrival() const noexcept;
    /// @brief The next message that has arrived, in the order of arrival; nothing: there is none.
    [[nodiscard]] std::optional<LinkArrival> Take(Nanoseconds now);

  private:
    struct Flight
    {
        Nanoseconds at{0};
        LinkArrival arrival;
    };
    /// A fault in one direction.
    struct Chooser
    {
        std::size_t fault{0U};
        NodeIndex sender{0U};
        Turns turns;
    };
    /// One direction.
    struct Way
    {
        std::deque<hal::LinkFrame> sent; ///< The last ones, newest in front.
        std::vector<LinkArrival> held;   ///< Until the next one has arrived.
    };

    [[nodiscard]] bool Hits(Chooser& chooser, Nanoseconds now);
    void Change(const FaultSetup& fault, NodeIndex sender, std::vector<Flight>& flights);
    void Depart(const Flight& flight);
    [[nodiscard]] NodeIndex Other(NodeIndex node) const noexcept;
    [[nodiscard]] Way& WayFrom(NodeIndex sender) noexcept;
    [[nodiscard]] Nanoseconds Delay() noexcept;

    const Scenario& scenario_;
    NodeIndex first_;
    EffectTeller teller_;
    Random random_;
    std::vector<Chooser> choosers_;
    std::array<Way, 2U> ways_{};
    std::deque<Flight> flights_; ///< Ascending; of two at the same time the one that departed first.
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_WORLD_LINK_WIRE_HPP
