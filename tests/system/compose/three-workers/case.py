"""Purpose: the composition as it is shipped plans what one process plans.

Topology, a private bridge without anything else:

    discovery    coordinator    worker x 3    client
    -----+------------+--------------+----------+-----
"""

import composition


class ThreeWorkers(composition.Case):
    def test_plan_what_one_process_plans(self):
        self.up(workers=3)
        self.await_log("worker", "works for coordinator", times=3)
        self.await_well()
        self.assert_plans("adaptive-mobile", "mixed-floor", composition.LONG)
        self.assertEqual(3, len(self.solvers()), "each has a share")

    def test_run_without_rights(self):
        self.up(workers=1)
        for name in ("coordinator", "worker", "discovery"):
            (container,) = self.containers(name)
            self.assertEqual("accord", self.docker("exec", container, "id", "-un").strip())
            self.assertEqual("true", self.inspect(container, "{{.HostConfig.ReadonlyRootfs}}"))
            status = self.docker("exec", container, "cat", "/proc/1/status")
            self.assertRegex(status, r"(?m)^CapEff:\s+0+$")

    def test_plan_the_demo(self):
        self.variables["COMPOSE_PROFILES"] = "demo"
        self.up(workers=1)
        self.await_log("demo", "solved, and proved free of collisions")
        (demo,) = self.containers("demo")
        self.wait_until(lambda: self.inspect(demo, "{{.State.Status}}") == "exited", "the demo ends")
        self.assertEqual("0", self.inspect(demo, "{{.State.ExitCode}}"))
