// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/stored_parts.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/entry_value.hpp"
#include "canopen/cia301/store/stored_image.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kAddressBytes = 3U;
constexpr std::uint16_t kSaveObject = 0x1010U;
constexpr std::uint16_t kLoadObject = 0x1011U;
constexpr std::uint32_t kSave = 0x65766173U; ///< "save"
constexpr std::uint32_t kLoad = 0x64616F6CU; ///< "load"
constexpr std::uint8_t kHighestSub = 4U;
/// By sub-index of 1010h and 1011h.
constexpr std::uint8_t kGroupOf[kHighestSub + 1U] = {0U, kAllGroups, kCommunicationGroup, kApplicationGroup,
                                                     kManufacturerGroup};
constexpr std::uint32_t kValuesInItem = 12U;
constexpr std::uint32_t kHeaderItemBytes = 10U;
constexpr std::uint32_t kNodeItemBytes = kHeaderItemBytes + 1U; ///< With the node-ID.
constexpr std::uint8_t kHeaderItem = 0U;
constexpr std::uint8_t kValueItem = 1U;
constexpr std::uint32_t kValueItemHead = 5U;

std::uint8_t GroupOfIndex(const std::uint16_t index) noexcept
{
    std::uint8_t group = 0U;
    if ((index >= 0x1000U) && (index < 0x2000U))
    {
        group = kCommunicationGroup;
    }
    else if ((index >= 0x2000U) && (index < 0x6000U))
    {
        group = kManufacturerGroup;
    }
    else if ((index >= 0x6000U) && (index < 0xA000U))
    {
        group = kApplicationGroup;
    }
    return group;
}

std::uint32_t NumberAt(const std::uint8_t* const bytes) noexcept
{
    return static_cast<std::uint32_t>(FromLittleEndian(bytes, 4U));
}

std::uint32_t ContinueWith(const std::uint32_t crc, const std::uint32_t value) noexcept
{
    std::uint8_t bytes[4] = {};
    ToLittleEndian(value, bytes, 4U);
    return ContinueCrc32(crc, Bytes{bytes, 4U});
}

} // namespace

StoredEntries::StoredEntries(const EntryTable& table, const Dictionary& dictionary, Tpdos& tpdos, Rpdos& rpdos) noexcept
    : table_(table), dictionary_(dictionary), tpdos_(tpdos), rpdos_(rpdos), defaults_(nullptr)
{
}

StoredEntries::StoredEntries(const EntryTable& table, const Dictionary& dictionary, Tpdos& tpdos, Rpdos& rpdos,
                             const NodeDefaults& defaults) noexcept
    : table_(table), dictionary_(dictionary), tpdos_(tpdos), rpdos_(rpdos), defaults_(&defaults)
{
}

std::uint32_t StoredEntries::ItemCount() noexcept
{
    return table_.count;
}

StoredItem StoredEntries::Item(const std::uint32_t number, const Room& room) noexcept
{
    const Entry& entry = table_.entries[number];
    StoredItem item{SdoAbort::kNone, 0U, 0U};
    if (((entry.uses & kStored) != 0U) && (room.size_bytes > kAddressBytes))
    {
        const Reading reading = ReadEntry(entry, Room{&room.data[kAddressBytes], room.size_bytes - kAddressBytes});
        const Bytes value{&room.data[kAddressBytes], reading.size_bytes};
        const bool follows_node =
            (defaults_ != nullptr) && (reading.abort == SdoAbort::kNone) && defaults_->IsNodeDefault(number, value);
        const std::uint8_t group = follows_node ? std::uint8_t{0U} : GroupOfIndex(entry.index);
        item = StoredItem{reading.abort, group, kAddressBytes + reading.size_bytes};
        ToLittleEndian(entry.index, room.data, 2U);
        room.data[2] = entry.sub;
    }
    return item;
}

void StoredEntries::BeginLoad(const std::uint8_t groups) noexcept
{
    if ((groups & kAllGroups) != 0U)
    {
        tpdos_.BeginConfiguration();
        rpdos_.BeginConfiguration();
    }
}

