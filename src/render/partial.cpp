#include "render/partial.h"

#include "core/errors.h"
#include "core/random.h"
#include "core/replace_file.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <fstream>

namespace vitrine {

namespace {

constexpr char magic[8] = {'V', 'I', 'T', 'P', 'A', 'R', 'T', '2'};

/// 64-bit mixing checksum: against cut or flipped files, not against forgery.
class Checksum {
  public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (; size >= 8; bytes += 8, size -= 8) {
            std::uint64_t word;
            std::memcpy(&word, bytes, 8);
            value_ = mixBits(value_ ^ word) + goldenGamma;
        }
        for (; size > 0; ++bytes, --size)
            value_ = mixBits(value_ ^ *bytes) + goldenGamma;
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0;
};

/// What stands before the sums.
class Writer {
  public:
    void bytes(const void* data, std::size_t size) {
        header_.append(static_cast<const char*>(data), size);
        checksum_.add(data, size);
    }
    template <class T>
    void value(const T& v) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(&v, sizeof v);
    }
    void text(const std::string& s) {
        value(std::uint64_t(s.size()));
        bytes(s.data(), s.size());
    }
    const std::string& header() const { return header_; }
    /// Of the header and of what follows it.
    std::uint64_t checksumWith(std::span<const std::span<const std::byte>> following) const {
        Checksum all = checksum_;
        for (const auto& bytes : following)
            all.add(bytes.data(), bytes.size());
        return all.value();
    }

  private:
    std::string header_;
    Checksum checksum_;
};

class Reader {
  public:
    Reader(std::istream& in, const std::string& path) : in_(in), path_(path) {}
    void bytes(void* data, std::size_t size) {
        if (!in_.read(static_cast<char*>(data), std::streamsize(size))) throw FileError(path_, "the file is cut short");
        checksum_.add(data, size);
    }
    template <class T>
    T value() {
        T v;
        bytes(&v, sizeof v);
        return v;
    }
    std::string text() {
        const auto size = value<std::uint64_t>();
        if (size > 65536) throw FileError(path_, "the file is damaged");
        std::string s(size, '\0');
        bytes(s.data(), size);
        return s;
    }
    std::uint64_t checksum() const { return checksum_.value(); }

  private:
    std::istream& in_;
    const std::string& path_;
    Checksum checksum_;
};

void writeFilmSettings(Writer& w, const FilmSettings& s) {
    for (const V2i& v : {s.resolution, s.cropMin, s.cropMax}) {
        w.value(v.x);
        w.value(v.y);
    }
    w.text(s.colorSpace ? s.colorSpace->name() : "srgb");
    w.value(s.maxComponentValue);
    w.value(s.imagingRatio);
}

FilmSettings readFilmSettings(Reader& r, const std::string& path) {
    FilmSettings s;
    for (V2i* v : {&s.resolution, &s.cropMin, &s.cropMax}) {
        v->x = r.value<int>();
        v->y = r.value<int>();
    }
    s.colorSpace = RgbColorSpace::named(r.text());
    s.maxComponentValue = r.value<float>();
    s.imagingRatio = r.value<float>();
    if (!s.colorSpace) throw FileError(path, "the file is damaged");
    return s;
}

/// What a damaged header asks for must not be allocated.
void checkSize(std::istream& in, const std::string& path, double bytes) {
    const auto here = in.tellg();
    in.seekg(0, std::ios::end);
    const double left = double(in.tellg() - here);
    in.seekg(here);
    if (bytes > left) throw FileError(path, "the file is cut short or damaged");
}

} // namespace

void PassSet::add(PassRange range) {
    if (range.begin > range.end) throw std::invalid_argument("an inverted range of passes");
    if (range.size() == 0) return;
    auto next = std::find_if(ranges_.begin(), ranges_.end(), [&](const PassRange& r) { return r.end > range.begin; });
    if (next != ranges_.end() && next->begin < range.end)
        throw std::invalid_argument(
            fmt::format("passes {}:{} overlap {}:{}", range.begin, range.end, next->begin, next->end));
    next = ranges_.insert(next, range);
    if (next + 1 != ranges_.end() && (next + 1)->begin == next->end) {
        next->end = (next + 1)->end;
        ranges_.erase(next + 1);
    }
    if (next != ranges_.begin() && (next - 1)->end == next->begin) {
        (next - 1)->end = next->end;
        ranges_.erase(next);
    }
}

