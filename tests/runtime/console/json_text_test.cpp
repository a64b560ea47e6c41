// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/console/json_text.hpp"
#include "verification/trace/ids/eds.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
// Given an umlaut in UTF-8, and one in Latin-1
TEST(JsonTextTest, IsUtf8WhateverBytesAFileHas)
{
    Verifies(req::SRS_CLI_350);
    EXPECT_EQ(JsonText({{"name", "T\xC3\xBCr"}}), "{\n  \"name\": \"T\xC3\xBCr\"\n}\n");
    EXPECT_EQ(JsonText({{"name", "T\xFCr"}}), "{\n  \"name\": \"T\xEF\xBF\xBDr\"\n}\n");
    EXPECT_EQ(OneLine({{"name", "T\xC3\xBCr"}}), "{\"name\":\"T\xC3\xBCr\"}\n");
    EXPECT_EQ(OneLine({{"name", "T\xFCr"}}), "{\"name\":\"T\xEF\xBF\xBDr\"}\n");
}
} // namespace
} // namespace counterpoint::runtime
