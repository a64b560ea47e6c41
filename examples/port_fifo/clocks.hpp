// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_PORT_FIFO_CLOCKS_HPP
#define EXAMPLES_PORT_FIFO_CLOCKS_HPP

#include "hal/api/clocks.hpp"
#include "safety_core/contract/time.hpp"

namespace port_fifo
{

/// Counter A: the processor's 80 MHz. Counter B: the oscillator of the second timer.
class Clocks final : public counterpoint::hal::Clocks
{
  public:
    [[nodiscard]] counterpoint::InstantPair Now() noexcept override;
};

} // namespace port_fifo

#endif
