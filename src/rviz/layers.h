// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <OgreMaterial.h>

#include "area_picture.h"
#include "mesh.h"

namespace Ogre {
class ManualObject;
class SceneManager;
class SceneNode;
}  // namespace Ogre
namespace rviz {
class MovableText;
}

namespace agrid_map_rviz {

/// What the layers of a map are stacked by: a higher one is drawn over a lower one.
struct Stack {
  Ogre::SceneNode* parent;
  int level;
  float height() const { return 0.01F * static_cast<float>(level); }
};

/// Flat shapes as one object of the scene.
class ShapeLayer {
 public:
  explicit ShapeLayer(const Stack& stack);
  ~ShapeLayer();
  ShapeLayer(const ShapeLayer&) = delete;
  ShapeLayer& operator=(const ShapeLayer&) = delete;

  void show(const Mesh& mesh);
  void setVisible(bool visible);

 private:
  Ogre::SceneNode* node_;
  Ogre::ManualObject* object_;
  Ogre::MaterialPtr material_;
  float height_;
};

/// The areas' picture as a texture on one face.
class AreaLayer {
 public:
  explicit AreaLayer(const Stack& stack);
  ~AreaLayer();
  AreaLayer(const AreaLayer&) = delete;
  AreaLayer& operator=(const AreaLayer&) = delete;

  void show(const AreaPicture& picture);
  void setAlpha(float alpha);
  void setVisible(bool visible);

 private:
  void setTexture(const AreaPicture& picture);

  Ogre::SceneNode* node_;
  Ogre::ManualObject* object_;
  Ogre::MaterialPtr material_;
  std::string texture_;  ///< its name; empty: none yet
  float height_;
};

/// Names that face the viewer.
class NameLayer {
 public:
  struct Name {
    std::string text;
    double x, y;
    float size;  ///< [m]
    Color color;
  };

  explicit NameLayer(const Stack& stack);
  ~NameLayer();
  NameLayer(const NameLayer&) = delete;
  NameLayer& operator=(const NameLayer&) = delete;

  void show(const std::vector<Name>& names);
  void setVisible(bool visible);

 private:
  void clear();

  Ogre::SceneNode* node_;
  std::vector<std::unique_ptr<rviz::MovableText>> texts_;
  float height_;
};

}  // namespace agrid_map_rviz
