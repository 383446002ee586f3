"""Purpose: a coordinator that dies, or is started anew, loses nothing that it has accepted.

Topology, a private bridge; the journal is on a volume:

    discovery    coordinator, which dies    worker x 2    client
    -----+------------+-------------------------+------------+-----
"""

import composition


class CoordinatorRestarted(composition.Case):
    def setUp(self):
        super().setUp()
        self.up(workers=2)
        self.await_log("worker", "works for coordinator", times=2)
        (self.coordinator,) = self.containers("coordinator")
        self.submission = self.submit(composition.LONG)
        self.wait_until(self.solvers, "a worker has solved a task")

    def assert_plans_in_the_end(self):
        self.assert_ends_planned(composition.LONG, self.submission)
        self.await_well()

    def test_after_it_died_while_planning(self):
        self.crash(self.coordinator)
        self.assert_plans_in_the_end()
        self.assertEqual("1", self.inspect(self.coordinator, "{{.RestartCount}}"))

    def test_when_asked_to_while_planning(self):
        self.compose("restart", "coordinator")
        self.assert_plans_in_the_end()
        self.assertIn("ended", self.logs("coordinator"), "it was not killed")
