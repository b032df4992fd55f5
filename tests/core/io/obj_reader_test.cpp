#include "core/io/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "tests/core/io/read_from_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

namespace stipple {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ReadResult read(const std::filesystem::path& path) {
  Progress progress;
  return readPoints(path, progress);
}

// A PNG of 2 x 2 pixels: red, green over blue, white.
void writeSmallPng(const std::filesystem::path& path) {
  const unsigned char pixels[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = 2;
  image.format = PNG_FORMAT_RGB;
  ASSERT_TRUE(png_image_write_to_file(&image, path.c_str(), 0, pixels, 0, nullptr));
}

TEST(ObjReader, VerticesPolygonsAndNegativeIndices) {
  const auto result =
      readFromText("a.obj",
                   "# comment\r\no thing\nv 0 0 0\nv 1 0 0 1.0\r\nv 1 1 \\\n 0\nv 0 1 0 # last\ng a\ns 1\n"
                   "f 1 2 3 4\nf -4/ -3// -1\n");
  EXPECT_THAT(result.points.positions(), ElementsAre(Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 0, 0),
                                                     Eigen::Vector3f(1, 1, 0), Eigen::Vector3f(0, 1, 0)));
  EXPECT_THAT(result.points.triangles(),
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 3}));
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(ObjReader, ABackslashMayBeTheLastCharacterOfTheFile) {
  const auto result = readFromText("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3 \\");
  EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(result.warnings, IsEmpty());
  EXPECT_EQ(readFromText("a.obj", "v 0 0 0\nv 1 0 0\\").points.size(), 2u);
}

TEST(ObjReader, NormalsAreTheMeanOfTheCornersThatShareAVertex) {
  const PointSet points = readFromText("a.obj",
                                       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 2\nvn 0 1 0\n"
                                       "f 1//1 2//1 3//1\nf 1//2 2//2 4//2\n")
                              .points;
  const float half = std::sqrt(0.5F);
  const auto normals = points.values<Eigen::Vector3f>("normal");
  EXPECT_LT((normals[0] - Eigen::Vector3f(0, half, half)).norm(), 1e-6);
  EXPECT_EQ(normals[2], Eigen::Vector3f(0, 0, 2));  // one normal is kept as it is
  EXPECT_EQ(normals[3], Eigen::Vector3f(0, 1, 0));
}

TEST(ObjReader, ColorsOfVertices) {
  const auto colors = [](const std::string& text) {
    const PointSet points = readFromText("a.obj", text).points;
    const auto values = points.values<Rgba8>("color");
    return std::vector<Rgba8>(values.begin(), values.end());
  };
  EXPECT_THAT(colors("v 0 0 0 1 0.2 0\nv 1 0 0 0 0 1\n"), ElementsAre(Rgba8{255, 51, 0}, Rgba8{0, 0, 255}));
  EXPECT_THAT(colors("v 0 0 0 255 51 0\nv 1 0 0 0 0 1\n"), ElementsAre(Rgba8{255, 51, 0}, Rgba8{0, 0, 1}));
}

