// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/new_answers.hpp"

#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>
#include <stdexcept>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint32_t kMostNodeId = 127U;
constexpr std::uint32_t kMostIdentity = 0xFFFFFFFFU;
constexpr const char* kProduce = "--produce";
constexpr const char* kConsume = "--consume";

std::string ProblemOfRole(const std::string& text)
{
    const bool is_role = text == "producer" || text == "consumer" || text == "controller";
    return is_role ? "" : cia306::Quoted(text) + ", expected producer, consumer or controller";
}

std::string ProblemOfNodeId(const std::string& text)
{
    return ProblemOfRange(text, 1U, kMostNodeId);
}

std::string ProblemOfIdentity(const std::string& text)
{
    return ProblemOfRange(text, 0U, kMostIdentity);
}

std::string ProblemOfText(const std::string& text)
{
    constexpr std::size_t most = 60U;
    const bool is_printable = std::all_of(text.begin(), text.end(),
                                          [](const char character) { return character >= ' ' && character <= '~'; });
    const bool is_right =
        !text.empty() && text.size() <= most && is_printable && text.front() != ' ' && text.back() != ' ';
    return is_right ? "" : cia306::Quoted(text) + ", expected 1 to 60 characters of ASCII";
}

std::string ProblemOfBitRate(const std::string& text)
{
    const bool is_rate = std::any_of(cia306::kBitRates.begin(), cia306::kBitRates.end(),
                                     [&text](const std::uint16_t rate) { return text == std::to_string(rate); });
    return is_rate ? "" : cia306::Quoted(text) + ", expected 10, 20, 50, 125, 250, 500, 800 or 1000";
}

std::string ProblemOfSwitch(const std::string& text)
{
    return text == "on" || text == "off" ? "" : cia306::Quoted(text) + ", expected on or off";
}

/// A file is not there yet, so that it has no objects to name.
std::string ProblemOfNewMapping(const std::string& text)
{
    const std::string problem = ProblemOfMapping(text);
    const std::vector<cia306::PlannedPair> pairs = cia306::ParseMapping(text).pairs;
    const bool has_present = std::any_of(pairs.begin(), pairs.end(),
                                         [](const cia306::PlannedPair& pair) { return pair.normal.has_value(); });
    return problem.empty() && has_present ? cia306::Quoted(text) + " names an object, expected lengths such as 2x8"
                                          : problem;
}

std::string ProblemOfCobId(const std::string& text)
{
    return cia306::ParseCobId(text)
               ? ""
               : cia306::Quoted(text) + ", expected an odd number from 0x101 to 0x17F, or node1 to "
                                        "node64";
}

std::uint32_t NumberOf(const std::string& text)
{
    return static_cast<std::uint32_t>(cia306::ParseTyped(text, kMostIdentity).value());
}
} // namespace

void NewAnswers::Describe(Options& options)
{
    options
        .Add("--role", &role_,
             "What the device does: producer (default with --produce alone), consumer (default with --consume alone), "
             "or "
             "controller, which is both (default with both)")
        .Type("WORD")
        .Words({"producer", "consumer", "controller"})
        .Check(ProblemOfRole);
    options.Add("--node-id", &node_id_, "Node-ID, 1 to 127").Type("N").Check(ProblemOfNodeId);
    options.Add("--name", &name_, "Name of the device (default: Safety device)").Type("TEXT").Check(ProblemOfText);
    options.Add(kProduce, &produced_, "An SRDO that is sent: lengths of its objects; may be given several times")
        .Type("MAPPING")
        .OneValueEach()
        .Check(ProblemOfNewMapping);
    options.Add(kConsume, &consumed_, "An SRDO that is received: lengths of its objects; may be given several times")
        .Type("MAPPING")
        .OneValueEach()
        .Check(ProblemOfNewMapping);
    srdos_.Describe(options);
    options.Add("--gfc", &gfc_, "Global fail-safe command (1300h): on or off (default)")
        .Type("WORD")
        .Words({"on", "off"})
        .Check(ProblemOfSwitch);
    options.Add("--bit-rate", &bit_rate_, "Bit rate [kbit/s] (default: 500)")
        .Type("KBIT")
        .Words({"10", "20", "50", "125", "250", "500", "800", "1000"})
        .Check(ProblemOfBitRate);
    options.Add("--vendor-name", &vendor_name_, "Name of the vendor (default: Unknown)")
        .Type("TEXT")
        .Check(ProblemOfText);
    options.Add("--vendor-id", &vendor_id_, "Vendor-ID (default: 0)").Type("N").Check(ProblemOfIdentity);
    options.Add("--product-code", &product_code_, "Product code (default: 0)").Type("N").Check(ProblemOfIdentity);
}

