#!/usr/bin/env python3
"""Each alert of deploy/monitoring/ fires where it should and not where it should not, as Prometheus's
promtool works it out: two services, one in trouble and one well. Skipped where promtool is missing
(Debian's package prometheus has it)."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
RULES = ROOT / "deploy/monitoring/alerts.yaml"
CONFIG = ROOT / "deploy/monitoring/prometheus.yaml"
PROMTOOL = shutil.which("promtool")

# For each alert the series of who is in trouble, and of who is well, one sample a minute as promtool
# writes them ("1x30": thirty more like it; "0+5x30": thirty more, each higher by five); and after how
# many minutes it has to fire.
READY, STARTED = {"accord_build_info": "1x60"}, 'process_start_time_seconds'
CASES = {
    "AccordDown": (5, {"up": "1x2 0x60"}, {"up": "1x60"}),
    "AccordHangs": (5, {"accord_loop_turn_age_seconds": "0 0+60x60"},
                    {"accord_loop_turn_age_seconds": "9x60"}),
    "AccordNotReady": (5, {"accord_ready": "1x2 0x60", "accord_accepting": "1x60"},
                       {"accord_ready": "1x2 0x60", "accord_accepting": "1x2 0x60"}),  # drains
    "AccordRestarts": (15, {STARTED: "0 100 200 300x60", **READY}, {STARTED: "0 100x60", **READY}),
    "AccordFilesRunOut": (10, {"process_open_fds": "900x60", "process_max_fds": "1000x60", **READY},
                          {"process_open_fds": "700x60", "process_max_fds": "1000x60", **READY}),
    "AccordVersionsDiffer": (70, {'accord_build_info{version="1"}': "1x90",
                                  'accord_build_info{version="2"}': "1x90"},
                             {'accord_build_info{version="1"}': "1x90"}),
    "AccordJournalFails": (5, {"accord_journal_takes_writes": "1x2 0x60"},
                           {"accord_journal_takes_writes": "1x60"}),
    "AccordPlansUnwritten": (10, {'accord_requests{state="unwritten"}': "101x60"},
                             {'accord_requests{state="unwritten"}': "100x60",
                              'accord_requests{state="queued"}': "900x60"}),
    "AccordRequestsWait": (20, {"accord_requests_oldest_queued_seconds": "0+60x60"},
                           {"accord_requests_oldest_queued_seconds": "0+60x6 0x60"}),
    "AccordQueueFull": (5, {'accord_requests_rejected_total{reason="queue_full"}': "0 0+1x60"},
                        {'accord_requests_rejected_total{reason="queue_full"}': "7x60",
                         'accord_requests_rejected_total{reason="bad_scene"}': "0+1x60"}),
    "AccordRequestsWrong": (25, {'accord_requests_rejected_total{reason="bad_scene"}': "0+3x60",
                                 "accord_requests_accepted_total": "0+7x60"},
                            {'accord_requests_rejected_total{reason="bad_scene"}': "0+1x60",
                             'accord_requests_rejected_total{reason="queue_full"}': "0+9x60",
                             "accord_requests_accepted_total": "0+9x60"}),
    "AccordPlansFail": (25, {'accord_requests_finished_total{status="timeout"}': "0+3x60",
                             'accord_requests_finished_total{status="solved"}': "0+7x60"},
                        {'accord_requests_finished_total{status="timeout"}': "0+1x60",
                         'accord_requests_finished_total{status="cancelled"}': "0+9x60"}),
    "AccordNoWorkers": (5, {"accord_cluster_threads": "0x60",
                            'accord_requests{state="queued"}': "0x2 1x60",
                            'accord_requests{state="planning"}': "0x60"},
                        {"accord_cluster_threads": "0x60",
                         'accord_requests{state="queued"}': "0x60",
                         'accord_requests{state="unwritten"}': "1x60"}),
    "AccordWorkerUnemployed": (5, {"accord_worker_employed": "0x60"},
                               {"accord_worker_employed": "0 1x60"}),
    "AccordWorkersLost": (5, {'accord_workers_lost_total{reason="silent"}': "0x2 1x60",
                              'accord_workers_lost_total{reason="gone"}': "0x60"},
                          {'accord_workers_lost_total{reason="gone"}': "5x60",
                           "accord_workers_left_total": "0+1x60"}),
    "AccordWorkerRefused": (5, {'accord_workers{standing="refused"}': "1x60"},
                            {'accord_workers{standing="refused"}': "0x60",
                             'accord_workers{standing="welcome"}': "4x60"}),
    "AccordWorkerDistrusted": (5, {"accord_workers_distrusted_total": "0x2 1x60"},
                               {"accord_workers_distrusted_total": "1x60"}),
    "AccordWorkersBusy": (35, {"accord_cluster_busy_seconds_total": "0+118x60",
                               "accord_cluster_thread_seconds_total": "0+120x60"},
                          {"accord_cluster_busy_seconds_total": "0+90x60",
                           "accord_cluster_thread_seconds_total": "0+120x60"}),
    "AccordTasksWait": (5, {"accord_tasks_oldest_waiting_seconds": "0+60x60",
                            "accord_cluster_threads": "2x60"},
                        {"accord_tasks_oldest_waiting_seconds": "0+60x60",
                         "accord_cluster_threads": "0x60"}),  # AccordNoWorkers says that
    "AccordTasksGivenUp": (5, {'accord_tasks_ended_total{outcome="quarantined"}': "0x2 1x60",
                               'accord_tasks_ended_total{outcome="refused"}': "0x60"},
                           {'accord_tasks_ended_total{outcome="quarantined"}': "1x60",
                            'accord_tasks_ended_total{outcome="cancelled"}': "0+9x60"}),
    "AccordLeasesLost": (15, {'accord_tasks_reassigned_total{reason="worker_lost"}': "0+2x60",
                              'accord_tasks_reassigned_total{reason="unheard"}': "0+1x60"},
                         {'accord_tasks_reassigned_total{reason="worker_lost"}': "0+1x60",
                          'accord_tasks_reassigned_total{reason="handed_back"}': "0+9x60"}),
    "AccordMessagesDropped": (5, {'accord_messages_dropped_total{bus="fleet",reason="unsent"}':
                                  "0x2 1x60"},
                              {'accord_messages_dropped_total{bus="fleet",reason="unsent"}': "1x60"}),
    "AccordLinksFull": (20, {"accord_links_full_total": "0+1200x60"},
                        {"accord_links_full_total": "0+300x60"}),
}


def series(written, of):
    """A series with the labels that Prometheus gives a target."""
    name, labels = re.fullmatch(r"(\w+)(?:{(.*)})?", written).groups()
    target = f'cluster="{of}",job="accord-{of}",instance="{of}:9464"'
    return f"{name}{{{','.join(filter(None, [labels, target]))}}}"


def case(alert, firing, minute, trouble, well):
    """One test of promtool's: whether the alert fires for `firing`, and for nobody else."""
    samples = "".join(
        f"      - series: '{series(name, of)}'\n        values: '{values}'\n"
        for of, all_of in (("trouble", trouble), ("well", well)) for name, values in all_of.items())
    return (f"  - interval: 1m\n    input_series:\n{samples}    promql_expr_test:\n"
            f"      - expr: 'count by (cluster) (ALERTS{{alertname=\"{alert}\",alertstate=\"firing\"}})'\n"
            f"        eval_time: {minute}m\n        exp_samples:\n"
            f"          - {{labels: '{{cluster=\"{firing}\"}}', value: 1}}\n")


