"""Checks proofs boundfit/proof/1 as docs/proof.md says: python3 tests/verify.py PROOF DATA [PROOF DATA]...
Exit status: 0 every statement is true, 4 one is false, 1 no proof or unreadable; of several pairs the largest."""
import bisect, csv, functools, hashlib, io, json, re, sys
from fractions import Fraction
sys.set_int_max_str_digits(0), csv.field_size_limit(1 << 30)
class Falsehood(Exception): pass
TYPES = dict.fromkeys("schema sha256 delimiter reading".split(), str) | {"header": bool} | dict.fromkeys(
    "rows model conditions vertices active sides farkas bounds".split(), list)
OPTIONAL = {"interval": list, "law": list, "x_origin": str}
MISSING = "na n/a #n/a nan null none - -- . ?".split() + [""]
def must(truth, statement, error=Falsehood):
    if not truth: raise error(statement)
SPACES = " \t\n\f\r\u00a0\u2007\u2009\u202f"
def plain(text): return re.sub("[dD]", "e", text.replace("\u2212", "-").strip(SPACES))
def number(text):  # section 1: all else is no text, or no number
    form = r"[+-]?((0|[1-9][0-9]*)/[1-9][0-9]*|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)"
    must(re.fullmatch(form, plain(text), re.ASCII), f"{text!r} is not a number")
    return Fraction(plain(text))
def pair(texts): return (lambda x, y: (number(x), number(y)))(*texts)
def dot(u, v): return u[0] * v[0] + u[1] * v[1]
def cross(u, v): return u[0] * v[1] - u[1] * v[0]
def is_low(u): return u[1] < 0 or (u[1] == 0 and u[0] < 0)
@functools.cmp_to_key
def angle(u, v): return is_low(u) - is_low(v) or (cross(u, v) < 0) - (cross(u, v) > 0)
def half_planes(proof, data):  # section 2: name -> (a1, a2, b): a1*theta1 + a2*theta2 <= b
    data = data.removeprefix(b"\xef\xbb\xbf").removeprefix(b"\xef\xbb\xbf")
    text = io.StringIO(data.decode(errors="surrogateescape"), newline="")
    records = [record for record in csv.reader(text, delimiter=proof["delimiter"])
               if len(record) > 1 or record and record[0].strip(" \t\n\f\r")]
    ends, rows, planes = proof["rows"], records[proof["header"]:], {}
    is_known = proof["reading"] in ("decimal", "binary64") and len(proof["model"]) == 4
    model = [(column, number(factor)) for column, factor in proof["model"]]
    must(all(type(column) is int and column >= 0 for column, _ in model), "model", ValueError)
    must(all(type(end) is int for end in ends) and is_known, "rows, reading or model", ValueError)
    ranges, before = list(zip(ends[::2], ends[1::2])), [0] + ends[1::2]
    must(ends and len(ends) % 2 == 0 and ends[-1] <= len(rows) and all(
        end < first <= last for end, (first, last) in zip(before, ranges)), "rows: are not in the data")
    def read(row, column):
        if column == 0: return Fraction(1)
        must(column <= len(rows[row - 1]), f"row {row} has no column {column}")
        value = number(rows[row - 1][column - 1])
        return value if proof["reading"] == "decimal" else Fraction(float(value))
    def side(row, column):  # a bound, or None where there is none
        if column is None: return None
        cells = rows[row - 1]
        text = cells[column - 1] if 0 < column <= len(cells) else "0"
        return None if text.strip(SPACES).lower() in MISSING else read(row, column)
    def quantity(row, kind, column):
        if kind == "abs": return abs(read(row, column))
        must(kind == "written", "law", ValueError)
        must(0 < column <= len(rows[row - 1]), f"row {row} has no column {column}")
        text = rows[row - 1][column - 1]
        number(text), must("/" not in text, f"row {row}: {text!r} has no last digit")
        mantissa, _, exponent = plain(text).lower().partition("e")
        return Fraction(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2])) / 2
    def law(row, terms): return sum(quantity(row, kind, column) * number(times) for kind, column, times in terms)
    for row in (row for first, last in ranges for row in range(first, last + 1)):
        origins = (number(proof.get("x_origin", "0")), 0, 0, 0)
        x1, x2, y, epsilon = ((read(row, c) - origin) * factor for (c, factor), origin in zip(model, origins))
        if "interval" in proof: lower, upper = (side(row, column) for column in proof["interval"])
        else:
            above, below = (epsilon + law(row, terms) for terms in proof.get("law", ([], [])))
            must(above >= 0 and below >= 0, f"row {row}: a negative error bound")
            lower, upper = y - below, y + above
        if upper is not None: planes[f"{row} upper"] = (x1, x2, upper)
        if lower is not None: planes[f"{row} lower"] = (-x1, -x2, -lower)
    for k, (a1, a2, b, *sign) in enumerate(proof["conditions"], 1):
        must(sign in ([], ["="]), "conditions", ValueError)
        upper, lower = (number(a1), number(a2), number(b)), (-number(a1), -number(a2), -number(b))
        planes |= {f"where:{k} upper": upper, f"where:{k} lower": lower} if sign else {f"where:{k}": upper}
    return planes
