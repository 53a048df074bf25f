"""Checks proofs boundfit/proof/1 and /2 as docs/proof.md says: python3 tests/verify.py PROOF DATA [PROOF DATA]...
Exit status: 0 every statement is true, 4 one is false, 1 no proof, or unreadable or beyond a limit; of several pairs the largest."""
import bisect, csv, functools, hashlib, io, json, re, sys, unicodedata
from fractions import Fraction
sys.set_int_max_str_digits(0), csv.field_size_limit(1 << 40)
DIGITS, EXPONENT, ROW, COLUMNS, PROOF = 10_000, 10_000, 1 << 24, 100_000, 1 << 28  # the limits of section 2 and of a proof
class Falsehood(Exception): pass
class NotAProof(Exception): pass
class Refused(Exception): pass
def must(truth, statement, error=Falsehood):
    if not truth: raise error(statement)
def visible(text):  # on one line, with all of it visible
    def shown(at, c):
        nothing = re.match("[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0\U000e0100-\U000e01ef]", c)
        if c.isprintable() and not nothing and (at or unicodedata.category(c) not in ("Mn", "Me")): return c
        return {"\t": r"\t", "\n": r"\n", "\r": r"\r", "\0": r"\0"}.get(c) or f"\\u{{{ord(c):x}}}"
    return "".join(map(shown, range(len(text)), text))
# Section 1: the file.
def is_text(value): return type(value) is str
def is_index(value): return type(value) is int
def is_number(value): return is_text(value) and re.fullmatch(r"-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?", value, re.ASCII)
def is_one_of(*texts): return lambda value: is_text(value) and value in texts
def is_null_or(shape): return lambda value: value is None or shape(value)
def is_list(shape): return lambda value: type(value) is list and all(map(shape, value))
def is_tuple(*shapes):
    return lambda value: type(value) is list and len(value) == len(shapes) and all(shape(v) for shape, v in zip(shapes, value))
PAIR, TERMS = is_tuple(is_number, is_number), is_list(is_tuple(is_text, is_number))
CONDITION = [is_tuple(is_number, is_number, is_number), is_tuple(is_number, is_number, is_number, is_one_of("="))]
LAW = is_list(is_tuple(is_one_of("abs", "written"), is_index, is_number))
SOURCE, INDICES, END = is_tuple(is_index, is_number), is_list(is_index), is_tuple(TERMS, PAIR, PAIR)
SIDES = is_list(is_tuple(is_text, is_null_or(is_index)))
ABOUT = {"schema": is_one_of("boundfit/proof/1", "boundfit/proof/2"), "sha256": is_text, "header": lambda value: type(value) is bool,
         "delimiter": is_one_of(",", ";", "\t", "|"), "rows": INDICES, "reading": is_one_of("decimal", "binary64"),
         "model": is_tuple(*[SOURCE] * 4), "conditions": is_list(lambda value: any(shape(value) for shape in CONDITION))}
OPTIONAL = {"interval": is_tuple(is_null_or(is_index), is_null_or(is_index)), "law": is_tuple(LAW, LAW), "x_origin": is_number}
FIRST = ABOUT | {"vertices": is_list(PAIR), "active": is_list(is_tuple(is_index, is_text)), "sides": SIDES, "farkas": TERMS,
                 "bounds": is_list(END)}
SCOPE = {"rows": INDICES, "without": INDICES, "where": INDICES, "factor": is_number, "epsilon": is_number,
         "side": is_one_of("+", "-", "strong")}
KINDS = {"form": {"form": PAIR, "lower": END, "upper": END}, "point": {"point": PAIR}, "empty": {"multipliers": TERMS},
         "least": {"point": PAIR, "multipliers": TERMS}, "set": {"point": PAIR, "vertices": is_list(PAIR), "sides": SIDES},
         "left out": {"least": is_index, "contradictions": is_list(is_tuple(INDICES, TERMS))}}
def is_statement(value):
    if type(value) is not dict or not is_text(value.get("kind")) or value["kind"] not in KINDS: return False
    extra = {"sets": is_list(INDICES)} if value["kind"] == "left out" else {}
    return not {"factor", "epsilon"} <= value.keys() and is_object({"kind": is_text} | KINDS[value["kind"]], SCOPE | extra)(value)
def is_object(needed, optional):
    return lambda value: needed.keys() <= value.keys() <= (needed | optional).keys() and all(
        (needed | optional)[field](own) for field, own in value.items())