TEST(ObjReader, ColorsOfTheTextureOfTheMaterial) {
  const TemporaryFolder folder;
  writeSmallPng(folder / "image.png");
  setContent(folder / "a.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd -s 1 1 1 image.png\n");
  // The centers of the pixels red, green and blue; the fourth point has no texture coordinate.
  setContent(folder / "a.obj",
             "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nvt 0.25 0.75\nvt 0.75 0.75\nvt 0.25 "
             "0.25\nusemtl paint\n"
             "f 1/1 2/2 3/3\n");
  const auto result = read(folder / "a.obj");
  EXPECT_THAT(result.points.values<Rgba8>("color"),
              ElementsAre(Rgba8{255, 0, 0}, Rgba8{0, 255, 0}, Rgba8{0, 0, 255}, Rgba8{255, 255, 255}));
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(ObjReader, NamesOfMaterialsAndTexturesMayHaveBlanks) {
  const TemporaryFolder folder;
  writeSmallPng(folder / "my image.png");
  setContent(folder / "my paints.mtl", "newmtl red paint\nmap_Kd -s 1 1 1 my image.png\n");
  setContent(folder / "a.obj",
             "mtllib my paints.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nusemtl red paint\n"
             "f 1/1 2/1 3/1\n");
  const auto result = read(folder / "a.obj");
  EXPECT_THAT(result.points.values<Rgba8>("color"), testing::Each(Rgba8{255, 0, 0}));
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(ObjReader, TextureBesideTheFileAndSamplingBetweenPixels) {
  const TemporaryFolder folder;
  writeSmallPng(folder / "a.png");
  setContent(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.75\nvt 0.5 0.5\nvt 1 0\nf 1/1 2/2 3/3\n");
  const auto result = read(folder / "a.obj");
  EXPECT_THAT(result.points.values<Rgba8>("color"),
              ElementsAre(Rgba8{128, 128, 0}, Rgba8{128, 128, 128}, Rgba8{255, 255, 255}));
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("a.png beside it")));
}

TEST(ObjReader, AMissingTextureIsAWarning) {
  const TemporaryFolder folder;
  setContent(folder / "a.mtl", "newmtl m\nmap_Kd gone.png\n");
  setContent(folder / "a.obj", "mtllib a.mtl\nmtllib other.mtl\nusemtl m\nv 0 0 0\nvt 0 0\nf 1/1 1/1 1/1\n");
  const auto result = read(folder / "a.obj");
  EXPECT_FALSE(result.points.has("color"));
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("gone.png"), HasSubstr("other.mtl")));
}

TEST(ObjReader, SpotHasTheColorsOfItsTexture) {
  STIPPLE_NEEDS_TEST_DATA();
  const auto result = read(testData("cc0/spot/spot_triangulated.obj"));
  EXPECT_EQ(result.points.size(), 2930u);
  EXPECT_EQ(result.points.triangles().size(), 5856u);
  EXPECT_TRUE(result.points.has("color"));
}

TEST(ObjReader, BadStatementsAreNamedAndBadFacesIgnored) {
  EXPECT_EQ(errorOfText("a.obj", "v 0 0 0\nv 1 up 0\n"), "a.obj: line 2: 'up' is not a number");
  EXPECT_EQ(errorOfText("a.obj", "v 0 0 0\nv 1 2\n"), "a.obj: line 2 has 2 numbers, expected 3");
  EXPECT_THAT(errorOfText("a.obj", "f 1 2 3\n"), HasSubstr("0 points"));
  const auto result =
      readFromText("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\nf a b c\nf 0 1 2\nf -9 1 2\nf 1 2 3\n");
  EXPECT_THAT(result.points.triangles(), ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("3 faces"), HasSubstr("1 triangles name points")));
}

TEST(ObjReader, RealFilesHaveTheStatedCounts) {
  STIPPLE_NEEDS_TEST_DATA();
  const struct {
    const char* name;
    Index points;
    std::size_t triangles;
    bool normals;
  } kFiles[] = {{"smooth/armadillo_43k.obj", 43243, 86482, false},
                {"smooth/head_face_open.obj", 25905, 51712, false},
                {"cad/rocker-arm.obj", 10044, 20088, false},
                {"open/mountain_25k.obj", 25600, 50562, false},
                {"open/lionstatue_31k.obj", 31825, 63338, false},
                {"cc0/spot_oded/spot_11k.obj", 11533, 23062, true},
                {"cc0/nefertiti/nefertiti-lowres.obj", 35002, 70000, false},
                {"cc0/fish/fish.obj", 10786, 21568, false},
                {"cc0/spot/spot_quadrangulated.obj", 2930, 5856, false},
                {"cc0/spot/spot_control_mesh.obj", 188, 372, false}};
  for (const auto& file : kFiles) {
    const PointSet points = read(testData(file.name)).points;
    EXPECT_EQ(points.size(), file.points) << file.name;
    EXPECT_EQ(points.triangles().size(), file.triangles) << file.name;
    EXPECT_EQ(points.has("normal"), file.normals) << file.name;
  }
}

}  // namespace
}  // namespace stipple
