// The B-spline surfaces of a STEP file by a parser that shares nothing with OpenCASCADE [ISO 10303-21].
#pragma once
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "knotfit/surface.h"
namespace knotfit::test {

class StepFile {
 public:
  /// \throws std::runtime_error  not what the witness understands
  explicit StepFile(const std::string& text) {
    std::size_t at = text.find("DATA;");
    if (at == std::string::npos) throw std::runtime_error("no DATA section");
    at += 5;
    std::string statement;
    bool quoted = false;
    for (; at < text.size(); ++at) {
      const char c = text[at];
      if (c == '\'') quoted = !quoted;
      if (c == '\n' || c == '\r' || (!quoted && (c == ' ' || c == '\t'))) continue;
      if (quoted || c != ';') {
        statement += c;
        continue;
      }
      if (statement == "ENDSEC") break;
      const std::size_t equal = statement.find('=');
      if (statement.empty() || statement[0] != '#' || equal == std::string::npos)
        throw std::runtime_error("no entity: " + statement);
      entities_[statement.substr(0, equal)] = statement.substr(equal + 1);
      statement.clear();
    }
  }

  std::vector<Surface> surfaces() const {
    std::vector<Surface> found;
    for (const auto& [id, entity] : entities_) {
      if (entity.starts_with("B_SPLINE_SURFACE_WITH_KNOTS(")) {
        const std::vector<std::string> a = arguments(entity, 0);
        found.push_back(surface(a, 1, a, 8));
      } else if (entity[0] == '(' && entity.find("B_SPLINE_SURFACE_WITH_KNOTS(") != std::string::npos) {
        if (entity.find("RATIONAL_B_SPLINE_SURFACE(") != std::string::npos)
          throw std::runtime_error("rational");
        found.push_back(surface(arguments(entity, entity.find("B_SPLINE_SURFACE(")), 0,
                                arguments(entity, entity.find("B_SPLINE_SURFACE_WITH_KNOTS(")), 0));
      }
    }
    return found;
  }

  /// Arguments of the only entity of a type, or of the first.
  std::vector<std::string> first(const std::string& type) const {
    for (const auto& [id, entity] : entities_)
      if (entity.starts_with(type + "(")) return arguments(entity, 0);
    throw std::runtime_error("no " + type);
  }
  int count(const std::string& type) const {
    int n = 0;
    for (const auto& [id, entity] : entities_) n += entity.starts_with(type + "(");
    return n;
  }
  /// "mm", "m" or "inch".
  std::string unit() const {
    for (const auto& [id, entity] : entities_) {
      if (entity.find("LENGTH_UNIT()") == std::string::npos) continue;
      if (entity.find("CONVERSION_BASED_UNIT('INCH'") != std::string::npos) return "inch";
    }
    for (const auto& [id, entity] : entities_) {
      if (entity.find("SI_UNIT(.MILLI.,.METRE.)") != std::string::npos) return "mm";
      if (entity.find("SI_UNIT($,.METRE.)") != std::string::npos) return "m";
    }
    throw std::runtime_error("no unit");
  }

  /// Top-level parts of "a,(b,c),'d,e'".
  static std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    std::string part;
    int depth = 0;
    bool quoted = false;
    for (const char c : list) {
      if (c == '\'') quoted = !quoted;
      if (!quoted && c == '(') ++depth;
      if (!quoted && c == ')') --depth;
      if (!quoted && depth == 0 && c == ',') {
        parts.push_back(part);
        part.clear();
      } else {
        part += c;
      }
    }
    parts.push_back(part);
    return parts;
  }

 private:
  static std::string inside(const std::string& list) {
    if (list.size() < 2 || list.front() != '(' || list.back() != ')')
      throw std::runtime_error("no list: " + list);
    return list.substr(1, list.size() - 2);
  }
  /// Of TYPE(...) that begins at `at`.
  static std::vector<std::string> arguments(const std::string& entity, std::size_t at) {
    const std::size_t open = entity.find('(', at);
    int depth = 0;
    bool quoted = false;
    for (std::size_t k = open; k < entity.size(); ++k) {
      if (entity[k] == '\'') quoted = !quoted;
      if (quoted) continue;
      if (entity[k] == '(') ++depth;
      if (entity[k] == ')' && --depth == 0) return split(entity.substr(open + 1, k - open - 1));
    }
    throw std::runtime_error("open: " + entity);
  }
  static double real(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size() || text.find('.') == std::string::npos)
      throw std::runtime_error("no real: " + text);  // the standard wants the point
    return value;
  }
  static KnotVector knots(int degree, const std::string& multiplicities, const std::string& values) {
    const auto m = split(inside(multiplicities)), k = split(inside(values));
    std::vector<double> flat;
    for (std::size_t i = 0; i < k.size(); ++i)
      flat.insert(flat.end(), static_cast<std::size_t>(std::stoi(m.at(i))), real(k[i]));
    return KnotVector(degree, std::move(flat));
  }
  Surface surface(const std::vector<std::string>& net, std::size_t n, const std::vector<std::string>& places,
                  std::size_t k) const {
    const int p = std::stoi(net.at(n)), q = std::stoi(net.at(n + 1));
    std::vector<double> points;
    for (const std::string& row : split(inside(net.at(n + 2))))
      for (const std::string& id : split(inside(row)))
        for (const std::string& x : split(inside(arguments(entities_.at(id), 0).at(1))))
          points.push_back(real(x));
    return Surface(knots(p, places.at(k), places.at(k + 2)), knots(q, places.at(k + 1), places.at(k + 3)), 3,
                   std::move(points));
  }

  std::map<std::string, std::string> entities_;
};

}  // namespace knotfit::test
