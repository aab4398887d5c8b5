// SPDX-License-Identifier: BSD-3-Clause
#include "place_list.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <map>
#include <utility>

namespace agrid_map_rviz {
namespace {

using agrid_map::Tag;
using agrid_map::TopologicalGraph;

constexpr int kPlaceRole = Qt::UserRole;

QString text(const std::string& s) { return QString::fromStdString(s); }

QString areaName(const TopologicalGraph& graph, std::uint32_t id) {
  return id == 0 ? PlaceList::tr("outside") : nameOf(graph, {Tag::AREA, id});
}

QString doorState(const agrid_map::Door& door) {
  QString state;
  if (door.state == agrid_map::Door::OPEN) state = PlaceList::tr("open");
  if (door.state == agrid_map::Door::CLOSED) state = PlaceList::tr("closed");
  const QString sure = PlaceList::tr("%1 % sure").arg(qRound(100 * door.confidence));
  return state.isEmpty() ? sure : state + ", " + sure;
}

QString reasonOf(const Tag& tag) {
  for (const auto& property : tag.properties) {
    if (property.key == "pending") return text(property.value);
  }
  return {};
}

}  // namespace

PlaceList::PlaceList(QWidget* parent) : QTreeWidget(parent) {
  setHeaderLabels({tr("Name"), tr("Category"), tr("State")});
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setUniformRowHeights(true);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  const QStringList titles = {tr("Areas"), tr("Doors"), tr("Objects"), tr("Waiting")};
  for (int i = 0; i < kGroups; ++i) {
    groups_[i] = new QTreeWidgetItem(this, {titles[i]});
    groups_[i]->setFlags(Qt::ItemIsEnabled);
    groups_[i]->setExpanded(true);
  }
  connect(this, &QTreeWidget::itemDoubleClicked, this, &PlaceList::editItemAt);
  connect(this, &QTreeWidget::itemChanged, this, &PlaceList::onItemChanged);
}

void PlaceList::show(const TopologicalGraph& graph) {
  std::vector<Row> rows[kGroups];
  for (const agrid_map::Area& area : graph.areas) {
    const bool guessed = area.category.empty() && !area.category_guess.empty();
    rows[kAreas].push_back(
        {{Tag::AREA, area.id},
         {text(area.name), text(area.category), tr("%1 m²").arg(area.size, 0, 'f', 1)},
         guessed ? tr("looks like a %1").arg(text(area.category_guess)) : ""});
  }
  for (const agrid_map::Door& door : graph.doors) {
    rows[kDoors].push_back(
        {{Tag::DOOR, door.id},
         {text(door.name), areaName(graph, door.areas[0]) + " – " + areaName(graph, door.areas[1]),
          doorState(door)},
         tr("%1 m wide").arg(door.width, 0, 'f', 2)});
  }
  for (const agrid_map::Object& object : graph.objects) {
    rows[kObjects].push_back(
        {{Tag::OBJECT, object.id},
         {text(object.name), text(object.category), areaName(graph, object.area)},
         {}});
  }
  for (const Tag& tag : graph.pending) {
    rows[kPending].push_back(
        {{tag.type, tag.id}, {text(tag.name), text(tag.category), reasonOf(tag)}, {}});
  }
  const QSignalBlocker quiet(this);  // what is filled in was not typed by anybody
  for (int i = 0; i < kGroups; ++i) fill(static_cast<Group>(i), rows[i]);
  groups_[kPending]->setHidden(rows[kPending].empty());
  search(searched_);
}

void PlaceList::fill(Group group, const std::vector<Row>& rows) {
  QTreeWidgetItem& parent = *groups_[group];
  std::map<std::pair<int, std::uint32_t>, QTreeWidgetItem*> known;
  for (int i = 0; i < parent.childCount(); ++i) {
    const Place place = placeOf(*parent.child(i));
    known[{place.type, place.id}] = parent.child(i);
  }
  for (const Row& row : rows) {
    const auto found = known.find({row.place.type, row.place.id});
    if (found == known.end()) {
      auto* item = new QTreeWidgetItem(&parent);
      item->setData(kName, kPlaceRole, row.place.id);
      item->setData(kCategory, kPlaceRole, row.place.type);
      // a waiting tag has no place yet that could be changed
      const Qt::ItemFlags editable = group == kPending ? Qt::NoItemFlags : Qt::ItemIsEditable;
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | editable);
      setRow(*item, row);
    } else {
      setRow(*found->second, row);
      known.erase(found);
    }
  }
  for (const auto& gone : known) delete gone.second;
  parent.setText(kState, QString::number(parent.childCount()));
}

void PlaceList::setRow(QTreeWidgetItem& item, const Row& row) {
  for (int i = 0; i < row.texts.size(); ++i) {
    if (item.text(i) != row.texts[i]) item.setText(i, row.texts[i]);
  }
  item.setToolTip(kName, row.hint);
}

void PlaceList::search(const QString& text) {
  searched_ = text;
  for (QTreeWidgetItem* group : groups_) {
    for (int i = 0; i < group->childCount(); ++i) {
      QTreeWidgetItem* item = group->child(i);
      bool found = text.isEmpty();
      for (int column = 0; column < columnCount(); ++column) {
        found = found || item->text(column).contains(text, Qt::CaseInsensitive);
      }
      item->setHidden(!found);
    }
  }
}

void PlaceList::editItemAt(QTreeWidgetItem* item, int column) {
  const bool writable =
      column == kName || (column == kCategory && placeOf(*item).type != Tag::DOOR);
  if (writable && (item->flags() & Qt::ItemIsEditable)) editItem(item, column);
}

void PlaceList::editSelected(Column column) {
  const QList<QTreeWidgetItem*> items = selectedItems();
  if (!items.isEmpty()) editItemAt(items.front(), column);
}

void PlaceList::onItemChanged(QTreeWidgetItem* item, int column) {
  const QString text = item->text(column).trimmed();
  if (column == kName) Q_EMIT renamed(placeOf(*item), text);
  if (column == kCategory) Q_EMIT categoryGiven(placeOf(*item), text);
}

Place PlaceList::placeOf(const QTreeWidgetItem& item) {
  return {static_cast<std::uint8_t>(item.data(kCategory, kPlaceRole).toUInt()),
          item.data(kName, kPlaceRole).toUInt()};
}

std::vector<Place> PlaceList::selectedPlaces() const {
  std::vector<Place> places;
  for (const QTreeWidgetItem* item : selectedItems()) places.push_back(placeOf(*item));
  return places;
}

}  // namespace agrid_map_rviz
