// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_STORE_PARAMETER_STORE_HPP
#define CANOPEN_CIA301_STORE_PARAMETER_STORE_HPP

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia301/store/stored_image.hpp"

#include "hal/api/parameter_memory.hpp"

namespace counterpoint::cia301
{

/// Groups of parameters, as bits.
constexpr std::uint8_t kCommunicationGroup = 1U; ///< 1000h to 1FFFh.
constexpr std::uint8_t kApplicationGroup = 2U;   ///< 6000h to 9FFFh.
constexpr std::uint8_t kManufacturerGroup = 4U;  ///< 2000h to 5FFFh.
constexpr std::uint8_t kLssGroup = 8U;           ///< Node-ID and bit rate; by LSS only.
constexpr std::uint8_t kAllGroups = 7U;          ///< What sub-index 1 of 1010h and 1011h means.
constexpr std::uint8_t kEveryGroup = 15U;        ///< All of them, LSS included.

/// One item of a part as it is stored.
struct StoredItem
{
    SdoAbort abort;           ///< Not kNone: the whole set is not stored.
    std::uint8_t group;       ///< 0: nothing to store at this number.
    std::uint32_t size_bytes; ///< At most 65535.
};

/// A part of the device that keeps parameters.
class StoredPart
{
  public:
    /// @brief How many items the part has; their numbers begin with 0.
    [[nodiscard]] virtual std::uint32_t ItemCount() noexcept = 0;
    /// @brief Group of an item, and its present bytes, which are written to `room`.
    [[nodiscard]] virtual StoredItem Item(std::uint32_t number, const Room& room) noexcept = 0;
    /// @brief All items were asked for by a save of these groups. Not kNone: something changed meanwhile, so that they
    /// do not belong together; the whole set is not stored.
    [[nodiscard]] virtual SdoAbort EndSave(std::uint8_t groups) noexcept
    {
        static_cast<void>(groups);
        return SdoAbort::kNone;
    }
    /// @brief Items of these groups are about to be loaded; nothing else is loaded before EndLoad.
    virtual void BeginLoad(std::uint8_t groups) noexcept = 0;
    /// @brief Takes a stored item; one that cannot be read, or is longer than the scratch room, comes without bytes.
    /// False: this device has no use for it any more.
    virtual bool LoadItem(const Bytes& item) noexcept = 0;
    /// @brief All items of these groups were loaded. False: together they are nothing that this device can use.
    virtual bool EndLoad(std::uint8_t groups) noexcept = 0;
    /// @brief What was saved of these groups is lost, and nobody knows what it was: a part whose values someone
    /// acknowledged does not take others for them.
    virtual void Lose(std::uint8_t groups) noexcept = 0;

  protected:
    StoredPart() noexcept = default;
    ~StoredPart() noexcept = default;
    StoredPart(const StoredPart&) = default;
    StoredPart& operator=(const StoredPart&) = default;
};

/// All kept by reference. The place of a part in the list is its number in the memory: it never changes.
struct StoreParts
{
    hal::ParameterMemory& memory;
    StoredPart* const* parts;
    std::uint8_t part_count;
    Room scratch; ///< Holds the largest item, at least 64 bytes.
};

/// What 1010h or 1011h asks for.
enum class StoreAction : std::uint8_t
{
    kInvalid = 0U,
    kSave = 1U,
    kForget = 2U, ///< Defaults hold after the next reset.
};

/// An action and the groups (bits) that it is for.
struct StoreRequest
{
    StoreAction action;
    std::uint8_t groups;
};

/// What is to be told of the memory.
enum class StoreFinding : std::uint8_t
{
    kInvalid = 0U,
    kSound = 0x5AU,
    kBrokenSave = 1U, ///< The last save has not ended: what was saved before it holds, or the defaults.
    kLost = 2U,       ///< A set that was saved is damaged. No older one and no default counts for it.
    kRefused = 3U,    ///< A part cannot use what was saved of it, though each item is known.
};

/// What Load came to; a device tells whatever is not kSound, and what was refused.
struct LoadReport
{
    StoreFinding finding; ///< Of the groups that were asked for.
    bool is_present;      ///< There was a valid set.
    std::uint32_t loaded;
    std::uint32_t refused; ///< Items that mean nothing to this device any more.
};

/// Keeps parameters in two banks of persistent memory. A set is whole or not there: it gets its header, with
/// generation and CRC, after everything else, and the other bank keeps the set before. Loses no set whenever power
/// fails. The older set comes back for a save that power cut off; never for one that was complete and has decayed.
/// [SRS_STO_001, SRS_STO_002, SRS_STO_003, SRS_STO_004, SRS_STO_005, SRS_STO_006, SRS_STO_007, SRS_STO_008,
/// SRS_STO_014, SRS_STO_015, SRS_STO_016, SRS_STO_020]
///
/// Order of use: Mount once; Load at each reset; OnCycle once a cycle. Not reentrant.
class ParameterStore
{
  public:
    /// @brief Nothing is read before Mount.
    explicit ParameterStore(const StoreParts& parts) noexcept;

