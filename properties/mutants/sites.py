"""Where core can be mutated: every operator, constant, condition and assignment that clang's syntax tree shows.

A site is one mutation of one piece of text. Sites stand in functions and default values only: what the
compiler itself evaluates (template arguments, array sizes, case labels, constexpr variables, static_assert)
is left out. Templates are visited where they are defined, so types may depend on a parameter; a mutation
that does not compile is dropped later (mutate.py).
"""
import contextlib
import os
import re
import sys
from dataclasses import dataclass


def load_cindex():
    # Debian's bindings belong to the system's interpreter, whichever one runs this.
    sys.path.append("/usr/lib/python3/dist-packages")
    try:
        from clang import cindex
    except ImportError:
        sys.exit("graze: mutants need libclang's bindings for Python; install python3-clang-14")
    with contextlib.suppress(ValueError):  # __builtin_bit_cast, which libclang 14 knows and its bindings do not
        cindex.CursorKind(280)
    return cindex


@dataclass(frozen=True)
class Site:
    file: str       # inside core/graze
    start: int      # bytes
    end: int
    line: int
    operator: str   # class of mutation, for counting
    original: str   # text, as shown
    mutated: str
    code: str       # what replaces [start, end); ID stands for the number of the mutant


COMPARED = {"<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="]}
COMPUTED = {"+": "-", "-": "+", "*": "/", "/": "*"}
JOINED = {"&&": "||", "||": "&&"}
ASSIGNED = {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "|=": "&=", "&=": "|="}
SWAPPED = {"min": "max", "max": "min", "cwiseMin": "cwiseMax", "cwiseMax": "cwiseMin", "minCoeff": "maxCoeff",
           "maxCoeff": "minCoeff"}


def uncommented(text):
    return re.sub(r"\s+", " ", re.sub(r"//[^\n]*", " ", text)).strip()


def pick(original, mutated):
    """Either of two expressions of a type that may depend on a template parameter."""
    return ("::graze_mutants::pick<ID>([&] { return ::graze_mutants::value(%s); }, "
            "[&] { return ::graze_mutants::value(%s); })" % (original, mutated))


def choose(original, mutated):
    """Either of two expressions of one type, by value or by reference."""
    return "(::graze_mutants::on<ID>() ? (%s) : (%s))" % (mutated, original)


def choose_bool(original, mutated):
    return ("::graze_mutants::pick<ID>([&] { return static_cast<bool>(%s); }, "
            "[&] { return static_cast<bool>(%s); })" % (original, mutated))


