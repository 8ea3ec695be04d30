#pragma once

#include "raylab/tracer/whitted/whitted.h"

// An observer is told of every ray that is traced. The tracer is a template on it: NoObserver's empty functions vanish.
// Node is what an observer calls a ray of its own; the tracer hands it back as parent of the next ones.

namespace raylab {

/// A ray about to be cast.
struct CastRay {
    RayKind kind;
    int depth;
    double throughput;
};

struct NoObserver {
    struct Node {};

    Node cast(const CastRay&, Node, const Ray&) { return {}; }
    void missed(Node, const Color&) {}
    void hit_found(Node, const SurfacePoint&, double) {}
    void shaded(Node, const Color&, Ending) {}
    void cut(const CastRay&, Node, Ending) {}
    Node shadow_ray_cast(Node, std::size_t, const Ray&, Ending, const Color&) { return {}; }
    void chosen(Node, double, const Color&) {}
};

/// Counts rays; a node is its kind.
struct CountingObserver {
    using Node = RayKind;
    RayCounts& counts;

    CastAndHit& of(RayKind kind) { return kind == RayKind::eye ? counts.primary : counts.secondary; }

    Node cast(const CastRay& ray, Node, const Ray&) {
        ++of(ray.kind).cast;
        return ray.kind;
    }
    void missed(Node, const Color&) {}
    void hit_found(Node node, const SurfacePoint&, double) { ++of(node).hit; }
    void shaded(Node, const Color&, Ending) {}
    void cut(const CastRay&, Node, Ending) {}
    Node shadow_ray_cast(Node, std::size_t, const Ray&, Ending ended, const Color&) {
        ++counts.shadow.cast;
        if (ended == Ending::blocked) ++counts.shadow.hit;
        return RayKind::shadow;
    }
    void chosen(Node, double, const Color&) {}
};

/// Keeps every ray as a node of the tree.
struct RecordingObserver {
    using Node = std::size_t;
    RayTree& tree;

    Node cast(const CastRay& cast, Node parent, const Ray& ray) {
        const bool is_root = tree.nodes.empty();
        tree.nodes.push_back({.kind = cast.kind,
                              .parent = is_root ? RayNode::none : parent,
                              .depth = cast.depth,
                              .throughput = cast.throughput,
                              .ray = ray});
        return tree.nodes.size() - 1;
    }
    void missed(Node node, const Color& background) { end(node, background, Ending::missed); }
    void hit_found(Node node, const SurfacePoint& at, double t) {
        RayNode& n = tree.nodes[node];
        n.object = at.object->path;
        n.t = t;
        n.point = at.position;
        n.normal = at.normal;
    }
    void shaded(Node node, const Color& local, Ending ended) { end(node, local, ended); }
    void cut(const CastRay& cast, Node parent, Ending ended) {
        tree.nodes.push_back(
            {.kind = cast.kind, .ended = ended, .parent = parent, .depth = cast.depth, .throughput = cast.throughput});
    }
    Node shadow_ray_cast(Node node, std::size_t light, const Ray& ray, Ending ended, const Color& brought) {
        const RayNode& from = tree.nodes[node];
        tree.nodes.push_back({.kind = RayKind::shadow,
                              .ended = ended,
                              .parent = node,
                              .light = light,
                              .depth = from.depth + 1,
                              .throughput = from.throughput,
                              .ray = ray,
                              .local = brought,
                              .contribution = from.throughput * brought});
        return tree.nodes.size() - 1;
    }
    /// What is known of a ray of a path: the density of its direction, and what it adds with the throughput of each
    /// channel.
    void chosen(Node node, double density, const Color& contribution) {
        tree.nodes[node].density = density;
        tree.nodes[node].contribution = contribution;
    }

private:
    void end(Node node, const Color& local, Ending ended) {
        RayNode& n = tree.nodes[node];
        n.local = local;
        n.contribution = n.throughput * local;
        n.ended = ended;
    }
};

}  // namespace raylab
