// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP
#define CANOPEN_START_UP_CIA302_BOOT_SLAVE_HPP

#include "canopen/cia302/network/concise_dcf.hpp"
#include "canopen/cia302/network/start_up.hpp"
#include "canopen/cia302/network/text_dcf.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// Times that CiA 302-2 leaves to the master.
constexpr std::uint32_t kAskAgainUs = 1'000'000U;  ///< Between two readings of 1000h.
constexpr std::uint32_t kResetUs = 1'000'000U;     ///< From a reset to the boot-up message.
constexpr std::uint32_t kCrowdedUs = 10'000'000U;  ///< The same at most, while SDOs of other slaves keep the bus busy,
constexpr std::uint32_t kCrowdedTimeOuts = 20U;    ///< or as many SDO time-outs, which are long where the bus is slow.
constexpr std::uint32_t kGuardAnswerUs = 100'000U; ///< From a remote frame to its answer.
constexpr std::uint32_t kFlashCheckUs = 100'000U;  ///< Between two readings of 1F57h.
constexpr std::uint16_t kMaxFlashChecks = 600U;    ///< A minute; then the update has failed.
constexpr std::uint8_t kMaxUpdates = 3U;           ///< That the slave's own restarts broke off.

/// Time of a call: modular, and as a count that does not wrap.
struct BootTime
{
    Instant now;
    std::uint64_t clock_us;
};

/// What a boot waits for inside its step.
enum class BootWait : std::uint8_t
{
    kNothing = 0U,
    kTransfer = 1U,
    kTime = 2U,
    kSign = 3U, ///< Heartbeat or guarding answer.
    kBootUp = 4U,
    kGate = 5U,
};

/// The boot of one slave. Zero-filled at first.
struct BootRecord
{
    NodeStatus status;
    std::uint64_t began_us;   ///< Boot: 1F89h counts from here.
    std::uint64_t since_us;   ///< Wait.
    ConcisePosition position; ///< In 1F22h.
    std::uint32_t offset;     ///< In 1F20h.
    std::uint32_t next;       ///< In 1F20h, behind the object that is written.
    std::uint8_t value[8];    ///< Of a transfer.
    BootWait wait;
    std::uint8_t part;  ///< Of the step.
    std::uint8_t beats; ///< Of the table when the wait began.
    std::uint16_t checks;
    std::uint8_t updates; ///< Begun since the last boot that ended well.
    bool is_fresh;        ///< Its boot-up message came in this boot: it is not asked for its state.
    bool is_resumed;      ///< Nothing is restored in this boot.
    bool is_updated;      ///< Software was downloaded in this boot.
    bool was_operational; ///< L.
    bool is_booted;       ///< The last boot ended without letter, or with L.
    bool is_start_wanted; ///< By application or master, whatever 1F80h says.
    char identity;        ///< Letter with which the boot found another device; 0: the expected one.
    bool is_unread;       ///< Stopped because it ran and did not answer.
    bool is_start_owed;   ///< The NMT master gave up its start.
    bool is_extra;        ///< Configuration or verification alone: its end says nothing of the boot.
};

/// Is told how boots end, and asked whether the master is OPERATIONAL.
class BootListener
{
  public:
    /// @brief The boot ended without letter, or with L.
    virtual void OnBooted(NodeId node, const BootTime& time) noexcept = 0;
    /// @brief It ended with another letter; the record tells.
    virtual void OnBootFailed(NodeId node, const BootTime& time) noexcept = 0;
    [[nodiscard]] virtual bool IsMasterOperational() const noexcept = 0;

  protected:
    BootListener() noexcept = default;
    ~BootListener() noexcept = default;
    BootListener(const BootListener&) = default;
    BootListener& operator=(const BootListener&) = default;
};

/// Boots slaves after CiA 302-2, each by itself and all at the same time: `records` has kNodeRoom elements by node-ID,
/// kept by reference as the parts. `node` is always that of a listed slave. Not reentrant.
class BootSlave
{
  public:
    BootSlave(const StartUpParts& parts, BootRecord* records, BootListener& listener) noexcept;