class Finder:
    def __init__(self, cindex, root):
        self.kinds = cindex.CursorKind
        self.root = root
        self.bytes = {}
        self.sites = {}
        self.seen = set()

    def source(self, path):
        if path not in self.bytes:
            with open(path, "rb") as file:
                self.bytes[path] = file.read()
        return self.bytes[path]

    def text(self, path, start, end):
        return self.source(path)[start:end].decode()

    def of(self, node):
        return node.extent.start.offset, node.extent.end.offset

    def add(self, path, start, end, operator, mutated, code, shown=None):
        original = uncommented(self.text(path, start, end))
        name = os.path.relpath(path, self.root)
        line = self.source(path).count(b"\n", 0, start) + 1
        site = Site(name, start, end, line, operator, shown or original, mutated, code)
        self.sites[(name, start, end, operator, mutated)] = site

    def between(self, path, first, second):
        return uncommented(self.text(path, first.extent.end.offset, second.extent.start.offset))

    def is_template_argument(self, path, start, end):
        """Names, digits and commas back to a '<' that clings to a name on its left."""
        before = self.text(path, max(0, start - 200), start)
        clinging = re.search(r"[A-Za-z_0-9]<([A-Za-z_0-9:,<> ]*)$", before)
        return clinging is not None and " <" not in clinging.group(1) and " >" not in clinging.group(1)

    # --- one kind of node each

    def binary(self, path, node, children):
        if len(children) < 2:
            return
        left, right = children[0], children[-1]
        sign = self.between(path, left, right)
        start, end = self.of(node)
        a, b = uncommented(self.text(path, *self.of(left))), uncommented(self.text(path, *self.of(right)))
        # An operator's left operand may be wrapped in parentheses that belong to the text between.
        if sign not in COMPARED and sign not in COMPUTED and sign not in JOINED and sign != "%":
            return
        if self.of(left)[0] != start or self.of(right)[1] != end:
            return
        whole = uncommented(self.text(path, start, end))
        for other in COMPARED.get(sign, []):
            mutated = "%s %s %s" % (a, other, b)
            self.add(path, start, end, "comparison", mutated, choose_bool(whole, mutated))
        if sign in JOINED:
            mutated = "(%s) %s (%s)" % (a, JOINED[sign], b)
            self.add(path, start, end, "and or", mutated, choose_bool(whole, mutated))
        if sign in COMPUTED:
            mutated = "%s %s %s" % (a, COMPUTED[sign], b)
            self.add(path, start, end, "arithmetic", mutated, pick(whole, "(%s) %s (%s)" % (a, COMPUTED[sign], b)))
        if sign == "%" and b == "3":
            mutated = "(%s + 1) %% 3" % whole
            self.add(path, start, end, "index", mutated, pick(whole, "(%s + 1) %% 3" % whole))

    def unary(self, path, node, children, is_statement):
        start, end = self.of(node)
        text = uncommented(self.text(path, start, end))
        if text.startswith("-") and not text.startswith("--") and children:
            inner = uncommented(self.text(path, *self.of(children[0])))
            self.add(path, start, end, "minus", inner, pick(text, inner))
        if is_statement and text[:2] in ("++", "--"):
            turned = ("--" if text[:2] == "++" else "++") + text[2:]
            self.add(path, start, end, "assignment", turned,
                     "(::graze_mutants::on<ID>() ? void(%s) : void(%s))" % (turned, text))
            self.deletion(path, start, end, text)

    def deletion(self, path, start, end, text):
        self.add(path, start, end, "deletion", "nothing",
                 "(::graze_mutants::on<ID>() ? void() : void(%s))" % text)

    def assignment(self, path, node, children, is_statement):
        if not is_statement or len(children) < 2:
            return
        start, end = self.of(node)
        text = uncommented(self.text(path, start, end))
        sign = self.between(path, children[0], children[-1])
        if sign == "=" or sign in ASSIGNED:
            self.deletion(path, start, end, text)
        if sign in ASSIGNED:
            turned = "%s %s %s" % (uncommented(self.text(path, *self.of(children[0]))), ASSIGNED[sign],
                                   uncommented(self.text(path, *self.of(children[-1]))))
            self.add(path, start, end, "assignment", turned,
                     "(::graze_mutants::on<ID>() ? void(%s) : void(%s))" % (turned, text))

    def literal(self, path, node, parent):
        start, end = self.of(node)
        text = self.text(path, start, end)
        if self.is_template_argument(path, start, end):
            return
        before = self.text(path, start - 1, start)
        if before == "[" and parent.kind in (self.kinds.VAR_DECL, self.kinds.FIELD_DECL):
            return
        is_index = before == "[" or (before == "(" and re.fullmatch("[0-2]", text) is not None and
                                     self.text(path, start - 6, start) in ("coeff(",))
        if is_index and re.fullmatch("[0-2]", text):
            mutated = str((int(text) + 1) % 3)
            self.add(path, start, end, "index", mutated, choose(text, mutated))
            return
        self.constant(path, start, end, text)

    def constant(self, path, start, end, text):
        for other in ("0", "1", "-%s" % text, "2 * %s" % text):
            if "kInfinity" in text and other.startswith("2"):
                continue
            if re.fullmatch(r"[0-9.]+", text):
                value = float(text)
                if float(other) == value if re.fullmatch("[0-9]", other) else value == 0:
                    continue
            code = other
            if re.fullmatch("[01]", other):
                code = "static_cast<std::remove_cvref_t<decltype(%s)>>(%s)" % (text, other)
            self.add(path, start, end, "constant", other, choose(text, code))

    def named_constant(self, path, node, parent):
        start, end = self.of(node)
        text = uncommented(self.text(path, start, end))
        if not re.match(r"(\w+::)*k[A-Z]\w*", text) or self.is_template_argument(path, start, end):
            return
        if "[" in text or "(" in text:
            return
        self.constant(path, start, end, text)

    def condition(self, path, node):
        if "=" in re.sub(r"[=!<>]=", "", self.text(path, *self.of(node)).split("(")[0]):
            return
        start, end = self.of(node)
        text = uncommented(self.text(path, start, end))
        if text in ("true", "false"):
            return
        for mutated in ("!(%s)" % text, "true", "false"):
            self.add(path, start, end, "condition", mutated, choose_bool(text, mutated))

    def call(self, path, node, children, is_statement):
        start, end = self.of(node)
        text = uncommented(self.text(path, start, end))
        if not children:
            return
        # A call: its callee is the first child; an operator of a class: text between two operands.
        callee = uncommented(self.text(path, *self.of(children[0])))
        rest = self.text(path, self.of(children[0])[1], end).lstrip()
        if self.of(children[0])[0] == start and rest.startswith("("):
            name = re.search(r"([A-Za-z_]+)$", callee)
            name = name.group(1) if name else ""
            arguments = uncommented(self.text(path, self.of(children[0])[1], end))
            if name in SWAPPED and ("std::" in callee or "." in callee):
                mutated = callee[:-len(name)] + SWAPPED[name] + arguments
                self.add(path, start, end, "min max", mutated, pick(text, mutated))
            if callee in ("std::abs", "std::fabs") and len(children) == 2:
                self.add(path, start, end, "abs", arguments, pick(text, arguments))
            if name == "cwiseAbs":
                mutated = callee[:-len(".cwiseAbs")]
                self.add(path, start, end, "abs", mutated, pick(text, mutated))
        elif len(children) == 3 and self.of(children[0])[0] == start and self.of(children[-1])[1] == end:
            self.binary(path, node, children)
            self.assignment(path, node, children, is_statement)
        elif len(children) == 2 and text.startswith("-"):
            self.unary(path, node, children[1:], is_statement)

    def leaving(self, path, node, function):
        """break, continue, and a return that is not the function's last statement."""
        start, end = self.of(node)
        source = self.text(path, end, end + 200)
        semicolon = re.match(r"\s*;", source)
        if not semicolon:
            return
        text = uncommented(self.text(path, start, end))
        if node.kind == self.kinds.RETURN_STMT:
            body = [c for c in function.get_children() if c.kind == self.kinds.COMPOUND_STMT] if function else []
            statements = list(body[-1].get_children()) if body else []
            if not statements:
                return
            last = statements[-1]
            if last.kind != self.kinds.RETURN_STMT and text != "return":
                return
            if last.extent.start.offset <= start < last.extent.end.offset:
                return
        self.add(path, start, end + semicolon.end(), "break return", "nothing",
                 "{ if (!::graze_mutants::on<ID>()) %s; }" % text, shown=text + ";")

    # --- the walk

    def is_constant(self, path, node):
        kinds = self.kinds
        if node.kind in (kinds.ENUM_DECL, kinds.STATIC_ASSERT, kinds.TYPE_ALIAS_DECL,
                         kinds.TYPE_ALIAS_TEMPLATE_DECL, kinds.TEMPLATE_NON_TYPE_PARAMETER,
                         kinds.TEMPLATE_TYPE_PARAMETER, kinds.TEMPLATE_TEMPLATE_PARAMETER):
            return True
        head = self.text(path, *self.of(node))[:200]
        if node.kind == kinds.VAR_DECL:
            before = self.text(path, node.extent.start.offset, node.location.offset)
            return "constexpr" in before
        return head.startswith(("static_assert", "concept", "requires"))

    def walk(self, node, path, function, statement_of):
        kinds = self.kinds
        children = list(node.get_children())
        body_kinds = (kinds.FUNCTION_DECL, kinds.FUNCTION_TEMPLATE, kinds.CXX_METHOD, kinds.CONSTRUCTOR,
                      kinds.LAMBDA_EXPR, kinds.CONVERSION_FUNCTION)
        for i, child in enumerate(children):
            if child.extent.start.file is None or child.extent.start.file.name != path:
                continue
            if self.is_constant(path, child):
                continue
            here = child if child.kind in body_kinds else function
            is_statement = self.is_statement(path, node, child, i, len(children))
            grandchildren = list(child.get_children())
            if node.kind == kinds.IF_STMT and i == 0 and child.kind.is_expression():
                if re.match(r"if\s+constexpr", self.text(path, *self.of(node))):
                    continue
                if len(children) >= 2 and self.is_condition(path, node, child):
                    self.condition(path, child)
            elif node.kind in (kinds.WHILE_STMT, kinds.CONDITIONAL_OPERATOR) and i == 0:
                if child.kind.is_expression():
                    self.condition(path, child)
            if node.kind == kinds.CASE_STMT and i == 0:
                continue
            # Default values of members may not capture, so only constants are mutated there.
            inside = here is not None
            if child.kind == kinds.BINARY_OPERATOR and inside:
                self.binary(path, child, grandchildren)
                self.assignment(path, child, grandchildren, is_statement)
            elif child.kind == kinds.COMPOUND_ASSIGNMENT_OPERATOR and inside:
                self.assignment(path, child, grandchildren, is_statement)
            elif child.kind == kinds.UNARY_OPERATOR and inside:
                self.unary(path, child, grandchildren, is_statement)
            elif child.kind == kinds.CALL_EXPR and inside:
                self.call(path, child, grandchildren, is_statement)
            elif child.kind in (kinds.INTEGER_LITERAL, kinds.FLOATING_LITERAL):
                if not self.is_in_type(path, node, child):
                    self.literal(path, child, node)
            elif child.kind == kinds.DECL_REF_EXPR and not self.is_in_type(path, node, child):
                self.named_constant(path, child, node)
            elif child.kind in (kinds.BREAK_STMT, kinds.CONTINUE_STMT, kinds.RETURN_STMT):
                self.leaving(path, child, here)
            self.walk(child, path, here, None)

    def is_in_type(self, path, parent, child):
        if parent.kind in (self.kinds.VAR_DECL, self.kinds.PARM_DECL, self.kinds.FIELD_DECL):
            return child.extent.start.offset < parent.location.offset
        return False

    def is_condition(self, path, node, child):
        before = self.text(path, node.extent.start.offset, child.extent.start.offset)
        after = self.text(path, child.extent.end.offset, child.extent.end.offset + 80).lstrip()
        return re.fullmatch(r"if\s*\(\s*", before) is not None and after.startswith(")")

    def is_statement(self, path, node, child, i, count):
        kinds = self.kinds
        after = self.text(path, child.extent.end.offset, child.extent.end.offset + 80).lstrip()
        if not after.startswith(";"):
            return False
        if node.kind == kinds.COMPOUND_STMT:
            return True
        return node.kind in (kinds.IF_STMT, kinds.WHILE_STMT, kinds.FOR_STMT, kinds.CXX_FOR_RANGE_STMT) and (
            i == count - 1 or node.kind == kinds.IF_STMT and i > 0) and not self.in_header(path, node, child)

    def in_header(self, path, node, child):
        """Inside the parentheses of for, if or while."""
        head = self.text(path, node.extent.start.offset, child.extent.start.offset)
        return head.count("(") > head.count(")")

    def unit(self, cursor):
        core = os.path.join(self.root, "")
        for child in cursor.get_children():
            file = child.location.file
            if file is None or not os.path.abspath(file.name).startswith(os.path.abspath(core)):
                continue
            key = (file.name, child.extent.start.offset)
            if key in self.seen:
                continue
            self.seen.add(key)
            self.walk(child, file.name, None, None)


def find_sites(core, flags, only=()):
    """All sites of the headers under core/graze, or of some and what they include, in order of file and place."""
    cindex = load_cindex()
    if os.path.exists("/usr/lib/llvm-14/lib/libclang-14.so.1"):
        cindex.Config.set_library_file("/usr/lib/llvm-14/lib/libclang-14.so.1")
    headers = [os.path.join("graze", h) for h in only]
    for folder, _, files in os.walk(os.path.join(core, "graze") if not only else os.devnull):
        headers += [os.path.relpath(os.path.join(folder, f), core) for f in files if f.endswith(".hpp")]
    text = "".join("#include <%s>\n" % h for h in sorted(headers))
    unit = cindex.Index.create().parse("all_of_core.cpp", ["-std=c++20", "-DNDEBUG", "-I" + core] + flags,
                                       unsaved_files=[("all_of_core.cpp", text)])
    wrong = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if wrong:
        sys.exit("graze: core does not parse: %s" % wrong[0])
    finder = Finder(cindex, core)
    finder.unit(unit.cursor)
    return sorted(finder.sites.values(), key=lambda s: (s.file, s.start, s.end, s.operator, s.mutated))
