// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_COMPARISON_HPP
#define CANOPEN_CIA302_FLYING_MASTER_COMPARISON_HPP

#include "canopen/cia302/flying_master/compare.hpp"
#include "canopen/start_up/el6751/setup.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// The values that one object has in the two masters.
struct Pair
{
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t first;
    std::uint32_t second;
};

/// Two masters that are compared, and where findings go.
class Comparison
{
  public:
    Comparison(const FlyingMasterView* const masters, const std::uint8_t count,
               FlyingFindingListener& listener) noexcept
        : masters_(masters), count_(count), listener_(listener), first_place_(0U), second_place_(0U),
          first_(masters[0]), second_(masters[0]), found_(0U)
    {
    }

    /// @brief What is wrong with one master by itself, by its place in the list.
    void CheckAlone(std::uint8_t place) noexcept;
    /// @brief Node-IDs that two masters have, and masters that do not list each other.
    void CheckNodes() noexcept;
    /// @brief Compares the master at this place with the first one.
    void CompareWithFirst(std::uint8_t place) noexcept;
    /// @brief How many findings were told.
    [[nodiscard]] std::uint32_t Found() const noexcept
    {
        return found_;
    }

  private:
    void Tell(FlyingFindingKind kind, NodeId slave, const Pair& pair) noexcept;
    void CompareValue(NodeId slave, const Pair& pair) noexcept;
    void CompareBytes(NodeId slave, std::uint16_t index, const Bytes& first, const Bytes& second) noexcept;
    void CompareTimes() noexcept;
    void CompareNetwork() noexcept;
    void CompareIdentity(NodeId slave) noexcept;
    void CompareSupervision(NodeId slave) noexcept;
    void CompareContents(NodeId slave) noexcept;
    void CompareProfiles(NodeId slave) noexcept;
    void ComparePart(NodeId slave, El6751Part part, std::uint32_t first, std::uint32_t second) noexcept;
    void CompareEl6751(NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept;
    void CompareCoupler(NodeId slave, const El6751Slave& first, const El6751Slave& second) noexcept;
    void ComparePdo(NodeId slave, std::uint16_t base, const El6751Pdo& first, const El6751Pdo& second) noexcept;
    void CompareSafety(NodeId slave) noexcept;
    void Pick(std::uint8_t first, std::uint8_t second) noexcept;
    [[nodiscard]] bool IsMaster(NodeId node) const noexcept;

    const FlyingMasterView* masters_;
    std::uint8_t count_;
    FlyingFindingListener& listener_;
    std::uint8_t first_place_;
    std::uint8_t second_place_;
    FlyingMasterView first_;
    FlyingMasterView second_;
    std::uint32_t found_;
};

} // namespace counterpoint::cia302

#endif
