#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A round robot that turns on the spot, in the world that the map shows and walls that the map does not.

Drives as `cmd_vel` says (and stops where it would touch a wall), sees the world by a laser all around.

subscribes  map (nav_msgs/OccupancyGrid), cmd_vel (geometry_msgs/Twist)
            ~walls (geometry_msgs/PolygonStamped: its sides, in the map's frame, are walls from now on;
            without points: those walls are gone)
            ~place (geometry_msgs/Pose: puts the robot there)
publishes   odom, base_pose_ground_truth (nav_msgs/Odometry), scan (sensor_msgs/LaserScan), TF odom -> base_link,
            clock where `speed` is not 0
parameters  ~x, ~y, ~yaw [m, rad] where it starts, ~radius [m], ~range of the laser [m],
            ~speed: how much faster than the clock on the wall time goes (needs use_sim_time); 0: the ROS clock
"""
import math
import threading

import numpy
import rospy
import tf2_ros
from geometry_msgs.msg import PolygonStamped, Pose, TransformStamped, Twist
from nav_msgs.msg import OccupancyGrid, Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan

STEP = 0.05  # [s]
SCAN_EVERY = 4  # steps
BEAMS = 180
FORGET = 0.6  # a command that is older counts no more [s]


class World:
    """What is in the way: pixels of the map and walls beside it."""

    def __init__(self, grid):
        info = grid.info
        self.resolution = info.resolution
        q = info.origin.orientation
        self.yaw = 2 * math.atan2(q.z, q.w) if q.z or q.w else 0.0
        self.origin = (info.origin.position.x, info.origin.position.y)
        data = numpy.array(grid.data, dtype=numpy.int8).reshape(info.height, info.width)
        self.map = data >= 65
        self.blocked = self.map.copy()

    def pixels(self, x, y):
        """Columns and rows of points of the map's frame, and which of them are on the map."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        dx, dy = x - self.origin[0], y - self.origin[1]
        column = numpy.floor((c * dx + s * dy) / self.resolution).astype(int)
        row = numpy.floor((-s * dx + c * dy) / self.resolution).astype(int)
        height, width = self.map.shape
        return column, row, (column >= 0) & (row >= 0) & (column < width) & (row < height)

    def is_blocked(self, x, y):
        column, row, inside = self.pixels(x, y)
        blocked = numpy.zeros(column.shape, dtype=bool)
        blocked[inside] = self.blocked[row[inside], column[inside]]
        return blocked

    def set_walls(self, corners):
        self.blocked = self.map.copy()
        for a, b in zip(corners, corners[1:] + corners[:1]):
            steps = int(math.dist(a, b) / self.resolution * 3) + 2
            column, row, inside = self.pixels(numpy.linspace(a[0], b[0], steps), numpy.linspace(a[1], b[1], steps))
            self.blocked[row[inside], column[inside]] = True

    def ranges(self, x, y, yaw, reach):
        """How far each beam of the laser goes."""
        distances = numpy.arange(self.resolution, reach, self.resolution * 0.7)
        angles = yaw + numpy.arange(BEAMS) * 2 * math.pi / BEAMS
        hit = self.is_blocked(x + numpy.outer(numpy.cos(angles), distances),
                              y + numpy.outer(numpy.sin(angles), distances))
        return numpy.where(hit.any(axis=1), distances[hit.argmax(axis=1)], math.inf)


