#pragma once

#include <any>
#include <cassert>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace raylab {

/// One way to answer a chapter's question, as a value. All methods of a question answer the same query with the same
/// result type, so charts sweep them, the stability suite tortures them, an exercise asks for one of them.
///
/// prepare() is timed and counted apart from answer(). Queries are answered in a batch, so that the indirect call is
/// paid once a batch and not once a ray; answers[i] belongs to queries[i].
template <class Data, class Query, class Result>
struct Method {
    std::string name;                                        // "Moeller-Trumbore"
    std::string number;                                      // what it computes in: "float", "double", "exact", ...
    std::string source;                                      // the paper, as a reader would look it up
    std::function<std::any(std::span<const Data>)> prepare;  // empty: nothing to prepare, the state is empty
    std::function<void(const std::any& state, std::span<const Data>, std::span<const Query>, std::span<Result>)> answer;

    /// "Moeller-Trumbore, float"
    std::string title() const { return name + ", " + number; }
};

/// One of several methods by its title; an unknown one is a broken promise (assertion).
template <class Data, class Query, class Result>
const Method<Data, Query, Result>& find_method(const std::vector<Method<Data, Query, Result>>& methods,
                                               const std::string& title) {
    for (const auto& method : methods)
        if (method.title() == title) return method;
    assert(!"a method with this title");
    std::abort();
}

/// A set of queries with a name. `data` is what methods may prepare (triangles); queries refer to it as they like.
template <class Data, class Query>
struct Workload {
    std::string name;
    std::string about;  // one sentence: what is hard about it
    std::vector<Data> data;
    std::vector<Query> queries;
};

}  // namespace raylab
