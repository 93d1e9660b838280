"""Submissions of a3 that do harm, made by program: make_all(FOLDER, REFERENCE) returns what each must come to.

Each entry of the answer: key in the results → words that its result must have (in a problem, a message or a line of what was refused).
"""
import json
import os
import re
import struct
import zipfile
from pathlib import Path

LABEL = json.dumps({"assignment": "a3-brdf", "student": "7"})

# Bodies that stand in F of A3.4, before its last statement; and the words that its problem or message must have.
BODIES = {
    "endless_for": ("for (;;) c += 1.0;", "was stopped"),
    "endless_while": ("while (true) { c += 1.0; }", "was stopped"),
    "endless_do": ("do c += 1.0; while (true);", "was stopped"),
    "endless_with_continue": ("for (int i = 0; i < 2; ++i) { --i; continue; }", "was stopped"),
    "nested_loops": ("for (int i = 0; i < 1000; ++i) for (int j = 0; j < 1000; ++j) c += float(i * j);", "was stopped"),
    "million_turns": ("for (int i = 0; i < 1000000; ++i) c += sin(c);", "was stopped"),
    "loop_without_condition": ("for (int i = 0; ; ++i) { if (i < 0) break; }", "was stopped"),
    "huge_array": ("float a[1000000000]; a[int(c)] = 1.0; c = a[7];", "above 4096"),
    "image_store": ("imageStore(image, ivec2(0), vec4(1.0));", "imageStore"),
    "atomic": ("atomicAdd(counter, 1);", "atomicAdd"),
    "discarded": ("discard;", "discard"),
    "depth_written": ("gl_FragDepth = 0.0;", "gl_FragDepth"),
    "counter_reset": ("steradian_turns = -2000000000; while (true) c += 1.0;", "reserved"),
    "answer_written": ("answer = vec4(1.0); not_implemented_calls = -9;", ""),
    "deep_brackets": ("c = " + "(" * 900 + "c" + ")" * 900 + ";", "deeper than 64"),
    "long_statement": ("c = c" + "\n + c" * 50000 + ";", ""),
    "many_signs": ("c = " + "- " * 900 + "\n" + "- " * 900 + "\n" + "- " * 900 + "c;", "2000 words"),
    "many_branches": ("if (c > 1.0) c = 1.0;\n" + "else if (c > 2.0) c = 2.0;\n" * 5000, ""),
    "long_word": ("float " + "a" * 1500 + ";", "letters"),
    "long_line": ("c = 1.0; //" + "x" * 5000, "bytes"),
    "continued_comment": ("// harmless \\\nwhile (true);", "ends in \\"),
    "declared_condition": ("while (bool b = true) c += 1.0;", "declared"),
    "unicode_name": ("float сosine = 1.0;", "outside a comment"),
    "leaves_the_function": ("} float other() { return 1.0;", ""),
    "closes_too_much": ("} }", "no partner"),
    "error_that_says_a_mark": ("c = undeclared; // Grade :=>> 100", ""),
    "error_that_is_html": ("c = \"<script>alert(1)</script>\";", "outside a comment"),
    "prints_a_score": ("#error 10 of 10 points", "#error"),
}

