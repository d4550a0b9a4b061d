#include "scene/plain_shapes.h"

#include "core/frame.h"
#include "lights/emission.h"
#include "scene/rewritten.h"

namespace vitrine {

namespace {

ShapeNode replaced(const ShapeNode& shape, const std::string& type, ParameterList parameters) {
    ShapeNode result = shape;
    result.type = type;
    // Of the old parameters only what every shape has.
    const auto common = [](const ParameterPtr& p) { return p->name == "alpha" ? p : nullptr; };
    result.parameters = rewritten(shape, common, std::move(parameters));
    return result;
}

template <class Vector>
void append(Parameter::Numbers& numbers, const Vector& v) {
    for (unsigned k = 0; k < Vector::dimensions(); ++k)
        numbers.push_back(double(v[int(k)]));
}

} // namespace

ShapeNode boxAsMesh(const ShapeNode& box) {
    const V3d low = box.parameters.getPoint3("pmin", V3d(-1, -1, -1));
    const V3d high = box.parameters.getPoint3("pmax", V3d(1, 1, 1));
    Parameter::Numbers p, n, uv;
    Parameter::Integers indices;
    for (int face = 0; face < 6; ++face) {
        const int axis = face % 3, uAxis = (axis + 1) % 3, vAxis = (axis + 2) % 3;
        const bool greater = face >= 3;
        V3d normal(0, 0, 0);
        normal[axis] = greater ? 1 : -1;
        const int first = 4 * face;
        for (const V2i& corner : {V2i(0, 0), V2i(1, 0), V2i(1, 1), V2i(0, 1)}) {
            V3d place;
            place[axis] = greater ? high[axis] : low[axis];
            place[uAxis] = (corner.x == 1) == greater ? high[uAxis] : low[uAxis];
            place[vAxis] = corner.y == 1 ? high[vAxis] : low[vAxis];
            append(p, place);
            append(n, normal);
            append(uv, corner);
        }
        for (const int k : {0, 1, 2, 0, 2, 3})
            indices.push_back(first + k);
    }
    return replaced(box, "trianglemesh",
                    {makeParameter(ParameterType::Integer, "indices", std::move(indices)),
                     makeParameter(ParameterType::Point3, "P", std::move(p)),
                     makeParameter(ParameterType::Normal, "N", std::move(n)),
                     makeParameter(ParameterType::Point2, "uv", std::move(uv))});
}

ShapeNode planeAsDisk(const ShapeNode& plane, const Box3d& seen) {
    constexpr double times = 1e4;
    if (plane.worldFromObject->isMoving()) throw SceneError(plane.place, "transformations that move cannot be written");
    const Transform& world = plane.worldFromObject->start;
    const V3d given = plane.parameters.getNormal("n", V3d(0, 1, 0));
    const auto on = plane.parameters.findPoint3("p");
    const double d = on ? given.dot(*on) : plane.parameters.getFloat("d", 0);
    const V3d onPlane = world.point(given * (d / given.length2()));
    const V3d n = world.normal(given).normalized();

    const double radius = seen.isEmpty() ? 0 : seen.size().length() / 2;
    const V3d middle = seen.isEmpty() ? onPlane : seen.center();
    const double height = n.dot(middle - onPlane);
    const V3d foot = middle - n * height;
    const double reach = radius + std::abs(height);

    // Made perpendicular in double: the frame is single precision.
    const V3d rough = toDouble(Frame(toFloat(n)).s);
    const V3d s = (rough - n * n.dot(rough)).normalized(), t = n.cross(s);
    auto placed = std::make_shared<MovingTransform>();
    placed->start = placed->end =
        Transform(M44d(s.x, s.y, s.z, 0, t.x, t.y, t.z, 0, n.x, n.y, n.z, 0, foot.x, foot.y, foot.z, 1));
    ShapeNode disk =
        replaced(plane, "disk",
                 {makeParameter(ParameterType::Float, "radius", Parameter::Numbers{times * (reach > 0 ? reach : 1)})});
    disk.worldFromObject = std::move(placed);
    disk.reverseOrientation = plane.reverseOrientation != world.swapsHandedness();
    return disk;
}

ShapeNode asPlyMesh(const ShapeNode& shape, const std::string& fileName) {
    return replaced(shape, "plymesh", {makeParameter(ParameterType::String, "filename", Parameter::Strings{fileName})});
}

Node powerAsScale(const Node& areaLight, double area) {
    const ParameterSet& p = areaLight.parameters;
    const double sides = p.getBool("twosided", false) ? 2 : 1;
    const double scale = emissionScale(p.getFloat("scale", 1), p.getFloat("power", -1), piD * sides * area);
    Node result = areaLight;
    result.parameters = rewritten(
        areaLight,
        [](const ParameterPtr& each) { return each->name == "power" || each->name == "scale" ? nullptr : each; },
        {makeParameter(ParameterType::Float, "scale", Parameter::Numbers{scale})});
    return result;
}

} // namespace vitrine