void NewAnswers::Complete(Questions& questions)
{
    CompleteRole(questions);
    questions.Complete(node_id_, {"--node-id", "Node-ID, 1 to 127", "", ProblemOfNodeId});
    questions.Complete(name_, {"--name", "Name of the device", "Safety device", ProblemOfText});
    if (role_ != "consumer")
    {
        CompleteMappings(questions, kProduce, produced_);
    }
    if (role_ != "producer")
    {
        CompleteMappings(questions, kConsume, consumed_);
    }
    if (produced_.size() + consumed_.size() > cia306::kMaxSrdos)
    {
        throw std::runtime_error(std::to_string(produced_.size() + consumed_.size()) +
                                 " SRDOs by --produce and --consume, expected at most 64");
    }
    CompleteCobIds(questions);
    srdos_.Complete(questions, !produced_.empty(), !consumed_.empty());
    questions.Complete(gfc_, {"--gfc", "Global fail-safe command, on or off", "off", ProblemOfSwitch});
    questions.Complete(bit_rate_, {"--bit-rate", "Bit rate [kbit/s]", "500", ProblemOfBitRate});
    questions.Complete(vendor_name_, {"--vendor-name", "Name of the vendor", "Unknown", ProblemOfText});
    questions.Complete(vendor_id_, {"--vendor-id", "Vendor-ID", "0", ProblemOfIdentity});
    questions.Complete(product_code_, {"--product-code", "Product code", "0", ProblemOfIdentity});
}

/// The role may follow from what is sent and received; what does not fit it is refused.
void NewAnswers::CompleteRole(Questions& questions)
{
    const bool is_told = !produced_.empty() || !consumed_.empty();
    const char* const implied = consumed_.empty() ? "producer" : (produced_.empty() ? "consumer" : "controller");
    questions.Complete(role_,
                       {"--role", "producer, consumer, or controller (both)", is_told ? implied : "", ProblemOfRole});
    const bool is_wrong = (role_ == "producer" && !consumed_.empty()) || (role_ == "consumer" && !produced_.empty());
    if (is_wrong)
    {
        throw std::runtime_error((consumed_.empty() ? kProduce : kConsume) + std::string(" does not fit --role ") +
                                 role_ + ", expected --role controller");
    }
}

void NewAnswers::CompleteMappings(Questions& questions, const char* const option, std::vector<std::string>& mappings)
{
    if (!mappings.empty())
    {
        return;
    }
    const std::string what = option == std::string(kProduce) ? "sends" : "receives";
    Question question{option, "Objects of an SRDO that it " + what + ", such as 2x8 or Speed=i16,8", "",
                      ProblemOfNewMapping};
    mappings.push_back(questions.Ask(question));
    question.text = "Objects of one more that it " + what + ", Enter for none";
    question.is_needed = false;
    while (questions.IsAsking())
    {
        const std::string mapping = questions.Ask(question);
        if (mapping.empty())
        {
            return;
        }
        mappings.push_back(mapping);
    }
}

/// Where nobody is asked, a COB-ID that is missing is told when the SRDO is planned.
void NewAnswers::CompleteCobIds(Questions& questions)
{
    std::uint8_t number = 0U;
    for (std::vector<std::string>* const mappings : {&produced_, &consumed_})
    {
        const bool is_producer = mappings == &produced_;
        for (std::string& mapping : *mappings)
        {
            ++number;
            const bool has_one = CobIdOf(cia306::ParseMapping(mapping), number, is_producer, NodeId()).has_value();
            if (questions.IsAsking() && !has_one)
            {
                const std::string text = "COB-ID of the normal data of SRDO " + std::to_string(number) + " (" +
                                         mapping + "), odd, 0x101 to 0x17F; nodeN: what node N sends by default";
                mapping += "@" + questions.Ask({is_producer ? kProduce : kConsume, text, "", ProblemOfCobId});
            }
        }
    }
}

std::uint8_t NewAnswers::NodeId() const
{
    return static_cast<std::uint8_t>(NumberOf(node_id_));
}

cia306::DevicePlan NewAnswers::Plan() const
{
    cia306::DevicePlan plan;
    plan.node_id = NodeId();
    plan.name = name_;
    plan.vendor_name = vendor_name_;
    plan.vendor_id = NumberOf(vendor_id_);
    plan.product_code = NumberOf(product_code_);
    plan.bit_rate_kbit = static_cast<std::uint16_t>(NumberOf(bit_rate_));
    plan.is_gfc_on = gfc_ == "on";
    std::uint8_t number = 0U;
    for (const std::vector<std::string>* const mappings : {&produced_, &consumed_})
    {
        for (const std::string& mapping : *mappings)
        {
            ++number;
            plan.srdos.push_back(srdos_.PlanOf(number, mappings == &produced_, mapping, plan.node_id));
        }
    }
    return plan;
}
} // namespace counterpoint::tools
