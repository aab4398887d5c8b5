// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTreeWidget>
#include <optional>
#include <vector>

#ifndef Q_MOC_RUN
#include <agrid_map/TopologicalGraph.h>

#include "places.h"
#endif

namespace agrid_map_rviz {

/// The areas, doors and objects of a graph, and what waits, as a tree that can be searched. Follows
/// each new graph in place: what is selected, open or being typed stays so.
class PlaceList : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { kName, kCategory, kState };

  explicit PlaceList(QWidget* parent = nullptr);

  void show(const agrid_map::TopologicalGraph& graph);
  /// Hides what bears the text nowhere in its line, whatever the case.
  void search(const QString& text);
  /// Opens the editor on the first selected place, for a column that people can write.
  void editSelected(Column column);
  std::vector<Place> selectedPlaces() const;

 Q_SIGNALS:
  void renamed(const Place& place, const QString& name);
  void categoryGiven(const Place& place, const QString& category);

 private:
  struct Row {
    Place place;
    QStringList texts;
    QString hint;
  };
  enum Group { kAreas, kDoors, kObjects, kPending, kGroups };

  void fill(Group group, const std::vector<Row>& rows);
  void setRow(QTreeWidgetItem& item, const Row& row);
  void editItemAt(QTreeWidgetItem* item, int column);
  void onItemChanged(QTreeWidgetItem* item, int column);
  static Place placeOf(const QTreeWidgetItem& item);

  QTreeWidgetItem* groups_[kGroups];
  QString searched_;
};

}  // namespace agrid_map_rviz
