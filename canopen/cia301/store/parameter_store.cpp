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
      item_count_(kUnknownLength), item_(0U), place_(0U), size_(0U), put_(0U), has_current_(false)
{
}

bool ParameterStore::Mount() noexcept
{
    has_current_ = Examine(hal::MemoryBank::kFirst);
    if (has_current_)
    {
        current_ = candidate_;
    }
    if (Examine(hal::MemoryBank::kSecond) && (!has_current_ || IsNewer(candidate_.Generation(), current_.Generation())))
    {
        current_ = candidate_;
        has_current_ = true;
    }
    return has_current_;
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
    LoadReport report{has_current_, 0U, 0U};
    for (std::uint8_t part = 0U; has_current_ && (part < parts_.part_count); ++part)
    {
        parts_.parts[part]->BeginLoad(groups);
    }
    std::uint32_t place = 0U;
    ItemHead head = has_current_ ? current_.HeadAt(place) : ItemHead{false, 0U, 0U, 0U};
    while (head.is_present)
    {
        const bool is_fit = (head.part < parts_.part_count) && (head.size_bytes <= parts_.scratch.size_bytes);
        const Room room{parts_.scratch.data, head.size_bytes};
        if ((head.group & groups) != 0U)
        {
            const bool is_loaded = is_fit && current_.Read(place + kItemHeadBytes, room) &&
                                   parts_.parts[head.part]->LoadItem(Bytes{room.data, room.size_bytes});
            report.loaded += is_loaded ? 1U : 0U;
            report.refused += is_loaded ? 0U : 1U;
        }
        place += kItemHeadBytes + head.size_bytes;
        head = current_.HeadAt(place);
    }
    for (std::uint8_t part = 0U; has_current_ && (part < parts_.part_count); ++part)
    {
        parts_.parts[part]->EndLoad(groups);
    }
    return report;
}

SdoAbort ParameterStore::Ask(const StoreRequest& request) noexcept
{
    const bool is_same = (request.action == request_.action) && (request.groups == request_.groups);
    SdoAbort answer = SdoAbort::kPending;
    if (phase_ == Phase::kIdle)
    {
        request_ = request;
        phase_ = Phase::kBegin;
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
        writer_.Begin(has_current_ ? OtherOf(current_.Bank()) : hal::MemoryBank::kFirst);
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
            ++part_;
            item_ = 0U;
            item_count_ = kUnknownLength;
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
        writer_.Close(has_current_ ? (current_.Generation() + 1U) : 1U);
        phase_ = Phase::kOpen;
    }
}

/// Reads back what was written.
void ParameterStore::Verify() noexcept
{
    ImageCheck check = ImageCheck::kMore;
    if (phase_ == Phase::kOpen)
    {
        const hal::MemoryBank bank = has_current_ ? OtherOf(current_.Bank()) : hal::MemoryBank::kFirst;
        check = candidate_.Open(bank) ? ImageCheck::kMore : ImageCheck::kInvalid;
        phase_ = Phase::kVerify;
    }
    else
    {
        check = candidate_.Continue();
    }
    if (check == ImageCheck::kValid)
    {
        current_ = candidate_;
        has_current_ = true;
        End(SdoAbort::kNone);
    }
    else if (check == ImageCheck::kInvalid)
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
