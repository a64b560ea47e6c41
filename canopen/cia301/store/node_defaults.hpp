// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_STORE_NODE_DEFAULTS_HPP
#define CANOPEN_CIA301_STORE_NODE_DEFAULTS_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// Knows which values of a table are those of the node-ID.
class NodeDefaults
{
  public:
    /// @brief Whether the default of the entry at this place of the table is reckoned from the node-ID ($NODEID in a
    /// file), and is this value.
    [[nodiscard]] virtual bool IsNodeDefault(std::uint32_t number, const Bytes& value) const noexcept = 0;

  protected:
    NodeDefaults() noexcept = default;
    ~NodeDefaults() noexcept = default;
    NodeDefaults(const NodeDefaults&) = default;
    NodeDefaults& operator=(const NodeDefaults&) = default;
};

} // namespace counterpoint::cia301

#endif