def states(value): return is_list(is_statement)(value) and value != []
SECOND, NEW = ABOUT | {"statements": states}, {"x_error": SOURCE, "response": is_list(SOURCE)}
def index(text):
    must(re.fullmatch("0|[1-9][0-9]{0,19}", text, re.ASCII) and int(text) < 1 << 64, f"{text} is no index", NotAProof)
    return int(text)
def fields(pairs):
    must(len(dict(pairs)) == len(pairs), "a field twice", NotAProof)
    return dict(pairs)
def refuse(text): raise NotAProof(f"{text} is no index")
def read_proof(data):
    must(len(data) <= PROOF, f"more than {PROOF} bytes", NotAProof)
    text = data.decode()
    must(all(len(run) <= 10 * DIGITS for run in re.findall("[0-9]+", text, re.ASCII)), "a number with too many digits", NotAProof)
    proof = json.loads(text, object_pairs_hook=fields, parse_int=index, parse_float=refuse, parse_constant=refuse)
    is_second = type(proof) is dict and proof.get("schema") == "boundfit/proof/2"
    is_shaped = is_object(SECOND, OPTIONAL | NEW) if is_second else is_object(FIRST, OPTIONAL)
    must(type(proof) is dict and is_shaped(proof), "another schema, or not as it says", NotAProof)
    json.dumps(proof, ensure_ascii=False).encode()  # no half of a surrogate pair
    return proof
# Section 2: the data and their half-planes.
SPACES = " \t\n\f\r\u00a0\u2007\u2009\u202f"
MISSING = "na n/a #n/a nan null none - -- . ? #nv #n/d #n/b #getting_data".split() + [""]
def is_missing(text):
    error = re.fullmatch(r"#[^ ]+[!?]|err:[0-9]+", text, re.ASCII | re.IGNORECASE)
    return error or text.lower() in MISSING
def plain(text): return re.sub("[dD]", "e", text.replace("\u2212", "-").strip(SPACES))
def cell_number(text):
    start = re.match(r"[+-]?([0-9]*)(?:/([0-9]*)|\.?([0-9]*)(?:[eE][+-]?([0-9]+))?)", plain(text), re.ASCII)
    whole, below, places, exponent = (part or "" for part in start.groups())
    fits = len(whole) <= DIGITS and len(below if whole else "") <= DIGITS and len(whole + places) <= DIGITS
    must(fits, "a number with too many digits", Refused)
    must(not whole + places or int(exponent.lstrip("0")[:9] or 0) <= EXPONENT, "too large an exponent", Refused)
    form = r"[+-]?((0|[1-9][0-9]*)/[1-9][0-9]*|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)"
    must(re.fullmatch(form, plain(text), re.ASCII), f"{text[:40]!r} is not a number")
    return Fraction(plain(text))
class Data(io.RawIOBase):  # the bytes, hashed as they are read, without up to two byte order marks
    def __init__(self, source): self.source, self.hash, self.start = source, hashlib.sha256(), b""
    def readable(self): return True
    def more(self, count):
        data = self.source.read(count)
        self.hash.update(data)
        return data
    def begin(self):
        self.start = self.more(6)
        for _ in range(2): self.start = self.start.removeprefix(b"\xef\xbb\xbf")
    def readinto(self, buffer):
        data = self.start[:len(buffer)] or self.more(len(buffer))
        self.start = self.start[len(data):]
        buffer[:len(data)] = data
        return len(data)
def records(text, delimiter):  # the rows that are not blank, each byte a character
    length = 0
    def lines():
        nonlocal length
        while line := text.readline(ROW + 2):
            must(length + len(line.rstrip("\r\n")) <= ROW, "a row with too many bytes", Refused)
            length += len(line)
            yield line
    for record in csv.reader(lines(), delimiter=delimiter):
        length = 0
        must(len(record) <= COLUMNS, "too many columns", Refused)
        if len(record) > 1 or record and record[0].strip(" \t\n\f\r"): yield record
def ranges(ends):  # first and last rows, which ascend
    is_ascending = all(end < first <= last for end, (first, last) in zip([0] + ends[1::2], zip(ends[::2], ends[1::2])))
    must(ends and len(ends) % 2 == 0 and is_ascending, "rows: are not in order")
    return list(zip(ends[::2], ends[1::2]))
