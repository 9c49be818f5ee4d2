#include "engine/collision/tree.h"

namespace engine {

int BoundsTree::newNode() {
    if (free_.empty()) {
        nodes_.emplace_back();
        return static_cast<int>(nodes_.size()) - 1;
    }
    const int node = free_.back();
    free_.pop_back();
    nodes_[node] = Node{};
    return node;
}

int BoundsTree::bestSibling(const Bounds& bounds) const {
    // Descends while pushing the new leaf into a child costs less than pairing it here.
    int node = root_;
    while (!nodes_[node].isLeaf()) {
        const double area = nodes_[node].bounds.area();
        const double enlarged = nodes_[node].bounds.with(bounds).area();
        const double pairHere = 2.0 * enlarged;
        const double inherited = 2.0 * (enlarged - area);
        double cost[2];
        for (int side = 0; side < 2; ++side) {
            const Node& child = nodes_[nodes_[node].children[side]];
            const double together = child.bounds.with(bounds).area();
            cost[side] = inherited + (child.isLeaf() ? together : together - child.bounds.area());
        }
        if (pairHere < cost[0] && pairHere < cost[1]) break;
        node = nodes_[node].children[cost[0] <= cost[1] ? 0 : 1];
    }
    return node;
}

int BoundsTree::insert(const Bounds& bounds, int body) {
    const int leaf = newNode();
    nodes_[leaf].bounds = bounds;
    nodes_[leaf].body = body;
    if (root_ < 0) {
        root_ = leaf;
        return leaf;
    }
    const int sibling = bestSibling(bounds);
    const int parent = newNode();
    const int above = nodes_[sibling].parent;
    if (above >= 0)
        nodes_[above].children[sideOf(sibling)] = parent;
    else
        root_ = parent;
    nodes_[parent].parent = above;
    nodes_[parent].children[0] = sibling;
    nodes_[parent].children[1] = leaf;
    nodes_[sibling].parent = parent;
    nodes_[leaf].parent = parent;
    refitFrom(parent);
    return leaf;
}

void BoundsTree::remove(int leaf) {
    free_.push_back(leaf);
    if (leaf == root_) {
        root_ = -1;
        return;
    }
    const int parent = nodes_[leaf].parent, above = nodes_[parent].parent;
    const int sibling = nodes_[parent].children[1 - sideOf(leaf)];
    nodes_[sibling].parent = above;
    if (above >= 0)
        nodes_[above].children[sideOf(parent)] = sibling;
    else
        root_ = sibling;
    free_.push_back(parent);
    if (above >= 0) refitFrom(above);
}

void BoundsTree::refitFrom(int node) {
    for (; node >= 0; node = nodes_[node].parent) {
        Node& n = nodes_[node];
        n.bounds = nodes_[n.children[0]].bounds.with(nodes_[n.children[1]].bounds);
        rotate(node);
    }
}

/// Swaps a child of `node` with a grandchild on the other side when that shrinks the side's bounds.
void BoundsTree::rotate(int node) {
    double bestGain = 0.0;
    int bestSide = -1, bestGrandchild = -1;
    for (int side = 0; side < 2; ++side) {
        const int stays = nodes_[node].children[side];  // one of its children moves up
        const int comes = nodes_[node].children[1 - side];
        if (nodes_[stays].isLeaf()) continue;
        const double area = nodes_[stays].bounds.area();
        for (int i = 0; i < 2; ++i) {
            const int left = nodes_[stays].children[1 - i];
            const double gain = area - nodes_[left].bounds.with(nodes_[comes].bounds).area();
            if (gain > bestGain) bestGain = gain, bestSide = side, bestGrandchild = i;
        }
    }
    if (bestSide < 0) return;
    const int stays = nodes_[node].children[bestSide];
    swapNodes(node, 1 - bestSide, stays, bestGrandchild);
    Node& n = nodes_[stays];
    n.bounds = nodes_[n.children[0]].bounds.with(nodes_[n.children[1]].bounds);
}

void BoundsTree::swapNodes(int parentA, int sideA, int parentB, int sideB) {
    const int a = nodes_[parentA].children[sideA], b = nodes_[parentB].children[sideB];
    nodes_[parentA].children[sideA] = b;
    nodes_[parentB].children[sideB] = a;
    nodes_[b].parent = parentA;
    nodes_[a].parent = parentB;
}

int BoundsTree::height() const {
    int deepest = 0;
    for (const Node& leaf : nodes_) {
        if (leaf.body < 0) continue;
        int levels = 0;
        for (int n = leaf.parent; n >= 0; n = nodes_[n].parent) ++levels;
        if (levels > deepest) deepest = levels;
    }
    return deepest;
}

bool BoundsTree::isConsistent() const {
    if (root_ < 0) return true;
    std::vector<int> open{root_};
    if (nodes_[root_].parent >= 0) return false;
    while (!open.empty()) {
        const int i = open.back();
        open.pop_back();
        const Node& node = nodes_[i];
        if (node.isLeaf()) continue;
        for (const int child : node.children) {
            if (nodes_[child].parent != i || !node.bounds.contains(nodes_[child].bounds))
                return false;
            open.push_back(child);
        }
    }
    return true;
}

}  // namespace engine
