// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/parameter_store.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kSkipsInStep = 64U; ///< Items that are not stored, which cost next to nothing.
constexpr std::uint32_t kHalfOfGenerations = 0x80000000U;
constexpr std::uint8_t kGreatestAge = 2U;

bool IsNewer(const std::uint32_t left, const std::uint32_t right) noexcept
{
    return (left != right) && ((left - right) < kHalfOfGenerations);
}

hal::MemoryBank OtherOf(const hal::MemoryBank bank) noexcept
{
    return (bank == hal::MemoryBank::kFirst) ? hal::MemoryBank::kSecond : hal::MemoryBank::kFirst;
}

} // namespace

ParameterStore::ParameterStore(const StoreParts& parts) noexcept
    : parts_(parts), current_(parts.memory), candidate_(parts.memory), writer_(parts.memory),
      request_{StoreAction::kInvalid, 0U}, phase_(Phase::kIdle), result_(SdoAbort::kNone), age_(0U), part_(0U),
      item_count_(kUnknownLength), item_(0U), place_(0U), size_(0U), put_(0U), has_current_(false),
      target_(hal::MemoryBank::kFirst), generation_(1U), lost_(0U), is_broken_(false), is_unsealed_(false)
{
}

bool ParameterStore::Mount() noexcept
{
    const bool is_first_whole = Examine(hal::MemoryBank::kFirst);
    current_ = is_first_whole ? candidate_ : current_;
    const bool is_second_whole = Examine(hal::MemoryBank::kSecond);
    const bool is_second =
        is_second_whole && (!is_first_whole || IsNewer(candidate_.Generation(), current_.Generation()));
    current_ = is_second ? candidate_ : current_;
    has_current_ = is_first_whole || is_second_whole;
    is_broken_ = false;
    is_unsealed_ = false;
    if (has_current_)
    {
        Judge(is_first_whole && is_second_whole);
    }
    else
    {
        JudgeWithoutSet();
    }
    return has_current_;
}

/// What the marks say about the newest whole set.
///     this bank    other bank   meaning
///     superseded   damaged      the other one was newer, and is lost
///     begun        damaged      a save into the other one has not ended
///     neither      any          this one is the newest
void ParameterStore::Judge(const bool is_other_whole) noexcept
{
    const hal::MemoryBank bank = current_.Bank();
    const hal::MemoryBank other = OtherOf(bank);
    const bool is_begun = HasMark(parts_.memory, bank, BankMark::kBegun);
    const bool is_superseded = !is_other_whole && HasMark(parts_.memory, bank, BankMark::kSuperseded);
    target_ = other;
    generation_ = current_.Generation() + 1U;
    lost_ = is_superseded ? kEveryGroup : current_.Lost();
    has_current_ = !is_superseded;
    is_broken_ = is_begun && !is_other_whole && !is_superseded;
    is_unsealed_ = !is_begun && !is_superseded && !HasMark(parts_.memory, other, BankMark::kSuperseded);
}

/// No bank is whole: nothing was ever saved, or the first save has not ended, or what was saved is lost.
void ParameterStore::JudgeWithoutSet() noexcept
{
    const bool is_first_blank = IsBlank(parts_.memory, hal::MemoryBank::kFirst);
    const bool is_second_blank = IsBlank(parts_.memory, hal::MemoryBank::kSecond);
    const bool is_first_broken = is_second_blank && HasBegun(hal::MemoryBank::kSecond);
    const bool is_second_broken = is_first_blank && HasBegun(hal::MemoryBank::kFirst);
    const bool is_first_lost = HasMark(parts_.memory, hal::MemoryBank::kSecond, BankMark::kSuperseded);
    const bool is_second_lost = HasMark(parts_.memory, hal::MemoryBank::kFirst, BankMark::kSuperseded);
    const bool is_fresh = is_first_blank && is_second_blank && !is_first_lost && !is_second_lost;
    const bool is_none = (parts_.memory.BankBytes() == 0U);
    is_broken_ = is_first_broken || is_second_broken;
    lost_ = (is_broken_ || is_fresh || is_none) ? std::uint8_t{0U} : kEveryGroup;
    // The bank with the mark stays, so that it goes on saying so until a set is complete.
    const bool is_into_second = is_second_broken || (!is_first_broken && is_second_lost && !is_first_lost);
    target_ = is_into_second ? hal::MemoryBank::kSecond : hal::MemoryBank::kFirst;
    generation_ = 1U;
}

