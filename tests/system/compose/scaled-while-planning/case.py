"""Purpose: workers that come while a request is planned take part at once.

Topology, a private bridge:

    discovery    coordinator    worker x 1, then 4    client
    -----+------------+--------------+------------------+-----
"""

import composition


class ScaledWhilePlanning(composition.Case):
    def test_from_one_to_four(self):
        self.up(workers=1)
        self.await_log("worker", "works for coordinator")
        submissions = [self.submit(name) for name in SCENES]
        self.wait_until(self.solvers, "a worker has solved a task")
        self.compose("up", "--detach", "--no-build", "--no-recreate", "--scale", "worker=4")
        for name, submission in zip(SCENES, submissions):
            self.assert_ends_planned(name, submission)
        self.assertEqual(4, len(self.solvers()))


SCENES = (composition.LONG, "high-manipulator-4", "random-crossing-0300", "fleet-1000")
