#include "raylab/radiosity/cache/radiosity_cache.h"

#include "raylab/base/error.h"
#include "raylab/base/output_place.h"
#include "raylab/base/printable.h"
#include "raylab/radiosity/cache/cache_file.h"
#include "raylab/radiosity/cache/mesh_hash.h"

#include <utility>

namespace raylab {

namespace {

// The number grows with every change of what is computed: files of before are then asked for no more.
const std::string form_factors_head = "raylab form factors 1", solution_head = "raylab solution 1";

}  // namespace

RadiosityCache::RadiosityCache(std::filesystem::path folder) : folder_(output_folder(folder).target) {}

// True if there is such a file and it was read.
bool RadiosityCache::found(const std::filesystem::path& file, const std::string& head,
                           const std::function<void(CacheReader&)>& read) {
    if (!std::filesystem::exists(file)) return false;
    try {
        read_cache_file(file, head, read);
        return true;
    } catch (const Error& error) {
        sentences_.push_back("rebuilt " + printable(file.string()) + ", which is damaged or foreign: " + error.what());
        return false;
    }
}

std::optional<ScaledFormFactors> RadiosityCache::form_factors(const std::string& key, std::size_t patches) {
    ScaledFormFactors result{FormFactors(0), {}, {}, {}, {}};
    const bool is_there = found(folder_ / ("form_factors-" + key), form_factors_head, [&](CacheReader& reader) {
        if (const auto size = reader.get_one<std::uint64_t>(); size != patches)
            throw Error("expected as many patches as the scene has, found another number");
        reader.check_left(patches * patches, sizeof(double));
        result.factors = FormFactors(patches);
        for (std::size_t i = 0; i < patches; ++i) reader.get(result.factors.row(i));
        result.scales = reader.get_list<double>();
        if (result.scales.size() != patches) throw Error("expected a scale for each patch, found another number");
        result.work = reader.get_one<FormFactorWork>();
        result.before = reader.get_one<RowSums>();
        result.after = reader.get_one<RowSums>();
    });
    return is_there ? std::optional(std::move(result)) : std::nullopt;
}

void RadiosityCache::keep(const std::string& key, const ScaledFormFactors& form_factors) {
    write_cache_file(folder_ / ("form_factors-" + key), form_factors_head, [&](CacheWriter& writer) {
        const std::size_t patches = form_factors.factors.patches();
        writer.put_one<std::uint64_t>(patches);
        for (std::size_t i = 0; i < patches; ++i) writer.put(form_factors.factors.row(i));
        writer.put_list(form_factors.scales);
        writer.put_one(form_factors.work);
        writer.put_one(form_factors.before);
        writer.put_one(form_factors.after);
    });
}

std::optional<Solution> RadiosityCache::solution(const std::string& key, std::size_t patches) {
    Solution result;
    const bool is_there = found(folder_ / ("solution-" + key), solution_head, [&](CacheReader& reader) {
        const auto name = reader.get_list<char>();
        result.solver.assign(name.begin(), name.end());
        result.radiosity = reader.get_list<Color>();
        result.unshot = reader.get_list<Color>();
        result.iterations = reader.get_one<std::int32_t>();
        result.residuals = reader.get_list<double>();
        result.residual = reader.get_one<double>();
        result.error_bound = reader.get_one<double>();
        if (result.radiosity.size() != patches)
            throw Error("expected as many patches as the scene has, found another number");
    });
    return is_there ? std::optional(std::move(result)) : std::nullopt;
}

void RadiosityCache::keep(const std::string& key, const Solution& solution) {
    write_cache_file(folder_ / ("solution-" + key), solution_head, [&](CacheWriter& writer) {
        writer.put_list(std::vector<char>(solution.solver.begin(), solution.solver.end()));
        writer.put_list(solution.radiosity);
        writer.put_list(solution.unshot);
        writer.put_one<std::int32_t>(solution.iterations);
        writer.put_list(solution.residuals);
        writer.put_one(solution.residual);
        writer.put_one(solution.error_bound);
    });
}

std::string form_factors_key(const PatchMesh& mesh, const FormFactorOptions& options, const std::string& scaling) {
    ContentHash hash;
    hash.add(form_factors_head + "\n" + options.method + "\n" + scaling + "\n");
    hash.add_value(options.rays);
    hash.add_value(options.effort);
    add_geometry(hash, mesh);
    return hash.digits();
}

std::string solution_key(const std::string& form_factors, const RadiositySystem& system, const std::string& solver,
                         const SolverOptions& options) {
    ContentHash hash;
    hash.add(solution_head + "\n" + form_factors + "\n" + solver + "\n");
    hash.add_value(options.residual);
    hash.add_value(options.iterations);
    for (std::size_t i = 0; i < system.patches(); ++i) {
        hash.add_value(system.emission[i]);
        hash.add_value(system.reflectance[i]);
    }
    return hash.digits();
}

}  // namespace raylab