/// A set in the other bank, and none is complete.
bool ParameterStore::HasBegun(const hal::MemoryBank bank) noexcept
{
    return HasMark(parts_.memory, bank, BankMark::kBegun) && !HasMark(parts_.memory, bank, BankMark::kSuperseded);
}

/// Whether the bank holds a valid set, which is the candidate then.
bool ParameterStore::Examine(const hal::MemoryBank bank) noexcept
{
    ImageCheck check = candidate_.Open(bank) ? ImageCheck::kMore : ImageCheck::kInvalid;
    while (check == ImageCheck::kMore)
    {
        check = candidate_.Continue();
    }
    return check == ImageCheck::kValid;
}

LoadReport ParameterStore::Load(const std::uint8_t groups) noexcept
{
    if (has_current_)
    {
        static_cast<void>(Mount()); // It may have decayed since.
    }
    const auto lost = static_cast<std::uint8_t>(lost_ & groups);
    LoadReport report{is_broken_ ? StoreFinding::kBrokenSave : StoreFinding::kSound, has_current_, 0U, 0U};
    if (has_current_)
    {
        LoadItems(static_cast<std::uint8_t>(groups & ~lost_ & 0xFFU), report);
    }
    for (std::uint8_t part = 0U; (lost != 0U) && (part < parts_.part_count); ++part)
    {
        parts_.parts[part]->Lose(lost);
    }
    report.finding = (lost != 0U) ? StoreFinding::kLost : report.finding;
    return report;
}

void ParameterStore::LoadItems(const std::uint8_t groups, LoadReport& report) noexcept
{
    for (std::uint8_t part = 0U; part < parts_.part_count; ++part)
    {
        parts_.parts[part]->BeginLoad(groups);
    }
    std::uint32_t place = 0U;
    ItemHead head = current_.HeadAt(place);
    while (head.is_present)
    {
        const Room room{parts_.scratch.data, head.size_bytes};
        if ((head.group & groups) != 0U)
        {
            const bool is_read =
                (head.size_bytes <= parts_.scratch.size_bytes) && current_.Read(place + kItemHeadBytes, room);
            const Bytes item{room.data, is_read ? room.size_bytes : 0U}; // The part knows of one that it does not get.
            const bool is_loaded = (head.part < parts_.part_count) && parts_.parts[head.part]->LoadItem(item);
            report.loaded += is_loaded ? 1U : 0U;
            report.refused += is_loaded ? 0U : 1U;
        }
        place += kItemHeadBytes + head.size_bytes;
        head = current_.HeadAt(place);
    }
    for (std::uint8_t part = 0U; part < parts_.part_count; ++part)
    {
        report.finding = parts_.parts[part]->EndLoad(groups) ? report.finding : StoreFinding::kRefused;
    }
}

/// The marks of an older save are of no interest to the next one, which waits for the memory alone.
SdoAbort ParameterStore::Begin(const StoreRequest& request) noexcept
{
    const bool is_free = (phase_ == Phase::kIdle) || (phase_ == Phase::kMend);
    if (is_free)
    {
        request_ = request;
        phase_ = Phase::kBegin;
    }
    return is_free ? SdoAbort::kPending : SdoAbort::kLocalControl;
}

