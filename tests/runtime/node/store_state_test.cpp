// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 1010h and 1011h of a node that is OPERATIONAL: by the bus, and by orders.
#include "tests/runtime/node/bench.hpp"
#include "verification/trace/ids/cia301.hpp"
#include "verification/trace/ids/comfort.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/store.hpp"
#include "verification/trace/verifies.hpp"

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <sys/resource.h>

namespace counterpoint::tools::test
{
namespace
{
using cia301::SdoAbort;

constexpr std::uint32_t kSave = 0x65766173U;
constexpr std::uint32_t kLoad = 0x64616F6CU;

std::string Everything()
{
    return std::string(COUNTERPOINT_SOURCE) + "/tests/runtime/data/everything.dcf";
}

TEST(NodeStoreStateTest, InOperationalTheBusSavesAndRestoresNothing)
{
    Verifies(req::SRS_STO_008);
    const std::string store = ::testing::TempDir() + "store_state.store";
    std::remove(store.c_str());
    Bench bench(Everything(), store);
    bench.Start();
    EXPECT_EQ(bench.Download(0x1010U, 1U, kSave, 4U), 0x08000022U);
    EXPECT_EQ(bench.Download(0x1011U, 1U, kLoad, 4U), 0x08000022U);
    EXPECT_FALSE(bench.Device().IsSaving());
    std::uint8_t bytes[4U]{};
    cia301::Dictionary& objects = bench.Device().Assembly().Dictionary();
    EXPECT_EQ(objects.Read({0x1010U, 1U}, {bytes, 4U}).abort, SdoAbort::kNone);
    EXPECT_EQ(bytes[0], 1U);
    EXPECT_EQ(objects.Read({0x1011U, 1U}, {bytes, 4U}).abort, SdoAbort::kNone);
    EXPECT_EQ(bytes[0], 1U);
    EXPECT_EQ(bench.Download(0x4005U, 0U, 50U, 1U), 0U);
    // When it is PRE-OPERATIONAL again, both are taken
    bench.Command(128U);
    bench.Store(0x1010U, kSave);
    bench.Store(0x1011U, kLoad);
    EXPECT_EQ(bench.Told().find("refused"), std::string::npos);
    std::remove(store.c_str());
}

/// An element of the file with another access.
std::string WithAccess(std::string text, const std::string& section, const std::string& access)
{
    const std::size_t place = text.find("AccessType=", text.find("[" + section + "]"));
    return text.replace(place, text.find('\n', place) - place, "AccessType=" + access);
}

TEST(NodeStoreStateTest, WhatTheFileFixesIsRefusedAsThatInEachState)
{
    Verifies(req::SRS_STO_008);
    std::ostringstream text;
    text << std::ifstream(Everything()).rdbuf();
    // Given 1010h:01 as a constant, and 1011h:01 that can be written alone
    const std::string file = ::testing::TempDir() + "store_fixed.dcf";
    std::ofstream(file) << WithAccess(WithAccess(text.str(), "1010sub1", "const"), "1011sub1", "wo");
    const std::string store = ::testing::TempDir() + "store_fixed.store";
    std::remove(store.c_str());
    Bench bench(file, store);
    // When both are written, PRE-OPERATIONAL and OPERATIONAL
    EXPECT_EQ(bench.Download(0x1010U, 1U, kSave, 4U), 0x06010002U);
    bench.Start();
    EXPECT_EQ(bench.Download(0x1010U, 1U, kSave, 4U), 0x06010002U);
    EXPECT_EQ(bench.Download(0x1011U, 1U, kLoad, 4U), 0x08000022U);
    std::remove(store.c_str());
}

TEST(NodeStoreStateTest, ASaveThatWasTakenGoesOnBehindTheStart)
{
    Verifies(req::SRS_OBD_530);
    Verifies(req::SRS_STO_005);
    const std::string store = ::testing::TempDir() + "store_goes_on.store";
    std::remove(store.c_str());
    {
        Bench bench(Everything(), store);
        EXPECT_EQ(bench.Download(0x4005U, 0U, 50U, 1U), 0U);
        EXPECT_EQ(bench.Download(0x1010U, 1U, kSave, 4U), 0U) << "the last answer is still that of 4005h";
        ASSERT_TRUE(bench.Device().IsSaving());
        const std::size_t answers = bench.SdoAnswers().size();
        bench.Start();
        EXPECT_EQ(bench.SdoAnswers().size(), answers);
        bench.AwaitStore();
        // Then its client is told that it succeeded
        const std::vector<host::LiveFrame> all = bench.SdoAnswers();
        ASSERT_EQ(all.size(), answers + 1U);
        EXPECT_EQ(all.back().data[0], 0x60U);
        EXPECT_EQ(all.back().data[1], 0x10U);
        EXPECT_EQ(all.back().data[2], 0x10U);
    }
    Bench bench(Everything(), store);
    EXPECT_EQ(bench.Device().Assembly().Dictionary().ReadNumber({0x4005U, 0U}).value, 50U);
    std::remove(store.c_str());
}

// As on a full disk: its client is told, the device goes on, and what was saved before stays as it is.
TEST(NodeStoreStateTest, ASaveIntoAFileThatMayGrowNoFurtherIsAborted)
{
    Verifies(req::SRS_EASE_008);
    const std::string folder = ::testing::TempDir() + "store_limited/";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    {
        Bench bench(Everything(), folder + "store");
        EXPECT_EQ(bench.Download(0x4005U, 0U, 50U, 1U), 0U);
        bench.Store(0x1010U, kSave);
        ASSERT_EQ(bench.SdoAnswers().back().data[0], 0x60U);
        EXPECT_EQ(bench.Download(0x4005U, 0U, 60U, 1U), 0U);
        // When files may have no byte
        rlimit before{};
        ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit none{0U, before.rlim_max};
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &none), 0);
        bench.Store(0x1010U, kSave);
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
        static_cast<void>(std::signal(SIGXFSZ, handler));
        // Then the answer is 0606 0000h, an error of the hardware
        const host::LiveFrame answer = bench.SdoAnswers().back();
        EXPECT_EQ(answer.data[0], 0x80U);
        EXPECT_EQ(answer.data[1], 0x10U);
        EXPECT_EQ(answer.data[6], 0x06U);
        EXPECT_EQ(answer.data[7], 0x06U);
        bench.Start();
    }
    Bench bench(Everything(), folder + "store");
    EXPECT_EQ(bench.Device().Assembly().Dictionary().ReadNumber({0x4005U, 0U}).value, 50U);
    const std::filesystem::directory_iterator files(folder);
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
    std::filesystem::remove_all(folder);
}