@unittest.skipUnless(PROMTOOL, "no promtool: apt-get install prometheus")
class Alerts(unittest.TestCase):
    def promtool(self, *arguments):
        return subprocess.run([PROMTOOL, *map(str, arguments)], text=True, capture_output=True,
                              timeout=120, check=False)

    def failed(self, firing, cases):
        """The alerts whose cases fail."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "cases.yaml")
            file.write_text(f"rule_files: ['{RULES}']\nevaluation_interval: 1m\ntests:\n" + "".join(
                case(alert, firing, *rest) for alert, rest in cases.items()))
            result = self.promtool("test", "rules", file)
        said = re.findall(r'expr: "count by .*?alertname=\\"(\w+)', result.stdout + result.stderr)
        self.assertEqual(result.returncode != 0, bool(said), result.stdout + result.stderr)
        return said

    def test_rules_and_the_example_configuration_are_read(self):
        for command in (("check", "rules", RULES), ("check", "config", CONFIG)):
            result = self.promtool(*command)
            self.assertEqual(0, result.returncode, result.stdout + result.stderr)

    def test_every_alert_has_a_case(self):
        alerts = re.findall(r"(?m)^      - alert: (\w+)$", RULES.read_text())
        self.assertEqual(sorted(alerts), sorted(CASES))

    def test_each_fires_for_who_is_in_trouble_and_for_nobody_else(self):
        self.assertEqual([], self.failed("trouble", CASES))

    def test_none_of_these_cases_passes_whatever_fires(self):
        self.assertEqual(list(CASES), self.failed("well", CASES))

    def test_none_fires_at_once(self):
        at_once = {alert: (0, trouble, well) for alert, (_, trouble, well) in CASES.items()}
        self.assertEqual(list(CASES), self.failed("trouble", at_once))


if __name__ == "__main__":
    unittest.main()
