"""A test case on a network of hosts of its own, with the service on them."""

import pathlib
import tempfile
import unittest

import service
import topology

WHY_NOT = topology.why_not()


@unittest.skipIf(WHY_NOT, WHY_NOT)
class OnHosts(unittest.TestCase):
    HOSTS = ()  # their names, in the order of their addresses

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.network = topology.Network(self.HOSTS)
        self.addCleanup(self.network.remove)
        self.service = service.Service(self.network.start, self.folder, self.flags)
        self.addCleanup(self.service.stop)

    def flags(self, host):
        return ["--transport", "udp", "--interface", self.network.addresses[host]]