    /// @brief Boots now, without waiting for a boot-up message. [SRS_BOOT_004, SRS_BOOT_005, SRS_BOOT_006,
    /// SRS_BOOT_007, SRS_BOOT_008, SRS_BOOT_009, SRS_BOOT_010, SRS_BOOT_011, SRS_BOOT_012, SRS_BOOT_013, SRS_BOOT_014]
    void Ask(NodeId node, const BootTime& time) noexcept;
    /// @brief As Ask, and what was written stays: no reset by the state check, nothing is restored. [SRS_SFS_005]
    void Resume(NodeId node, const BootTime& time) noexcept;
    /// @brief Boots when the boot-up message comes; mandatory slaves and those kept alive also without one, after
    /// kResetUs. [SRS_BOOT_002]
    void Await(NodeId node, const BootTime& time) noexcept;
    /// @brief Resets the node, then as Await. [SRS_BOOT_017]
    void Reset(NodeId node, const BootTime& time) noexcept;
    /// @brief The boot-up message of the node: what the boot waits for, or its begin. [SRS_BOOT_018]
    void OnBootUp(NodeId node, const BootTime& time) noexcept;
    /// @brief Writes the configuration, and nothing else. [SRS_NMM_009]
    void Configure(NodeId node, const BootTime& time) noexcept;
    /// @brief Starts a booted slave, after verification if it is a safety slave. [SRS_BOOT_023]
    void Start(NodeId node, const BootTime& time) noexcept;
    /// @brief Verifies a safety slave that was found OPERATIONAL. [SRS_BOOT_013]
    void Verify(NodeId node, const BootTime& time) noexcept;
    /// @brief Gives up whatever runs, and takes the slave for another device until a boot has asked it. [SRS_BOOT_017]
    void Doubt(NodeId node, const BootTime& time) noexcept;
    /// @brief Gives up whatever runs.
    void End(NodeId node) noexcept;
    /// @brief Goes on as far as it can. Once a cycle, and after each frame of the node.
    void OnCycle(NodeId node, const BootTime& time) noexcept;

    /// @brief `node` is 1 to 127, checked by the caller.
    [[nodiscard]] BootRecord& Record(NodeId node) noexcept;
    [[nodiscard]] const BootRecord& Record(NodeId node) const noexcept;

  private:
    /// One slave in one call.
    struct Job
    {
        NodeId node;
        BootRecord& record;
        const SlaveSetup& setup;
        const BootTime& time;
    };
    enum class Got : std::uint8_t
    {
        kNothingYet = 0U,
        kDone = 1U,
        kRefused = 2U, ///< Abort or silence: see the status.
    };

    [[nodiscard]] Job JobOf(NodeId node, const BootTime& time) noexcept;
    void Clear(const Job& job) noexcept;
    void Enter(const Job& job, StartUpStep step) noexcept;
    void Wait(const Job& job, BootWait wait) noexcept;
    void Fail(const Job& job, char letter) noexcept;
    void Finish(const Job& job) noexcept;
    void Run(const Job& job) noexcept;
    void RunLater(const Job& job, StartUpStep step) noexcept;
    [[nodiscard]] static bool IsOver(const Job& job, std::uint64_t limit_us) noexcept;
    [[nodiscard]] bool IsSilent(const Job& job) noexcept;

    [[nodiscard]] Got Fetch(const Job& job, const ObjectAddress& object) noexcept;
    [[nodiscard]] Got Put(const Job& job, const ObjectAddress& object, const Bytes& value, SdoMode mode) noexcept;
    [[nodiscard]] Got PutByte(const Job& job, const ObjectAddress& object, std::uint8_t value) noexcept;
    [[nodiscard]] Got Take(const Job& job) noexcept;

    void AwaitReset(const Job& job) noexcept;
    void WakeUp(const Job& job) noexcept;
    void ReadDeviceType(const Job& job) noexcept;
    void StopUnread(const Job& job) noexcept;
    void Compare(const Job& job, std::uint8_t sub, std::uint32_t expected, char letter) noexcept;
    void CheckState(const Job& job) noexcept;
    void TakeState(const Job& job) noexcept;
    void CheckSoftware(const Job& job) noexcept;
    void JudgeSoftware(const Job& job, std::uint32_t expected) noexcept;
    void UpdateSoftware(const Job& job) noexcept;
    void CheckFlash(const Job& job, bool is_cleared) noexcept;
    void CompareDate(const Job& job) noexcept;
    void Restore(const Job& job) noexcept;
    void WriteConfiguration(const Job& job) noexcept;
    void WriteText(const Job& job) noexcept;
    void WriteConcise(const Job& job) noexcept;
    void RefuseDomain(const Job& job, std::uint16_t index) noexcept;
    void BeginSupervision(const Job& job) noexcept;
    void VerifySafety(const Job& job) noexcept;
    void RefuseSafety(const Job& job) noexcept;
    void StartNode(const Job& job) noexcept;

    StartUpParts parts_;
    BootRecord* records_;
    BootListener& listener_;
};

} // namespace counterpoint::cia302

#endif
