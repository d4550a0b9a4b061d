// The typed parameter list of one directive: lookups that remember what was asked for, so that what nobody read is an
// error with its place.
#pragma once

#include "core/errors.h"
#include "core/vec.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vitrine {

enum class ParameterType {
    Integer,
    Float,
    Bool,
    String,
    Texture,
    Point2,
    Vector2,
    Point3,
    Vector3,
    Normal,
    Rgb,
    Blackbody,
    Spectrum,
    Untyped ///< from `--set key=value`: the text takes the type that it is asked for
};

/// pbrt-v4's word for the type: "integer", "point3", ...
std::string_view typeName(ParameterType type);

/// One parameter as it was written. Values lie contiguous: a mesh has millions.
struct Parameter {
    using Numbers = std::vector<double>; ///< every value finite and within the range of a float
    using Integers = std::vector<int>;   ///< `integer`, and `bool` as 0 and 1
    using Strings = std::vector<std::string>;

    ParameterType type = ParameterType::Float;
    std::string name;
    Place place;            ///< of the quoted declaration
    std::size_t offset = 0; ///< byte in its file where it begins
    std::variant<Numbers, Integers, Strings> values;
    std::string colorSpace; ///< current where the parameter was written ("srgb", ...)

    std::size_t size() const;
    /// Place of the `index`-th value, found by reading the text again from the declaration on.
    Place valuePlace(std::size_t index) const;
};

using ParameterPtr = std::shared_ptr<const Parameter>;
using ParameterList = std::vector<ParameterPtr>;

/// A spectrum as written; what it means (reflectance, emission ...) is the reader's business.
struct SpectrumNode {
    enum class Kind {
        Rgb,       ///< values: r g b, none negative
        Blackbody, ///< values: the temperature in kelvin, positive
        Name,      ///< text: a named spectrum or else a file (pbrt-v4 tries them in this order; see resolveFile())
        Pairs      ///< values: wavelength in nm, value, ...; wavelengths strictly increasing
    };
    Kind kind = Kind::Rgb;
    std::vector<double> values;
    std::string text;
    std::string colorSpace;
    Place place; ///< of the value (Name) or of the parameter
};

/// The parameters of one node. Lookups never throw: a wrong type or count is recorded, the default (or nothing) is
/// returned, and report() hands the errors over. Call report() after building every node: it also reports what was
/// not read. Lookups change marks inside: one set is for one thread at a time.
class ParameterSet {
  public:
    ParameterSet() = default;
    /// `defaults` are those of the Attribute directive: they come second and may stay unread. (One of the wrong type is an
    /// error; pbrt-v4 passes over it.)
    ParameterSet(ParameterList own, std::shared_ptr<const ParameterList> defaults, std::string colorSpace, Place place);

    void setDefaults(std::shared_ptr<const ParameterList> defaults) { defaults_ = std::move(defaults); }

    /// Whether the parameter was given, with any type. Does not count as reading it.
    bool has(std::string_view name) const;
    /// Whether the parameter was given with this type. Does not count as reading it.
    bool is(std::string_view name, ParameterType type) const;

    std::optional<double> findFloat(std::string_view name) const;
    std::optional<int> findInteger(std::string_view name) const;
    std::optional<bool> findBool(std::string_view name) const;
    std::optional<std::string> findString(std::string_view name) const;
    std::optional<V2d> findPoint2(std::string_view name) const { return findPair(name, ParameterType::Point2); }
    std::optional<V2d> findVector2(std::string_view name) const { return findPair(name, ParameterType::Vector2); }
    std::optional<V3d> findPoint3(std::string_view name) const { return findTriple(name, ParameterType::Point3); }
    std::optional<V3d> findVector3(std::string_view name) const { return findTriple(name, ParameterType::Vector3); }
    std::optional<V3d> findNormal(std::string_view name) const { return findTriple(name, ParameterType::Normal); }

    double getFloat(std::string_view name, double fallback) const { return findFloat(name).value_or(fallback); }
    int getInteger(std::string_view name, int fallback) const { return findInteger(name).value_or(fallback); }
    bool getBool(std::string_view name, bool fallback) const { return findBool(name).value_or(fallback); }
    std::string getString(std::string_view name, const std::string& fallback) const {
        return findString(name).value_or(fallback);
    }
    V2d getPoint2(std::string_view name, const V2d& fallback) const { return findPoint2(name).value_or(fallback); }
    V2d getVector2(std::string_view name, const V2d& fallback) const { return findVector2(name).value_or(fallback); }
    V3d getPoint3(std::string_view name, const V3d& fallback) const { return findPoint3(name).value_or(fallback); }
    V3d getVector3(std::string_view name, const V3d& fallback) const { return findVector3(name).value_or(fallback); }
    V3d getNormal(std::string_view name, const V3d& fallback) const { return findNormal(name).value_or(fallback); }

