// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia305/stored_lss.hpp"

namespace counterpoint::cia305
{
namespace
{

constexpr std::uint32_t kItemBytes = 2U;

bool IsSame(const LssSettings& left, const LssSettings& right) noexcept
{
    return (left.node_id == right.node_id) && (left.timing.index == right.timing.index);
}

} // namespace

StoredLss::StoredLss(const LssSettings& settings) noexcept : settings_(settings), is_saving_(false)
{
}

const LssSettings& StoredLss::Settings() const noexcept
{
    return settings_;
}

LssStored StoredLss::Keep(const LssSettings& settings, cia301::ParameterStore& store) noexcept
{
    const cia301::StoreRequest request{cia301::StoreAction::kSave, cia301::kLssGroup};
    LssStored stored = LssStored::kPending;
    if (!is_saving_)
    {
        is_saving_ = (store.Begin(request) == cia301::SdoAbort::kPending); // Another store that is running comes first.
        settings_ = is_saving_ ? settings : settings_;
    }
    else
    {
        const cia301::SdoAbort answer = store.Continue(request);
        is_saving_ = (answer == cia301::SdoAbort::kPending);
        if (!is_saving_ && IsSame(settings, settings_))
        {
            stored = (answer == cia301::SdoAbort::kNone) ? LssStored::kDone : LssStored::kFailed;
        }
    }
    return stored;
}

std::uint32_t StoredLss::ItemCount() noexcept
{
    return 1U;
}

cia301::StoredItem StoredLss::Item(std::uint32_t, const cia301::Room& room) noexcept
{
    cia301::StoredItem item{cia301::SdoAbort::kOutOfMemory, cia301::kLssGroup, kItemBytes};
    if (room.size_bytes >= kItemBytes)
    {
        room.data[0] = settings_.node_id;
        room.data[1] = settings_.timing.index;
        item.abort = cia301::SdoAbort::kNone;
    }
    return item;
}

void StoredLss::BeginLoad(std::uint8_t) noexcept
{
}

bool StoredLss::LoadItem(const cia301::Bytes& item) noexcept
{
    const bool is_item = (item.size_bytes == kItemBytes);
    if (is_item)
    {
        settings_ = LssSettings{item.data[0], BitTiming{item.data[1]}};
    }
    return is_item;
}

bool StoredLss::EndLoad(std::uint8_t) noexcept
{
    return true;
}

void StoredLss::Lose(std::uint8_t) noexcept
{
}

} // namespace counterpoint::cia305