SdoAbort ParameterStore::Continue(const StoreRequest& request) noexcept
{
    const bool is_same = (request.action == request_.action) && (request.groups == request_.groups);
    SdoAbort answer = SdoAbort::kPending;
    if ((phase_ == Phase::kIdle) || (phase_ == Phase::kMend))
    {
        answer = Begin(request);
    }
    else if (!is_same)
    {
        answer = SdoAbort::kLocalControl;
    }
    else if (phase_ == Phase::kEnded)
    {
        answer = result_;
        phase_ = Phase::kIdle;
    }
    return answer;
}

bool ParameterStore::IsBusy() const noexcept
{
    return (phase_ != Phase::kIdle) && (phase_ != Phase::kEnded);
}

void ParameterStore::OnCycle() noexcept
{
    if (phase_ == Phase::kEnded)
    {
        ++age_;
        phase_ = (age_ >= kGreatestAge) ? Phase::kIdle : Phase::kEnded;
    }
    else if ((phase_ == Phase::kIdle) && is_unsealed_ && (parts_.memory.Status() != hal::MemoryStatus::kBusy))
    {
        is_unsealed_ = false;
        StartMark(parts_.memory, target_, BankMark::kSuperseded);
        phase_ = Phase::kMend;
    }
    else if (IsBusy())
    {
        const hal::MemoryStatus status = parts_.memory.Status();
        if (status == hal::MemoryStatus::kReady)
        {
            Step();
        }
        else if ((status != hal::MemoryStatus::kBusy) && (phase_ == Phase::kBegin))
        {
            Step(); // What failed before is of no interest.
        }
        else if ((status != hal::MemoryStatus::kBusy) && (phase_ == Phase::kMend))
        {
            phase_ = Phase::kIdle; // The next start tries again.
        }
        else if (status != hal::MemoryStatus::kBusy)
        {
            End(SdoAbort::kHardware);
        }
    }
}

/// The memory is ready.
void ParameterStore::Step() noexcept
{
    switch (phase_)
    {
    case Phase::kBegin:
        is_unsealed_ = false;
        // What is lost stays lost until the set is complete.
        StartMark(parts_.memory, OtherOf(target_),
                  (has_current_ || (lost_ == 0U)) ? BankMark::kBegun : BankMark::kSuperseded);
        phase_ = Phase::kErase;
        break;
    case Phase::kErase:
        writer_.Begin(target_);
        part_ = 0U;
        item_ = 0U;
        item_count_ = kUnknownLength;
        place_ = 0U;
        size_ = 0U;
        put_ = 0U;
        phase_ = (request_.action == StoreAction::kSave) ? Phase::kItems : Phase::kCopy;
        break;
    case Phase::kItems:
    case Phase::kCopy:
        if (put_ < size_)
        {
            PutPiece();
        }
        else if (phase_ == Phase::kItems)
        {
            FetchItem();
        }
        else
        {
            FetchOld();
        }
        break;
    case Phase::kClose:
        Close();
        break;
    case Phase::kOpen:
    case Phase::kVerify:
        Verify();
        break;
    case Phase::kSeal:
        EndSeal();
        break;
    case Phase::kMend:
        phase_ = Phase::kIdle;
        break;
    case Phase::kIdle:
    case Phase::kEnded:
    default:
        break;
    }
}

