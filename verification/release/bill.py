"""The bill of materials of a release in SPDX 2.3 (JSON): each file that is handed out, what it is linked with, what built and tested it.

Versions are those of the machine that built it (dpkg) and the pins of requirements.txt. The time is that of the commit and the name space
holds it, so that the same commit and tools give the same bytes. The gate `bill` reads it by spdx-tools. [SRS_VER_143]
"""
import hashlib
import json
import re
import subprocess

NAME = "bill.spdx.json"  # In the folder of the collected data, in the evidence and in the release.
# Folder of the collected data -> folder of the release.
PARTS = {"package": "install", "images": "images"}
# What `counterpoint` is made with; no room of the package, and no image, has any of them.
LINKED = ("libcli11-dev", "libyaml-cpp-dev", "nlohmann-json3-dev", "libboost-dev")
# Installed only when asked for; it makes nothing that is measured.
OPTIONAL_LISTS = ("PDF_PACKAGES", "GCC_COVERAGE_PACKAGES")
BUILD_LISTS = ("PACKAGES", "FIRMWARE_PACKAGES")
ROOT_ID = "SPDXRef-Counterpoint"


def package_lists(dev):
    """(name, packages) of each list of ./dev."""
    return re.findall(r"^(\w*PACKAGES)=\((.*)\)$", dev, re.MULTILINE)


def debian_packages(dev):
    """Name -> relationship, for each package that ./dev installs without being asked."""
    found = {}
    for name, packages in package_lists(dev):
        if name in OPTIONAL_LISTS:
            continue
        for package in packages.split():
            role = "DEPENDENCY_OF" if package in LINKED else "BUILD_TOOL_OF" if name in BUILD_LISTS else "TEST_TOOL_OF"
            found.setdefault(package, role)
    return found


def pins(requirements):
    """Name -> version of each package of requirements.txt."""
    return dict(re.findall(r"^([\w.-]+)==(\S+)$", requirements, re.MULTILINE))


def installed_versions(names):
    """As Debian tells them; a package that is not installed is left out."""
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${db:Status-Status} ${Version}\n", *names], capture_output=True, text=True, check=False)
    rows = (line.split(" ") for line in done.stdout.splitlines())
    return {name: version for name, status, version in rows if status == "installed"}


def handed_out(data):
    """(name in the release, path) of each file that is handed out to be linked, run or flashed."""
    for folder, name in PARTS.items():
        for path in sorted((data / folder).rglob("*")):
            if path.is_file():
                yield f"./{name}/{path.relative_to(data / folder).as_posix()}", path


def identifier(text):
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)


def foreign(name, version, kind):
    purl = f"pkg:deb/debian/{name}@{version}" if kind == "deb" else f"pkg:pypi/{name.lower()}@{version}"
    return {"SPDXID": f"SPDXRef-{kind}-{identifier(name)}", "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION", "copyrightText": "NOASSERTION",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}]}


def file_entry(name, path):
    content = path.read_bytes()
    sums = [{"algorithm": kind.upper(), "checksumValue": hashlib.new(kind, content).hexdigest()} for kind in ("sha1", "sha256")]
    return {"SPDXID": f"SPDXRef-File-{sums[0]['checksumValue'][:12]}-{identifier(name[2:])}", "fileName": name, "checksums": sums,
            "licenseConcluded": "Apache-2.0", "licenseInfoInFiles": ["NOASSERTION"], "copyrightText": "Copyright the Counterpoint authors"}


def verification_code(files):
    """Of SPDX 2.3, section 7.9: SHA-1 over the sorted SHA-1 sums of the files."""
    sums = sorted(entry["checksums"][0]["checksumValue"] for entry in files)
    return hashlib.sha1("".join(sums).encode()).hexdigest()


def made(root, data, identity, versions=None):
    """The document as a dictionary."""
    version, commit = identity["version"], identity["commit"]
    debian = debian_packages((root / "dev").read_text(encoding="utf-8"))
    versions = installed_versions(debian) if versions is None else versions
    files = [file_entry(name, path) for name, path in handed_out(data)]
    own = {"SPDXID": ROOT_ID, "name": "counterpoint", "versionInfo": f"{version} (commit {commit})", "downloadLocation": "NOASSERTION",
           "filesAnalyzed": True, "packageVerificationCode": {"packageVerificationCodeValue": verification_code(files)},
           "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0", "licenseInfoFromFiles": ["NOASSERTION"],
           "copyrightText": "Copyright the Counterpoint authors", "comment": f"Objects of core and channels: SHA-256 {identity['digest']} on the host, {identity['target_digest']} on the target"}
    others = [(foreign(name, versions[name], "deb"), role) for name, role in sorted(debian.items()) if name in versions]
    others += [(foreign(name, pin, "pypi"), "TEST_TOOL_OF") for name, pin in pins((root / "requirements.txt").read_text(encoding="utf-8")).items()]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", ROOT_ID)] + [(package["SPDXID"], role, ROOT_ID) for package, role in others]
    relations += [(ROOT_ID, "CONTAINS", entry["SPDXID"]) for entry in files]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"counterpoint-{version}",
            "documentNamespace": f"urn:counterpoint:{version}:{commit}",
            "creationInfo": {"created": identity["commit_time"], "creators": ["Organization: the Counterpoint authors", "Tool: dev-release"]},
            "packages": [own] + [package for package, _ in others], "files": files,
            "relationships": [{"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other} for one, kind, other in relations]}


def write(root, data, identity):
    (data / NAME).write_text(json.dumps(made(root, data, identity), indent=1) + "\n", encoding="utf-8")
