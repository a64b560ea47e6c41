// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_NMT_FRAME_SINK_HPP
#define CANOPEN_CIA301_NMT_FRAME_SINK_HPP

#include "canopen/cia301/nmt/slave.hpp"

namespace counterpoint::cia301
{

/// NMT state of the node and time at a call; every service that has OnFrame and OnCycle takes it.
struct Moment
{
    NodeState state;
    Instant now;
};

/// The way of a service to the bus.
class FrameSink
{
  public:
    /// @brief Whether the frame was taken. If it was not, the sender keeps it and tries again in a later cycle.
    [[nodiscard]] virtual bool Send(const CanFrame& frame) noexcept = 0;

  protected:
    FrameSink() noexcept = default;
    ~FrameSink() noexcept = default;
    FrameSink(const FrameSink&) = default;
    FrameSink& operator=(const FrameSink&) = default;
};

} // namespace counterpoint::cia301

#endif
