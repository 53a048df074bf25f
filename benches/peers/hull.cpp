// The convex hull by CGAL: hull epick|epeck FILE DECIMALS_X DECIMALS_Y RUNS prints one line of JSON with medians in
// seconds. The kernels have exact predicates; epeck has exact constructions too. FILE has the columns x and y; the
// numbers are made integers by their decimals, so that a double holds each exactly.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/version.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>
#include <vector>

struct Columns {
    std::vector<double> x, y;
};

static Columns read_columns(const char* file, double scale_x, double scale_y) {
    std::FILE* input = std::fopen(file, "r");
    if (!input) {
        std::perror(file);
        std::exit(1);
    }
    Columns columns;
    char line[256];
    bool header = true;
    while (std::fgets(line, sizeof line, input)) {
        if (!header) {
            char* rest = nullptr;
            columns.x.push_back(std::round(std::strtod(line, &rest) * scale_x));
            columns.y.push_back(std::round(std::strtod(rest + 1, nullptr) * scale_y));
        }
        header = false;
    }
    std::fclose(input);
    return columns;
}

static double processor_seconds() {
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

template <class Kernel>
static size_t corners(const Columns& columns) {
    using Point = typename Kernel::Point_2;
    std::vector<Point> points, hull;
    points.reserve(columns.x.size());
    for (size_t i = 0; i < columns.x.size(); ++i) points.emplace_back(columns.x[i], columns.y[i]);
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    return hull.size();
}

template <class Kernel>
static void measure(const Columns& columns, int runs) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
    const auto start = Clock::now();
    size_t found = corners<Kernel>(columns);
    // Work that is shorter than 5 ms is repeated within one run: clocks are coarse.
    const int repetitions = 1 + static_cast<int>(0.005 / seconds(Clock::now() - start));
    std::vector<double> walls, processors;
    for (int run = 0; run < runs; ++run) {
        const auto wall = Clock::now();
        const double processor = processor_seconds();
        for (int k = 0; k < repetitions; ++k) found = corners<Kernel>(columns);
        walls.push_back(seconds(Clock::now() - wall) / repetitions);
        processors.push_back((processor_seconds() - processor) / repetitions);
    }
    std::printf("{\"wall\": %.9g, \"cpu\": %.9g, \"runs\": %d, \"corners\": %zu, \"versions\": [\"CGAL %s\"]}\n",
                median(walls), median(processors), runs, found, CGAL_VERSION_STR);
}

int main(int count, char** arguments) {
    if (count != 6) {
        std::fprintf(stderr, "usage: hull epick|epeck FILE DECIMALS_X DECIMALS_Y RUNS\n");
        return 2;
    }
    const double scale_x = std::pow(10.0, std::atoi(arguments[3]));
    const double scale_y = std::pow(10.0, std::atoi(arguments[4]));
    const Columns columns = read_columns(arguments[2], scale_x, scale_y);
    const int runs = std::max(1, std::atoi(arguments[5]));
    if (std::strcmp(arguments[1], "epeck") == 0) {
        measure<CGAL::Exact_predicates_exact_constructions_kernel>(columns, runs);
    } else {
        measure<CGAL::Exact_predicates_inexact_constructions_kernel>(columns, runs);
    }
}
