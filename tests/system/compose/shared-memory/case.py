"""Purpose: on one machine all goes over its shared memory, by deploy/docker-compose.shm.yml.

Topology, the host's network and /dev/shm, but nothing is sent over that network:

    coordinator    worker x 3    client
    =====+==============+===========+=====  /dev/shm
"""

import composition


class SharedMemory(composition.Case):
    OVERLAYS = ("shm",)

    def test_plans_what_one_process_plans(self):
        self.up(workers=3)
        self.await_log("worker", "works for coordinator", times=3)
        self.await_well()
        self.assert_plans("adaptive-mobile", "high-manipulator-4", composition.LONG)
        self.assertEqual(3, len(self.solvers()))

    def test_is_what_carries_the_messages(self):
        self.up(workers=1)
        self.await_well()
        self.assertEqual([], self.containers("discovery"))
        for name in ("coordinator", "worker"):
            (container,) = self.containers(name)
            opened = self.docker("exec", container, "cat", "/proc/1/maps")
            self.assertIn("/dev/shm/fastrtps_", opened)
            sockets = self.docker("exec", container, "ls", "-l", "/proc/1/fd")
            self.assertGreater(sockets.count("/dev/shm/fastrtps_"), 0)