    /// A string that must be one of `choices`; another is recorded as an error and `fallback` returned.
    std::string getChoice(std::string_view name, const std::string& fallback,
                          const std::vector<std::string>& choices) const;

    /// rgb, blackbody or spectrum; nothing when not given. (A "float" or "texture" under this name is a type error: try
    /// is() or findTexture() before, where they are allowed.)
    std::optional<SpectrumNode> findSpectrum(std::string_view name) const;
    /// Name of the texture when the parameter is one; nothing when it is not given or of another type (no error).
    std::optional<std::string> findTexture(std::string_view name) const;

    // Arrays: empty when not given. Spans stay valid as long as the set. A count that is no multiple of the items' size
    // is an error.
    std::span<const double> getFloats(std::string_view name) const;
    std::span<const int> getIntegers(std::string_view name) const;
    std::vector<std::string> getStrings(std::string_view name) const;
    template <class V = V2d>
    std::vector<V> getPoint2s(std::string_view name) const {
        return gather<V>(name, ParameterType::Point2);
    }
    template <class V = V2d>
    std::vector<V> getVector2s(std::string_view name) const {
        return gather<V>(name, ParameterType::Vector2);
    }
    template <class V = V3d>
    std::vector<V> getPoint3s(std::string_view name) const {
        return gather<V>(name, ParameterType::Point3);
    }
    template <class V = V3d>
    std::vector<V> getVector3s(std::string_view name) const {
        return gather<V>(name, ParameterType::Vector3);
    }
    template <class V = V3d>
    std::vector<V> getNormals(std::string_view name) const {
        return gather<V>(name, ParameterType::Normal);
    }

    /// Colour space current at the directive.
    const std::string& colorSpace() const { return colorSpace_; }
    /// Of the parameter, or of the directive when it was not given.
    Place place(std::string_view name) const;
    /// Of one value of it.
    Place valuePlace(std::string_view name, std::size_t index) const;

    /// Records an error about a parameter, for report(): say `"radius" must be positive`.
    void error(std::string_view name, std::string message, std::string hint = {}) const;
    /// The same, with the caret under one of its values.
    void errorAtValue(std::string_view name, std::size_t index, std::string message, std::string hint = {}) const;

    /// Hands over the recorded errors, then one for every own parameter that nobody read.
    void report(Diagnostics& diagnostics) const;
    /// The recorded errors only: for a node whose building stopped half-way.
    void reportErrors(Diagnostics& diagnostics) const;
    /// Whether any error was recorded.
    bool hasErrors() const { return !errors_.empty(); }

    /// Puts a parameter of the command line before those of the file. It may stay unread: see wasRead().
    void addOverride(ParameterPtr parameter);
    bool wasRead(std::string_view name) const;
    /// Whether it is the file's own and nobody read it.
    bool isUnused(std::string_view name) const;
    /// Drops an own parameter; false when there is none. (`--integrator` keeps what the new type knows.)
    bool remove(std::string_view name);
    /// The own parameters, in the order written.
    ParameterList own() const;
    /// Those of the Attribute directive, newest first; empty for none.
    const ParameterList& defaults() const;
    /// Names of the own parameters, in the order written.
    std::vector<std::string> names() const;
    /// What was looked up in a copy counts as looked up here.
    void takeReadsFrom(const ParameterSet& copy) const;
    /// Every name that was looked up so far.
    const std::vector<std::string>& askedNames() const { return asked_; }

  private:
    struct Entry {
        ParameterPtr parameter;
        bool mayStayUnread = false;
        bool read = false;
    };

    Entry* ownEntry(std::string_view name) const;
    const Parameter* lookUp(std::string_view name) const;
    const Parameter* read(std::string_view name, ParameterType type) const;
    const Parameter* readOne(std::string_view name, ParameterType type) const;
    void mark(std::string_view name) const;
    bool checkSpectrum(const SpectrumNode& node, const Parameter& parameter) const;
    std::optional<V2d> findPair(std::string_view name, ParameterType type) const;
    std::optional<V3d> findTriple(std::string_view name, ParameterType type) const;
    std::span<const double> readNumbers(std::string_view name, ParameterType type) const;
    void record(Place place, std::string message, std::string hint = {}) const;

    template <class V>
    std::vector<V> gather(std::string_view name, ParameterType type) const {
        const std::size_t n = V::dimensions();
        const auto numbers = readNumbers(name, type);
        std::vector<V> items(numbers.size() / n);
        for (std::size_t i = 0; i < items.size(); ++i)
            for (std::size_t k = 0; k < n; ++k)
                items[i][int(k)] = typename V::BaseType(numbers[n * i + k]);
        return items;
    }

    mutable std::vector<Entry> own_;
    std::shared_ptr<const ParameterList> defaults_; ///< newest first
    std::string colorSpace_ = "srgb";
    Place place_;
    mutable std::vector<std::string> asked_;
    mutable std::vector<Diagnostic> errors_;
};

} // namespace vitrine