/// The next item that is to be stored, head and bytes, into the scratch room.
void ParameterStore::FetchItem() noexcept
{
    bool is_found = false;
    for (std::uint32_t i = 0U; (i < kSkipsInStep) && !is_found && (phase_ == Phase::kItems); ++i)
    {
        if (part_ >= parts_.part_count)
        {
            phase_ = Phase::kCopy;
        }
        else if (item_count_ == kUnknownLength)
        {
            item_count_ = parts_.parts[part_]->ItemCount();
        }
        else if (item_ >= item_count_)
        {
            const SdoAbort abort = parts_.parts[part_]->EndSave(request_.groups);
            ++part_;
            item_ = 0U;
            item_count_ = kUnknownLength;
            if (abort != SdoAbort::kNone)
            {
                End(abort);
            }
        }
        else
        {
            const Room room{&parts_.scratch.data[kItemHeadBytes], parts_.scratch.size_bytes - kItemHeadBytes};
            const StoredItem item = parts_.parts[part_]->Item(item_, room);
            ++item_;
            is_found = (item.group & request_.groups) != 0U;
            size_ = is_found ? (kItemHeadBytes + item.size_bytes) : 0U;
            put_ = 0U;
            parts_.scratch.data[0] = item.group;
            parts_.scratch.data[1] = part_;
            ToLittleEndian(item.size_bytes, &parts_.scratch.data[2], 2U);
            if (is_found && ((item.abort != SdoAbort::kNone) || !writer_.HasRoom(size_)))
            {
                End((item.abort != SdoAbort::kNone) ? item.abort : SdoAbort::kNotStored);
            }
        }
    }
}

/// The next item of the old set that stays: it is copied in pieces.
void ParameterStore::FetchOld() noexcept
{
    const ItemHead head = has_current_ ? current_.HeadAt(place_) : ItemHead{false, 0U, 0U, 0U};
    const std::uint32_t whole = kItemHeadBytes + head.size_bytes;
    if (!head.is_present)
    {
        phase_ = Phase::kClose;
    }
    else if ((head.group & request_.groups) != 0U)
    {
        place_ += whole;
    }
    else if (!writer_.HasRoom(whole))
    {
        End(SdoAbort::kNotStored);
    }
    else
    {
        size_ = whole;
        put_ = 0U;
    }
}

void ParameterStore::PutPiece() noexcept
{
    const std::uint32_t left = size_ - put_;
    const std::uint32_t count = (left < writer_.Space()) ? left : writer_.Space();
    if (phase_ == Phase::kItems)
    {
        writer_.Put(Bytes{&parts_.scratch.data[put_], count});
        put_ += count;
    }
    else if (current_.Read(place_, Room{parts_.scratch.data, count}))
    {
        writer_.Put(Bytes{parts_.scratch.data, count});
        put_ += count;
        place_ += count;
    }
    else
    {
        End(SdoAbort::kHardware);
    }
    static_cast<void>(writer_.Flush(false));
}

void ParameterStore::Close() noexcept
{
    if (!writer_.Flush(true))
    {
        writer_.Close(generation_, static_cast<std::uint8_t>(lost_ & ~request_.groups & 0xFFU));
        phase_ = Phase::kOpen;
    }
}

/// Reads back what was written.
void ParameterStore::Verify() noexcept
{
    ImageCheck check = ImageCheck::kMore;
    if (phase_ == Phase::kOpen)
    {
        check = candidate_.Open(target_) ? ImageCheck::kMore : ImageCheck::kInvalid;
        phase_ = Phase::kVerify;
    }
    else
    {
        check = candidate_.Continue();
    }
    if (check == ImageCheck::kValid)
    {
        StartMark(parts_.memory, OtherOf(target_), BankMark::kSuperseded);
        phase_ = Phase::kSeal;
    }
    else if (check == ImageCheck::kInvalid)
    {
        End(SdoAbort::kHardware);
    }
}

/// The set counts, and says so.
void ParameterStore::EndSeal() noexcept
{
    if (HasMark(parts_.memory, OtherOf(target_), BankMark::kSuperseded))
    {
        current_ = candidate_;
        has_current_ = true;
        lost_ = current_.Lost();
        is_broken_ = false;
        target_ = OtherOf(target_);
        generation_ = current_.Generation() + 1U;
        End(SdoAbort::kNone);
    }
    else
    {
        End(SdoAbort::kHardware);
    }
}

void ParameterStore::End(const SdoAbort result) noexcept
{
    phase_ = Phase::kEnded;
    result_ = result;
    age_ = 0U;
}

} // namespace counterpoint::cia301
