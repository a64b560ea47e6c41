// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_START_GATE_HPP
#define CANOPEN_CIA302_NETWORK_START_GATE_HPP

#include "canopen/cia301/base/abort_code.hpp"
#include "canopen/cia302/network/setup.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// State of the safety gate for one slave.
enum class GateState : std::uint8_t
{
    kClosed = 0U,  ///< Not verified since the last boot-up of the slave.
    kBusy = 1U,    ///< Reads who it is, and reads (or writes) its safety objects.
    kDiffers = 2U, ///< See Finding: this object has another value than expected.
    kFailed = 3U,  ///< See Finding: this object could not be read or written.
    kOpen = 0x5AU, ///< Verified: the slave may be started.
};

/// Which of 1000h and 1018h say whether a slave is the expected device: what the start-up profile compares. 0 in 1F84h
/// to 1F88h is never asked.
enum class IdentityRule : std::uint8_t
{
    kCia302 = 0U,
    kEl6751 = 1U,      ///< No 1000h whose check is switched off; of a bus coupler no revision and no serial number.
    kPlcDesigner = 2U, ///< The low word of 1000h alone.
};

/// The first object that kept the gate closed.
struct GateFinding
{
    ObjectAddress object;
    cia301::SdoAbort abort; ///< kNone: the values differ; kLengthMismatch with kDiffers: their lengths do.
    std::uint64_t expected;
    std::uint64_t read;

    /// @brief Whether the object, 1000h or of 1018h, says who the slave is.
    [[nodiscard]] constexpr bool IsOfIdentity() const noexcept
    {
        constexpr std::uint16_t kDeviceType = 0x1000U;
        constexpr std::uint16_t kIdentity = 0x1018U;
        return (object.index == kDeviceType) || (object.index == kIdentity);
    }
};

/// Is asked before every start of a safety slave, by every start-up profile: call Verify, then wait until State is not
/// kBusy. While it is kBusy the slave's SDO connection belongs to the gate. Nodes that are no safety slaves may always
/// start.
class StartGate
{
  public:
    /// @brief Begins a verification; for a node that is no safety slave nothing happens.
    virtual void Verify(NodeId node, Instant now) noexcept = 0;
    /// @brief Drives verification; once a cycle, by the owner of all parts.
    virtual void OnCycle(Instant now) noexcept = 0;
    /// @brief The slave booted up, was reset or was lost: its verification does not count any more.
    virtual void Close(NodeId node) noexcept = 0;
    /// @brief kOpen for a node that is no safety slave.
    [[nodiscard]] virtual GateState State(NodeId node) const noexcept = 0;
    /// @brief Has meaning with kDiffers and kFailed only.
    [[nodiscard]] virtual GateFinding Finding(NodeId node) const noexcept = 0;

    /// @brief Whether another device than the expected one was found behind this node-ID. [SRS_SFS_217]
    [[nodiscard]] bool IsOther(const NodeId node) const noexcept
    {
        return (State(node) == GateState::kDiffers) && Finding(node).IsOfIdentity();
    }
    /// @brief Whether a start of the node may leave now.
    [[nodiscard]] bool MayStart(const NodeId node) const noexcept
    {
        return State(node) == GateState::kOpen;
    }

  protected:
    StartGate() noexcept = default;
    ~StartGate() noexcept = default;
    StartGate(const StartGate&) = default;
    StartGate& operator=(const StartGate&) = default;
};

} // namespace counterpoint::cia302

#endif
