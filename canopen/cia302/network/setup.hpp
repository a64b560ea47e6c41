// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_SETUP_HPP
#define CANOPEN_CIA302_NETWORK_SETUP_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/nmt/slave.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

using cia301::Bytes;
using cia301::NodeId;

struct El6751Slave;       ///< canopen/start_up/el6751/setup.hpp
struct PlcSlave;          ///< canopen/start_up/plc_designer/setup.hpp
struct SafetyExpectation; ///< canopen/cia302/safety_gate/safety_check.hpp

constexpr std::uint8_t kLastNode = 127U;
constexpr std::uint8_t kNodeRoom = 128U; ///< Arrays by node-ID; element 0 is not used.
constexpr NodeId kAllNodes{0U};

/// Bits of 1F80h, "NMT startup".
constexpr std::uint32_t kIsMaster = 0x01U;
constexpr std::uint32_t kStartAllAtOnce = 0x02U;        ///< Else each slave by itself.
constexpr std::uint32_t kApplicationStartsSelf = 0x04U; ///< Else the master enters OPERATIONAL by itself.
constexpr std::uint32_t kApplicationStartsSlaves = 0x08U;
constexpr std::uint32_t kResetAllOnError = 0x10U; ///< An error of a mandatory slave resets all; else that slave alone.
constexpr std::uint32_t kFlyingMaster = 0x20U;
/// An error of a mandatory slave stops all; counts before kResetAllOnError.
constexpr std::uint32_t kStopAllOnError = 0x40U;
constexpr std::uint32_t kKnownStartUpBits = 0x7FU;

/// Bits of 1F81h, "slave assignment"; retry factor in bits 8 to 15, guard time in bits 16 to 31.
constexpr std::uint32_t kInNetwork = 0x01U;
constexpr std::uint32_t kBootSlave = 0x04U; ///< Configure and start it; else only supervise.
constexpr std::uint32_t kMandatory = 0x08U;
constexpr std::uint32_t kKeepAlive = 0x10U; ///< No reset while it is OPERATIONAL.
constexpr std::uint32_t kVerifySoftware = 0x20U;
constexpr std::uint32_t kMayUpdateSoftware = 0x40U;
constexpr std::uint32_t kRestoreDefaults = 0x80U;

/// When supervision by heartbeat begins.
enum class Arming : std::uint8_t
{
    kInvalid = 0U,
    kFirstHeartbeat = 1U, ///< As CiA 301: a node that never sends one is not missed.
    kBootUp = 2U,         ///< At the boot-up message.
    kImmediately = 3U,    ///< At once: a node that was never seen is lost when the time is over.
};

/// Heartbeat of a slave as the master expects it, and as the master tells the slave to send it.
struct HeartbeatSetup
{
    std::uint16_t consumer_ms; ///< 1016h of the master; 0: no supervision by heartbeat.
    std::uint16_t producer_ms; ///< 1017h of the slave, information; written by its concise DCF.
    Arming arming;
};

/// What the software check compares, 0: not compared; and what an update downloads.
struct SoftwareSetup
{
    std::uint32_t identification; ///< 1F55h, against 1F56h:01 of the slave.
    std::uint32_t date;           ///< 1F53h, against 1F52h:01.
    std::uint32_t time;           ///< 1F54h, against 1F52h:02.
    Bytes program;                ///< 1F58h, to 1F50h:01; null: there is none.
};

/// All that the manager knows beforehand of one slave. A number that is 0 is not compared. All values zero: the slave
/// is not in the network.
struct SlaveSetup
{
    std::uint32_t assignment;         ///< 1F81h.
    std::uint32_t device_type;        ///< 1F84h.
    std::uint32_t vendor_id;          ///< 1F85h.
    std::uint32_t product_code;       ///< 1F86h.
    std::uint32_t revision_number;    ///< 1F87h.
    std::uint32_t serial_number;      ///< 1F88h.
    std::uint8_t restore_sub;         ///< 1F8Ah: sub-index of 1011h of the slave; 0: no restoring.
    std::uint32_t configuration_date; ///< 1F26h.
    std::uint32_t configuration_time; ///< 1F27h.
    HeartbeatSetup heartbeat;
    Bytes dcf;         ///< 1F20h, DCF as text; null: none.
    Bytes concise_dcf; ///< 1F22h; null: none.
    SoftwareSetup software;
    const SafetyExpectation* safety; ///< Null: no safety slave.
    const El6751Slave* el6751;       ///< Needed by the EL6751 profile only.
    const PlcSlave* plc;             ///< Needed by the PLC Designer profile only.
    std::uint32_t emergency_id;      ///< 1014h: whose emergencies come with it; 0: 80h + node-ID.

    /// @brief Whether all these bits of 1F81h are set.
    [[nodiscard]] constexpr bool Has(const std::uint32_t bits) const noexcept
    {
        return (assignment & bits) == bits;
    }
    /// @brief Whether it is in the network list (1F81h bit 0).
    [[nodiscard]] constexpr bool IsListed() const noexcept
    {
        return Has(kInNetwork);
    }
    /// @brief Unanswered remote frames in a row that are a loss; 0: no guarding.
    [[nodiscard]] constexpr std::uint8_t RetryFactor() const noexcept
    {
        return static_cast<std::uint8_t>((assignment >> 8U) & 0xFFU);
    }
    /// @brief Between two remote frames; 0: no guarding.
    [[nodiscard]] constexpr std::uint16_t GuardTimeMs() const noexcept
    {
        return static_cast<std::uint16_t>(assignment >> 16U);
    }
};

/// The network that a manager manages, kept by reference by all its parts. `slaves` has kNodeRoom elements by node-ID;
/// the element of the own node is ignored.
struct NetworkSetup
{
    NodeId own;
    std::uint32_t start_up;       ///< 1F80h.
    std::uint32_t boot_time_ms;   ///< 1F89h; 0: mandatory slaves are waited for without end.
    std::uint16_t inhibit_100us;  ///< 102Ah: least time between two NMT commands.
    std::uint32_t sync_period_us; ///< 1006h of the master; 0: no SYNC.
    const SlaveSetup* slaves;

    /// @brief Whether all these bits of 1F80h are set.
    [[nodiscard]] constexpr bool Has(const std::uint32_t bits) const noexcept
    {
        return (start_up & bits) == bits;
    }
    /// @brief `node` is 1 to 127, checked by the caller.
    [[nodiscard]] constexpr const SlaveSetup& Slave(const NodeId node) const noexcept
    {
        return slaves[node.value & kLastNode];
    }
    /// @brief Whether the node is in the network list and not the master itself. Any node-ID.
    [[nodiscard]] constexpr bool IsListed(const NodeId node) const noexcept
    {
        return (node.value >= 1U) && (node.value <= kLastNode) && (node.value != own.value) && Slave(node).IsListed();
    }
    /// @brief Whether the node is listed and has a safety configuration that is expected of it. Any node-ID.
    [[nodiscard]] constexpr bool IsSafetySlave(const NodeId node) const noexcept
    {
        return IsListed(node) && (Slave(node).safety != nullptr);
    }
    /// @brief Whether any listed slave is a safety slave. While this holds, no start goes to node 0 by any path. O(127)
    [[nodiscard]] constexpr bool HasSafetySlave() const noexcept
    {
        bool has_one = false;
        for (std::uint8_t node = 1U; node <= kLastNode; ++node)
        {
            has_one = has_one || IsSafetySlave(NodeId{node});
        }
        return has_one;
    }
};

} // namespace counterpoint::cia302

#endif
