// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The objects of a manager one by one: what has no room, what has no data, writes that wait while the manager loses its
// role.
#include "runtime/manager/objects.hpp"
#include "tests/runtime/manager/rig.hpp"
#include "verification/trace/ids/manager.hpp"
#include "verification/trace/verifies.hpp"

#include <array>

namespace counterpoint::tools
{
namespace
{
using cia301::SdoAbort;

class ManagerObjectsTest : public test::ManagerRig
{
  protected:
    /// What the objects themselves answer where the reader has so many bytes of room.
    cia301::Reading ReadInto(const std::size_t size_bytes, const ObjectAddress& object)
    {
        runtime::ManagerObjects objects(station->Assembly(), *net);
        room_.assign(size_bytes, 0U);
        return objects.OnRead(object, cia301::Room{room_.data(), static_cast<std::uint32_t>(size_bytes)});
    }

  private:
    std::vector<std::uint8_t> room_;
};

TEST_F(ManagerObjectsTest, WhatDoesNotFitIsNotGiven)
{
    Verifies(req::SRS_MGR_020);
    Verifies(req::SRS_MGR_151);
    Make("manager: {node: 127, heartbeat: 100 ms}\nslaves: [{node: 33, dcf: actuator.dcf, consumer: 300 ms}]\n");
    EXPECT_EQ(ReadInto(2U, {0x1017U, 0U}).abort, SdoAbort::kNone);
    EXPECT_EQ(ReadInto(1U, {0x1017U, 0U}).abort, SdoAbort::kOutOfMemory);
    EXPECT_EQ(ReadInto(4U, {0x1016U, 1U}).abort, SdoAbort::kNone);
    EXPECT_EQ(ReadInto(3U, {0x1016U, 1U}).abort, SdoAbort::kOutOfMemory);
    const std::size_t length = cia306::test::ExampleText("actuator").size();
    EXPECT_EQ(ReadInto(length, {0x1F20U, 33U}).abort, SdoAbort::kNone);
    EXPECT_EQ(ReadInto(length, {0x1F20U, 33U}).size_bytes, length);
    EXPECT_EQ(ReadInto(length - 1U, {0x1F20U, 33U}).abort, SdoAbort::kOutOfMemory);
    const std::size_t concise = net->Find(33U)->concise.size();
    EXPECT_EQ(ReadInto(concise, {0x1F22U, 33U}).abort, SdoAbort::kNone);
    EXPECT_EQ(ReadInto(concise - 1U, {0x1F22U, 33U}).abort, SdoAbort::kOutOfMemory);
    // Of a node that is none there is nothing
    EXPECT_EQ(ReadInto(8U, {0x1F20U, 99U}).abort, SdoAbort::kNoData);
    EXPECT_EQ(ReadInto(8U, {0x1F58U, 33U}).abort, SdoAbort::kNoData);
}

TEST_F(ManagerObjectsTest, WithoutAFlyingMasterItsTimesAreNotWritten)
{
    Verifies(req::SRS_MGR_219);
    Make("manager: {node: 127}\nslaves: [{node: 5}]\n");
    runtime::ManagerObjects objects(station->Assembly(), *net);
    const std::array<std::uint8_t, 2U> value{1U, 0U};
    EXPECT_EQ(objects.OnWrite({0x1F90U, 2U}, {value.data(), 2U}), SdoAbort::kDeviceState);
}

TEST_F(ManagerObjectsTest, TimesOfTheManagerMayChangeWhileItRuns)
{
    Verifies(req::SRS_MGR_021);
    Make("manager: {node: 127}\nslaves: [{node: 5, boot: false}]\n");
    EndStartUp();
    EXPECT_EQ(Write(0x102AU, 0U, 20U, 2U), 0U);
    EXPECT_EQ(Read(0x102AU, 0U), 20U);
    EXPECT_EQ(Write(0x1F89U, 0U, 3000U, 4U), 0U);
    EXPECT_EQ(Read(0x1F89U, 0U), 3000U);
    EXPECT_EQ(Order("set 0x1F20:05 1"),
              "no number 0x1F20:05 (node 5) that can be written, expected one of the manager");
    EXPECT_EQ(Order("set 0x1018:01 1"), "no number 0x1018:01 that can be written, expected one of the manager");
    EXPECT_EQ(Order("set 0x6000:01 1"), "no number 0x6000:01 that can be written, expected one of the manager");
}

TEST_F(ManagerObjectsTest, ADomainIsToldByItsLength)
{
    Verifies(req::SRS_MGR_006);
    Make("manager: {node: 127}\nslaves: [{node: 33, dcf: actuator.dcf}, {node: 5, boot: false}]\n");
    Run(2U);
    EXPECT_EQ(Order("get 0x1F20:21"),
              "0x1F20:21 (node 33) = " + std::to_string(cia306::test::ExampleText("actuator").size()) + " bytes");
    EXPECT_EQ(Order("get 0x1F20:05"),
              "0x1F20:05 (node 5): 0x08000024 (no data), expected an object that can be read now");
    // While a client reads one, there is no room for another one; numbers are read
    EXPECT_FALSE(Ask({0x40U, 0x20U, 0x1FU, 33U, 0U, 0U, 0U, 0U}).empty());
    EXPECT_EQ(Order("get 0x1F20:21").rfind("0x1F20:21 (node 33): 0x08000022", 0U), 0U) << Order("get 0x1F20:21");
    EXPECT_EQ(Order("get 0x1F80:00"), "0x1F80:00 = 1 (0x1)");
}

TEST_F(ManagerObjectsTest, ACommandThatWaitsIsNoneOfAManagerThatLeadsNoMore)
{
    Verifies(req::SRS_MGR_213);
    Make("manager: {node: 127, heartbeat: 200 ms, inhibit: 1 s, flying: {priority: 2}}\n"
         "slaves: [{node: 5, boot: false, mandatory: false}, {node: 6, boot: false, mandatory: false}]\n");
    Run(30000U);
    ASSERT_TRUE(station->Assembly().Core().IsActive());
    // Given a queue that is full of commands, and one of a client that waits for it
    int taken = 0;
    std::uint8_t command = 127U;
    while (!Ask({0x2FU, 0x82U, 0x1FU, 5U, command, 0U, 0U, 0U}).empty())
    {
        command = (command == 127U) ? 4U : 127U;
        ASSERT_LT(++taken, 400);
    }
    // When a better master leads, then the client is told
    sent.clear();
    Hear(0x071U, {0U, 6U});
    Run(5U);
    ASSERT_FALSE(station->Assembly().Core().IsActive());
    const auto answer = std::find_if(sent.begin(), sent.end(),
                                     [](const CanFrame& frame) { return frame.identifier == test::kAnswers; });
    ASSERT_NE(answer, sent.end());
    EXPECT_EQ(answer->data[0], 0x80U);
    EXPECT_EQ(NumberIn({&answer->data[0], &answer->data[0] + 8U}), 0x08000022U);
}
} // namespace
} // namespace counterpoint::tools
