// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/objects/store.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace counterpoint::runtime
{
namespace
{
constexpr std::uint32_t kBankBytes = 256U * 1024U;
constexpr std::uint32_t kLargestItem = 65535U;

/// What the host says of the file has the form of all complaints about files. [SRS_EDS_036]
host::FileParameterMemory OpenFile(const std::string& path)
{
    try
    {
        return host::FileParameterMemory(path, kBankBytes);
    }
    catch (const std::runtime_error& error)
    {
        const std::string text = error.what();
        const std::string head = path + ": ";
        const std::string mark = ", expected ";
        const std::size_t begin = (text.rfind(head, 0U) == 0U) ? head.size() : 0U;
        const std::size_t end = std::min(text.rfind(mark), text.size());
        throw cia306::InputError(
            path, {},
            {"the store " + text.substr(begin, end - begin), text.substr(std::min(end + mark.size(), text.size()))});
    }
}
} // namespace

NodeMemory::NodeMemory(const std::string& path) : file_(OpenFile(path)), worker_([this] { Work(); })
{
}

NodeMemory::~NodeMemory()
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_finished_ = true;
    }
    wake_.notify_one();
    worker_.join();
}

hal::MemoryStatus NodeMemory::Status() noexcept
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_busy_ ? hal::MemoryStatus::kBusy : file_.Status();
}

void NodeMemory::Erase(const hal::MemoryBank bank) noexcept
{
    Order([this, bank] { file_.Erase(bank); });
}

void NodeMemory::Program(const hal::MemorySection& section, const std::uint8_t* const from) noexcept
{
    Order([this, section, from] { file_.Program(section, from); });
}

bool NodeMemory::Read(const hal::MemorySection& section, std::uint8_t* const to) noexcept
{
    return file_.Read(section, to);
}

void NodeMemory::Order(std::function<void()> work)
{
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = std::move(work);
        is_busy_ = true;
    }
    wake_.notify_one();
}

void NodeMemory::Work()
{
    std::unique_lock<std::mutex> lock(mutex_);
    while (!is_finished_ || work_)
    {
        wake_.wait(lock, [this] { return is_finished_ || static_cast<bool>(work_); });
        if (const std::function<void()> work = std::exchange(work_, nullptr))
        {
            lock.unlock();
            work();
            lock.lock();
            is_busy_ = false;
        }
    }
}

NodeStore::NodeStore(const std::string& path, const NodeStoreParts& parts)
    : path_(path), memory_(path),
      entries_(parts.table, parts.dictionary, parts.services.tpdos, parts.services.rpdos, parts.defaults),
      loaded_(entries_, parts.dictionary), safety_(parts.kernel, parts.services.node), lss_({0U, {0U}}),
      list_{&loaded_, &safety_, &lss_}, scratch_(kLargestItem),
      store_({memory_, list_.data(), static_cast<std::uint8_t>(list_.size()), {scratch_.data(), kLargestItem}}),
      objects_(store_)
{
    static_cast<void>(store_.Mount());
}

std::string NodeStore::Load(const std::uint8_t groups) noexcept
{
    const cia301::LoadReport report = store_.Load(groups);
    const std::string warning = cia306::Printable(path_) + ": warning: ";
    if (report.finding == cia301::StoreFinding::kLost)
    {
        return warning + "what was saved is damaged, expected the whole set that 1010h has saved last; no older one is "
                         "loaded, and 13FEh is not A5h until a configuration is written and saved again";
    }
    if (report.finding == cia301::StoreFinding::kBrokenSave)
    {
        return warning +
               "the last save has not ended; what was saved before it holds, without any the values of the DCF";
    }
    const bool is_refused = report.finding == cia301::StoreFinding::kRefused;
    if (report.refused == 0U)
    {
        return is_refused ? warning + "the saved safety configuration is refused, expected that of this device and "
                                      "node-ID; 13FEh is not A5h"
                          : std::string();
    }
    return warning + std::to_string(report.refused) + " of " + std::to_string(report.loaded + report.refused) +
           " saved values are refused" + loaded_.TakeRefused() + ", expected those of this device" +
           (is_refused ? "; so is the saved safety configuration, and 13FEh is not A5h" : "");
}

std::vector<std::string> NodeStore::NotTaken() const
{
    std::vector<std::string> lines;
    for (const std::string& object : loaded_.NotTaken())
    {
        lines.push_back(cia306::Printable(path_) + ": warning: " + object +
                        ": the device does without the saved value, expected one that goes with the others");
    }
    return lines;
}

cia305::LssSettings NodeStore::LoadLss(const cia305::LssSettings& otherwise) noexcept
{
    static_cast<void>(Load(cia301::kLssGroup));         // The reset that follows tells.
    const bool is_kept = lss_.Settings().node_id != 0U; // No setting that LSS could have.
    return is_kept ? lss_.Settings() : otherwise;
}

cia305::LssStored NodeStore::Keep(const cia305::LssSettings& settings) noexcept
{
    return lss_.Keep(settings, store_);
}

void NodeStore::OnCycle() noexcept
{
    store_.OnCycle();
}
} // namespace counterpoint::runtime
