// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// As much of GoogleTest's face as the tests of the safety rooms use, so that their very sources run on a target without
// an operating system. What fails is printed with file and line; RunAllTests says how many ran and failed.
#ifndef VERIFICATION_TARGET_GTEST_GTEST_GTEST_H
#define VERIFICATION_TARGET_GTEST_GTEST_GTEST_H

#include <cstdint>
#include <ios>
#include <string>
#include <vector>

namespace testing
{

class TestResult
{
  public:
    int test_property_count() const
    {
        return count_;
    }
    void Count()
    {
        ++count_;
    }

  private:
    int count_{0};
};

class TestInfo
{
  public:
    TestResult* result() const
    {
        return &result_;
    }

  private:
    mutable TestResult result_{};
};

class UnitTest
{
  public:
    static UnitTest* GetInstance();
    const TestInfo* current_test_info() const
    {
        return &info_;
    }

  private:
    TestInfo info_{};
};

class Test
{
  public:
    virtual ~Test() = default;
    virtual void TestBody() = 0;

    static void RecordProperty(const std::string& /*key*/, const char* /*value*/)
    {
        UnitTest::GetInstance()->current_test_info()->result()->Count();
    }

  protected:
    virtual void SetUp()
    {
    }
    virtual void TearDown()
    {
    }

  private:
    friend void RunOne(const char* suite, const char* name, Test* (*make)());
};

using Maker = Test* (*)();

/// One test in the chain of all.
struct Registered
{
    /// Joins the chain of all tests unless the test waits for its parameters.
    Registered(const char* suite_name, const char* test_name, Maker maker, bool joins = true);

    const char* suite;
    const char* name;
    Maker make;
    Registered* next{nullptr};
};

/// Takes whatever is streamed behind an expectation and forgets it: file and line were printed.
struct Sink
{
    template <class Value> const Sink& operator<<(const Value& /*value*/) const
    {
        return *this;
    }
    const Sink& operator<<(std::ios_base& (*/*manipulator*/)(std::ios_base&)) const
    {
        return *this;
    }
};

struct Return
{
    void operator=(const Sink& /*sink*/) const
    {
    }
};

/// @brief Tells and counts a failure; gives back what it was given.
bool Check(bool holds, const char* file, int line, const char* text);

template <class Parameter> struct TestParamInfo
{
    Parameter param;
};

template <class Parameter> class WithParamInterface
{
  public:
    static const Parameter& GetParam()
    {
        return *parameter_;
    }
    static void SetParam(const Parameter* parameter)
    {
        parameter_ = parameter;
    }
    using ParamType = Parameter;

  private:
    static inline const Parameter* parameter_{nullptr};
};

template <class Parameter> class TestWithParam : public Test, public WithParamInterface<Parameter>
{
};

/// Tests of a fixture with parameters, and the parameters: run together, when all are known.
template <class Fixture> struct Parameterised
{
    static inline std::vector<Registered*> tests{};
    static inline std::vector<typename Fixture::ParamType> parameters{};
};

template <class... Value> struct ValueList
{
    std::vector<std::common_type_t<Value...>> values;
};

template <class... Value> ValueList<Value...> Values(Value... value)
{
    return {{value...}};
}

/// Creates, runs and forgets a test.
void RunOne(const char* suite, const char* name, Maker make);

template <class Fixture> struct ParameterRun
{
    using Run = void (*)();

    static void All()
    {
        for (const auto& parameter : Parameterised<Fixture>::parameters)
        {
            Fixture::SetParam(&parameter);
            for (const Registered* test : Parameterised<Fixture>::tests)
            {
                RunOne(test->suite, test->name, test->make);
            }
        }
    }
};

/// Runs that wait for RunAllTests.
struct LaterRun
{
    explicit LaterRun(void (*later)());

