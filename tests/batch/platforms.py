"""The same class as each platform gives it."""

from tests.batch.classes import CODE, Files, packed

METADATA = """---
submission_101:
  :submitters:
  - :name: Ada Lovelace
    :sid: '9001'
    :email: ada@uni.example
  :created_at: 2026-11-01 10:00:00.000000000 Z
  :results:
    :output: |
      :submitters:
      - :name: nobody
submission_102:
  :submitters:
  - :name: "Zo\\xEB \\"Z\\" Ng"
    :sid: '9002'
    :email: zoe@uni.example
  - :name: 'O''Neil'
    :sid: ''
    :email: neil@uni.example
"""


MOODLE: Files = {
    "Ada Lovelace_657717_assignsubmission_file_/mine.cpp": CODE,
    "Ada Lovelace_657717_assignsubmission_onlinetext_/onlinetext.html": "hello",
    "Ben_B_Berg_657718_assignsubmission_file/b.zip": packed({"x/exercise03.cpp": "b"}),
    "Cy Clo_657719_assignsubmission_file_my own.cpp": "c",
    "Di Da_657720_assignsubmission_onlinetext_/onlinetext.html": "here is my code",
}


CANVAS: Files = {
    "lovelaceada_9001_70001_exercise03-2.cpp": CODE,
    "lovelaceada_9001_70002_notes.txt": "notes",
    "berg_ben_LATE_9002_70003_any name.cpp": "b",
    "anon_Xy12z_70004_exercise03.cpp": "c",
    "LATE_anon_Q1w2e_70005_solution.zip": packed({"exercise03.cpp": "d"}),
}


GRADESCOPE: Files = {
    "assignment_5_export/submission_metadata.yml": METADATA,
    "assignment_5_export/submission_101/exercise03.cpp": CODE,
    "assignment_5_export/submission_102/src/exercise03.cpp": "b",
    "assignment_5_export/submission_103/other.cpp": "c",
}


GITHUB: Files = {
    "bvh-submissions/bvh-ada/.git/HEAD": "ref",
    "bvh-submissions/bvh-ada/src/exercise03.cpp": CODE,
    "bvh-submissions/bvh-ada/README.md": "sheet",
    "bvh-submissions/bvh-ben-b/src/exercise03.cpp": "b",
    "bvh-submissions/bvh-ben-b/README.md": "sheet",
}


PLAIN: Files = {
    "ada.cpp": CODE,
    "ben/exercise03.cpp": "b",
    "ben/readme.txt": "hello",
    "cy.tar.zip": packed({"a/exercise03.cpp": "c"}),
    "grades.csv": "nobody's",
    ".DS_Store": "x",
    "__MACOSX/._ada.cpp": "x",
}


FLAT = "_assignsubmission_file_"


TYPED: Files = {
    "berg_9002_text.html": "<p>my code</p>",
    "clocy_LATE_9003_link.html": "https://example.org",
    "anon_Xy12z_text.html": "a",
    "LATE_anon_Q1w2e_link.html": "b",
    "gradebook.csv": "nobody's",
}