    /// @brief Finds the set that counts. False: there is none. The memory must be ready, for Mount does not wait.
    /// O(bank)
    bool Mount() noexcept;
    /// @brief Hands the items of these groups to their parts, after another look at the memory. Not while IsBusy: a
    /// device that is reset during a store first sees the store through (device::Owner::IsStoring). O(set)
    /// [SRS_STO_007, SRS_STO_014]
    LoadReport Load(std::uint8_t groups) noexcept;
    /// @brief Starts a request: kPending, or kLocalControl where one is running or its result waits, whoever asked for
    /// that. [SRS_STO_020]
    [[nodiscard]] SdoAbort Begin(const StoreRequest& request) noexcept;
    /// @brief Asks for the end of what Begin has started, for whoever called that: kPending until it ended, then kNone
    /// once, or kHardware (memory), kNotStored (no room), or what a part refuses with. A result that nobody asks for
    /// in two cycles is forgotten; the request begins anew then. [SRS_STO_005]
    [[nodiscard]] SdoAbort Continue(const StoreRequest& request) noexcept;
    /// @brief One step of at most kStoreStepBytes or one erasing; O(step) [SRS_STO_006]
    void OnCycle() noexcept;
    /// @brief Whether a request is under way.
    [[nodiscard]] bool IsBusy() const noexcept;

  private:
    enum class Phase : std::uint8_t
    {
        kIdle = 0U,
        kBegin = 1U,
        kItems = 2U, ///< Items of now.
        kCopy = 3U,  ///< Items of the old set that stay.
        kClose = 4U, ///< Last bytes and header.
        kOpen = 5U,  ///< The header is being written.
        kVerify = 6U,
        kSeal = 7U, ///< The set before is being marked as superseded.
        kEnded = 8U,
        kErase = 9U,
        kMend = 10U, ///< As kSeal, for a save that power cut off there.
    };

    void Step() noexcept;
    void FetchItem() noexcept;
    void FetchOld() noexcept;
    void PutPiece() noexcept;
    void Close() noexcept;
    void Verify() noexcept;
    void EndSeal() noexcept;
    void End(SdoAbort result) noexcept;
    [[nodiscard]] bool Examine(hal::MemoryBank bank) noexcept;
    void Judge(bool is_other_whole) noexcept;
    void JudgeWithoutSet() noexcept;
    [[nodiscard]] bool HasBegun(hal::MemoryBank bank) noexcept;
    void LoadItems(std::uint8_t groups, LoadReport& report) noexcept;

    StoreParts parts_;
    ImageReader current_;
    ImageReader candidate_;
    ImageWriter writer_;
    StoreRequest request_;
    Phase phase_;
    SdoAbort result_;
    std::uint8_t age_; ///< Cycles since the end.
    std::uint8_t part_;
    std::uint32_t item_count_; ///< Of the part; kUnknownLength: not asked.
    std::uint32_t item_;
    std::uint32_t place_;      ///< In the old set.
    std::uint32_t size_;       ///< Bytes of the item in hand, head included.
    std::uint32_t put_;        ///< Those that are written.
    bool has_current_;         ///< There is a set that counts.
    hal::MemoryBank target_;   ///< Of the next set. The other bank keeps the one before, and the marks about it.
    std::uint32_t generation_; ///< Of the next set.
    std::uint8_t lost_;        ///< Groups that were saved and are lost.
    bool is_broken_;           ///< The last save has not ended.
    bool is_unsealed_;         ///< The set that counts is complete, but the bank of the one before does not say so.
};

} // namespace counterpoint::cia301

#endif
