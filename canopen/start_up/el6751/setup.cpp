// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/start_up/el6751/setup.hpp"

namespace counterpoint::cia302
{
namespace
{

constexpr El6751Slave kPlainSlave{};

bool HasSynchronous(const El6751Slave& slave) noexcept
{
    bool has_one = false;
    for (std::uint8_t i = 0U; i < slave.PdoCount(); ++i)
    {
        has_one = has_one || IsSynchronous(El6751PdoOf(slave, i).type);
    }
    return has_one;
}

} // namespace

const El6751Slave& El6751SlaveOf(const NetworkSetup& setup, const NodeId node) noexcept
{
    const El6751Slave* const slave = setup.Slave(node).el6751;
    return (slave != nullptr) ? *slave : kPlainSlave;
}

const El6751Pdo& El6751PdoOf(const El6751Slave& slave, const std::uint8_t position) noexcept
{
    const bool is_rx = (position < slave.rx_count);
    return is_rx ? slave.rx_pdos[position] : slave.tx_pdos[position - slave.rx_count];
}

bool NeedsSync(const NetworkSetup& setup) noexcept
{
    bool is_needed = false;
    for (std::uint8_t id = 1U; (id <= kLastNode) && (setup.sync_period_us != 0U); ++id)
    {
        const NodeId node{id};
        is_needed = is_needed || (setup.IsListed(node) && HasSynchronous(El6751SlaveOf(setup, node)));
    }
    return is_needed;
}

std::uint16_t El6751PdoCount(const NetworkSetup& setup) noexcept
{
    std::uint16_t count = 0U;
    for (std::uint8_t id = 1U; id <= kLastNode; ++id)
    {
        const NodeId node{id};
        const std::uint8_t own = setup.IsListed(node) ? El6751SlaveOf(setup, node).PdoCount() : std::uint8_t{0U};
        count = static_cast<std::uint16_t>(count + own);
    }
    return count;
}

} // namespace counterpoint::cia302
