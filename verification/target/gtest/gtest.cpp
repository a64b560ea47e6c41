// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Runs the tests of gtest.h.
#include <gtest/gtest.h>

#include "verification/target/gtest/memory.hpp"
#include "verification/target/target.hpp"

namespace
{

constexpr std::uint32_t kMostTold = 20U;

testing::Registered* first_test = nullptr;
testing::Registered* last_test = nullptr;
testing::LaterRun* first_later = nullptr;
testing::Outcome outcome{0U, 0U};

} // namespace

namespace testing
{

UnitTest* UnitTest::GetInstance()
{
    static UnitTest instance{};
    return &instance;
}

Registered::Registered(const char* const suite_name, const char* const test_name, const Maker maker, const bool joins)
    : suite{suite_name}, name{test_name}, make{maker}
{
    if (joins)
    {
        ((last_test == nullptr) ? first_test : last_test->next) = this;
        last_test = this;
    }
}

LaterRun::LaterRun(void (*const later)()) : run{later}, next{first_later}
{
    first_later = this;
}

bool Check(const bool holds, const char* const file, const int line, const char* const text)
{
    if (!holds)
    {
        ++outcome.failures;
        if (outcome.failures <= kMostTold)
        {
            using namespace counterpoint::target;
            Write("failed: ");
            Write(file);
            Write(":");
            WriteNumber(static_cast<std::uint32_t>(line));
            Write(": ");
            Write(text);
            Write("\n");
        }
    }
    return holds;
}

void RunOne(const char* const suite, const char* const name, Test* (*const make)())
{
    counterpoint::target::NameMemoryUser(suite, name);
    const std::size_t before = counterpoint::target::MarkMemory();
    Test* const test = make();
    test->SetUp();
    test->TestBody();
    test->TearDown();
    test->~Test();
    counterpoint::target::ReleaseMemory(before);
    ++outcome.tests;
}

Outcome RunAllTests()
{
    for (const Registered* test = first_test; test != nullptr; test = test->next)
    {
        RunOne(test->suite, test->name, test->make);
    }
    for (const LaterRun* later = first_later; later != nullptr; later = later->next)
    {
        later->run();
    }
    return outcome;
}

} // namespace testing