def numbers_of(proof, rows):  # row -> (x1, x2, lower, upper, how far x1 may be from that)
    found, wanted = {}, ranges(proof["rows"])
    model = [(column, Fraction(factor)) for column, factor in proof["model"]]
    def cell(row, column):
        must(column <= len(rows[row - 1]), f"row {row} has no column {column}")
        return rows[row - 1][column - 1].encode("latin-1").decode(errors="surrogateescape")
    def read(row, column):
        if column == 0: return Fraction(1)
        value = cell_number(cell(row, column))
        return value if proof["reading"] == "decimal" else Fraction(float(value))
    def side(row, column):  # a bound, or None where there is none
        if column is None or column and is_missing(cell(row, column).strip(SPACES)): return None
        return read(row, column)
    def quantity(row, kind, column):
        if kind == "abs": return abs(read(row, column))
        must(column > 0, f"row {row}: column 0 has no last digit")
        text = cell(row, column)
        read(row, column), must("/" not in text, f"row {row}: {text[:40]!r} has no last digit")
        mantissa, _, exponent = plain(text).lower().partition("e")
        return Fraction(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2])) / 2
    def law(row, terms): return sum(quantity(row, kind, column) * Fraction(times) for kind, column, times in terms)
    more = [(column, Fraction(factor)) for column, factor in proof.get("response", [])]
    for row in (row for first, last in wanted for row in range(first, min(last, len(rows) + 1) + 1)):
        must(row <= len(rows), f"row {row} is not in the data")
        x1, x2, y, *others = [read(row, column) * factor for column, factor in model[:3] + more + model[3:]]
        *others, epsilon = others
        x1, y = x1 - Fraction(proof.get("x_origin", "0")) * model[0][1], y + sum(others)
        above = below = 0
        if "interval" in proof: lower, upper = [side(row, column) for column in proof["interval"]]
        else:
            above, below = [epsilon + law(row, terms) for terms in proof.get("law", ([], []))]
            lower, upper = y - below, y + above
        column, factor = proof.get("x_error", (0, "0"))
        found[row] = x1, x2, lower, upper, read(row, column) * Fraction(factor)
        must(above >= 0 and below >= 0 and found[row][4] >= 0, f"row {row}: a negative error bound")
    return found
def half_planes(proof, numbers, scope):  # section 8: name -> (a1, a2, b): a1*theta1 + a2*theta2 <= b
    side, factor, epsilon = scope.get("side"), *[Fraction(scope[name]) if name in scope else None for name in ("factor", "epsilon")]
    must((factor or 0) >= 0 and (epsilon or 0) >= 0, "factor or epsilon: is negative")
    must(("side" in scope) == ("x_error" in proof), "side: is there where x has no errors, or missing where it has")
    chosen, planes = ranges(scope["rows"]) if "rows" in scope else [(1, 1 << 64)], {}
    # At which end of its x a row asks something from above and from below, and what its name has behind it.
    seen = {"+": [(-1, 1, "")], "-": [(1, -1, "")], "strong": [(-1, -1, " -"), (1, 1, " +")], None: [(0, 0, "")]}[side]
    for row, (x1, x2, lower, upper, error) in numbers.items():
        before = bisect.bisect(chosen, (row, 1 << 64)) - 1
        if before < 0 or chosen[before][1] < row: continue
        if lower is not None and upper is not None and lower <= upper and (factor, epsilon) != (None, None):
            middle, width = (lower + upper) / 2, (upper - lower) / 2 * factor if epsilon is None else epsilon
            lower, upper = middle - width, middle + width
        error = error if factor is None else factor * error
        for above, below, mark in seen:
            if upper is not None: planes[f"{row} upper{mark}"] = (x1 + above * error, x2, upper)
            if lower is not None: planes[f"{row} lower{mark}"] = (-x1 - below * error, -x2, -lower)
    for k, (*parts, sign) in enumerate((parts + [""])[:4] for parts in proof["conditions"]):
        if "where" in scope and k + 1 not in scope["where"]: continue
        upper = tuple(map(Fraction, parts))
        both = {f"where:{k + 1} upper": upper, f"where:{k + 1} lower": tuple(-part for part in upper)}
        planes |= both if sign else {f"where:{k + 1}": upper}
    if side in ("+", "-"): planes["side"] = (-1 if side == "+" else 1, 0, 0)
    return planes
def pair(texts): return tuple(map(Fraction, texts))
def dot(u, v): return u[0] * v[0] + u[1] * v[1]
def cross(u, v): return u[0] * v[1] - u[1] * v[0]
def is_low(u): return u[1] < 0 or (u[1] == 0 and u[0] < 0)
@functools.cmp_to_key
def angle(u, v): return is_low(u) - is_low(v) or (cross(u, v) < 0) - (cross(u, v) > 0)
def find(planes, name): return planes[name] if name in planes else must(False, f"{name[:40]} is no half-plane of the data")
def add(planes, terms, most):
    found = [(find(planes, name), Fraction(times)) for name, times in terms]
    must(len(found) <= most and all(times > 0 for _, times in found), "multipliers: too many, or not positive")
    return tuple(sum(times * plane[j] for plane, times in found) for j in range(3))
