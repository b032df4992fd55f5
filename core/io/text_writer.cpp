#include "core/io/text_writer.h"

#include <fmt/format.h>

#include <set>
#include <variant>

#include "core/io/losses.h"
#include "core/io/point_lines.h"
#include "core/io/row_blocks.h"
#include "core/io/text_columns.h"

namespace stipple {

namespace {

// Writes the columns of the attributes in the order given.
void writeRows(OutputFile& file, const PointSet& points, std::span<const Attribute* const> attributes,
               char separator, Progress& progress) {
  TextBuffer text;
  PointLines lines(points, text, separator);
  RowBlocks(file, points.size(), progress).writeLines(points.size(), text, [&](std::size_t row) {
    lines.appendPosition(row);
    for (const Attribute* attribute : attributes) {
      std::visit(
          [&](const auto& column) {
            using Value = typename std::decay_t<decltype(column)>::value_type;
            if constexpr (std::is_same_v<Value, Eigen::Vector3f>)
              lines.appendVector(column[row]);
            else if constexpr (std::is_same_v<Value, Rgba8>)
              lines.appendBytes(column[row]);
            else
              text.append(separator).append(column[row]);
          },
          attribute->column.values());
    }
    text.append('\n');
  });
}

// What readers would take for a separator or a quote becomes a line.
std::string withoutBlanks(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ';' || c == '"') c = '_';
  }
  return name;
}

std::vector<std::string> columnNames(const Attribute& attribute) {
  const std::string name = withoutBlanks(attribute.name);
  if (attribute.type() == AttributeType::kColor) {
    const std::string prefix = attribute.name == "color" ? "" : name + "_";
    return {prefix + "red", prefix + "green", prefix + "blue"};
  }
  if (attribute.type() != AttributeType::kVector3) return {name};
  if (attribute.name == "normal") return {"nx", "ny", "nz"};
  return {name + "_x", name + "_y", name + "_z"};
}

std::vector<std::string> writeNamed(OutputFile& file, const PointSet& points, std::string_view begin,
                                    char separator, Progress& progress) {
  std::vector<const Attribute*> attributes;
  std::vector<std::string> losses;
  std::string header = fmt::format("{}x{}y{}z", begin, separator, separator);
  std::set<std::string> usedNames = {"x", "y", "z"};
  for (const Attribute& attribute : points.attributes()) {
    attributes.push_back(&attribute);
    for (const std::string& wanted : columnNames(attribute)) {
      std::string name = wanted;
      while (!usedNames.insert(canonicalColumnName(name)).second) name += '_';
      if (name != wanted) {
        losses.push_back(fmt::format("column '{}' is written as '{}', the name is taken", wanted, name));
      }
      header += separator + name;
    }
  }
  file.write(header + '\n');
  writeRows(file, points, attributes, separator, progress);
  if (!points.triangles().empty()) {
    losses.push_back(fmt::format("{} triangles cannot be held by this format and are left out",
                                 points.triangles().size()));
  }
  return losses;
}

// The attributes of these names that are there, in this order.
std::vector<const Attribute*> present(std::initializer_list<const Attribute*> attributes) {
  std::vector<const Attribute*> found;
  for (const Attribute* attribute : attributes) {
    if (attribute) found.push_back(attribute);
  }
  return found;
}

}  // namespace

std::vector<std::string> writeXyz(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  writeRows(file, points,
            present({findOfType(points, "color", AttributeType::kColor),
                     findOfType(points, "normal", AttributeType::kVector3)}),
            ' ', progress);
  return lossesOf(points, {.attributes = {"color", "normal"}});
}

std::vector<std::string> writePwn(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  writeRows(file, points, present({findOfType(points, "normal", AttributeType::kVector3)}), ' ', progress);
  return lossesOf(points, {.attributes = {"normal"}});
}

std::vector<std::string> writePts(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  file.write(fmt::format("{}\n", points.size()));
  const Attribute* intensity = points.find("intensity");
  if (intensity &&
      (intensity->type() == AttributeType::kVector3 || intensity->type() == AttributeType::kColor)) {
    intensity = nullptr;
  }
  writeRows(file, points, present({intensity, findOfType(points, "color", AttributeType::kColor)}), ' ',
            progress);
  return lossesOf(points, {.attributes = {"intensity", "color"}});
}

std::vector<std::string> writeTable(OutputFile& file, const PointSet& points, const WriteOptions&,
                                    Progress& progress) {
  return writeNamed(file, points, "# ", ' ', progress);
}

std::vector<std::string> writeCsv(OutputFile& file, const PointSet& points, const WriteOptions&,
                                  Progress& progress) {
  return writeNamed(file, points, "", ',', progress);
}

}  // namespace stipple