def verify(proof, data):
    must(proof["sha256"] == hashlib.sha256(data).hexdigest(), "sha256")
    planes, points, bounds = half_planes(proof, data), [pair(theta) for theta in proof["vertices"]], proof["bounds"]
    def find(name): return planes[name] if name in planes else must(False, f"{name} is no half-plane of the data")
    def add(terms, most):
        found = [(find(name), number(times)) for name, times in terms]
        must(len(found) <= most and all(times > 0 for _, times in found), "multipliers: too many, or not positive")
        return tuple(sum(times * plane[j] for plane, times in found) for j in range(3))
    if proof["farkas"]:  # section 3
        a1, a2, b = add(proof["farkas"], 3)
        return must(a1 == a2 == 0 > b and not (proof["sides"] or proof["active"] or points or bounds), "farkas")
    sides = [(find(name), end) for name, end in proof["sides"]]  # section 4
    must(all(any(a[:2]) and (end is None or type(end) is int and 0 <= end < len(points)) for a, end in sides), "sides")
    angles = [angle(a) for a, _ in sides]
    must(all(u < v for u, v in zip(angles, angles[1:])), "sides: not in order of angle")
    for (a, end), (after, to) in zip(sides, sides[1:] + sides[:1]):
        must((cross(a, after) > 0) == (end is not None), f"sides: {a}: a vertex, or none, against its angle")
        must(end is None or all(dot(u, points[end]) == u[2] for u in (a, after)), f"sides: {a}: not tight")
        must(None in (end, to) or cross(after, points[to]) >= cross(after, points[end]), f"sides: {after}: backwards")
    corners = {points[end] for _, end in sides if end is not None}
    must(len(corners) == len(points), "vertices: one is on no side, or twice")
    def support(a):  # section 5: the maximum of a.theta and vertices that attain it, or None
        if not sides or not any(a): return (None if any(a) else 0), []
        left, right = bisect.bisect_left(angles, angle(a)) - 1, bisect.bisect(angles, angle(a)) - 1
        ends = [end for end in (sides[left][1], sides[right][1]) if end is not None]
        if left != right: return dot(a, a) / dot(a, sides[right][0]) * sides[right][0][2], ends
        return (dot(a, points[ends[0]]) if ends else None), ends
    touching = set()
    for name, (a1, a2, b) in planes.items():
        value, ends = support((a1, a2))
        must(value is not None and value <= b, f"{name} cuts off a part of the set")
        touching |= {(end, name) for end in ends if value == b}
    must(touching == {(end, name) for end, name in proof["active"]}, "active: is not what touches")
    must(len(bounds) == 4, "bounds: are not four")
    for (terms, point, ray), e in zip(bounds, ((-1, 0), (1, 0), (0, -1), (0, 1))):  # section 6
        point, ray = pair(point), pair(ray)
        must(all(dot(a, point) <= a[2] and dot(a, ray) <= 0 for a, _ in sides), f"bounds: in direction {e}: outside")
        is_end = add(terms, 2) == (*e, dot(e, point)) and ray == (0, 0) if terms != [] else dot(e, ray) > 0
        must(is_end, f"bounds: in direction {e}: not proved")
def status(text, data):
    try:
        proof = json.loads(text)
        types = {key: type(value) for key, value in proof.items()}
        optional = {key: value for key, value in OPTIONAL.items() if key in types}
        must(types == TYPES | optional and proof["schema"] == "boundfit/proof/1", "another schema or other fields", ValueError)
        return verify(proof, data) or 0, "verified"
    except (Falsehood, OverflowError, csv.Error) as error: return 4, f"refuted: {error}"
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError) as error:
        return 1, f"not a proof: {error}"
if __name__ == "__main__":
    results = [status(open(p, "rb").read(), open(d, "rb").read()) for p, d in zip(sys.argv[1::2], sys.argv[2::2])]
    sys.exit(print(*(line for _, line in results), sep="\n") or max(code for code, _ in results))
