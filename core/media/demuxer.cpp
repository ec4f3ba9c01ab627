#include "core/media/demuxer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>

#include <unistd.h>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory.h"
#include "core/base/text.h"

extern "C" {
#include <libavutil/opt.h>
}

namespace vvr::media {
namespace {

constexpr std::array<std::string_view, 7> playlist_formats{
    "hls", "concat", "dash", "imf", "sdp", "vobsub", "webm_dash_manifest"};

}  // namespace

bool is_playlist_name(const std::string& name) {
    const std::string ending = extension_of(name);
    return ending == ".m3u8" || ending == ".m3u";
}

bool is_playlist_format(const AVInputFormat& format) {
    const std::string_view names(format.name);
    return std::ranges::count(playlist_formats, names.substr(0, names.find(','))) > 0;
}

std::int64_t stamp_of(const AVPacket& packet) {
    return packet.pts != AV_NOPTS_VALUE ? packet.pts : packet.dts;
}

void throw_timeout(const Input& input) {
    throw Error(ErrorCode::stream_timeout,
                fmt::format("cannot read '{}': no data arrived in time; check that the stream is running", input.name));
}

std::string name_of(const AVStream& stream) {
    const char* const kind = av_get_media_type_string(stream.codecpar->codec_type);
    const bool cover = (stream.disposition & AV_DISPOSITION_ATTACHED_PIC) != 0;
    return fmt::format("{} ({})",
                       cover  ? "cover picture"
                       : kind ? kind
                              : "data",
                       avcodec_get_name(stream.codecpar->codec_id));
}

namespace {

/// All of libav's demuxers except playlists, as a `format_whitelist`.
std::string formats_of_clips() {
    std::string names;
    void* place = nullptr;
    while (const AVInputFormat* format = av_demuxer_iterate(&place)) {
        if (is_playlist_format(*format)) continue;
        names += names.empty() ? "" : ",";
        names += format->name;
    }
    return names;
}

constexpr int max_read_errors = 100;  // consecutive
constexpr int greatest_errno = 4096;  // libav's own codes are greater

/// Whether memory has run out. libav says so too of an impossible size in a damaged file.
bool is_out_of_memory(int code) {
    constexpr std::int64_t needed = 128'000'000;  // bytes: more than a packet or an index needs
    return code == AVERROR(ENOMEM) && !is_memory_available(needed);
}

/// Whether the operating system fails to read the beginning of a file.
bool has_read_error(const std::string& name) {
    constexpr std::size_t probed = 1 << 24;
    std::ifstream file(name, std::ios::binary);
    std::vector<char> bytes(probed);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file.bad();
}

/// The first bytes of a file, followed by the zeros that libav's probe needs.
class Beginning {
  public:
    explicit Beginning(const Input& input) : bytes_(probed + AVPROBE_PADDING_SIZE, '\0') {
        const std::string path = input.url.substr(std::min(input.url.size(), std::string_view("file:").size()));
        size_ =
            static_cast<int>(input.file ? ::pread(input.file->get(), bytes_.data(), probed, 0)
                                        : std::ifstream(path, std::ios::binary).read(bytes_.data(), probed).gcount());
    }

    std::string_view text() const { return {bytes_.data(), static_cast<std::size_t>(std::max(0, size_))}; }

    /// The format that libav finds in them; null if there is none.
    /// \param name for formats that are told by the name too
    const AVInputFormat* format(const char* name) {
        if (size_ <= 0) return nullptr;
        const AVProbeData data{name, reinterpret_cast<unsigned char*>(bytes_.data()), size_, nullptr};
        return av_probe_input_format(&data, 1);
    }