def verify(proof, source):
    data = Data(source)
    data.begin()
    text = io.TextIOWrapper(io.BufferedReader(data), encoding="latin-1", newline="")
    rows = list(records(text, proof["delimiter"]))
    must(proof["sha256"] == data.hash.hexdigest(), "sha256: is not that of the data")
    numbers = numbers_of(proof, rows[proof["header"]:])
    return verify_statements(proof, numbers) if "statements" in proof else verify_set(proof, half_planes(proof, numbers, {}))
def walk(planes, points, named):  # section 4: the sides, and the maximum of a.theta with vertices that attain it, or None
    sides = [(find(planes, name), end) for name, end in named]
    must(all(any(a[:2]) and (end is None or end < len(points)) for a, end in sides), "sides")
    angles = [angle(a) for a, _ in sides]
    must(all(u < v for u, v in zip(angles, angles[1:])), "sides: not in order of angle")
    for (a, end), (after, to) in zip(sides, sides[1:] + sides[:1]):
        must((cross(a, after) > 0) == (end is not None), f"sides: {a}: a vertex, or none, against its angle")
        must(end is None or all(dot(u, points[end]) == u[2] for u in (a, after)), f"sides: {a}: not tight")
        must(None in (end, to) or cross(after, points[to]) >= cross(after, points[end]), f"sides: {after}: backwards")
    corners = {points[end] for _, end in sides if end is not None}
    must(len(corners) == len(points), "vertices: one is on no side, or twice")
    def support(a):  # section 5
        if not sides or not any(a): return (None if any(a) else 0), []
        left, right = bisect.bisect_left(angles, angle(a)) - 1, bisect.bisect(angles, angle(a)) - 1
        ends = [end for end in (sides[left][1], sides[right][1]) if end is not None]
        if left != right: return dot(a, a) / dot(a, sides[right][0]) * sides[right][0][2], ends
        return (dot(a, points[ends[0]]) if ends else None), ends
    return sides, support
def touching(planes, support):  # section 5
    touching = set()
    for name, (a1, a2, b) in planes.items():
        value, ends = support((a1, a2))
        must(value is not None and value <= b, f"{name} cuts off a part of the set")
        touching |= {(end, name) for end in ends if value == b}
    return touching
def check_end(planes, inside, end, e):  # section 6
    terms, point, ray = end[0], pair(end[1]), pair(end[2])
    must(all(dot(a, point) <= a[2] and dot(a, ray) <= 0 for a in inside), f"in direction {e}: outside")
    is_end = add(planes, terms, 2) == (*e, dot(e, point)) and ray == (0, 0) or terms == [] and dot(e, ray) > 0
    must(is_end, f"in direction {e}: not proved")
def verify_set(proof, planes):
    points, bounds = [pair(theta) for theta in proof["vertices"]], proof["bounds"]
    if proof["farkas"]:  # section 3
        a1, a2, b = add(planes, proof["farkas"], 3)
        return must(a1 == a2 == 0 > b and not (proof["sides"] or proof["active"] or points or bounds), "farkas")
    sides, support = walk(planes, points, proof["sides"])
    must(touching(planes, support) == {(end, name) for end, name in proof["active"]}, "active: is not what touches")
    must(len(bounds) == 4, "bounds: are not four")
    for end, e in zip(bounds, ((-1, 0), (1, 0), (0, -1), (0, 1))): check_end(planes, [a for a, _ in sides], end, e)
# Section 9: statements, each about the half-planes of its scope.
def verify_statements(proof, numbers):
    scopes, shown = {}, {scope_of(own) for own in proof["statements"] if own["kind"] in ("point", "set")}
    for own in proof["statements"]:
        if own["kind"] == "left out": check_sets(own, shown, numbers)
        scope = {field: own[field] for field in SCOPE if field in own and field != "without"}
        key = json.dumps(scope)
        if key not in scopes: scopes[key] = half_planes(proof, numbers, scope)
        CHECKS[own["kind"]](own, without(scopes[key], own.get("without", [])), numbers)
def without(planes, rows):
    left, names = dict(planes), ("upper", "lower", "upper -", "upper +", "lower -", "lower +")
    for name in [f"{row} {name}" for row in rows for name in names]: left.pop(name, None)
    return left
