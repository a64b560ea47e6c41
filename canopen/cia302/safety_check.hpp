// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_SAFETY_CHECK_HPP
#define CANOPEN_CIA302_SAFETY_CHECK_HPP

#include "canopen/cia301/sdo_client.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// One object of a safety configuration. Its length follows from its address.
struct ExpectedObject
{
    ObjectAddress address;
    std::uint32_t value;
    bool is_fixed; ///< A part of the slave's program: compared, never written.
};

/// The safety configuration that a slave has to have: 1300h (where the slave has it), sub-index 1 to 6 of each 1301h to
/// 1340h, sub-index 0 to count of each 1381h to 13C0h, sub-index 0 (where it is told) and n of 13FFh. Strictly
/// ascending by index and sub-index. 13FEh is not in it: it has to be A5h. [SRS-SFS-001]
struct SafetyExpectation
{
    const ExpectedObject* objects; ///< Kept by whoever made it.
    std::uint16_t count;
};

/// @brief Whether it names every part of at least one SRDO and nothing else. O(count) [SRS-SFS-007]
[[nodiscard]] bool IsUsable(const SafetyExpectation& expectation) noexcept;
/// @brief Bytes of an object of a safety configuration; 0: it is none.
[[nodiscard]] std::uint8_t SizeOf(const ObjectAddress& address) noexcept;

enum class SafetyTask : std::uint8_t
{
    kInvalid = 0U,
    kVerify = 1U, ///< Reads and compares.
    kWrite = 2U,  ///< Writes by the full procedure, which compares before it declares anything valid.
};

enum class SafetyVerdict : std::uint8_t
{
    kInvalid = 0U,
    kOpen = 1U,     ///< Not compared since the slave last started, or under way.
    kDiffers = 2U,  ///< `object` has another value or length.
    kAborted = 3U,  ///< The transfer of `object` was aborted.
    kSilent = 4U,   ///< No answer about `object`, three times.
    kUnusable = 5U, ///< The expectation itself is none.
    kAlike = 0x69U,
};

/// What a check found; the first difference ends it. [SRS-SFS-003]
struct SafetyResult
{
    SafetyVerdict verdict;
    ObjectAddress object;     ///< Of a difference; of a check under way, where it is.
    std::uint32_t expected;   ///< kDiffers.
    std::uint32_t read;       ///< kDiffers.
    cia301::SdoAbort abort;   ///< kAborted.
    std::uint32_t size_bytes; ///< kDiffers: of the value that was read.
};

/// Compares or writes the safety configuration of one slave, one SDO after the other. Begin, then OnCycle until IsBusy
/// is false; the client is fed by its owner and used by nobody else meanwhile. Not reentrant.
class SafetyCheck
{
  public:
    SafetyCheck() noexcept = default;

    /// @brief Both are kept by reference until the end. False: busy, or the client is.
    [[nodiscard]] bool Begin(const SafetyExpectation& expectation, SafetyTask task, cia301::SdoClient& client,
                             Instant now) noexcept;
    /// @brief Takes what the client has and starts the next transfer.
    void OnCycle(Instant now) noexcept;
    /// @brief Ends it without a verdict, together with a running transfer; a verdict from before is gone too.
    void Withdraw() noexcept;

    [[nodiscard]] bool IsBusy() const noexcept
    {
        return client_ != nullptr;
    }
    [[nodiscard]] const SafetyResult& Result() const noexcept
    {
        return result_;
    }

  private:
    /// One pass over the expectation, or one access to 13FEh.
    enum class Phase : std::uint8_t
    {
        kEnd = 0U,
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
    };
    static constexpr std::uint8_t kLongestTask = 12U;
    static constexpr std::uint8_t kAttempts = 3U;

    [[nodiscard]] static bool IsValidFlag(Phase phase) noexcept;
    [[nodiscard]] static bool TakesPart(Phase phase, const ExpectedObject& object) noexcept;
    [[nodiscard]] static std::uint32_t ValueIn(Phase phase, const ExpectedObject& object) noexcept;
    [[nodiscard]] Phase PhaseNow() const noexcept;
    [[nodiscard]] bool Reads() const noexcept;
    void Seek() noexcept;
    void Next() noexcept;
    void Access(Instant now) noexcept;
    void Judge(Instant now) noexcept;
    void JudgeFailure(Instant now) noexcept;
    void End(SafetyVerdict verdict) noexcept;

    const SafetyExpectation* expectation_{nullptr};
    cia301::SdoClient* client_{nullptr}; ///< Null: nothing is under way.
    SafetyResult result_{SafetyVerdict::kOpen, {0U, 0U}, 0U, 0U, cia301::SdoAbort::kNone, 0U};
    SafetyTask task_{SafetyTask::kInvalid};
    std::uint8_t phase_{0U};     ///< Of the task.
    std::uint16_t position_{0U}; ///< In the expectation.
    std::uint8_t attempt_{0U};
    std::uint32_t target_{0U}; ///< Value that is written or expected.
    bool has_begun_{false};    ///< The transfer of this object.
    std::uint8_t buffer_[4]{};
};

} // namespace counterpoint::cia302

#endif
