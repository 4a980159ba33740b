#!/bin/sh
# sh tests/jobs.sh: the job files that README.md has for GNU parallel and for a matrix of GitHub's make the report that one process makes. They
# are run as they stand there; of GitHub's actions those are acted that the file names: checkout, upload-artifact, download-artifact. Takes the
# program from build/, or from PMREPORT. Slurm's are tried by tests/slurm.sh.
set -eu
cd "$(dirname "$0")/.."
# shellcheck source=reports/packages.sh
. reports/packages.sh
install_packages parallel python3-yaml
program=${PMREPORT:-$PWD/build/bin/pmreport}
[ -x "$program" ] || { echo "there is no $program: sh reports/run.sh builds it" >&2 && exit 1; }
readme=$PWD/README.md scenario=$PWD/tests/data/spread.toml
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
mkdir "$room/bin" "$room/parallel" "$room/github"
ln -s "$program" "$room/bin/pmreport"
export PATH="$room/bin:$PATH"
cp "$scenario" "$room/machine.toml"
cd "$room"
pmreport machine.toml --quiet

cp machine.toml parallel/
sed -n '/^parallel --joblog/,/^```/p' "$readme" | grep -v '^```' >parallel/job
(cd parallel && sh -eu job >log 2>&1 || { cat log >&2 && exit 1; })
[ "$(wc -l <parallel/shards.log)" -eq 17 ] || { echo "GNU parallel did not run 16 shards" >&2 && exit 1; }
diff -r machine-report parallel/machine-report
echo "GNU parallel: 16 shards make the same report, byte by byte"

python3 - "$readme" <<'X'
import itertools, pathlib, re, shutil, subprocess, sys
import yaml

blocks = re.findall(r"```yaml\n(.*?)```", pathlib.Path(sys.argv[1]).read_text(), re.S)
(jobs,) = [yaml.safe_load(b)["jobs"] for b in blocks if "matrix" in b]
artifacts = pathlib.Path("artifacts").absolute()


def run(name, job, values):
    here = pathlib.Path("github", name).absolute()
    here.mkdir(parents=True)
    filled = lambda text: re.sub(r"\$\{\{ *matrix\.(\w+) *\}\}", lambda m: str(values[m[1]]), text)
    for step in job["steps"]:
        action, given = step.get("uses", "").partition("@")[0], step.get("with", {})
        if "run" in step:
            subprocess.run(["bash", "-e", "-c", filled(step["run"])], cwd=here, check=True, stdout=subprocess.DEVNULL)
        elif action == "actions/checkout":
            shutil.copy("machine.toml", here)
        elif action == "actions/upload-artifact":
            shutil.copytree(here / filled(given["path"]), artifacts / filled(given["name"]))
        elif action == "actions/download-artifact":
            assert given["merge-multiple"], "artifacts come to folders of their own"
            for artifact in sorted(artifacts.glob(given["pattern"])):
                shutil.copytree(artifact, here / given["path"], dirs_exist_ok=True)
        else:
            sys.exit(f"nothing is known of a step {step}")


done = set()
while len(done) < len(jobs):
    name = next(n for n, j in jobs.items() if n not in done and j.get("needs", "") in done | {""})
    matrix = jobs[name].get("strategy", {}).get("matrix", {})
    for combination in itertools.product(*matrix.values()):
        run("-".join([name, *map(str, combination)]), jobs[name], dict(zip(matrix, combination)))
    done.add(name)
X
diff -r machine-report github/report/machine-report
echo "GitHub's matrix: its shards make the same report, byte by byte"
