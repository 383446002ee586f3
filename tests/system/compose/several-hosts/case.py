"""Purpose: machines that share no bridge, by deploy/docker-compose.hosts.yml: each knows its own address
and the coordinator's.

Topology: as far as one engine can have it, since a container of each machine would be on a network of
its own: all on one machine's network, over UDP, by its address alone.

    coordinator    worker x 2    client
    -----+--------------+-----------+-----  127.0.0.1
"""

import composition


class SeveralHosts(composition.Case):
    OVERLAYS = ("hosts",)
    VARIABLES = {"ACCORD_HOST": "127.0.0.1", "ACCORD_COORDINATOR_HOST": "127.0.0.1"}

    def test_plan_what_one_process_plans(self):
        self.up(workers=2)
        self.await_log("worker", "works for coordinator", times=2)
        self.await_well()
        self.assert_plans("mixed-floor", "high-manipulator-4")
