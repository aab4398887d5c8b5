// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <vector>

#ifndef Q_MOC_RUN
#include <ros/ros.h>
#include <rviz/panel.h>
#endif

#include "edit_session.h"
#include "place_list.h"

namespace agrid_map_rviz {

/// RViz panel: what the map holds as a list that can be searched, and what can be done with it.
/// Saved with the configuration: `Node`, the nodelet's name, and `Goal Topic`, where a goal of
/// 'Go to' is published as geometry_msgs/PoseStamped.
class PlacesPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit PlacesPanel(QWidget* parent = nullptr);

  void onInitialize() override;
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  /// What becomes of the next path that is planned.
  enum class Wish { kPlan, kGo };

  QPushButton* addButton(const QString& text, const QString& name, const QString& hint);
  void makeButtons();
  void lay();
  void useNode();
  void useGoalTopic();
  void updateButtons();
  void showGraph();
  void showAnswer(bool success, const QString& sentence);

  void setDoorState(std::uint8_t state);
  void split();
  void join();
  void removeSelected();
  void plan(Wish wish);
  void planRoutes();
  void showPath(const agrid_map::PlanPath::Response& response);
  void showRoutes(const agrid_map::PlanAreas::Response& response);
  QString called(const Place& place) const;

  QLineEdit* node_;
  QLineEdit* goal_topic_;
  QLineEdit* search_;
  PlaceList* list_;
  QComboBox* start_;
  QListWidget* routes_;
  QLabel* answer_;
  QPushButton *rename_, *category_, *open_, *close_, *split_, *join_, *remove_, *go_, *plan_,
      *alternatives_, *undo_;
  QPointer<EditSession> session_;
  ros::Publisher goal_publisher_;
  Wish wish_ = Wish::kPlan;
  std::vector<agrid_map::Route> ways_;  ///< the lines of routes_
};

}  // namespace agrid_map_rviz
