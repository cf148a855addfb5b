"""What does PrairieLearn install? An image that grades, and a question that uses it.

Source: PrairieLearn, docs/externalGrading.md. A question's uuid has to be its own in a course,
and stays the same for a course that updates the grader.
"""

import json
import uuid

from grader.package.archive import Member, below
from grader.package.kit import FOLDER, Choices, kit, ours

IMAGE = "OWNER/bvhgrade"
"""To be replaced by where the course pushes its image to."""

SECONDS = 240
TIMEOUT = 300
"""Seconds until PrairieLearn ends the container, which counts as a failure of the grader."""

QUESTION = "questions/bvh"

DOCKERFILE = f"""\
FROM debian:bookworm-slim
COPY {FOLDER} /{FOLDER}
RUN /{FOLDER}/install.sh
COPY entry.sh /{FOLDER}/entry.sh
"""

HTML = """\
<pl-question-panel>
  <p>
    Hand in <code>exercise03.cpp</code> with your <code>BVH::construct</code> (25 points) and
    <code>intersect</code> (25 points). It is compiled together with the exercise's own headers.
  </p>
  <pl-file-upload file-names="exercise03.cpp"></pl-file-upload>
</pl-question-panel>
<pl-submission-panel>
  <pl-external-grader-results></pl-external-grader-results>
  <pl-file-preview></pl-file-preview>
</pl-submission-panel>
"""


def members(choices: Choices) -> tuple[Member, ...]:
    """Collect the archive's files; fails as `kit` does."""
    limit = ("--time-limit", str(SECONDS))
    image = (
        Member("Dockerfile", DOCKERFILE.encode()),
        ours("prairielearn-entry.sh", "entry.sh"),
        *kit(choices, *limit),
    )
    question = (
        Member("info.json", f"{json.dumps(_information(), indent=4)}\n".encode()),
        Member("question.html", HTML.encode()),
    )
    return (*below("image", image), *below(QUESTION, question))


def _information() -> dict[str, object]:
    return {
        "uuid": str(uuid.uuid5(uuid.NAMESPACE_URL, "bvhgrade/prairielearn/bvh")),
        "title": "Bounding volume hierarchy",
        "topic": "Ray tracing",
        "tags": ["C++"],
        "type": "v3",
        "gradingMethod": "External",
        "externalGradingOptions": {
            "enabled": True,
            "image": IMAGE,
            "entrypoint": f"/{FOLDER}/entry.sh",
            "timeout": TIMEOUT,
            "enableNetworking": False,
        },
    }
