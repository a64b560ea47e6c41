// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Columns of tables, whose names may be in any language.
#include "canopen/cia306/text/column.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::cia306
{
namespace
{
TEST(ColumnTest, ACharacterIsOnePlaceAndIsNotCutInTwo)
{
    Verifies(req::SRS_MGR_751);
    EXPECT_EQ(CharactersOf(""), 0U);
    EXPECT_EQ(CharactersOf("Pump"), 4U);
    EXPECT_EQ(CharactersOf("F\xC3\xB6rder"), 6U);
    EXPECT_EQ(CharactersOf("\xC3"), 1U);
    EXPECT_EQ(Column("Pump", 6U), "Pump  ");
    EXPECT_EQ(Column("Pump", 4U), "Pump");
    EXPECT_EQ(Column("Pump", 2U), "Pu");
    EXPECT_EQ(Column("F\xC3\xB6rder", 8U), "F\xC3\xB6rder  ");
    EXPECT_EQ(Column("F\xC3\xB6rder", 2U), "F\xC3\xB6");
    EXPECT_EQ(Column("F\xC3\xB6rder", 1U), "F");
    // Three and four bytes
    EXPECT_EQ(Column("\xE6\x97\xA5\xE6\x9C\xAC", 1U), "\xE6\x97\xA5");
    EXPECT_EQ(Column("\xF0\x9F\x98\x80", 2U), "\xF0\x9F\x98\x80 ");
}

TEST(ColumnTest, WhatIsNoCharacterIsShownAsOne)
{
    Verifies(req::SRS_MGR_751);
    EXPECT_EQ(Column("F\xF6rder", 7U), "F?rder ");
    EXPECT_EQ(Column("a\tb", 8U), "a\\x09b  ");
    // An escape that has no room is left out whole
    EXPECT_EQ(Column("a\tb", 4U), "a   ");
}
} // namespace
} // namespace counterpoint::cia306