std::uint64_t PassSet::size() const {
    std::uint64_t n = 0;
    for (const auto& r : ranges_)
        n += r.size();
    return n;
}

std::vector<PassRange> PassSet::missingFrom(PassRange range) const {
    std::vector<PassRange> missing;
    std::uint64_t at = range.begin;
    for (const auto& r : ranges_) {
        if (r.end <= at) continue;
        if (r.begin >= range.end) break;
        if (r.begin > at) missing.push_back({at, r.begin});
        at = r.end;
    }
    if (at < range.end) missing.push_back({at, range.end});
    return missing;
}

std::string PassSet::toString() const {
    std::string text;
    for (const auto& r : ranges_)
        text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", r.begin, r.end);
    return text;
}

void writePartial(const std::string& path, const PartialRender& state, const Film& film) {
    Writer w;
    w.bytes(magic, sizeof magic);
    w.value(state.fingerprint);
    w.text(state.sceneName);
    w.value(state.seconds);
    w.value(std::uint64_t(state.passes.ranges().size()));
    for (const auto& r : state.passes.ranges())
        w.value(r);
    w.value(std::uint64_t(state.matrices.size()));
    for (const auto& [name, matrix] : state.matrices) {
        w.text(name);
        w.bytes(matrix.getValue(), 16 * sizeof(double));
    }
    writeFilmSettings(w, film.settings());
    w.value(std::uint64_t(state.integratorState.size()));
    const std::array<std::span<const std::byte>, 3> body = {std::as_bytes(film.sums()), std::as_bytes(film.badCounts()),
                                                            std::span(state.integratorState)};
    const std::uint64_t checksum = w.checksumWith(body);
    replaceFile(path, {std::as_bytes(std::span(w.header())), body[0], body[1], body[2],
                       std::as_bytes(std::span(&checksum, 1))});
}

LoadedPartial readPartial(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw FileError(path, "cannot be opened");
    Reader r(in, path);
    char found[sizeof magic];
    r.bytes(found, sizeof found);
    if (std::memcmp(found, magic, sizeof magic) != 0) throw FileError(path, "is not a file of partial sums");
    PartialRender state;
    state.fingerprint = r.value<std::uint64_t>();
    state.sceneName = r.text();
    state.seconds = r.value<double>();
    const auto ranges = r.value<std::uint64_t>();
    if (ranges > 1u << 20) throw FileError(path, "the file is damaged");
    for (std::uint64_t i = 0; i < ranges; ++i) {
        try {
            state.passes.add(r.value<PassRange>());
        } catch (const std::invalid_argument&) {
            throw FileError(path, "the file is damaged");
        }
    }
    const auto matrices = r.value<std::uint64_t>();
    if (matrices > 16) throw FileError(path, "the file is damaged");
    for (std::uint64_t i = 0; i < matrices; ++i) {
        const std::string name = r.text();
        r.bytes(state.matrices[name].getValue(), 16 * sizeof(double));
    }
    try {
        const FilmSettings settings = readFilmSettings(r, path);
        const auto stateSize = r.value<std::uint64_t>();
        const V2i size = settings.cropSize();
        checkSize(in, path, double(size.x) * double(size.y) * double(Film::bytesPerPixel) + double(stateSize));
        LoadedPartial loaded{std::move(state), Film(settings)};
        r.bytes(loaded.film.sums().data(), loaded.film.sums().size_bytes());
        r.bytes(loaded.film.badCounts().data(), loaded.film.badCounts().size_bytes());
        loaded.state.integratorState.resize(stateSize);
        r.bytes(loaded.state.integratorState.data(), stateSize);
        const std::uint64_t expected = r.checksum();
        std::uint64_t stored;
        if (!in.read(reinterpret_cast<char*>(&stored), sizeof stored) || stored != expected)
            throw FileError(path, "the file is damaged (its checksum differs)");
        if (in.peek() != std::istream::traits_type::eof()) throw FileError(path, "the file is damaged");
        return loaded;
    } catch (const std::invalid_argument&) {
        throw FileError(path, "the file is damaged");
    }
}

} // namespace vitrine