    void (*run)();
    LaterRun* next{nullptr};
};

template <class Fixture> struct ParameterisedTest
{
    ParameterisedTest(const char* suite, const char* name, Maker make)
    {
        Parameterised<Fixture>::tests.push_back(new Registered{suite, name, make, false});
    }
};

template <class Fixture> struct Instantiated
{
    template <class List, class... Namer> explicit Instantiated(const List& list, const Namer&... /*namer*/) : later{&ParameterRun<Fixture>::All}
    {
        for (const auto& value : list.values)
        {
            Parameterised<Fixture>::parameters.push_back(value);
        }
    }

    LaterRun later;
};

struct Outcome
{
    std::uint32_t tests;
    std::uint32_t failures;
};

Outcome RunAllTests();

} // namespace testing

#define GTEST_CLASS_(suite, name, parent)                                                                                   \
    class suite##_##name final : public parent                                                                              \
    {                                                                                                                       \
      public:                                                                                                               \
        void TestBody() override;                                                                                           \
        static ::testing::Test* Make()                                                                                      \
        {                                                                                                                   \
            return new suite##_##name();                                                                                    \
        }                                                                                                                   \
    };

#define TEST_OF_(suite, name, parent)                                                                                       \
    GTEST_CLASS_(suite, name, parent)                                                                                       \
    static ::testing::Registered suite##_##name##_registered{#suite, #name, &suite##_##name::Make};                         \
    void suite##_##name::TestBody()

#define TEST(suite, name) TEST_OF_(suite, name, ::testing::Test)
#define TEST_F(fixture, name) TEST_OF_(fixture, name, fixture)
#define TEST_P(fixture, name)                                                                                               \
    GTEST_CLASS_(fixture, name, fixture)                                                                                    \
    static ::testing::ParameterisedTest<fixture> fixture##_##name##_registered{#fixture, #name, &fixture##_##name::Make};   \
    void fixture##_##name::TestBody()
#define INSTANTIATE_TEST_SUITE_P(prefix, fixture, ...)                                                                      \
    static ::testing::Instantiated<fixture> prefix##_##fixture##_instantiated{__VA_ARGS__}

#define GTEST_EXPECT_(condition)                                                                                            \
    switch (0)                                                                                                              \
    case 0:                                                                                                                 \
    default:                                                                                                                \
        if (::testing::Check((condition), __FILE__, __LINE__, #condition))                                                  \
            ;                                                                                                               \
        else                                                                                                                \
            ::testing::Sink {}
#define GTEST_ASSERT_(condition)                                                                                            \
    switch (0)                                                                                                              \
    case 0:                                                                                                                 \
    default:                                                                                                                \
        if (::testing::Check((condition), __FILE__, __LINE__, #condition))                                                  \
            ;                                                                                                               \
        else                                                                                                                \
            return ::testing::Return{} = ::testing::Sink {}

#define EXPECT_TRUE(a) GTEST_EXPECT_(static_cast<bool>(a))
#define EXPECT_FALSE(a) GTEST_EXPECT_(!static_cast<bool>(a))
#define EXPECT_EQ(a, b) GTEST_EXPECT_((a) == (b))
#define EXPECT_NE(a, b) GTEST_EXPECT_((a) != (b))
#define EXPECT_LE(a, b) GTEST_EXPECT_((a) <= (b))
#define EXPECT_LT(a, b) GTEST_EXPECT_((a) < (b))
#define EXPECT_GE(a, b) GTEST_EXPECT_((a) >= (b))
#define EXPECT_GT(a, b) GTEST_EXPECT_((a) > (b))
#define ASSERT_TRUE(a) GTEST_ASSERT_(static_cast<bool>(a))
#define ASSERT_FALSE(a) GTEST_ASSERT_(!static_cast<bool>(a))
#define ASSERT_EQ(a, b) GTEST_ASSERT_((a) == (b))
#define ASSERT_NE(a, b) GTEST_ASSERT_((a) != (b))
#define ASSERT_GE(a, b) GTEST_ASSERT_((a) >= (b))

#endif