class Robot:
    def __init__(self):
        self.lock = threading.Lock()
        self.pose = [rospy.get_param('~' + name, 0.0) for name in ('x', 'y', 'yaw')]
        self.radius = rospy.get_param('~radius', 0.2)
        self.reach = rospy.get_param('~range', 6.0)
        self.command = (0.0, 0.0)
        self.commanded = -math.inf
        self.now = 1.0
        self.speed = rospy.get_param('~speed', 0.0)
        self.world = None
        self.touched = 0  # steps in which it was stopped by a wall
        self.odom = rospy.Publisher('odom', Odometry, queue_size=10)
        self.truth = rospy.Publisher('base_pose_ground_truth', Odometry, queue_size=10)
        self.scan = rospy.Publisher('scan', LaserScan, queue_size=2)
        self.clock = rospy.Publisher('/clock', Clock, queue_size=1) if self.speed else None
        self.transforms = tf2_ros.TransformBroadcaster()
        rospy.Subscriber('map', OccupancyGrid, self.take_map, queue_size=1)
        rospy.Subscriber('cmd_vel', Twist, self.take_command, queue_size=1)
        rospy.Subscriber('~walls', PolygonStamped, self.take_walls, queue_size=1)
        rospy.Subscriber('~place', Pose, self.take_place, queue_size=1)

    def take_map(self, grid):
        with self.lock:
            self.world = World(grid)

    def take_command(self, twist):
        with self.lock:
            self.command = (twist.linear.x, twist.angular.z)
            self.commanded = self.now

    def take_walls(self, polygon):
        with self.lock:
            if self.world:
                self.world.set_walls([(p.x, p.y) for p in polygon.polygon.points])

    def take_place(self, pose):
        with self.lock:
            self.pose = [pose.position.x, pose.position.y, 2 * math.atan2(pose.orientation.z, pose.orientation.w)]
            self.command = (0.0, 0.0)

    def touches(self, x, y):
        around = numpy.arange(24) * 2 * math.pi / 24
        inside = 0.9 * self.radius
        return self.world.is_blocked(x + inside * numpy.cos(around), y + inside * numpy.sin(around)).any()

    def drive(self):
        """One step; where it would touch a wall, it only turns."""
        speed, turn = self.command if self.now - self.commanded < FORGET else (0.0, 0.0)
        x, y, yaw = self.pose
        ahead = yaw + turn * STEP / 2
        to = (x + speed * STEP * math.cos(ahead), y + speed * STEP * math.sin(ahead))
        if self.world and self.touches(*to) and not self.touches(x, y):
            self.touched += 1
            rospy.logwarn_throttle(5, 'stopped by a wall at (%.2f, %.2f)', x, y)
            to, speed = (x, y), 0.0
        self.pose = [to[0], to[1], yaw + turn * STEP]
        return speed, turn

    def publish(self, stamp, speed, turn):
        x, y, yaw = self.pose
        message = Odometry()
        message.header.stamp = stamp
        message.header.frame_id = 'odom'
        message.child_frame_id = 'base_link'
        message.pose.pose.position.x, message.pose.pose.position.y = x, y
        message.pose.pose.orientation.z, message.pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        message.twist.twist.linear.x, message.twist.twist.angular.z = speed, turn
        transform = TransformStamped()
        transform.header = message.header
        transform.child_frame_id = message.child_frame_id
        transform.transform.translation.x, transform.transform.translation.y = x, y
        transform.transform.rotation = message.pose.pose.orientation
        self.transforms.sendTransform(transform)
        self.odom.publish(message)
        self.truth.publish(message)

    def publish_scan(self, stamp):
        scan = LaserScan()
        scan.header.stamp = stamp
        scan.header.frame_id = 'base_link'
        scan.angle_max = 2 * math.pi * (BEAMS - 1) / BEAMS
        scan.angle_increment = 2 * math.pi / BEAMS
        scan.range_min, scan.range_max = 0.05, self.reach
        scan.ranges = self.world.ranges(*self.pose, self.reach).tolist()
        self.scan.publish(scan)

    def run(self):
        rate = rospy.Rate(1 / STEP) if not self.clock else None
        step = 0
        while not rospy.is_shutdown():
            began = rospy.get_rostime().to_sec() if rate else 0
            with self.lock:
                self.now = began if rate else self.now + STEP
                stamp = rospy.Time.from_sec(self.now)
                if self.clock:
                    self.clock.publish(Clock(stamp))
                self.publish(stamp, *self.drive())
                if self.world and step % SCAN_EVERY == 0:
                    self.publish_scan(stamp)
            step += 1
            if rate:
                rate.sleep()
            else:
                rospy.rostime.wallsleep(STEP / self.speed)


if __name__ == '__main__':
    rospy.init_node('robot', disable_rostime=rospy.get_param('/use_sim_time', False))
    Robot().run()
