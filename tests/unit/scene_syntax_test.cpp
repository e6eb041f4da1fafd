// SPDX-License-Identifier: Apache-2.0
// Directives and parameters: what is read of them, and each fault with its place.
#include "scene/syntax.h"

#include <cmath>
#include <set>

#include "scene_test_support.h"

using namespace lobe;

namespace {

struct Parsed {
    std::unique_ptr<SourceFile> source;
    std::vector<Statement> statements;
};

Parsed parse(const std::string& text) {
    Parsed parsed{make_source("s.pbrt", text), {}};
    std::vector<std::string> warnings;
    parsed.statements = parse_statements(*parsed.source, false, warnings);
    return parsed;
}

Parameter parameter(const std::string& text) {
    return parse("Shape \"x\" " + text).statements.at(0).parameters.at(0);
}

std::string fault(const std::string& text) {
    try {
        parse(text);
    } catch (const Error& error) {
        return error.where().substr(7) + " " + error.what() + " | " + error.hint();
    }
    return "";
}

}  // namespace

TEST(Syntax, ReadsNumbersAsTheyAreWritten) {
    const Parameter p = parameter("\"float a\" [1e-7 .5 -0 +3 1.9e-015 5. 1e-400]");
    EXPECT_EQ(p.numbers, (std::vector<double>{1e-7, .5, 0, 3, 1.9e-15, 5, 0}));
    EXPECT_TRUE(std::signbit(p.numbers[2]));
}

TEST(Syntax, BracketsAreOptionalForOneValue) {
    EXPECT_EQ(parameter("\"integer a\" 3").numbers, std::vector<double>{3});
    EXPECT_EQ(parameter("\"string a\" \"b\"").strings, std::vector<std::string>{"b"});
    EXPECT_EQ(parameter("\"string a\" [\"b\" \"c\"]").strings.size(), 2u);
}

TEST(Syntax, ReadsEveryType) {
    using T = ParameterType;
    const std::vector<std::pair<std::string, T>> types{
        {"point", T::point3},    {"point3", T::point3},   {"vector", T::vector3},
        {"vector3", T::vector3}, {"normal", T::normal},   {"normal3", T::normal},
        {"rgb", T::rgb},         {"color", T::rgb},       {"xyz", T::xyz},
        {"float", T::number},    {"integer", T::integer}, {"blackbody", T::blackbody}};
    for (const auto& [name, type] : types)
        EXPECT_EQ(parameter("\"" + name + " a\" [1 2 3]").type, type) << name;
    EXPECT_EQ(parameter("\"point2 a\" [1 2]").type, T::point2);
    EXPECT_EQ(parameter("\"vector2 a\" [1 2]").type, T::vector2);
    EXPECT_EQ(parameter("\"spectrum a\" \"metal-Cu-eta\"").type, T::spectrum);
    EXPECT_EQ(parameter("\"texture a\" \"t\"").type, T::texture);
}

TEST(Syntax, ReadsBothFormsOfBool) {
    EXPECT_TRUE(parameter("\"bool a\" true").bare_boolean);
    EXPECT_FALSE(parameter("\"bool a\" [\"false\"]").bare_boolean);
    EXPECT_EQ(parameter("\"bool a\" [false]").strings[0], "false");
    EXPECT_EQ(fault("Shape \"x\" \"bool a\" 1"),
              "1:20 parameter \"a\" of type bool wants true or false, has the number 1 | ");
    EXPECT_EQ(fault("Shape \"x\" \"bool a\" \"yes\""),
              "1:20 parameter \"a\" of type bool wants true or false, has 'yes' | ");
}

TEST(Syntax, KnowsWhereAValueStands) {
    const Parsed parsed = parse("Shape \"x\" \"integer a\" [\n 1 2 # two\n 3 ]");
    EXPECT_EQ(to_string(place_of_value(parsed.statements[0].parameters[0], 2)), "s.pbrt:3:2");
    const Parsed one = parse("Shape \"x\" \"integer a\"  7");
    EXPECT_EQ(to_string(place_of_value(one.statements[0].parameters[0], 0)), "s.pbrt:1:24");
}

TEST(Syntax, CountsNumbers) {
    EXPECT_EQ(
        fault("Shape \"x\"\n\"rgb Kd\" [1 2]"),
        "2:1 parameter \"Kd\" of type rgb wants 3 numbers, has 2 | every value has 3 numbers");
    EXPECT_EQ(fault("Translate 1 2 Shape"), "1:1 Translate wants 3 numbers, has 2 | ");
    EXPECT_EQ(fault("Translate 1 2"), "1:1 Translate wants 3 numbers, has 2 | ");
    EXPECT_EQ(fault("Translate 1 2x 3"), "1:13 Translate wants finite numbers, has '2x' | ");
    EXPECT_EQ(fault("Transform [1 2 3]"), "1:1 Transform wants 16 numbers, has 3 | ");
    EXPECT_EQ(fault("Shape \"x\" \"float a\" []"),
              "1:11 parameter \"a\" of type float has no value | ");
}

