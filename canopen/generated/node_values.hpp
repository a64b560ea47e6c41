// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_NODE_VALUES_HPP
#define CANOPEN_GENERATED_NODE_VALUES_HPP

#include "canopen/cia301/nmt/slave.hpp"
#include "canopen/cia301/store/node_defaults.hpp"

#include <cstdint>

namespace counterpoint::generated
{

/// An entry whose value the file writes with $NODEID.
struct NodeValue
{
    std::uint32_t number; ///< Its place in the table.
    std::uint64_t addend; ///< The value is the node-ID and so much.
};

/// All of them, by ascending place; null and 0 where there is none.
struct NodeValueTable
{
    const NodeValue* values;
    std::uint32_t count;
};

/// Tells a store which values follow the node-ID. [SRS_GEN_331]
class NodeValues final : public cia301::NodeDefaults
{
  public:
    /// @brief `table` and what it points to outlive this; `node` is the node-ID of now, and may change.
    constexpr NodeValues(const NodeValueTable& table, const cia301::NodeId& node) noexcept : table_(table), node_(node)
    {
    }

    [[nodiscard]] bool IsNodeDefault(std::uint32_t number, const cia301::Bytes& value) const noexcept override;

  private:
    NodeValueTable table_;
    const cia301::NodeId& node_;
};

} // namespace counterpoint::generated

#endif
