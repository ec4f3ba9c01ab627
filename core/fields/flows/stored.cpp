#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/fields/flo_file.h"
#include "core/fields/flow.h"
#include "core/fields/settings.h"

namespace vvr::fields {
namespace {

/// Middlebury's mark of an unknown vector is a larger value.
constexpr float largest = 1e9F;

/// The flow that another program has computed. Its frames are only read where the seeds need to know what changes.
class StoredFlow final : public FlowMethod {
  public:
    explicit StoredFlow(const std::filesystem::path& folder) : files_(open_flow_files(folder)) {}

    int reach() const override { return 1; }
    int margin() const override { return 0; }
    FlowFrame prepare(const Plane<std::uint8_t>& grey) const override { return {.grey = grey, .levels = {}}; }

    Flow operator()(std::span<const FlowFrame* const> frames, const PixelBox& /*part*/) const override {
        const FlowFrame& here = *frames[1];
        const Size size = here.grey.size();
        const std::filesystem::path* const file = files_.find(here.index);
        // Between two frames there is one flow, so one end of the clip may have none.
        if (file == nullptr && (here.index == 0 || here.index == files_.last() + 1))
            return {Plane<float>(size), Plane<float>(size)};
        Flow flow = read_flo(files_.of(here.index).string());
        if (flow.u.size() != size) {
            throw Error(
                ErrorCode::file_invalid,
                fmt::format("'{}' has {}x{} pixels, but the clip's fields have {}x{}; give field-size {}x{}, or "
                            "compute the flow at the size of the fields",
                            file->string(), flow.u.width(), flow.u.height(), size.width, size.height, flow.u.width(),
                            flow.u.height()),
                {setting::field_size.name, setting::flow.name});
        }
        for (std::size_t i = 0; i < flow.u.pixels().size(); ++i) {
            float& u = flow.u.pixels()[i];
            float& v = flow.v.pixels()[i];
            if (std::abs(u) > largest || std::abs(v) > largest) u = v = 0;
        }
        return flow;
    }

  private:
    FrameFiles files_;
};

}  // namespace

FrameFiles open_flow_files(const std::filesystem::path& folder) {
    return {setting::flow.name, folder, {".flo"}};
}

std::unique_ptr<FlowMethod> make_stored_flow(const FlowOptions& options) {
    return std::make_unique<StoredFlow>(options.method.name());
}

}  // namespace vvr::fields
