// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_SAFETY_GATE_SAFETY_CHECK_HPP
#define CANOPEN_CIA302_SAFETY_GATE_SAFETY_CHECK_HPP

#include "canopen/cia302/network/sdo_pool.hpp"
#include "canopen/cia302/network/setup.hpp"
#include "canopen/cia302/network/start_gate.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// One object of a safety configuration. Its length follows from its address.
struct ExpectedObject
{
    ObjectAddress address;
    std::uint64_t value;
    bool is_fixed; ///< A part of the slave's program: compared, never written.
};

/// The safety configuration that a slave has to have: 1300h (where the slave has it), sub-index 0 (where it is told)
/// and 1 to 6 of each 1301h to 1340h, sub-index 0 to count of each 1381h to 13C0h, sub-index 0 (where it is told) and n
/// of 13FFh, what else of 1381h to 13C0h and 13FFh is fixed, and of what 13FFh does not cover 5F04h (the device digest)
/// or n of 5F01h, 5F02h and 5F05h, fixed. Strictly ascending by index and sub-index. 13FEh is not in it: it has to be
/// A5h. [SRS_SFS_001, SRS_SFS_670]
struct SafetyExpectation
{
    const ExpectedObject* objects; ///< Kept by whoever made it.
    std::uint16_t count;
};

/// @brief Whether it names every object of at least one SRDO, and nothing else. O(count) [SRS_SFS_007]
[[nodiscard]] bool IsUsable(const SafetyExpectation& expectation) noexcept;
/// @brief Length in bytes of an object that an expectation may hold; 0: it may not.
[[nodiscard]] std::uint8_t SizeOf(const ObjectAddress& address) noexcept;

/// One object that says who a slave is.
struct IdentityRow
{
    ObjectAddress object;
    std::uint32_t expected;
    std::uint32_t mask; ///< Bits that are compared; 0: it is not asked.
};

constexpr std::uint8_t kIdentityRows = 5U;

/// @brief 1000h and 1018h:01 to :04 by `row` 0 to 4, as the rule compares them. [SRS_SFS_010, SRS_SFS_215, SRS_SFS_216]
[[nodiscard]] IdentityRow IdentityRowOf(const SlaveSetup& slave, IdentityRule rule, std::uint8_t row) noexcept;

/// What a check does with the safety configuration of its slave.
enum class SafetyTask : std::uint8_t
{
    kInvalid = 0U,
    kVerify = 1U, ///< Asks who it is, reads and compares.
    kWrite = 2U,  ///< Asks, then writes by the full procedure, which compares before it declares anything valid.
};

/// Where a check is, or how it ended.
enum class CheckState : std::uint8_t
{
    kClosed = 0U,
    kBusy = 1U,
    kDiffers = 2U, ///< Finding: this object has another value, or a value of another length.
    kFailed = 3U,  ///< Finding: this object could not be read or written. Object 0000h: the expectation is none.
    kAlike = 0x69U,
};

/// Which slave is to be checked, and how. The slave is a safety slave, and is kept by reference.
struct SafetyOrder
{
    const SlaveSetup& slave;
    IdentityRule rule;
    SafetyTask task;
};

/// Compares or writes the safety configuration of one slave, one SDO after the other: Begin, then OnCycle while it is
/// busy; nobody else uses the slave's connection meanwhile. The first difference ends it. Not reentrant.
class SafetyCheck
{
  public:
    SafetyCheck() noexcept = default;

    /// @brief Begins the check from its start. [SRS_SFS_001, SRS_SFS_005, SRS_SFS_010, SRS_SFS_220]
    void Begin(const SafetyOrder& order, NodeId node) noexcept;
    /// @brief Takes what the slave answered and asks for the next object.
    void OnCycle(SdoPool& sdo, Instant now) noexcept;
    /// @brief kBusy, kDiffers, kFailed or kAlike; kClosed before the first Begin. [SRS_SFS_003]
    [[nodiscard]] CheckState State() const noexcept
    {
        return state_;
    }
    /// @brief Verification or writing: the last one that was begun.
    [[nodiscard]] SafetyTask Task() const noexcept
    {
        return task_;
    }
    /// @brief Has meaning with kDiffers and kFailed only.
    [[nodiscard]] const GateFinding& Finding() const noexcept
    {
        return finding_;
    }
    /// @brief Whether an answer of the slave that this object was written belongs to this check, or makes no difference
    /// to it since all is read behind it. [SRS_SFS_121]
    [[nodiscard]] bool IsOwn(const ObjectAddress& written) const noexcept;
    /// @brief Whether an SDO of this check is under way; if the check is given up, this SDO has to be cancelled.
    [[nodiscard]] bool HasTransfer() const noexcept
    {
        return has_begun_; // Begin and End reset it.
    }

  private:
    /// One pass over the expectation or the identity, or one access to 13FEh.
    enum class Phase : std::uint8_t
    {
        kEnd = 0U,
        kIdentity,
        kReadValid,
        kCompare,
        kClearValid,
        kSwitchOff, ///< Directions.
        kSettings,  ///< Identifiers, times, transmission type.
        kMapClear,
        kMapEntries,
        kMapCount,
        kSwitchOn,
        kSign, ///< Signatures and 1300h.
        kSetValid,
        kCompareGfc, ///< Once more: to write 1300h leaves 13FEh as it is.
    };
    static constexpr std::uint8_t kLongestTask = 13U;

    [[nodiscard]] static bool IsValidFlag(Phase phase) noexcept;
    [[nodiscard]] static bool TakesPart(Phase phase, const ExpectedObject& object) noexcept;
    [[nodiscard]] static std::uint64_t ValueIn(Phase phase, const ExpectedObject& object) noexcept;
    [[nodiscard]] Phase PhaseNow() const noexcept;
    [[nodiscard]] bool Reads() const noexcept;
    [[nodiscard]] bool Take(Phase phase) noexcept;
    [[nodiscard]] std::uint16_t CountIn(Phase phase) const noexcept;
    void Seek() noexcept;
    void Next() noexcept;
    [[nodiscard]] std::uint8_t SizeNow() const noexcept;
    [[nodiscard]] bool IsAsExpected(std::uint32_t size_bytes) const noexcept;
    void Access(SdoPool& sdo, Instant now) noexcept;
    void Judge(const cia301::SdoOutcome& outcome) noexcept;
    void End(CheckState state) noexcept;

    const SlaveSetup* slave_{nullptr};
    GateFinding finding_{{0U, 0U}, SdoAbort::kNone, 0U, 0U};
    NodeId node_{0U};
    CheckState state_{CheckState::kClosed};
    SafetyTask task_{SafetyTask::kInvalid};
    IdentityRule rule_{IdentityRule::kCia302};
    std::uint8_t phase_{0U};     ///< Of the task.
    std::uint16_t position_{0U}; ///< In the expectation or the identity.
    ObjectAddress object_{0U, 0U};
    std::uint64_t target_{0U}; ///< Value that is written or expected.
    bool has_begun_{false};    ///< The transfer of `object_`.
    std::uint8_t buffer_[8]{};
};

} // namespace counterpoint::cia302

#endif