TEST(NodeStoreStateTest, AnOrderSavesAndRestoresWhereAClientMay)
{
    Verifies(req::SRS_NODE_530);
    const std::string store = ::testing::TempDir() + "store_orders.store";
    std::remove(store.c_str());
    Bench bench(Everything(), store);
    bench.Start();
    for (const std::string& set : {std::string("0x1010:01 0x65766173"), std::string("0x1011:01 0x64616F6C")})
    {
        bench.Order("set " + set);
        EXPECT_FALSE(bench.Device().IsSaving()) << set;
    }
    bench.Order("set 0x4005:00 50"); // Others are taken.
    bench.Command(128U);
    bench.Order("set 0x1010:01 0x65766173");
    EXPECT_TRUE(bench.Device().IsSaving());
    bench.AwaitStore();
    const std::string told = bench.Told();
    const std::string end = " refused with 0800 0022h, expected an input or an object of the device, and a value that "
                            "it takes";
    EXPECT_NE(told.find("set: 0x1010:01 = 1702257011" + end), std::string::npos) << told;
    EXPECT_NE(told.find("set: 0x1011:01 = 1684107116" + end), std::string::npos) << told;
    EXPECT_EQ(told.find("0800 0020h"), std::string::npos) << told;
    std::remove(store.c_str());
}
} // namespace
} // namespace counterpoint::tools::test
