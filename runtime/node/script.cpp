// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/node/script.hpp"

#include "runtime/yaml/map.hpp"

#include "runtime/device/names.hpp"
#include "runtime/yaml/document.hpp"
#include "runtime/yaml/value.hpp"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <system_error>

namespace counterpoint::runtime
{
namespace
{

LogicRule ReadRule(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(), {"set", "op", "from"});
    LogicRule rule;
    rule.source = value.Where();
    rule.target = map.Require("set").Object();
    rule.operation = map.Require("op").Choice(kOperationWords);
    const YamlValue from = map.Require("from");
    for (const YamlValue& input : from.Items("a list of objects"))
    {
        rule.inputs.push_back(input.Object());
    }
    const bool takes_one = rule.operation == LogicOperation::kCopy || rule.operation == LogicOperation::kNot;
    if (rule.inputs.empty() || (takes_one && rule.inputs.size() != 1U))
    {
        from.Refuse(std::to_string(rule.inputs.size()) + " objects",
                    "one with copy and not, one or more with and and or");
    }
    return rule;
}

/// The rule that sets this object; null: none does.
const LogicRule* RuleOf(const std::vector<LogicRule>& rules, const ObjectAddress& object)
{
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&object](const LogicRule& each) { return IsSame(each.target, object); });
    return rule == rules.end() ? nullptr : &*rule;
}

/// Of two who write an object the last one would win without a word. [SRS_NODE_710]
void RequireNoRule(const std::vector<LogicRule>& rules, const ObjectAddress& object, const YamlValue& writer)
{
    if (const LogicRule* const rule = RuleOf(rules, object); rule != nullptr)
    {
        writer.Refuse(ObjectText(object) + ", which the rule at " +
                          cia306::PlaceText(rule->source.file, rule->source.place) + " sets",
                      "one writer of each object");
    }
}

ScriptStep ReadStep(const std::string& file, const YamlValue& value)
{
    const YamlMap map(file, value.Node(), {"at", "do", "every"});
    ScriptStep step;
    step.at_ns = static_cast<std::uint64_t>(map.Require("at").Duration());
    const YamlValue order = map.Require("do");
    step.order = ParseOrder(order.Text("an order such as set 0x2000:01 1"));
    if (step.order.kind == OrderKind::kProblem)
    {
        order.Refuse(step.order.problem.substr(0U, step.order.problem.find(", expected ")),
                     step.order.problem.substr(step.order.problem.find(", expected ") + 11U));
    }
    if (step.order.kind == OrderKind::kNothing)
    {
        order.Refuse("no order", "an order such as set 0x2000:01 1");
    }
    if (const std::optional<YamlValue> every = map.Find("every"))
    {
        step.every_ns = static_cast<std::uint64_t>(every->Lasting());
    }
    return step;
}

/// A step behind the end of the run is never done. [SRS_NODE_712]
void RequireBeforeQuit(const std::vector<ScriptStep>& steps, const std::vector<YamlValue>& values)
{
    std::size_t quit = steps.size();
    for (std::size_t step = 0U; step < steps.size(); ++step)
    {
        const bool is_quit = steps[step].order.kind == OrderKind::kQuit;
        if (is_quit && (quit == steps.size() || steps[step].at_ns < steps[quit].at_ns))
        {
            quit = step;
        }
    }
    for (std::size_t step = 0U; step < steps.size() && quit < steps.size(); ++step)
    {
        const bool is_later = steps[step].at_ns > steps[quit].at_ns;
        if (is_later || (step > quit && steps[step].at_ns == steps[quit].at_ns))
        {
            values[step].Refuse("a step behind 'quit', which is never done", "one before it");
        }
    }
}
} // namespace

NodeScript ReadNodeScript(const std::string& file)
{
    NodeScript script;
    script.file = file;
    std::error_code error;
    if (!std::filesystem::exists(file, error) && !error)
    {
        throw YamlError(file, {}, "no such file", "a script of orders");
    }
    const YamlNode document = ParseYaml(file, ReadYamlText(file));
    const YamlMap map(script.file, document, {"title", "logic", "steps"});
    if (const std::optional<YamlValue> title = map.Find("title"))
    {
        static_cast<void>(title->Text("a title"));
    }
    if (const std::optional<YamlValue> logic = map.Find("logic"))
    {
        for (const YamlValue& rule : logic->Items("a list of rules"))
        {
            const LogicRule read = ReadRule(script.file, rule);
            RequireNoRule(script.rules, read.target, rule);
            script.rules.push_back(read);
        }
    }
    if (const std::optional<YamlValue> steps = map.Find("steps"))
    {
        const std::vector<YamlValue> values = steps->Items("a list of steps");
        for (const YamlValue& step : values)
        {
            script.steps.push_back(ReadStep(script.file, step));
            if (script.steps.back().order.kind == OrderKind::kSet)
            {
                RequireNoRule(script.rules, script.steps.back().order.object, step);
            }
        }
        RequireBeforeQuit(script.steps, values);
    }
    return script;
}
} // namespace counterpoint::runtime
