# SPDX-License-Identifier: MIT
"""The data of a page of `fdebench report`, as docs/results.md describes it."""

import base64
import gzip
import json
import re


def data_of(page):
    """page: the text of index.html."""
    packed = re.search(r'id="data">(.*?)</script>', page, re.DOTALL)[1]
    return json.loads(gzip.decompress(base64.b64decode(packed, validate=True)))
