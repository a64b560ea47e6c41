// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// What std::map and std::set want from the library on a target that has none: a search tree without balance. The maps
// of the third voice have some ten elements.
#include "verification/target/target.hpp"

#include <map>

namespace std
{
namespace
{
using Node = _Rb_tree_node_base;

Node* After(Node* node) noexcept
{
    if (node->_M_right != nullptr)
    {
        return Node::_S_minimum(node->_M_right);
    }
    Node* above = node->_M_parent;
    while (node == above->_M_right)
    {
        node = above;
        above = above->_M_parent;
    }
    return (node->_M_right != above) ? above : node;
}

/// `by` takes the place of `node` below its parent.
void Replace(Node* const node, Node* const by, Node& header) noexcept
{
    Node* const above = node->_M_parent;
    if (header._M_parent == node)
    {
        header._M_parent = by;
    }
    else
    {
        ((above->_M_left == node) ? above->_M_left : above->_M_right) = by;
    }
    if (by != nullptr)
    {
        by->_M_parent = above;
    }
}
} // namespace

void __throw_out_of_range(const char* const why) // NOLINT(bugprone-reserved-identifier): the name is the library's
{
    counterpoint::target::Write("FAILURE: out of range: ");
    counterpoint::target::Write(why);
    counterpoint::target::Write("\n");
    counterpoint::target::Exit(1U);
}

Node* _Rb_tree_increment(Node* const node) noexcept
{
    return After(node);
}

const Node* _Rb_tree_increment(const Node* const node) noexcept
{
    return After(const_cast<Node*>(node));
}

Node* _Rb_tree_decrement(Node* node) noexcept
{
    // The header, which stands behind the last one, is red and the grandparent of itself; here nobody else is red.
    if ((node->_M_color == _S_red) && (node->_M_parent == nullptr || node->_M_parent->_M_parent == node))
    {
        return node->_M_right;
    }
    if (node->_M_left != nullptr)
    {
        return Node::_S_maximum(node->_M_left);
    }
    Node* above = node->_M_parent;
    while (node == above->_M_left)
    {
        node = above;
        above = above->_M_parent;
    }
    return above;
}

const Node* _Rb_tree_decrement(const Node* const node) noexcept
{
    return _Rb_tree_decrement(const_cast<Node*>(node));
}

void _Rb_tree_insert_and_rebalance(const bool is_left, Node* const node, Node* const above, Node& header) noexcept
{
    node->_M_parent = above;
    node->_M_left = nullptr;
    node->_M_right = nullptr;
    node->_M_color = _S_black;
    if (is_left)
    {
        above->_M_left = node; // Of the header: its first one, too.
        if (above == &header)
        {
            header._M_parent = node;
            header._M_right = node;
        }
        else if (above == header._M_left)
        {
            header._M_left = node;
        }
    }
    else
    {
        above->_M_right = node;
        if (above == header._M_right)
        {
            header._M_right = node;
        }
    }
}

Node* _Rb_tree_rebalance_for_erase(Node* const node, Node& header) noexcept
{
    if ((node->_M_left != nullptr) && (node->_M_right != nullptr))
    {
        // The next one has nothing on its left and takes the place of `node`.
        Node* const next = Node::_S_minimum(node->_M_right);
        if (next != node->_M_right)
        {
            Replace(next, next->_M_right, header);
            next->_M_right = node->_M_right;
            next->_M_right->_M_parent = next;
        }
        Replace(node, next, header);
        next->_M_left = node->_M_left;
        next->_M_left->_M_parent = next;
        return node;
    }
    Replace(node, (node->_M_left != nullptr) ? node->_M_left : node->_M_right, header);
    Node* const root = header._M_parent;
    header._M_left = (root != nullptr) ? Node::_S_minimum(root) : &header;
    header._M_right = (root != nullptr) ? Node::_S_maximum(root) : &header;
    return node;
}

} // namespace std