bool StoredEntries::LoadItem(const Bytes& item) noexcept
{
    bool is_loaded = false;
    if (item.size_bytes >= kAddressBytes)
    {
        const ObjectAddress address{static_cast<std::uint16_t>(FromLittleEndian(item.data, 2U)), item.data[2]};
        const Entry* const entry = dictionary_.Find(address);
        const Bytes value{&item.data[kAddressBytes], item.size_bytes - kAddressBytes};
        const bool is_stored = (entry != nullptr) && ((entry->uses & kStored) != 0U);
        is_loaded = is_stored && (WriteEntry(*entry, value, Attempt::kFirst) == SdoAbort::kNone);
    }
    return is_loaded;
}

bool StoredEntries::EndLoad(std::uint8_t) noexcept
{
    tpdos_.EndConfiguration();
    rpdos_.EndConfiguration();
    return true;
}

void StoredEntries::Lose(std::uint8_t) noexcept
{
}

StoredSafety::StoredSafety(Kernel& kernel) noexcept
    : kernel_(kernel), header_{0U, 0U, 0U}, has_header_(false), has_refused_(false), has_image_(false), given_crc_(0U),
      node_(nullptr), is_of_node_(true)
{
}

StoredSafety::StoredSafety(Kernel& kernel, const NodeId& node) noexcept : StoredSafety(kernel)
{
    node_ = &node;
}

/// The header, then the values. Where there is none to be had, the header alone, which then refuses: a set without it
/// would leave whatever configuration the device begins with.
std::uint32_t StoredSafety::ItemCount() noexcept
{
    const HeaderReply reply = kernel_.Image().Header();
    header_ = reply.header;
    given_crc_ = 0U;
    has_image_ = (reply.result == Result::kSuccessful);
    const std::uint32_t items = (header_.count + (kValuesInItem - 1U)) / kValuesInItem;
    return has_image_ ? (1U + items) : 1U;
}

StoredItem StoredSafety::Item(const std::uint32_t number, const Room& room) noexcept
{
    StoredItem item{SdoAbort::kOutOfMemory, kCommunicationGroup, kHeaderItemBytes};
    const bool has_room = room.size_bytes >= (kValueItemHead + (4U * kValuesInItem));
    if (has_room && (number == 0U))
    {
        room.data[0] = kHeaderItem;
        ToLittleEndian(header_.count, &room.data[1], 4U);
        ToLittleEndian(header_.crc, &room.data[5], 4U);
        room.data[9] = header_.valid;
        if (node_ != nullptr)
        {
            room.data[kHeaderItemBytes] = node_->value;
            item.size_bytes = kNodeItemBytes;
        }
        item.abort = has_image_ ? SdoAbort::kNone : SdoAbort::kDeviceState;
    }
    else if (has_room)
    {
        const std::uint32_t first = (number - 1U) * kValuesInItem;
        const std::uint32_t left = header_.count - first;
        const std::uint32_t count = (left < kValuesInItem) ? left : kValuesInItem;
        item.abort = SdoAbort::kNone;
        item.size_bytes = kValueItemHead + (4U * count);
        room.data[0] = kValueItem;
        ToLittleEndian(first, &room.data[1], 4U);
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            const ItemReply reply = kernel_.Image().ReadItem(first + i);
            item.abort = (reply.result == Result::kSuccessful) ? item.abort : SdoAbort::kNotStored;
            ToLittleEndian(reply.value, &room.data[kValueItemHead + (4U * i)], 4U);
            given_crc_ = ContinueWith(given_crc_, reply.value);
        }
    }
    return item;
}

/// A client may have written while the items were read: header and values are those of one configuration only if both
/// are those of now. A valid one of another digest than the expected one (1300h may change while it runs) would be
/// refused at the next start.
SdoAbort StoredSafety::EndSave(const std::uint8_t groups) noexcept
{
    SdoAbort abort = SdoAbort::kNone;
    if (has_image_ && ((groups & kCommunicationGroup) != 0U))
    {
        const ImageHeader now = kernel_.Image().Header().header;
        std::uint32_t crc = 0U;
        for (std::uint32_t i = 0U; i < header_.count; ++i)
        {
            crc = ContinueWith(crc, kernel_.Image().ReadItem(i).value);
        }
        const bool is_same = (now.crc == header_.crc) && (now.valid == header_.valid) && (crc == given_crc_);
        const bool is_expected =
            (now.valid != kConfigurationValidValue) || (kernel_.Digest().result == Result::kSuccessful);
        abort = (is_same && is_expected) ? SdoAbort::kNone : SdoAbort::kDeviceState;
    }
    return abort;
}