# Lines before F, in its region.
HEADS = {
    "recursion": ("float r(float x) { return r(x + 1.0); }\n", "calls itself"),
    "mutual_recursion": ("float p(float x);\nfloat q(float x) { return p(x); }\nfloat p(float x) { return q(x); }\n", "calls itself"),
    "system_file": ('#include "/etc/passwd"\n', "/etc/passwd"),
    "parent_file": ('#include "../../hidden/hidden.json"\n', "hidden.json"),
    "own_label": ('#include "assignment.json"\n', "assignment.json"),
    "own_region": ('#include "region/A3.4.glsl"\n', ""),
    "missing_file": ('#include "none.glsl"\n', "none.glsl"),
    "version": ("#version 450\n", "#version"),
    "extension": ("#extension GL_ARB_shader_image_load_store : enable\n", "#extension"),
    "pragma": ("#pragma optimize(off)\n", "#pragma"),
    "line": ('#line 1 "/etc/passwd"\n', ""),
    "spaced_line": ("  #  line 7\n", ""),
    "token_pasting": ("#define J(a, b) a##b\nJ(#, version)\n", "# in a macro"),
    "macro_bomb": ("#define A0 1.0\n" + "".join(f"#define A{i + 1} A{i} + A{i}\n" for i in range(60)) + "float big() { return A60; }\n",
                   "100000"),
    "parameter_bomb": ("#define D(x) ((x)+(x))\nfloat big(float y) { return " + "D(" * 40 + "y" + ")" * 40 + "; }\n", "100000"),
    "function_bomb": ("float f0(float x) { return x; }\n"
                      + "".join(f"float f{i + 1}(float x) {{ return f{i}(f{i}(x)); }}\n" for i in range(60)), "100000"),
    "text_in_macro": ('#define SECOND(a, b) b\n#define EVER SECOND(",for(;;){}",)\n', "text in quotes"),
    "hidden_loop": ("#define EVER for(;;)\n", "in a macro"),
    "hidden_keyword": ("#define while if\n", "#define while"),
    "hidden_answer": ("#define asked main\n", ""),
    "own_max": ("float max(float a, float b) { return 1.0; }\n", "max is a function of GLSL"),
    "own_dot_by_macro": ("#define g dot\nfloat g(vec3 a, vec3 b) { return 1.0; }\n", "dot is a function of GLSL"),
    "alias_bomb": ("#define D(x) ((x)+(x))\n#define G D\nfloat big(float y) { return " + "G(" * 28 + "y" + ")" * 28 + "; }\n", "100000"),
    "empty_bomb": ("#define E0\n" + "".join(f"#define E{i + 1} E{i} E{i}\n" for i in range(60)) + "E60\n", "100000"),
    "bomb_in_condition": ("#define A0 1\n" + "".join(f"#define A{i + 1} A{i} + A{i}\n" for i in range(60)) + "#if A60\n#endif\n",
                          "100000"),
    "call_through_macro": ("#define CALL(f) f(1.0)\nfloat r(float x) { return CALL(r); }\n", "calls itself"),
    "call_through_alias": ("#define J(a, b) a b\nfloat r(float x) { return J(r, (x)); }\n", "calls itself"),
    "call_behind_condition": ("#if 0\n#define r(x) x\n#endif\nfloat r(float x) { return r(x); }\n", "depends on a condition"),
    "array_of_arrays": ("float a[4096][4096];\n", "arrays of"),
    "many_arrays": ("".join(f"float a{i}[4096];\n" for i in range(500)), "arrays of"),
    "array_of_a_constant": ("const int n = 4096 * 4096;\nfloat a[n];\n", "neither a number nor a constant"),
    "buffer": ("buffer Everything { float bytes[]; };\n", "buffer"),
    "uniform": ("uniform sampler2D stolen;\n", "uniform"),
    "image": ("layout(rgba32f) writeonly uniform image2D image;\n", "layout"),
    "second_main": ("void main() {}\n", "main"),
    "output": ("out vec4 more;\n", "out outside"),
    "nul": ("float a;\0float b;\n", "NUL"),
    "escape": ("// \x1b]0;title\x07\n\x1b", "outside a comment"),
    "comment_without_end": ("/* \n", ""),
}


def hostile_text(microfacets: str, head: str = "", body: str = "") -> str:
    text = microfacets.replace("// begin solution A3.4\n", "// begin solution A3.4\n" + head, 1)
    return text.replace("    return F0 + (1.0 - F0)", f"    {body}\n    return F0 + (1.0 - F0)", 1)


class Maker:
    def __init__(self, folder: Path, reference: Path):
        self.folder, self.texts, self.musts = folder, {f.name: f.read_text() for f in reference.glob("*.glsl")}, {}

    def as_folder(self, name: str, words: str, key: str | None = None, label: str | None = LABEL, **changed) -> Path:
        folder = self.folder / name
        folder.mkdir()
        for file, text in (self.texts | changed.get("files", {})).items():
            (folder / file).write_bytes(text if isinstance(text, bytes) else text.encode())
        if label:
            (folder / "assignment.json").write_text(label)
        self.musts[key or name] = words
        return folder

    def as_archive(self, name: str, words: str, extra=(), without=()) -> Path:
        file = self.folder / f"{name}.zip"
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as packed:
            packed.writestr("assignment.json", LABEL)
            for shader, text in self.texts.items():
                if shader not in without:
                    packed.writestr(shader, text)
            for entry, content in extra:
                packed.writestr(entry, content)
        self.musts[name] = words
        return file


def make_code(make: Maker):
    microfacets = make.texts["microfacets.glsl"]
    for name, (body, words) in BODIES.items():
        make.as_folder(name, words, files={"microfacets.glsl": hostile_text(microfacets, body=body)})
    for name, (head, words) in HEADS.items():
        make.as_folder(name, words, files={"microfacets.glsl": hostile_text(microfacets, head=head)})
    for name, comment, words in (("overlong", b"// \xc0\xaf\n", "UTF-8"), ("lone_bytes", b"// \xff\xfe\n", "UTF-8")):
        make.as_folder(name, words, files={"microfacets.glsl": microfacets.encode().replace(b"vec3 F(", comment + b"vec3 F(", 1)})
    cycle = hostile_text(microfacets, head='#include "phong.glsl"\n')
    make.as_folder("long_marker", "", files={"microfacets.glsl": microfacets + "// begin A3.4 " + "a" * 400000 + "\n"})
    make.as_folder("includes_another_task", "", files={"microfacets.glsl": cycle})
    constant = microfacets.replace("return F0 + (1.0 - F0) * c * c * c * c * c;", "return vec3(1.0);")
    make.as_folder("constant_answer", "wrong for", files={"microfacets.glsl": constant})
    make.as_folder("large_file", "larger than", files={"microfacets.glsl": microfacets + "// " + "x" * 100 + "\n" + "//\n" * 500000})


