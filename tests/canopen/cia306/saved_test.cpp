// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/file/saved.hpp"
#include "verification/trace/ids/generate.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace counterpoint::cia306
{
namespace
{

bool IsKept(const std::uint16_t index, const Access access)
{
    Entry entry;
    entry.index = index;
    entry.access = access;
    entry.is_safety = index >= 0x5F00U && index <= 0x5F05U;
    return IsSaved(entry);
}

TEST(Saved, IsWhatSomebodyCanWriteAndReadBack)
{
    Verifies(req::SRS_GEN_330);
    EXPECT_TRUE(IsKept(0x2000U, Access::kReadWrite));
    EXPECT_FALSE(IsKept(0x2000U, Access::kReadOnly));
    EXPECT_FALSE(IsKept(0x2000U, Access::kConstant));
    EXPECT_FALSE(IsKept(0x2000U, Access::kWriteOnly));
}

TEST(Saved, IsNoListOfErrorsNoCommandAndNoParameterOfTheProgram)
{
    Verifies(req::SRS_GEN_330);
    constexpr std::uint16_t kOwn[] = {0x1003U, 0x1010U, 0x1011U, 0x5F00U, 0x5F05U};
    for (const std::uint16_t index : kOwn)
    {
        EXPECT_FALSE(IsKept(index, Access::kReadWrite)) << index;
    }
    constexpr std::uint16_t kBeside[] = {0x1002U, 0x1004U, 0x100FU, 0x1012U, 0x5EFFU, 0x5F06U};
    for (const std::uint16_t index : kBeside)
    {
        EXPECT_TRUE(IsKept(index, Access::kReadWrite)) << index;
    }
}

TEST(Saved, TwoObjectsAreCommandsOfAStore)
{
    Verifies(req::SRS_STO_008);
    constexpr std::uint16_t kBeside[] = {0x100FU, 0x1012U, 0x1110U, 0x0010U};
    EXPECT_TRUE(IsStoreCommand(0x1010U));
    EXPECT_TRUE(IsStoreCommand(0x1011U));
    for (const std::uint16_t index : kBeside)
    {
        EXPECT_FALSE(IsStoreCommand(index)) << index;
    }
}

} // namespace
} // namespace counterpoint::cia306
