// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/live/socketcand/message.hpp"

#include "verification/trace/ids/live_bus.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace counterpoint::host
{
namespace
{

// Given the examples of the protocol's text and what other programs write, then each is read as what it says.
TEST(SocketcandText, ReadsTheProtocol)
{
    Verifies(req::SRS_LIVE_050);
    EXPECT_EQ(ReadSocketcand("< hi >").word, SocketcandWord::kHi);
    EXPECT_EQ(ReadSocketcand("<rawmode>").word, SocketcandWord::kRawMode);
    EXPECT_EQ(ReadSocketcand("< open can0 >").text, "can0");
    const SocketcandMessage none = ReadSocketcand("< send 123 0  >");
    EXPECT_EQ(none.word, SocketcandWord::kSend);
    EXPECT_EQ(none.frame.identifier, 0x123U);
    EXPECT_EQ(none.frame.length_bytes, 0U);
    const SocketcandMessage wide = ReadSocketcand("< send 1AAAAAAA 2 1 F1 >");
    EXPECT_TRUE(wide.frame.extended);
    EXPECT_EQ(wide.frame.identifier, 0x1AAA'AAAAU);
    EXPECT_EQ(wide.frame.data[0], 0x01U);
    EXPECT_EQ(wide.frame.data[1], 0xF1U);
    const SocketcandMessage remote = ReadSocketcand("< sendrtr 00000123 8 >");
    EXPECT_TRUE(remote.frame.remote && remote.frame.extended);
    EXPECT_EQ(remote.frame.length_bytes, 8U);
    const SocketcandMessage spaced = ReadSocketcand("< frame 123 23.424242 11 22 33 44 >");
    EXPECT_EQ(spaced.stamp_us, 23'424'242U);
    EXPECT_EQ(spaced.frame.length_bytes, 4U);
    EXPECT_EQ(spaced.frame.data[3], 0x44U);
    const SocketcandMessage packed = ReadSocketcand("< frame 7FF 1700000000.5 1122334455667788 >");
    EXPECT_EQ(packed.stamp_us, 1'700'000'000'500'000U);
    EXPECT_EQ(packed.frame.length_bytes, 8U);
    EXPECT_EQ(packed.frame.data[7], 0x88U);
    EXPECT_EQ(ReadSocketcand("< rtr 123 23.424242 4 >").frame.length_bytes, 4U);
    const SocketcandMessage error = ReadSocketcand("< error 040 23.424242 >");
    EXPECT_EQ(error.word, SocketcandWord::kErrorFrame);
    EXPECT_TRUE(error.frame.error);
    EXPECT_EQ(error.frame.identifier, 0x40U);
    const SocketcandMessage single = ReadSocketcand("< frame 123 1.0 1 A 22 >");
    EXPECT_EQ(single.frame.length_bytes, 3U);
    EXPECT_EQ(single.frame.data[1], 0x0AU);
    // Classes beyond those that there are: words
    EXPECT_EQ(ReadSocketcand("< error 20000000 1.0 >").text, "20000000 1.0");
    EXPECT_EQ(ReadSocketcand("< error unknown command >").text, "unknown command");
    EXPECT_TRUE(ReadSocketcand("< own 123 1.000000 AB >").frame.own);
    EXPECT_TRUE(ReadSocketcand("< ownrtr 123 1.000000 1 >").frame.remote);
}

// Given malformed elements, then each is answered by what was wrong and what was expected.
TEST(SocketcandText, SaysWhatIsWrong)
{
    Verifies(req::SRS_LIVE_050);
    const std::string identifier = "', expected 1 to 3 hexadecimal digits up to 7FF, or 8 up to 1FFFFFFF";
    const std::string known = "', expected open, rawmode, bcmmode, ownmode, send, sendrtr or echo";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"",
         "element without brackets or of more than 256 characters, expected a word and its values in angle brackets"},
        {"< hi",
         "element without brackets or of more than 256 characters, expected a word and its values in angle brackets"},
        {"< a < b >", "bracket within an element, expected the end of the element before"},
        {"< >", "empty element, expected a word"},
        {"< SEND 1 0 >", "unknown command 'SEND" + known},
        {"< a\x01\x80 >", "unknown command 'a??" + known},
        {"x hi >",
         "element without brackets or of more than 256 characters, expected a word and its values in angle brackets"},
        {"<" + std::string(256U, 'x') + ">",
         "element without brackets or of more than 256 characters, expected a word and its values in angle brackets"},
        {"< a\x7F >", "unknown command 'a?" + known},
        {"< frame 123 1.x 11 >", "frame: time '1.x', expected SECONDS.MICROSECONDS"},
        {"< hi there >", "hi: count of values '1', expected 0"},
        {"< open >", "open: count of values '0', expected 1"},
        {"< open a_name_of_17_char >", "open: bus 'a_name_of_17_char', expected a name of at most 16 characters"},
        {"< send 123 >", "send: count of values '1', expected 2 to 10"},
        {"< send 123 9 >", "send: length '9', expected 0 to 8"},
        {"< send 123 -1 >", "send: length '-1', expected 0 to 8"},
        {"< send 123 2 11 >", "send: count of data bytes '1', expected 2 as the length says"},
        {"< send 123 1 11 22 >", "send: count of data bytes '2', expected 1 as the length says"},
        {"< send 123 1 111 >", "send: data byte '111', expected 1 or 2 hexadecimal digits"},
        {"< send 123 1 0x >", "send: data byte '0x', expected 1 or 2 hexadecimal digits"},
        {"< send 800 0 >", "send: identifier '800" + identifier},
        {"< send 0123 0 >", "send: identifier '0123" + identifier},
        {"< send 20000000 0 >", "send: identifier '20000000" + identifier},
        {"< send 12G 0 >", "send: identifier '12G" + identifier},
        {"< send 123456789 0 >", "send: identifier '123456789" + identifier},
        {"< sendrtr 123 1 11 >", "sendrtr: count of values '3', expected 2"},
        {"< frame 123 23 11 >", "frame: time '23', expected SECONDS.MICROSECONDS"},
        {"< frame 123 23.1234567 11 >", "frame: time '23.1234567', expected SECONDS.MICROSECONDS"},
        {"< frame 123 .5 11 >", "frame: time '.5', expected SECONDS.MICROSECONDS"},
        {"< frame 123 99999999999999999999.0 11 >",
         "frame: time '99999999999999999999.0', expected SECONDS.MICROSECONDS"},
        {"< frame 123 18446744073709.0 11 >", "frame: time '18446744073709.0', expected SECONDS.MICROSECONDS"},
        {"<error " + std::string(247U, 'x') + ">",
         "error: text '" + std::string(32U, 'x') + "', expected at most 246 characters"},
        {"< frame 123 1.0 112 >", "frame: data '112', expected 0 to 8 bytes of 2 hexadecimal digits"},
        {"< frame 123 1.0 112233445566778899 >",
         "frame: data '112233445566778899', expected 0 to 8 bytes of 2 hexadecimal digits"},
        {"< frame 123 1.0 1G >", "frame: data byte '1G', expected 1 or 2 hexadecimal digits"},
        {"< rtr 123 1.0 9 >", "rtr: length '9', expected 0 to 8"},
    };
    for (const auto& [element, problem] : cases)
    {
        const SocketcandMessage message = ReadSocketcand(element);
        EXPECT_EQ(message.problem, problem) << element;
        EXPECT_EQ(message.word, SocketcandWord::kInvalid) << element;
    }
}

// Given messages of every word, then what is written is what the protocol says, and is read as the same.
TEST(SocketcandText, WritesWhatItReads)
{
    Verifies(req::SRS_LIVE_050);
    const std::string longest = "< error " + std::string(246U, 'x') + " >";
    EXPECT_EQ(WriteSocketcand(ReadSocketcand("<error " + std::string(246U, 'x') + ">")), longest);
    EXPECT_EQ(WriteSocketcand(ReadSocketcand("< frame 123 18446744073708.999999 11 >")),
              "< frame 123 18446744073708.999999 11 >");
    for (const std::string text :
         {"< hi >", "< ok >", "< echo >", "< open can0 >", "< rawmode >", "< bcmmode >", "< ownmode >",
          "< send 123 0  >", "< send 00000123 3 01 0A FF >", "< sendrtr 7FF 8 >", "< frame 123 23.424242  >",
          "< frame 1FFFFFFF 23.000001 1122334455667788 >", "< rtr 001 0.000000 4 >", "< own 181 5.100000 01 >",
          "< ownrtr 181 5.000000 1 >", "< error 1FFFFFFF 23.424242 >", "< error 004 23.424242 >",
          "< error send: bus-off >"})
    {
        EXPECT_EQ(WriteSocketcand(ReadSocketcand(text)), text);
    }
}

std::vector<std::string> AllOf(SocketcandStream& stream)
{
    std::vector<std::string> texts;
    while (const std::optional<SocketcandMessage> message = stream.Next())
    {
        texts.push_back(message->problem.empty() ? WriteSocketcand(*message) : message->problem);
    }
    return texts;
}

// Given a stream of elements cut at every place, then the same elements come out.
TEST(SocketcandStreamTest, IsCutAnywhere)
{
    Verifies(req::SRS_LIVE_050);
    const std::string all = "< hi >< ok >\r\n  < frame 123 1.5 11 >x< echo ><<bad>< ok >";
    SocketcandStream whole;
    whole.Feed(all.data(), all.size());
    const std::vector<std::string> expected{"< hi >",
                                            "< ok >",
                                            "< frame 123 1.500000 11 >",
                                            "'x' outside of angle brackets, expected an element",
                                            "< echo >",
                                            "bracket within an element, expected the end of the element before",
                                            "< ok >"};
    EXPECT_EQ(AllOf(whole), expected);
    for (std::size_t cut = 0U; cut <= all.size(); ++cut)
    {
        SocketcandStream stream;
        stream.Feed(all.data(), cut);
        std::vector<std::string> texts = AllOf(stream);
        stream.Feed(all.data() + cut, all.size() - cut);
        const std::vector<std::string> rest = AllOf(stream);
        texts.insert(texts.end(), rest.begin(), rest.end());
        EXPECT_EQ(texts, expected) << cut;
    }
}

TEST(SocketcandStreamTest, ShowsWhatIsOutsideWithoutBrackets)
{
    Verifies(req::SRS_LIVE_050);
    SocketcandStream stream;
    stream.Feed("x>y< ok >", 9U);
    EXPECT_EQ(AllOf(stream),
              (std::vector<std::string>{"'x?y' outside of angle brackets, expected an element", "< ok >"}));
}

// Given an element without an end, then it is refused once when it is too long, and the next element is read.
TEST(SocketcandStreamTest, SkipsWhatIsTooLong)
{
    Verifies(req::SRS_LIVE_050);
    SocketcandStream stream;
    const std::string start = "< send " + std::string(300U, '1');
    stream.Feed(start.data(), start.size());
    EXPECT_EQ(AllOf(stream),
              std::vector<std::string>{"element without an end in 256 characters, expected a closing bracket"});
    stream.Feed(start.data() + 10U, 200U);
    EXPECT_TRUE(AllOf(stream).empty());
    stream.Feed("111 >< ok >", 11U);
    EXPECT_EQ(AllOf(stream), std::vector<std::string>{"< ok >"});
}

} // namespace
} // namespace counterpoint::host
