#include "core/footage/steady_rate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"
#include "core/media/input.h"

namespace vvr::footage {

namespace {

constexpr std::size_t fewest = 4;  // files; fewer may be alike by chance

/// A file and the time until the next one begins.
struct Paced {
    const Segment* segment = nullptr;
    double pace = 0;  ///< seconds
};

/// The files after which the next begins as soon as usual. Empty if this is not the rule, as in clips of motion.
std::vector<Paced> paced_files(const std::vector<Segment>& segments) {
    constexpr double near = 0.1;  // of the usual
    std::vector<Paced> paced;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        if (!segments[i].begin || !segments[i + 1].begin) return {};
        paced.push_back({&segments[i], static_cast<double>(*segments[i + 1].begin - *segments[i].begin)});
    }
    if (paced.size() < fewest) return {};
    std::vector<Paced> sorted = paced;
    std::ranges::sort(sorted, {}, &Paced::pace);
    const double usual = sorted[sorted.size() / 2].pace;
    const std::size_t all = paced.size();
    std::erase_if(paced, [&](const Paced& one) { return std::abs(one.pace - usual) > near * usual; });
    if (paced.size() < fewest || 2 * paced.size() < all) paced.clear();
    return paced;
}

/// How a file fills its time.
struct Filling {
    double ratio = 0;  ///< of its time to its length
    double length = 0;
    double rate = 0;      ///< frames per second, as stated
    bool closed = false;  ///< it was last written when its frames end, not when the next file begins
};

std::optional<Filling> filling_of(const Paced& file) {
    constexpr double tolerance = 1;  // seconds
    constexpr double most = 1.6;     // of the length
    try {
        const media::Demuxer demuxer(media::open_input(file.segment->path), media::Demuxer::Kind::video, 0);
        const media::ClipHeader header = media::header_of(demuxer);
        if (header.length <= 0 || header.rate <= 0) return std::nullopt;
        if (file.pace - header.length <= tolerance || file.pace > most * header.length) return std::nullopt;
        const double written = modified_at(file.segment->path).value_or(0);
        const double end = static_cast<double>(*file.segment->begin) + header.length;
        return Filling{file.pace / header.length, header.length, header.rate, std::abs(written - end) < 2 * tolerance};
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::limit) throw;
        return std::nullopt;  // reported when it is read
    }
}

}  // namespace

std::optional<SteadyRate> find_steady_rate(const std::vector<Segment>& segments) {
    constexpr std::size_t most = 12;  // headers that are read
    constexpr double near = 0.05;
    const std::vector<Paced> paced = paced_files(segments);
    std::vector<Filling> files;
    const std::size_t step = std::max<std::size_t>(1, paced.size() / most);
    for (std::size_t i = 0; i < paced.size(); i += step) {
        const auto filling = filling_of(paced[i]);
        if (!filling) return std::nullopt;
        files.push_back(*filling);
    }
    if (files.empty() || std::ranges::all_of(files, &Filling::closed)) return std::nullopt;
    std::ranges::sort(files, {}, &Filling::ratio);
    const Filling& usual = files[files.size() / 2];
    const double rounding = 1 / usual.length;  // names have whole seconds
    for (const Filling& one : files) {
        if (std::abs(one.ratio - usual.ratio) > near * usual.ratio + rounding) return std::nullopt;
        if (std::abs(one.rate - usual.rate) > near * usual.rate) return std::nullopt;
    }
    return SteadyRate{usual.rate / usual.ratio, usual.rate, usual.length, usual.ratio * usual.length};
}

}  // namespace vvr::footage
