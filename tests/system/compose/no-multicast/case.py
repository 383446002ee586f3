"""Purpose: no process depends on multicast, or as much as listens to it.

Topology, a private bridge whose ends drop what is for more than one:

    discovery    coordinator    worker x 2    client
    -----x------------x--------------x----------x-----
"""

import composition


class NoMulticast(composition.Case):
    def test_plans_all_the_same(self):
        self.up(workers=2)
        containers = self.compose("ps", "--quiet").split()
        for container in containers:
            for chain in ("INPUT", "OUTPUT"):
                self.in_network_of(container, "iptables", "-A", chain, "-d", "224.0.0.0/4",
                                   "-j", "DROP")
        self.compose("restart", "coordinator")
        self.assert_plans("mixed-floor", "high-manipulator-4")

    def test_nobody_listens_to_groups(self):
        self.up(workers=1)
        self.await_well()
        for name in ("discovery", "coordinator", "worker"):
            (container,) = self.containers(name)
            groups = self.in_network_of(container, "ip", "maddress", "show")
            self.assertNotIn("239.255.", groups, name)
