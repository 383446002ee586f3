"""Purpose: a worker that dies while it plans costs time, not the plan, and is replaced.

Topology, a private bridge:

    discovery    coordinator    worker x 2, one of which dies    client
    -----+------------+--------------+-----------------------------+-----
"""

import composition


class WorkerKilled(composition.Case):
    def test_while_planning(self):
        self.up(workers=2)
        self.await_log("worker", "works for coordinator", times=2)
        submission = self.submit(composition.LONG)
        self.wait_until(self.solvers, "a worker has solved a task")
        victim = self.solvers()[0]
        self.crash(victim)
        self.assert_ends_planned(composition.LONG, submission)
        self.wait_until(lambda: self.inspect(victim, "{{.RestartCount}}") == "1",
                        "the engine has started it anew")
        self.await_well()
        self.await_log("worker", "works for coordinator", times=3)
