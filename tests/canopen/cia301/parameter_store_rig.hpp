// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_PARAMETER_STORE_RIG_HPP
#define TESTS_CANOPEN_CIA301_PARAMETER_STORE_RIG_HPP

#include "canopen/cia301/store/parameter_store.hpp"
#include "tests/canopen/cia301/cut_memory.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace counterpoint::cia301
{

using Values = std::map<int, Octets>;

/// Items by number, three of each group; the first byte of an item is its number.
class ListPart final : public StoredPart
{
  public:
    std::uint32_t ItemCount() noexcept override
    {
        return 100U; // Most of them are not stored.
    }
    StoredItem Item(std::uint32_t number, const Room& room) noexcept override
    {
        StoredItem item{SdoAbort::kNone, 0U, 0U};
        const auto found = values.find(static_cast<int>(number));
        if ((found != values.end()) && (found->second.size() < room.size_bytes))
        {
            item.abort = abort;
            item.group = static_cast<std::uint8_t>(1U << (number % 3U));
            item.size_bytes = static_cast<std::uint32_t>(1U + found->second.size());
            room.data[0] = static_cast<std::uint8_t>(number);
            std::copy(found->second.begin(), found->second.end(), &room.data[1]);
        }
        return item;
    }
    void BeginLoad(std::uint8_t) noexcept override
    {
        values = defaults;
        ++loads;
    }
    bool LoadItem(const Bytes& item) noexcept override
    {
        if (item.size_bytes == 0U)
        {
            ++unread;
            return false;
        }
        values[item.data[0]] = Octets(&item.data[1], &item.data[item.size_bytes]);
        return item.data[0] != 99U;
    }
    bool EndLoad(std::uint8_t) noexcept override
    {
        ++loads;
        return !is_useless;
    }
    void Lose(std::uint8_t groups) noexcept override
    {
        lost = groups;
    }

    Values values{};
    Values defaults{};
    SdoAbort abort{SdoAbort::kNone};
    int loads{0};
    std::uint32_t unread{0U}; ///< Items that came without bytes.
    std::uint8_t lost{0U};
    bool is_useless{false};
};

constexpr StoreRequest kSaveAll{StoreAction::kSave, kAllGroups};

class ParameterStoreTest : public ::testing::Test
{
  public:
    explicit ParameterStoreTest(std::uint32_t bank_bytes = 512U) : memory(bank_bytes)
    {
    }
    /// A store after power-on.
    struct Started
    {
        explicit Started(ParameterStoreTest& test)
            : store(StoreParts{test.memory, test.parts.data(), 1U, Room{test.scratch.data(), 64U}})
        {
            is_mounted = store.Mount();
        }
        /// Cycles until the request has an answer; kPending: it has none.
        SdoAbort Finish(const StoreRequest& request)
        {
            return Await(request, store.Begin(request));
        }
        SdoAbort Await(const StoreRequest& request, SdoAbort answer = SdoAbort::kPending)
        {
            for (int i = 0; (i < 500) && (answer == SdoAbort::kPending); ++i)
            {
                store.OnCycle();
                answer = store.Continue(request);
            }
            return answer;
        }
        ParameterStore store;
        bool is_mounted{false};
    };
    static Values SetOf(std::uint8_t fill)
    {
        Values values{};
        for (const int number : {0, 1, 2, 30, 61, 92})
        {
            values[number] = Octets(static_cast<std::size_t>(3 + (number / 3)), fill);
        }
        return values;
    }
    SdoAbort Save(const Values& values, const StoreRequest& request = kSaveAll)
    {
        part.values = values;
        return Started(*this).Finish(request);
    }
    Values LoadNow(std::uint8_t groups = kAllGroups)
    {
        part.values.clear();
        part.lost = 0U;
        Started started{*this};
        report = started.store.Load(groups);
        return part.values;
    }

    CutMemory memory;
    ListPart part{};
    std::array<StoredPart*, 1> parts{&part};
    std::array<std::uint8_t, 64> scratch{};
    LoadReport report{StoreFinding::kInvalid, false, 0U, 0U};
};

} // namespace counterpoint::cia301

#endif
