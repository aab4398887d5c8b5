#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sends move_base to what has a name: an area, an object, the nearest thing of a category.

usage: rosrun agrid_map go_to.py NAME   (parameters ~nodelet: agrid, ~anchor: true, to the middle of an area)

The nodelet's ~plan_path says where that is for this robot: an area's anchor (or its nearest place), a free
place beside an object, facing it. Ends with 0 if the robot got there.
"""
import sys
import time

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from agrid_map.msg import Status
from agrid_map.srv import PlanPath, PlanPathRequest
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

LONGEST_START = 60  # [s] of real time, until there is a map and the robot's pose
NOT_YET = (Status.NO_MAP, Status.NO_TRANSFORM)


def ask(service, request):
    """The answer, as soon as everything that was started together is there."""
    deadline = time.monotonic() + LONGEST_START
    rospy.wait_for_service(service, 10)
    while True:
        answer = rospy.ServiceProxy(service, PlanPath)(request)
        if answer.status.code not in NOT_YET or time.monotonic() > deadline or rospy.is_shutdown():
            return answer
        time.sleep(0.5)


def main():
    rospy.init_node('go_to', anonymous=True)
    arguments = rospy.myargv()[1:]
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 64
    nodelet = rospy.get_param('~nodelet', 'agrid')
    while not rospy.get_time():  # simulated time has to begin before anything can be waited for
        rospy.rostime.wallsleep(0.05)
    request = PlanPathRequest(start_from_robot=True, goal_name=arguments[0],
                              goal_at_anchor=rospy.get_param('~anchor', True), tolerance=0.5)
    answer = ask(nodelet + '/plan_path', request)
    if answer.status.code:
        print('no way to %s: %s' % (arguments[0], answer.status.message), file=sys.stderr)
        return 1
    goal = MoveBaseGoal()
    goal.target_pose = answer.path.poses[-1]
    goal.target_pose.header.stamp = rospy.Time.now()
    client = actionlib.SimpleActionClient('move_base', MoveBaseAction)
    if not client.wait_for_server(rospy.Duration(10)):
        print('move_base does not answer', file=sys.stderr)
        return 1
    rospy.on_shutdown(client.cancel_all_goals)
    print('%s: %.1f m by %s' % (arguments[0], answer.length, ', '.join(answer.route.names)))
    client.send_goal_and_wait(goal)
    print(client.get_goal_status_text())
    return 0 if client.get_state() == GoalStatus.SUCCEEDED else 1


if __name__ == '__main__':
    sys.exit(main())
