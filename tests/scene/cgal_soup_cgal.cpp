#include "scene/cgal_soup.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

std::optional<Soup> read_with_cgal(const std::filesystem::path& file) {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    Soup soup;
    if (!CGAL::IO::read_polygon_soup(file.string(), points, soup.polygons)) return std::nullopt;
    for (const auto& p : points)
        soup.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    return soup;
}
