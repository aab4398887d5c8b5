#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Drives the simulated robot of launch/navigation.launch to goals, one after the other, and says how it went.

usage: drive.py [--goals N] [--seed S] [--timeout SECONDS]   random goals in areas, with a table at the end
       drive.py --door CLOSED_BY   one goal behind a door that is closed on the way: by 'tag' (said with
                                   ~set_door) or by 'wall' (only the laser sees it); a picture: --trace FILE.csv
"""
import argparse
import csv
import math
import random
import statistics
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from agrid_map.msg import BlockedDoors, TopologicalGraph
from agrid_map.srv import PlanPath, PlanPathRequest, SetDoor
from geometry_msgs.msg import Point32, PolygonStamped, Pose, PoseStamped
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal
from nav_msgs.msg import Odometry


class Drive:
    def __init__(self):
        self.trace = []
        self.goal = (0, 0)
        self.blocked = []
        while not rospy.get_time():
            rospy.rostime.wallsleep(0.05)
        self.graph = rospy.wait_for_message('agrid/graph', TopologicalGraph, 600)
        rospy.wait_for_service('agrid/plan_path')
        self.plan_path = rospy.ServiceProxy('agrid/plan_path', PlanPath)
        self.client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
        if not self.client.wait_for_server(rospy.Duration(600)):
            sys.exit('move_base does not answer')
        rospy.Subscriber('base_pose_ground_truth', Odometry, self.take_pose)
        rospy.Subscriber('move_base/AGridPlanner/blocked_doors', BlockedDoors, self.take_blocked)
        self.walls = rospy.Publisher('robot/walls', PolygonStamped, queue_size=1, latch=True)
        self.places = rospy.Publisher('robot/place', Pose, queue_size=1, latch=True)

    def take_pose(self, odom):
        at = odom.pose.pose.position
        if not self.trace or math.dist(self.trace[-1], (at.x, at.y)) > 0.02:
            self.trace.append((at.x, at.y))

    def take_blocked(self, message):
        if message.doors:
            self.blocked = [door.name for door in message.doors]

    def path_to(self, x, y):
        request = PlanPathRequest(start_from_robot=True, tolerance=0.5)
        request.goal.pose.position.x, request.goal.pose.position.y = x, y
        return self.plan_path(request)

    def start(self, x, y):
        goal = MoveBaseGoal(PoseStamped())
        goal.target_pose.header.frame_id = 'map'
        goal.target_pose.pose.position.x, goal.target_pose.pose.position.y = x, y
        goal.target_pose.pose.orientation.w = 1
        self.goal = (x, y)
        self.trace, self.blocked = self.trace[-1:], []
        self.client.send_goal(goal)

    def finish(self, timeout):
        """Whether it got there, and how far it drove."""
        if not self.client.wait_for_result(rospy.Duration(timeout)):
            self.client.cancel_goal()
            self.client.wait_for_result(rospy.Duration(5))
        driven = sum(math.dist(a, b) for a, b in zip(self.trace, self.trace[1:]))
        near = math.dist(self.trace[-1], self.goal) < 0.5  # whatever move_base says
        return near and self.client.get_state() == GoalStatus.SUCCEEDED, driven


    def place(self, at):
        pose = Pose(position=at)
        pose.orientation.w = 1
        self.places.publish(pose)
        rospy.sleep(5)  # until localization and costmaps have followed


def drive_goals(drive, options):
    chance = random.Random(options.seed)
    drive.place(max(drive.graph.areas, key=lambda area: area.size).anchor)
    done, ratios, seconds = 0, [], []
    for number in range(options.goals):
        area = chance.choice(drive.graph.areas)
        way = drive.path_to(area.anchor.x, area.anchor.y)
        began = rospy.get_time()
        drive.start(area.anchor.x, area.anchor.y)
        there, driven = drive.finish(options.timeout)
        done += there
        took = rospy.get_time() - began
        print('%d %s: %s, shortest %.1f m, driven %.1f m, %.0f s' %
              (number + 1, area.name, 'there' if there else 'NOT there', way.length, driven, took), flush=True)
        if there and way.length > 2:
            ratios.append(driven / way.length)
            seconds.append(took)
    print('%d of %d goals; driven / shortest: median %.3f, max %.3f; %.0f s of driving' %
          (done, options.goals, statistics.median(ratios), max(ratios), sum(seconds)))
    return 0 if done == options.goals else 1


def through_a_door(drive, options):
    """A goal that is reached without one of the doors on the shortest way, too: that door is closed."""
    for area in drive.graph.areas:
        way = drive.path_to(area.anchor.x, area.anchor.y)
        for door in [d for d in way.route.doors[1:] if d]:
            request = PlanPathRequest(start_from_robot=True, closed_doors=[door])
            request.goal.pose.position = area.anchor
            other = drive.plan_path(request)
            if not other.status.code and way.length > 8 and 1.1 * way.length < other.length < 2 * way.length:
                return area, way, other, next(d for d in drive.graph.doors if d.id == door)
    sys.exit('no door of this map can be gone around from here')


def drive_door(drive, options):
    area, way, other, door = through_a_door(drive, options)
    print('to %s: %.1f m; without %s %.1f m' % (area.name, way.length, door.name, other.length))
    drive.start(area.anchor.x, area.anchor.y)
    rospy.sleep(4)
    if options.door == 'tag':
        print(rospy.ServiceProxy('agrid/set_door', SetDoor)(door=str(door.id), state=2).status.message or 'closed by a tag')
    else:
        wall = PolygonStamped()
        wall.header.frame_id = 'map'
        wall.polygon.points = [Point32(jamb.x, jamb.y, 0) for jamb in door.jambs]
        drive.walls.publish(wall)
    there, driven = drive.finish(options.timeout)
    print('%s; driven %.1f m; said to be blocked: %s' %
          ('there' if there else 'NOT there', driven, ', '.join(drive.blocked) or 'none'))
    if options.trace:
        with open(options.trace, 'w', newline='') as file:
            rows = [('driven', *p) for p in drive.trace] + [('door', j.x, j.y) for j in door.jambs]
            rows += [('lead', p.pose.position.x, p.pose.position.y) for p in way.path.poses]
            csv.writer(file).writerows(rows)
    return 0 if there and driven > way.length else 1


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('--goals', type=int, default=10)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--timeout', type=float, default=300)
    parser.add_argument('--door', choices=['tag', 'wall'])
    parser.add_argument('--trace')
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node('drive', anonymous=True)
    drive = Drive()
    return drive_door(drive, options) if options.door else drive_goals(drive, options)


if __name__ == '__main__':
    sys.exit(main())