void StoredSafety::BeginLoad(std::uint8_t) noexcept
{
    has_header_ = false;
    has_refused_ = false;
    is_of_node_ = true;
}

bool StoredSafety::LoadItem(const Bytes& item) noexcept
{
    const bool is_loaded = TakeItem(item);
    has_refused_ = has_refused_ || !is_loaded;
    return is_loaded;
}

/// A header without a node-ID is of a device that has one for ever, or was saved before headers told it.
bool StoredSafety::TakeItem(const Bytes& item) noexcept
{
    bool is_loaded = false;
    const bool has_node = (item.size_bytes == kNodeItemBytes);
    if (((item.size_bytes == kHeaderItemBytes) || has_node) && (item.data[0] == kHeaderItem))
    {
        header_ = ImageHeader{NumberAt(&item.data[1]), NumberAt(&item.data[5]), item.data[9]};
        has_header_ = true;
        is_of_node_ = (node_ == nullptr) || (!has_node) || (item.data[kHeaderItemBytes] == node_->value);
        is_loaded = true;
    }
    else if ((item.size_bytes > kValueItemHead) && (item.data[0] == kValueItem))
    {
        const std::uint32_t first = NumberAt(&item.data[1]);
        const std::uint32_t count = (item.size_bytes - kValueItemHead) / 4U;
        is_loaded = true;
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            const std::uint32_t value = NumberAt(&item.data[kValueItemHead + (4U * i)]);
            is_loaded = (kernel_.Image().LoadItem(first + i, value) == Result::kSuccessful) && is_loaded;
        }
    }
    return is_loaded;
}

/// The kernel checks what it got, and keeps the power-on configuration if that is not what was saved. It looks at the
/// node-ID by its digest alone, and expects none where the node-ID is not that of the file. An object whose item is
/// refused keeps its value, so that a damaged set may end as what its header tells: it is damaged all the same.
bool StoredSafety::EndLoad(std::uint8_t) noexcept
{
    const bool is_whole = !has_refused_ && is_of_node_;
    bool is_used = is_whole;
    if (!is_whole)
    {
        static_cast<void>(kernel_.Image().RestoreDefaults());
    }
    else if (has_header_)
    {
        is_used = (kernel_.Image().Load(header_) == Result::kSuccessful);
    }
    else
    {
        // Nothing was saved of it.
    }
    return is_used;
}

void StoredSafety::Lose(const std::uint8_t groups) noexcept
{
    if ((groups & kCommunicationGroup) != 0U)
    {
        static_cast<void>(kernel_.Image().RestoreDefaults());
    }
}

StoreObjects::StoreObjects(ParameterStore& store) noexcept : store_(store)
{
}

ObjectValue StoreObjects::Fetch(const ObjectAddress& address) noexcept
{
    ObjectValue value{SdoAbort::kNone, 1U, 4U}; // Saves, or restores, on command.
    if ((address.index != kSaveObject) && (address.index != kLoadObject))
    {
        value.abort = SdoAbort::kObjectUnknown;
    }
    else if (address.sub > kHighestSub)
    {
        value.abort = SdoAbort::kSubUnknown;
    }
    else if (address.sub == 0U)
    {
        value = ObjectValue{SdoAbort::kNone, kHighestSub, 1U};
    }
    return value;
}

SdoAbort StoreObjects::Store(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    return Request(address, value, Attempt::kFirst);
}

SdoAbort StoreObjects::StoreAgain(const ObjectAddress& address, const std::uint32_t value) noexcept
{
    return Request(address, value, Attempt::kAgain);
}

SdoAbort StoreObjects::Request(const ObjectAddress& address, const std::uint32_t value, const Attempt attempt) noexcept
{
    const bool is_save = (address.index == kSaveObject);
    SdoAbort abort = Fetch(address).abort;
    if ((abort == SdoAbort::kNone) && (address.sub == 0U))
    {
        abort = SdoAbort::kReadOnly;
    }
    else if ((abort == SdoAbort::kNone) && (value != (is_save ? kSave : kLoad)))
    {
        abort = SdoAbort::kNotStored;
    }
    else if (abort == SdoAbort::kNone)
    {
        const StoreRequest request{is_save ? StoreAction::kSave : StoreAction::kForget, kGroupOf[address.sub]};
        abort = (attempt == Attempt::kAgain) ? store_.Continue(request) : store_.Begin(request);
    }
    return abort;
}

} // namespace counterpoint::cia301