  private:
    static constexpr std::size_t probed = 4096;
    std::string bytes_;
    int size_ = 0;
};

/// Whether a file's content is a playlist. FFmpeg 7.1 only looks if the name is a playlist's, so it gets such a name.
bool is_playlist(const Input& input) {
    const AVInputFormat* const format = Beginning(input).format("list.m3u8");
    return format != nullptr && is_playlist_format(*format);
}

/// Whether a file begins with text that is no video's header.
bool is_text(const Input& input) {
    Beginning begin(input);
    const bool has_text = std::ranges::all_of(begin.text(), [](char c) {
        return static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\r' || c == '\t';
    });
    return !begin.text().empty() && has_text && begin.format("") == nullptr;
}

[[noreturn]] void throw_text_file(const std::string& name) {
    throw Error(ErrorCode::not_video, fmt::format("'{}' is not a video, but a text file; give a video file", name));
}

[[noreturn]] void throw_unreadable_file(const Input& input, const av::Log& log, int code) {
    const std::string words = log.text(code);
    // libav also uses system error codes for other errors: EIO for a damaged Matroska file, EBUSY for a picture that is
    // too large.
    if (code == AVERROR(ENOENT) || code == AVERROR(EACCES)) {
        throw Error(code_of_system_error(AVUNERROR(code)),
                    fmt::format("cannot read '{}': {}; check its name and permissions", input.name, words));
    }
    if (code == AVERROR(EIO) && has_read_error(input.name)) {
        throw Error(ErrorCode::io, fmt::format("cannot read '{}': {}; check the disk", input.name, words));
    }
    if (is_text(input)) throw_text_file(input.name);
    if (words.find("moov atom not found") != std::string::npos) {
        throw Error(ErrorCode::not_video,
                    fmt::format("'{}' is incomplete: it lacks the index that is written last (moov atom not found); "
                                "wait until its recorder has finished it, or copy it again",
                                input.name));
    }
    const bool of_the_system = AVUNERROR(code) > 0 && AVUNERROR(code) < greatest_errno && !log.has_text();
    throw Error(ErrorCode::not_video,
                fmt::format("'{}' is not a video that FFmpeg can read: {}; run `ffprobe` on it for details", input.name,
                            of_the_system ? "it is damaged, or its pictures are too large" : words));
}

[[noreturn]] void throw_unreadable(const Input& input, const av::Log& log, int code) {
    const std::string words = log.text(code);
    if (is_local(input) && is_playlist(input)) {
        throw Error(
            ErrorCode::playlist,
            fmt::format("'{}' is a playlist, not a video; give the folder of its files, or a .txt list with one "
                        "path per line",
                        input.name));
    }
    if (is_out_of_memory(code)) {
        throw Error(ErrorCode::out_of_memory,
                    fmt::format("out of memory while opening '{}'; give vvr more memory", input.name));
    }
    if (code == AVERROR(EMFILE) || code == AVERROR(ENFILE)) {
        throw Error(
            ErrorCode::too_many_open_files,
            fmt::format("cannot read '{}': {}; raise the limit of open files (`ulimit -n`)", input.name, words));
    }
    if (code == AVERROR_EXIT) throw_timeout(input);
    if (is_local(input)) throw_unreadable_file(input, log, code);
    // A device that is not a camera fails with ENOTTY.
    if (code != AVERROR_INVALIDDATA && code != AVERROR(ENOTTY))
        throw Error(ErrorCode::stream_unreachable,
                    fmt::format("cannot read '{}': {}; check the address", input.name, words));
    throw Error(ErrorCode::not_video,
                fmt::format("'{}' is not a video that FFmpeg can read: {}; run `ffprobe` on it for details", input.name,
                            words));
}

bool is_picture_format(std::string_view name) {
    return name.ends_with("_pipe") || name == "gif" || name == "apng" || name == "mjpeg" || name == "ico";
}

// libav decodes text files as pictures of a terminal.
bool is_text_art(AVCodecID codec) {
    return codec == AV_CODEC_ID_ANSI || codec == AV_CODEC_ID_BINTEXT || codec == AV_CODEC_ID_XBIN ||
           codec == AV_CODEC_ID_IDF;
}

std::string streams_found(const AVFormatContext& format) {
    std::string found;
    for (unsigned i = 0; i < format.nb_streams; ++i) {
        found += (found.empty() ? "" : ", ") + name_of(*format.streams[i]);
    }
    return found.empty() ? "no streams" : found;
}

/// Reads packets until the streams' parameters are known. Returns libav's error code.
int probe_streams(AVFormatContext& format) {
    std::vector<av::Dictionary> options(format.nb_streams);
    std::vector<AVDictionary*> pointers;
    for (auto& option : options) {
        option.set("max_pixels", std::to_string(av::max_pixels));
        pointers.push_back(*option.get());
    }
    const int code = avformat_find_stream_info(&format, pointers.empty() ? nullptr : pointers.data());
    for (std::size_t i = 0; i < options.size(); ++i) *options[i].get() = pointers[i];
    return code;
}

/// Whether the input comes from a server. A `file://` URL does not.
bool is_remote(const Input& input) {
    return is_url(input.url) && !is_local(input);
}

/// The host of a URL, with its port if the URL has one.
std::string_view host_of(std::string_view url) {
    const auto scheme = url.find("://");
    if (scheme == std::string_view::npos) return {};
    url.remove_prefix(scheme + 3);
    url = url.substr(0, url.find_first_of("/?#"));
    if (const auto user = url.rfind('@'); user != std::string_view::npos) url.remove_prefix(user + 1);
    for (const std::string_view usual : {":80", ":443", ":554"}) {
        if (url.ends_with(usual)) url.remove_suffix(usual.size());
    }
    return url;
}

/// The URL after redirects. For HTTP it is an option of the connection, for RTSP it replaces the original URL.
std::string address_of(const AVFormatContext& format) {
    std::uint8_t* location = nullptr;
    if (format.pb != nullptr && av_opt_get(format.pb, "location", AV_OPT_SEARCH_CHILDREN, &location) >= 0) {
        const std::unique_ptr<std::uint8_t, void (*)(void*)> owner(location, &av_free);
        if (location != nullptr && *location != 0) return reinterpret_cast<const char*>(location);
    }
    return format.url != nullptr ? format.url : "";
}

/// Rejects a redirect to another host, which the user did not ask for.
void check_host(const Input& input, const AVFormatContext& format) {
    const std::string found = address_of(format);
    const std::string_view host = host_of(found);
    if (host.empty() || host == host_of(input.url)) return;
    throw Error(ErrorCode::stream_unreachable,
                fmt::format("cannot read '{}': the server redirects to another host, '{}'; if you trust it, give its "
                            "address",
                            input.name, host));
}

/// Sets options for low delay: no buffering, and no wait for lost UDP packets.
void set_live(av::Dictionary& options) {
    options.set("fflags", "nobuffer");
    options.set("analyzeduration", "2000000");
    options.set("overrun_nonfatal", "1");
}

/// Of a container that lists its frames, such as MP4: the seconds that its duration lacks, because many frames in a row
/// lie a tick apart. For others it is 0, as only reading them tells.
double seconds_lacking(AVStream& stream) {
    const int frames = avformat_index_get_entries_count(&stream);
    if (stream.duration <= 0 || frames != stream.nb_frames) return 0;
    const auto stamp = [&](int frame) { return avformat_index_get_entry(&stream, frame)->timestamp; };
    const double tick = av_q2d(stream.time_base);
    const double average = static_cast<double>(stream.duration) * tick / frames;
    int run = 0;
    int mended = 0;
    double spanned = 0;  // seconds of the mended frames, with the gap before them
    for (int i = 1; i <= frames; ++i) {
        if (i < frames && is_tick(static_cast<double>(stamp(i) - stamp(i - 1)) * tick, average)) {
            ++run;
            continue;
        }
        const int first = i - 1 - run;
        if (run >= lasting_ticks && first > 0) {
            mended += run + 1;
            spanned += static_cast<double>(stamp(i - 1) - stamp(first - 1)) * tick;
        }
        run = 0;
    }
    const double usual = (static_cast<double>(stream.duration) * tick - spanned) / std::max(1, frames - mended);
    return std::max(0.0, mended * usual - spanned);
}

}  // namespace

Demuxer::Demuxer(const Input& input, Kind kind, double rate) : watchdog_(input.watchdog) {
    if (input.file) reader_ = std::make_unique<FileReader>(input.file);
    if (input.pipe) pipe_ = std::make_unique<PipeReader>(input.pipe, watchdog_);
    int code = open(input, rate, "prefer_tcp");
    // Some RTSP servers don't support RTP over TCP and answer "400 Bad Request".
    if (code == AVERROR_HTTP_BAD_REQUEST && input.url.starts_with("rtsp")) code = open(input, rate, "");
    if (code >= 0 && is_remote(input)) check_host(input, *format_);
    if (code >= 0 && kind == Kind::video) code = probe_streams(*format_);
    if (code < 0) throw_unreadable(input, log_, code);
    choose_stream(input, kind);
    if (watchdog_ || kind == Kind::picture) return;
    lacking_ = seconds_lacking(*stream_);
    mender_.emplace(stream_->index, tick(), frame_duration() / tick());
    if (rate > 0) stretch_ = 1 / (frame_duration() * rate);
}

int Demuxer::open(const Input& input, double rate, const std::string& rtsp_flags) {
    AVFormatContext* opened = avformat_alloc_context();
    if (!opened) throw Error(ErrorCode::out_of_memory, "out of memory for opening a video; give vvr more memory");
    log_.attach(*opened, watchdog_.get());
    if (reader_) opened->pb = reader_->context();
    if (pipe_) opened->pb = pipe_->context();
    av::Dictionary options;
    options.set("framerate", fmt::format("{:.6f}", rate > 0 ? rate : assumed_rate));
    options.set("pattern_type", "none");
    options.set("max_pixels", std::to_string(av::max_pixels));
    if (is_remote(input) && watchdog_) {
        set_live(options);
        if (!rtsp_flags.empty()) options.set("rtsp_flags", rtsp_flags);
    } else if (is_remote(input)) {
        options.set("rw_timeout", "30000000");
    } else {
        options.set("protocol_whitelist", "file,crypto,data");
        if (input.format.empty()) options.set("format_whitelist", formats_of_clips());
    }
    const AVInputFormat* const format = input.format.empty() ? nullptr : av_find_input_format(input.format.c_str());
    // On failure, libav frees the context and sets the pointer to null.
    const int code = avformat_open_input(&opened, input.url.c_str(), format, options.get());
    format_.reset(opened);
    return code;
}

void Demuxer::choose_stream(const Input& input, Kind kind) {
    if (kind == Kind::picture && !is_picture_format(format_->iformat->name)) {
        throw Error(ErrorCode::not_video,
                    fmt::format("'{}' is not a picture: its format is {}", input.name, format_->iformat->name));
    }

    for (unsigned i = 0; i < format_->nb_streams; ++i) {
        AVStream* const each = format_->streams[i];
        const bool is_cover = (each->disposition & AV_DISPOSITION_ATTACHED_PIC) != 0;
        if (each->codecpar->codec_type == AVMEDIA_TYPE_VIDEO && !is_cover) tracks_.push_back(each);
    }
    const int chosen = av_find_best_stream(format_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0);
    if (chosen < 0 || format_->streams[chosen]->disposition & AV_DISPOSITION_ATTACHED_PIC) {
        throw Error(ErrorCode::no_video_stream,
                    fmt::format("'{}' has no video stream (found: {}); give a file that has one", input.name,
                                streams_found(*format_)));
    }
    stream_ = format_->streams[chosen];
    if (input.track > tracks()) {
        throw Error(ErrorCode::no_video_stream,
                    fmt::format("track {}: '{}' has {}", input.track, input.name, counted(tracks(), "video track")),
                    {"track"});
    }
    if (input.track > 0) stream_ = tracks_[static_cast<std::size_t>(input.track) - 1];

    const auto& codec = *stream_->codecpar;
    if (is_text_art(codec.codec_id)) throw_text_file(input.name);
    if (std::int64_t{codec.width} * codec.height > av::max_pixels) {
        throw Error(
            ErrorCode::picture_too_large,
            fmt::format("'{}' has pictures of {}x{}, more than the limit of {} megapixels; scale the video down first",
                        input.name, codec.width, codec.height, av::max_pixels / 1'000'000));
    }
    for (unsigned i = 0; i < format_->nb_streams; ++i) {
        if (format_->streams[i] != stream_) format_->streams[i]->discard = AVDISCARD_ALL;
    }
}

void Demuxer::select_all_streams() {
    for (unsigned i = 0; i < format_->nb_streams; ++i) format_->streams[i]->discard = AVDISCARD_DEFAULT;
}

bool Demuxer::read(AVPacket& packet) {
    while (read_any(packet)) {
        if (packet.stream_index == stream_->index) return true;
    }
    return false;
}

bool Demuxer::read_any(AVPacket& packet) {
    if (!mender_) return read_unmended(packet);
    return mender_->read(packet, [this](AVPacket& next) { return read_unmended(next); });
}

MendedFrames Demuxer::mended() const {
    MendedFrames mended = mender_ ? mender_->mended() : MendedFrames();
    mended.from *= stretch_;
    for (condition::Interval& interval : mended.intervals) {
        interval.begin *= stretch_;
        interval.end *= stretch_;
    }
    return mended;
}

bool Demuxer::read_unmended(AVPacket& packet) {
    if (watchdog_) watchdog_->feed();
    const std::int64_t before = damaged_;
    for (int errors = 0; errors < max_read_errors;) {
        av_packet_unref(&packet);
        const int code = av_read_frame(format_.get(), &packet);
        if (code == AVERROR_EOF || code == AVERROR_EXIT) return false;
        if (is_out_of_memory(code)) av::throw_out_of_memory();
        if (code < 0) {
            ++damaged_;
            ++errors;
        } else {
            return true;
        }
    }
    damaged_ = before + 1;  // each attempt failed at the same packet
    return false;
}

std::optional<double> Demuxer::seconds(std::int64_t stamp) const {
    if (stamp == AV_NOPTS_VALUE) return std::nullopt;
    return static_cast<double>(stamp) * tick();
}

double Demuxer::tick() const {
    return av_q2d(stream_->time_base) * stretch_;
}

int Demuxer::track() const {
    return static_cast<int>(std::ranges::find(tracks_, stream_) - tracks_.begin()) + 1;
}

double Demuxer::frame_duration() const {
    if (lacking_ > 0) {
        const double stated = static_cast<double>(stream_->duration) * av_q2d(stream_->time_base);
        return stretch_ * (stated + lacking_) / static_cast<double>(stream_->nb_frames);
    }
    for (const AVRational rate : {stream_->avg_frame_rate, stream_->r_frame_rate}) {
        if (rate.num > 0 && rate.den > 0) return stretch_ / av_q2d(rate);
    }
    return stretch_ / assumed_rate;
}

}  // namespace vvr::media
