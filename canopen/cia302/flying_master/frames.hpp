// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_FLYING_MASTER_FRAMES_HPP
#define CANOPEN_CIA302_FLYING_MASTER_FRAMES_HPP

#include "canopen/cia302/network/setup.hpp"

#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Services of the negotiation by their identifiers. 072h to 076h have no data: sent by several at once they are one
/// frame. 071h differs from node to node: two at the same instant destroy each other.
enum class FlyingService : std::uint32_t
{
    kActiveMaster = 0x71U,     ///< Priority level and node-ID of the active master.
    kNegotiation = 0x72U,      ///< The waiting begins.
    kDetection = 0x73U,        ///< Is there an active master?
    kMasterCapable = 0x74U,    ///< Answer to kCapableDetection.
    kCapableDetection = 0x75U, ///< Who could be master?
    kForceNegotiation = 0x76U,
};

/// A master by what its 071h tells.
struct MasterClaim
{
    std::uint8_t level;
    NodeId node;
};

/// @brief The lower level is better; with equal levels the lower node-ID. Total, so that of two masters one yields.
[[nodiscard]] constexpr bool IsBetter(const MasterClaim& left, const MasterClaim& right) noexcept
{
    return (left.level != right.level) ? (left.level < right.level) : (left.node.value < right.node.value);
}

/// @brief A service without data.
[[nodiscard]] constexpr CanFrame ServiceFrame(const FlyingService service) noexcept
{
    return CanFrame{static_cast<std::uint32_t>(service), FrameKind::kData, CanPortId::kFirst, 0U, {}};
}

/// @brief 071h.
[[nodiscard]] constexpr CanFrame ClaimFrame(const MasterClaim& claim) noexcept
{
    return CanFrame{static_cast<std::uint32_t>(FlyingService::kActiveMaster),
                    FrameKind::kData,
                    CanPortId::kFirst,
                    2U,
                    {claim.level, claim.node.value}};
}

} // namespace counterpoint::cia302

#endif