TEST(Syntax, RefusesValuesOfTheWrongType) {
    EXPECT_EQ(fault("Shape \"x\" \"float a\" \"b\""),
              "1:21 parameter \"a\" of type float wants numbers, has the string 'b' | ");
    EXPECT_EQ(fault("Shape \"x\" \"string a\" 4"),
              "1:22 parameter \"a\" of type string wants strings, has the number 4 | ");
    EXPECT_EQ(fault("Shape \"x\" \"integer a\" [1 1.5]"),
              "1:26 parameter \"a\" of type integer wants whole numbers, has 1.5 | ");
    EXPECT_EQ(fault("Shape \"x\" \"float a\" [1 1,5]"),
              "1:24 '1,5' is not a value for parameter \"a\" of type float | ");
}

TEST(Syntax, RefusesNumbersThatAreNotFinite) {
    EXPECT_EQ(fault("Shape \"x\" \"point P\" [0 0 nan]"),
              "1:26 the number nan is not a number | "
              "an exporter may have divided by zero: mend or leave out the shape");
    EXPECT_EQ(fault("Shape \"x\" \"point P\" [0 -inf 0]"),
              "1:24 parameter \"P\" of type point has an infinite value | ");
    EXPECT_EQ(fault("Shape \"x\" \"float a\" 1e999"), "1:21 the number 1e999 is too large | ");
    EXPECT_EQ(fault("Scale 1 inf 1"), "1:9 Scale wants finite numbers, has 'inf' | ");
}

TEST(Syntax, NamesTheNearestDirectiveAndType) {
    EXPECT_EQ(fault("\n Shpae \"x\"").find("2:2 unknown directive 'Shpae' | did you mean 'Shape'?"),
              0u);
    EXPECT_EQ(fault("Shape \"x\" \"flaot a\" 1")
                  .find("1:11 unknown parameter type 'flaot' of parameter \"a\" | "
                        "did you mean 'float'? choose one of: float, integer"),
              0u);
}

TEST(Syntax, RefusesWhatIsNoSyntax) {
    EXPECT_EQ(fault("\"Shape\""), "1:1 a directive was expected, not 'Shape' | ");
    EXPECT_EQ(fault("Shape"), "1:1 Shape wants a quoted string | ");
    EXPECT_EQ(fault("Shape \"x\" \"float\" 1"),
              "1:11 'float' is not a parameter's type and name | write it like \"float radius\"");
    EXPECT_EQ(fault("Shape \"x\" \"float a\" [1 2"),
              "1:21 a list of values that does not end | close it with ]");
    EXPECT_EQ(fault("]"), "1:1 a directive was expected, not ']' | ");
}

TEST(Syntax, TokenisesEveryDirective) {
    const Parsed parsed = parse(
        "Accelerator \"bvh\" ActiveTransform All AreaLightSource \"a\" Attribute \"shape\" "
        "\"float r\" 1 AttributeBegin AttributeEnd Camera \"p\" ColorSpace \"srgb\" "
        "ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1] CoordSysTransform \"c\" "
        "CoordinateSystem \"c\" Film \"f\" Identity Import \"i\" Include \"i\" Integrator \"i\" "
        "LightSource \"l\" LookAt 1 2 3 4 5 6 7 8 9 MakeNamedMaterial \"m\" MakeNamedMedium \"m\" "
        "Material \"m\" MediumInterface \"a\" \"b\" MediumInterface \"a\" NamedMaterial \"m\" "
        "ObjectBegin \"o\" ObjectEnd ObjectInstance \"o\" Option \"bool x\" true "
        "PixelFilter \"box\" ReverseOrientation Rotate 1 2 3 4 Sampler \"s\" Scale 1 2 3 "
        "Shape \"s\" SurfaceIntegrator \"s\" Texture \"t\" \"float\" \"constant\" "
        "Transform 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 TransformBegin TransformEnd "
        "TransformTimes 0 1 Translate 1 2 3 WorldBegin WorldEnd");
    std::set<std::string> seen, names;
    for (const Statement& statement : parsed.statements) seen.insert(statement.name);
    for (const std::string& name : directive_names()) names.insert(name);
    for (const char* older : {"Renderer", "Volume", "VolumeIntegrator"}) names.erase(older);
    EXPECT_EQ(seen, names);
}
