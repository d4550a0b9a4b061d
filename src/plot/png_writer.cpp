#include "plot/png_writer.h"

#include <fmt/format.h>

#include <cairo.h>
#include <memory>
#include <new>
#include <stdexcept>

namespace vitrine::plot {

namespace {

constexpr double cairoLimit = 32767;

/// \throws std::bad_alloc, which is what Cairo's drawing can fail of
void check(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(fmt::format("Cairo: {}", cairo_status_to_string(status)));
}

struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

class CairoPainter {
  public:
    explicit CairoPainter(cairo_t* context) : c_(context) {
        cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(c_, CAIRO_LINE_CAP_ROUND);
        cairo_set_fill_rule(c_, CAIRO_FILL_RULE_EVEN_ODD);
    }

    void add(const Line& line) {
        cairo_new_path(c_);
        for (const V2d& p : line.points)
            cairo_line_to(c_, p.x, p.y);
        if (line.brush) fill(*line.brush);
        if (line.pen) stroke(*line.pen);
    }

    void add(const Disk& disk) {
        cairo_new_path(c_);
        cairo_arc(c_, disk.centre.x, disk.centre.y, disk.radius, 0, 2 * piD);
        fill(disk.brush);
        stroke(disk.pen);
    }

    void add(const Text& text) {
        const std::vector<TextRun> runs = textRuns(text.text);
        double width = 0;
        for (const TextRun& run : runs)
            width += select(text, run);
        cairo_save(c_);
        setColour(text.colour, 1);
        cairo_translate(c_, text.at.x, text.at.y);
        if (text.upwards) cairo_rotate(c_, -piD / 2);
        double x = text.anchor == Anchor::Start ? 0 : text.anchor == Anchor::Middle ? -width / 2 : -width;
        for (const TextRun& run : runs) {
            const double advance = select(text, run);
            const double shift = run.level < 0 ? subscriptDrop : run.level > 0 ? -superscriptRise : 0;
            cairo_move_to(c_, x, shift * text.size);
            cairo_show_text(c_, run.text.c_str());
            x += advance;
        }
        cairo_restore(c_);
    }

    void add(const GroupBegin& group) {
        cairo_save(c_);
        if (!group.clip) return;
        const V2d extent = group.clip->size();
        cairo_rectangle(c_, group.clip->min.x, group.clip->min.y, extent.x, extent.y);
        cairo_clip(c_);
    }

    void add(const GroupEnd&) { cairo_restore(c_); }

  private:
    void setColour(const Colour& c, double opacity) {
        cairo_set_source_rgba(c_, c.r / 255., c.g / 255., c.b / 255., opacity);
    }

    void fill(const Brush& brush) {
        setColour(brush.colour, brush.opacity);
        cairo_fill_preserve(c_);
    }

    void stroke(const Pen& pen) {
        setColour(pen.colour, pen.opacity);
        cairo_set_line_width(c_, pen.width);
        cairo_set_dash(c_, pen.dashes.data(), int(pen.dashes.size()), 0);
        cairo_stroke(c_);
    }

    /// Sets the font of a run and returns the run's width.
    double select(const Text& text, const TextRun& run) {
        cairo_select_font_face(c_, fontFamily, run.italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                               text.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(c_, run.level != 0 ? scriptSize * text.size : text.size);
        cairo_text_extents_t extents;
        cairo_text_extents(c_, run.text.c_str(), &extents);
        return extents.x_advance;
    }

    cairo_t* c_;
};

/// A C function that Cairo calls: nothing may be thrown through it.
cairo_status_t append(void* to, const unsigned char* data, unsigned length) {
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    try {
        auto& file = *static_cast<std::vector<std::byte>*>(to);
        file.insert(file.end(), bytes, bytes + length);
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

} // namespace

std::vector<std::byte> toPng(const Figure& figure, double pixelsPerPoint) {
    const double width = std::ceil(figure.size.x * pixelsPerPoint), height = std::ceil(figure.size.y * pixelsPerPoint);
    if (!(width <= cairoLimit && height <= cairoLimit))
        throw std::invalid_argument(
            fmt::format("a PNG of {} x {} pixels is too large: up to {} a side", width, height, cairoLimit));
    const std::unique_ptr<cairo_surface_t, Destroy> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(width), int(height)));
    check(cairo_surface_status(surface.get()));
    const std::unique_ptr<cairo_t, Destroy> context(cairo_create(surface.get()));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    cairo_scale(context.get(), pixelsPerPoint, pixelsPerPoint);
    CairoPainter painter(context.get());
    for (const auto& item : figure.items())
        std::visit([&](const auto& i) { painter.add(i); }, item);
    check(cairo_status(context.get()));
    std::vector<std::byte> file;
    check(cairo_surface_write_to_png_stream(surface.get(), append, &file));
    return file;
}

} // namespace vitrine::plot