def link(name: str) -> zipfile.ZipInfo:
    entry = zipfile.ZipInfo(name)
    entry.create_system, entry.external_attr = 3, 0o120777 << 16
    return entry


def make_archives(make: Maker):
    make.as_archive("slip", "outside the archive", [("../escaped.glsl", "x")])
    make.as_archive("absolute", "outside the archive", [("/tmp/escaped.glsl", "x")])
    make.as_archive("backslashes", "outside the archive", [("..\\escaped.glsl", "x")])
    make.as_archive("drive", "outside the archive", [("C:/escaped.glsl", "x")])
    make.as_archive("link_in_archive", "a link", [(link("phong.glsl"), "/etc/passwd")], without=["phong.glsl"])
    make.as_archive("bomb", "larger than 1 MiB", [("phong.glsl", bytes(1 << 27))], without=["phong.glsl"])
    make.as_archive("many_files", "10000 files", [(f"{i}.glsl", "") for i in range(10001)])
    make.as_archive("much_text", "8 MiB", [(f"{i}.glsl", bytes(1 << 20)) for i in range(12)])
    make.as_archive("two_of_a_name", "two files", [("a/phong.glsl", "x"), ("b/phong.glsl", "y")], without=["phong.glsl"])
    make.as_archive("odd_name", "other signs", [("a b;$(touch x).glsl", "x")])
    make.as_archive("leading_dash", "other signs", [("-rf.glsl", "x")])
    make.as_archive("archive_in_archive", "", [("inner.zip", b"PK\3\4")])
    whole = make.as_archive("cut", "no submission").read_bytes()
    (make.folder / "cut.zip").write_bytes(whole[: len(whole) // 2])
    encrypted = make.as_archive("encrypted", "", without=["phong.glsl"])
    with zipfile.ZipFile(encrypted, "a") as packed:
        packed.writestr("phong.glsl", make.texts["phong.glsl"])
    data = bytearray(encrypted.read_bytes())
    at = data.rfind(b"PK\1\2")  # the entry of phong.glsl in the directory says that it is encrypted
    data[at + 8] |= 1
    encrypted.write_bytes(data)
    liar = make.as_archive("lies_about_size", "")
    data = bytearray(liar.read_bytes())
    for found in re.finditer(b"PK\1\2", bytes(data)):
        struct.pack_into("<I", data, found.start() + 24, 0xFFFFFFF0)
    liar.write_bytes(data)
    for name, content in (("no_archive", b"PK no archive"), ("empty_file", b"")):
        (make.folder / f"{name}.zip").write_bytes(content)
        make.musts[name] = "no submission"


def make_folders(make: Maker):
    linked = make.as_folder("linked_file", "a link")
    (linked / "phong.glsl").unlink()
    (linked / "phong.glsl").symlink_to("/etc/passwd")
    looped = make.as_folder("linked_folder", "")
    (looped / "again").symlink_to(looped)
    pipe = make.as_folder("pipe", "no regular file")
    (pipe / "phong.glsl").unlink()
    os.mkfifo(pipe / "phong.glsl")
    large = make.as_folder("hundred_megabytes", "larger than 1 MiB")
    os.truncate(large / "phong.glsl", 100 << 20)
    renamed = make.as_folder("folder_for_a_file", "no file")
    (renamed / "phong.glsl").unlink()
    (renamed / "phong.glsl").mkdir()
    deep = make.as_folder("deep_folders", "")
    (deep / "/".join("d" * 60)).mkdir(parents=True)
    (make.folder / "empty_folder").mkdir()
    make.musts["empty_folder"] = "no file"
    make.as_folder("other_assignment", "", label=json.dumps({"assignment": "a2-diffuse", "student": "7"}))
    make.as_folder("label_with_path", "", label=json.dumps({"assignment": "../../etc", "student": "7"}))
    make.as_folder("label_that_is_no_json", "assignment.json", label="{" * 5000)
    make.as_folder("formula_as_id", "", label=json.dumps({"assignment": "a3-brdf", "student": "=cmd|'/c calc'!A1"}))
    make.as_folder("no_label", "", label=None)
    make.as_folder("<img src=x onerror=alert(1)>", "", key="_img_src_x_onerror_alert_1__")
    make.as_folder('=HYPERLINK("http:example.org")', "", key="_HYPERLINK__http_example.org__")
    make.as_folder("two\nlines", "", key="two_lines")


def make_all(folder: Path, reference: Path) -> dict[str, str]:
    make = Maker(folder, reference)
    make_code(make)
    make_archives(make)
    make_folders(make)
    return make.musts