def row_of(name): return int(name.split()[0]) if name[:1].isdigit() else None
def contradict(planes, terms):
    a1, a2, b = add(planes, terms, 3)
    must(a1 == a2 == 0 > b, "multipliers: do not add up to 0 <= a negative number")
def check_point(own, planes, numbers): must(all(dot(a, pair(own["point"])) <= a[2] for a in planes.values()), "point: outside")
def check_form(own, planes, numbers):
    form = pair(own["form"])
    check_end(planes, planes.values(), own["lower"], (-form[0], -form[1]))
    check_end(planes, planes.values(), own["upper"], form)
def check_empty(own, planes, numbers): contradict(planes, own["multipliers"])
def check_least(own, planes, numbers):
    check_point(own, planes, numbers)
    must("epsilon" in own or "factor" in own and own.get("side") != "strong", "least: of what?")
    def grows(row):
        lower, upper = numbers[row][2:4] if row else (None, None)
        return None not in (lower, upper) and (lower < upper or lower == upper and "epsilon" in own)
    is_zero = add(planes, own["multipliers"], 3) == (0, 0, 0)
    is_least = Fraction(own.get("factor", own.get("epsilon"))) == 0 or any(grows(row_of(name)) for name, _ in own["multipliers"])
    must(is_zero and is_least, "multipliers: do not show that it is the least")
def check_set(own, planes, numbers):
    check_point(own, planes, numbers)
    touching(planes, walk(planes, [pair(theta) for theta in own["vertices"]], own["sides"])[1])
def scope_of(own, more=()):
    rows, where = [tuple(own[field]) if field in own else None for field in ("rows", "where")]
    sizes = [Fraction(own[field]) if field in own else None for field in ("factor", "epsilon")]
    return rows, where and frozenset(where), *sizes, own.get("side"), frozenset(own.get("without", [])).union(more)
def check_sets(own, shown, numbers):  # rows of the scope, as many as "least", and something is left without them
    must(own["least"] > 0 or "sets" in own, "least: 0 says nothing without sets")
    chosen = ranges(own["rows"]) if "rows" in own else [(1, 1 << 64)]
    def is_in(row): return row in numbers and row not in own.get("without", []) and any(a <= row <= b for a, b in chosen)
    listed = [tuple(sorted(rows)) for rows in own.get("sets", [])]
    must(len(set(listed)) == len(listed), "sets: one is there twice")
    for rows in listed:
        must(len(set(rows)) == len(rows) == own["least"] and all(map(is_in, rows)), f"sets: {rows[:6]}: are not such rows")
        must(scope_of(own, rows) in shown, f"sets: no statement shows that anything is left without {rows[:6]}")
def check_left_out(own, planes, numbers):
    known = {frozenset(rows): terms for rows, terms in own["contradictions"]}
    sets, tried, seen = {frozenset(rows) for rows in own.get("sets", [])}, [frozenset()], set()
    while tried:
        rows = tried.pop()
        is_enough = len(rows) >= own["least"]
        if rows in seen or is_enough and ("sets" not in own or rows in sets): continue
        must(rows in known, f"contradictions: none is shown without {sorted(rows)[:6]}")
        contradict(without(planes, rows), known[rows])
        if not is_enough: tried += [rows | {row_of(name)} for name, _ in known[rows] if row_of(name)]
        seen.add(rows)
CHECKS = {"form": check_form, "point": check_point, "empty": check_empty, "least": check_least, "set": check_set,
          "left out": check_left_out}
def status(proof, data):  # of the bytes of a proof, and of a file that is open
    try: proof = read_proof(proof)
    except (NotAProof, ValueError, RecursionError) as error: return 1, f"not a proof: {visible(str(error))}"
    about = {field: proof[field] for field in proof if field in ABOUT | OPTIONAL | NEW and field not in ("schema", "sha256")}
    try: return verify(proof, data) or 0, f"verified: {json.dumps(about)}"
    except (Falsehood, OverflowError) as error: return 4, f"refuted: {visible(str(error))}"
    except (Refused, OSError) as error: return 1, f"refused: {visible(str(error))}"
def of_files(proof, data):
    try:
        with open(proof, "rb") as proof, open(data, "rb") as data: return status(proof.read(PROOF + 1), data)
    except OSError as error: return 1, f"refused: {visible(str(error))}"
if __name__ == "__main__":
    results = [of_files(*pair) for pair in zip(sys.argv[1::2], sys.argv[2::2])]
    sys.exit(print(*(line for _, line in results), sep="\n") or max(code for code, _ in results))
