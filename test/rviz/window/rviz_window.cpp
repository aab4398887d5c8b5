// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_window.h"

#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>

#include <OgreCamera.h>
#include <OgreRenderWindow.h>
#include <OgreViewport.h>
#include <ros/package.h>
#include <rviz/geometry.h>
#include <rviz/tool_manager.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

namespace agrid_map_rviz::test {

rviz::VisualizationFrame* RvizWindow::frame_ = nullptr;

void RvizWindow::open() {
  frame_ = new rviz::VisualizationFrame;
  frame_->setApp(qApp);
  frame_->setSplashPath("");
  frame_->initialize(
      QString::fromStdString(ros::package::getPath("agrid_map") + "/rviz/agrid.rviz"));
  frame_->show();
}

void RvizWindow::close() {
  delete frame_;
  frame_ = nullptr;
}

void RvizWindow::SetUp() {
  useTwoRooms();
  for (const std::uint8_t type : {agrid_map::Tag::AREA, agrid_map::Tag::OBJECT}) {
    for (const agrid_map::Tag& tag : given(type)) {
      agrid_map::RemoveTag::Request request;
      request.type = type;
      request.id = tag.id;
      ask<agrid_map::RemoveTag>("agrid/remove_tag", request);
    }
  }
  const auto expected = now();
  ASSERT_TRUE(comesTrue([&] {
    std::size_t shown = 0;
    for (const agrid_map::Area& area : expected.areas) {
      shown += line(QString::fromStdString(area.name)) != nullptr;
    }
    return shown == 3;
  }));
  list()->clearSelection();
  // the whole map in the middle of the view
  auto* controller = frame_->getManager()->getViewManager()->getCurrent();
  controller->subProp("X")->setValue(8.5);
  controller->subProp("Y")->setValue(3.5);
  controller->subProp("Scale")->setValue(30);
  QTest::qWait(100);
}

bool RvizWindow::comesTrue(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 10000);
}

QTreeWidget* RvizWindow::list() {
  for (QTreeWidget* tree : frame_->findChildren<QTreeWidget*>()) {
    if (tree->headerItem()->text(1) == "Category") return tree;
  }
  throw std::runtime_error("there is no list of places");
}

void RvizWindow::press(const char* button) {
  auto* widget = RvizWindow::widget<QPushButton>(button);
  ASSERT_TRUE(comesTrue([&] { return widget->isEnabled(); })) << button;
  QTest::mouseClick(widget, Qt::LeftButton);
}

QTreeWidgetItem* RvizWindow::line(const QString& name) {
  const auto lines = list()->findItems(name, Qt::MatchExactly | Qt::MatchRecursive, 0);
  return lines.isEmpty() ? nullptr : lines.front();
}

void RvizWindow::choose(const std::vector<QString>& names) {
  Qt::KeyboardModifiers keys = Qt::NoModifier;
  for (const QString& name : names) {
    ASSERT_NE(line(name), nullptr) << name.toStdString();
    list()->scrollToItem(line(name));
    const QPoint at = list()->visualItemRect(line(name)).center();
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, keys,
                      {10 + list()->indentation() * 2, at.y()});
    keys = Qt::ControlModifier;
  }
}

void RvizWindow::type(const QString& text) {
  auto* editor = list()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  editor->selectAll();
  QTest::keyClicks(editor, text);
  QTest::keyClick(editor, Qt::Key_Return);
}

QString RvizWindow::answer() { return widget<QLabel>("answer")->text(); }

rviz::Tool* RvizWindow::tool(const QString& class_id) {
  rviz::ToolManager& tools = *frame_->getManager()->getToolManager();
  for (int i = 0; i < tools.numTools(); ++i) {
    if (tools.getTool(i)->getClassId() == class_id) return tools.getTool(i);
  }
  throw std::runtime_error("no tool " + class_id.toStdString());
}

QPoint RvizWindow::pixelOf(double x, double y) {
  const Ogre::Vector2 at = rviz::project3DPointToViewportXY(
      view()->getViewport(), {static_cast<float>(x), static_cast<float>(y), 0});
  return {static_cast<int>(at.x), static_cast<int>(at.y)};
}

void RvizWindow::click(double x, double y) {
  QTest::mouseMove(view(), pixelOf(x, y));
  QTest::mouseClick(view(), Qt::LeftButton, {}, pixelOf(x, y));
}

void RvizWindow::drag(double x1, double y1, double x2, double y2) {
  QTest::mousePress(view(), Qt::LeftButton, {}, pixelOf(x1, y1));
  QMouseEvent half_way(QEvent::MouseMove, pixelOf((x1 + x2) / 2, (y1 + y2) / 2), Qt::NoButton,
                       Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(view(), &half_way);
  QTest::qWait(50);
  QTest::mouseRelease(view(), Qt::LeftButton, {}, pixelOf(x2, y2));
}

QImage RvizWindow::picture() {
  QTest::qWait(200);
  view()->getViewport()->getTarget()->update();
  return qApp->primaryScreen()->grabWindow(view()->winId()).toImage();
}

std::vector<agrid_map::Tag> RvizWindow::given(std::uint8_t type) {
  agrid_map::ListTags::Request request;
  request.type = type;
  std::vector<agrid_map::Tag> tags;
  for (const auto& tag : ask<agrid_map::ListTags>("agrid/list_tags", request).tags) {
    if (tag.source != agrid_map::Tag::AUTOMATIC) tags.push_back(tag);
  }
  return tags;
}

QString RvizWindow::areaAt(double x, double y) {
  const std::uint32_t id = NodeletClient::areaAt(x, y);
  for (const agrid_map::Area& area : now().areas) {
    if (area.id == id) return QString::fromStdString(area.name);
  }
  return {};
}

bool RvizWindow::becomesCalled(double x, double y, const QString& name) {
  return comesTrue([&] { return areaAt(x, y) == name; });
}

bool RvizWindow::areasBecome(std::size_t count) {
  return comesTrue([&] { return now().areas.size() == count; });
}

}  // namespace agrid_map_rviz::test
