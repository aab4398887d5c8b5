// SPDX-License-Identifier: BSD-3-Clause
#include "layers.h"

#include <atomic>

#include <OgreHardwarePixelBuffer.h>
#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <OgreTextureUnitState.h>
#include <rviz/ogre_helpers/movable_text.h>

namespace agrid_map_rviz {
namespace {

const Ogre::String kGroup = Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;

/// Ogre's resources need names that nothing else has.
std::string uniqueName(const char* kind) {
  static std::atomic<unsigned> count{0};
  return std::string("agrid_map/") + kind + std::to_string(count++);
}

/// Unlit, seen from both sides, laid over what is below it.
Ogre::MaterialPtr makeMaterial() {
  Ogre::MaterialPtr material =
      Ogre::MaterialManager::getSingleton().create(uniqueName("material"), kGroup);
  material->setReceiveShadows(false);
  material->setLightingEnabled(false);
  material->setCullingMode(Ogre::CULL_NONE);
  material->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  material->setDepthWriteEnabled(false);
  return material;
}

Ogre::ManualObject* makeObject(Ogre::SceneNode& node, int level) {
  Ogre::ManualObject* object = node.getCreator()->createManualObject(uniqueName("object"));
  // transparent faces at nearly the same distance would be drawn in any order
  object->setRenderQueueGroupAndPriority(Ogre::RENDER_QUEUE_6, static_cast<Ogre::ushort>(level));
  node.attachObject(object);
  return object;
}

void addVertices(Ogre::ManualObject& object, const std::vector<Mesh::Vertex>& vertices,
                 const Ogre::MaterialPtr& material, Ogre::RenderOperation::OperationType type,
                 float height) {
  if (vertices.empty()) return;
  object.estimateVertexCount(vertices.size());
  object.begin(material->getName(), type, kGroup);
  for (const Mesh::Vertex& vertex : vertices) {
    object.position(vertex.x, vertex.y, height);
    object.colour(vertex.color.r, vertex.color.g, vertex.color.b, vertex.color.a);
  }
  object.end();
}

}  // namespace

ShapeLayer::ShapeLayer(const Stack& stack)
    : node_(stack.parent->createChildSceneNode()),
      object_(makeObject(*node_, stack.level)),
      material_(makeMaterial()),
      height_(stack.height()) {}

ShapeLayer::~ShapeLayer() {
  Ogre::SceneManager* scene = node_->getCreator();
  scene->destroyManualObject(object_);
  scene->destroySceneNode(node_);
  Ogre::MaterialManager::getSingleton().remove(material_->getName());
}

void ShapeLayer::show(const Mesh& mesh) {
  object_->clear();
  addVertices(*object_, mesh.triangles, material_, Ogre::RenderOperation::OT_TRIANGLE_LIST,
              height_);
  addVertices(*object_, mesh.lines, material_, Ogre::RenderOperation::OT_LINE_LIST, height_);
}

void ShapeLayer::setVisible(bool visible) { node_->setVisible(visible); }

AreaLayer::AreaLayer(const Stack& stack)
    : node_(stack.parent->createChildSceneNode()),
      object_(makeObject(*node_, stack.level)),
      material_(makeMaterial()),
      height_(stack.height()) {}

AreaLayer::~AreaLayer() {
  Ogre::SceneManager* scene = node_->getCreator();
  scene->destroyManualObject(object_);
  scene->destroySceneNode(node_);
  Ogre::MaterialManager::getSingleton().remove(material_->getName());
  if (!texture_.empty()) Ogre::TextureManager::getSingleton().remove(texture_);
}

void AreaLayer::setTexture(const AreaPicture& picture) {
  Ogre::TextureManager& textures = Ogre::TextureManager::getSingleton();
  if (!texture_.empty()) textures.remove(texture_);
  texture_ = uniqueName("texture");
  const Ogre::TexturePtr texture = textures.createManual(
      texture_, kGroup, Ogre::TEX_TYPE_2D, picture.width, picture.height, 0, Ogre::PF_BYTE_RGBA);
  // Ogre only reads from it
  auto* texels = const_cast<std::uint8_t*>(picture.rgba.data());
  texture->getBuffer()->blitFromMemory(
      Ogre::PixelBox(picture.width, picture.height, 1, Ogre::PF_BYTE_RGBA, texels));
}

void AreaLayer::show(const AreaPicture& picture) {
  object_->clear();
  if (picture.width == 0) return;
  setTexture(picture);
  Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
  if (pass->getNumTextureUnitStates() == 0) pass->createTextureUnitState();
  Ogre::TextureUnitState* unit = pass->getTextureUnitState(0);
  unit->setTextureName(texture_);
  unit->setTextureFiltering(Ogre::TFO_NONE);
  unit->setTextureAddressingMode(Ogre::TextureUnitState::TAM_CLAMP);
  object_->begin(material_->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST, kGroup);
  for (const int corner : {0, 1, 3, 0, 3, 2}) {
    const bool right = corner % 2 == 1;
    const bool high = corner >= 2;
    object_->position(static_cast<float>(right ? picture.right : picture.left),
                      static_cast<float>(high ? picture.high : picture.low), height_);
    object_->textureCoord(right ? 1.0F : 0.0F, high ? 1.0F : 0.0F);
  }
  object_->end();
}

void AreaLayer::setAlpha(float alpha) {
  Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
  if (pass->getNumTextureUnitStates() == 0) pass->createTextureUnitState();
  pass->getTextureUnitState(0)->setAlphaOperation(Ogre::LBX_MODULATE, Ogre::LBS_TEXTURE,
                                                  Ogre::LBS_MANUAL, 1, alpha);
}

void AreaLayer::setVisible(bool visible) { node_->setVisible(visible); }

NameLayer::NameLayer(const Stack& stack)
    : node_(stack.parent->createChildSceneNode()), height_(stack.height()) {}

NameLayer::~NameLayer() {
  clear();
  node_->getCreator()->destroySceneNode(node_);
}

void NameLayer::clear() {
  node_->removeAndDestroyAllChildren();
  texts_.clear();
}

void NameLayer::show(const std::vector<Name>& names) {
  clear();
  for (const Name& name : names) {
    if (name.text.empty()) continue;
    const Color& c = name.color;
    auto text = std::make_unique<rviz::MovableText>(name.text, "Liberation Sans", name.size,
                                                    Ogre::ColourValue(c.r, c.g, c.b, c.a));
    text->setTextAlignment(rviz::MovableText::H_CENTER, rviz::MovableText::V_ABOVE);
    text->setRenderQueueGroup(Ogre::RENDER_QUEUE_7);
    const Ogre::Vector3 place(static_cast<float>(name.x), static_cast<float>(name.y), height_);
    node_->createChildSceneNode(place)->attachObject(text.get());
    texts_.push_back(std::move(text));
  }
}

void NameLayer::setVisible(bool visible) { node_->setVisible(visible); }

}  // namespace agrid_map_rviz
