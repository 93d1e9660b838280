"""More submissions of a3 that do harm: values that crash a driver, loops in disguise, texts and files of odd forms.

make_all(FOLDER, REFERENCE) returns what each must come to, as in hostile.py; RIGHT are those that must have all points.
"""
import json
import os
import stat
import zipfile
from pathlib import Path

from hostile import LABEL, Maker, hostile_text, link

# Bodies that stand in F of A3.4, before its last statement; and the words that its problem or message must have.
BODIES = {
    "least_over_minus_one": ("int z = int(c * 0.0); int i = -2147483647 - 1 + z; int j = z - 1; c = float(i / j) + float(i % j);", ""),
    "zero_divides": ("int z = int(c * 0.0); c = float(7 / z) + float(7 % z) + float(7u / uint(z));", ""),
    "index_beyond": ("float a[4]; a[0] = c; c = a[int(c * 1e6) + 5];", ""),
    "index_below": ("float a[4]; a[0] = c; c = a[-int(c * 1e6) - 5];", ""),
    "writes_beyond": ("float a[4]; for (int i = 0; i < 1000; ++i) a[i * 999] = c; c = a[3];", ""),
    "component_beyond": ("vec3 v = vec3(c); c = v[int(c * 100.0) + 3];", ""),
    "never_written": ("float a[64]; c = a[int(c * 63.0)];", ""),
    "shift_by_all": ("int s = int(c * 1000.0); c = float(1 << s) + float(-1 >> s);", ""),
    "swizzle_as_counter": ("ivec4 i = ivec4(0); for (; i.x < 9; i.yzwx = i.xyzw) c += 1.0;", "was stopped"),
    "false_and_again": ("while (false) { } do { c += 1.0; } while (!false);", "was stopped"),
    "comma_as_condition": ("int i = 0; while (i++, true) c += 1.0;", "was stopped"),
    "unsigned_countdown": ("for (uint i = 5u; i >= 0u; --i) c += 1.0;", "was stopped"),
    "float_that_misses": ("for (float x = 0.0; x != 1.0; x += 0.3) c += 1.0;", "was stopped"),
    "not_a_number_waits": ("float x = sqrt(-1.0 - c); while (!(x > 0.0)) c += 1.0;", "was stopped"),
    "assignment_as_condition": ("bool b = false; while (b = true) c += 1.0;", "was stopped"),
    "array_as_counter": ("int n[2] = int[2](0, 0); for (; n[0] < 9; ++n[1]) c += 1.0;", "was stopped"),
    "switch_in_a_loop": ("for (int i = 0; i < 2; ) switch (i) { default: c += 1.0; break; }", "was stopped"),
    "not_finite": ("c = 1.0 / (c - c);", "wrong for"),
    "not_a_number": ("c = sqrt(-1.0 - c);", "wrong for"),
    "position_decides": ("if (gl_FragCoord.x > 3.0) c = 0.5;", "wrong for"),
    "deep_ternaries": ("c = " + ("c > 0.5 ? 1.0 : " * 3 + "\n") * 2000 + "c;", "more than"),
    "million_tokens": ("c = c" + "+c" * 500000 + ";", "larger than"),
    "tokens_in_a_line": ("c = c;" + ";" * 100000, "bytes"),
    "huge_numbers": ("c = 1e99999 * 1" + "0" * 120 + ".0;", "wrong for"),
    "hexadecimal_size": ("float a[0x7fffffff]; a[1] = c;", "above 4096"),
    "octal_size": ("float a[017777777777]; a[1] = c;", "above 4096"),
    "joiner": ("float a\u200db = 1.0;", "outside a comment"),
    "hidden_in_a_number": ("float e = 1.0; c = 1e+for(;;);", ""),
    "markup_in_a_comment": ("// </pre></script><script>alert(1)</script><img src=x onerror=alert(1)> \u202e\n", ""),
}

WIDE = "s" + "w" * 119  # the name of a struct

# Lines before F, in its region.
HEADS = {
    "loop_as_argument": ("#define RUN(x) x\nfloat spin(float c) { RUN(for (;;) c += 1.0;) return c; }\nfloat s = spin(1.0);\n", ""),
    "loop_word_as_argument": ("#define RUN(x) x\nvoid spin() { RUN(while)(true); }\n", "while without"),
    "structs_in_structs": ("".join(f"struct S{i} {{ " for i in range(40)) + "float x; " + "} s; " * 40 + "\n", "struct"),
    "overloads_in_reverse": ("".join(f"struct T{i} {{ float x; }};\n" for i in range(40)) + "".join(f"float f(T{i} x);\n" for i in range(40))
                             + "".join(f"float f(T{i} x) {{ T{i + 1} y; return f(y) + f(y); }}\n" for i in range(39)) + "float f(T39 x) { return 1.0; }\n",
                             "100000"),
    "long_complaint": (f"struct {WIDE} {{ float x; }};\nfloat g9(float x) {{ return x; }}\nfloat g(float x) {{ {WIDE} s; return g9(" + "s,\n" * 900 + "s); }\n", ""),
    "include_in_a_comment": ('/*\n#include "/etc/passwd"\n*/ // #include "none.glsl"\n', ""),
    "loop_in_an_initialiser": ("float spin() { float c = 0.0; while (true) c += 1.0; return c; }\nfloat spun = spin();\n", ""),
    "mixed_line_ends": ("// one\r// two\r\n// three\n\r// while (true) {\r\r", ""),
    "copied_names": ("int row_number() { return 0; }\nvec4 asked() { return vec4(1.0); }\n", ""),
    "array_of_structs_by_value": ("struct S { mat4 m[40]; };\nS f(S s) { return s; }\nS g(S s) { return f(f(f(f(f(f(s)))))); }\n", "arrays of"),
}

# What passes in spite of its form.
RIGHT = ("carriage_returns", "windows_lines", "byte_order_mark", "two_cases", "in_deep_zip", "-rf", "con", "other_results", "include_in_a_comment",
         "markup_in_a_comment", "mixed_line_ends", "sparse_files", "a_device")


def make_code(make: Maker):
    microfacets = make.texts["microfacets.glsl"]
    for name, (body, words) in BODIES.items():
        make.as_folder(name, words, files={"microfacets.glsl": hostile_text(microfacets, body=body)})
    for name, (head, words) in HEADS.items():
        make.as_folder(name, words, files={"microfacets.glsl": hostile_text(microfacets, head=head)})


def make_texts(make: Maker):
    def encoded(name: str, words: str, encode):
        make.as_folder(name, words, files={file: encode(text) for file, text in make.texts.items()})

    encoded("utf_16", "UTF-16", lambda text: text.encode("utf-16"))
    encoded("carriage_returns", "", lambda text: text.replace("\n", "\r").encode())
    encoded("windows_lines", "", lambda text: text.replace("\n", "\r\n").encode())
    encoded("byte_order_mark", "", lambda text: b"\xef\xbb\xbf" + text.encode())
    make.as_folder("two_cases", "", files={"Phong.glsl": "nonsense", "PHONG.GLSL": "nonsense"})
    upper = make.as_folder("upper_case", "no file")
    (upper / "phong.glsl").rename(upper / "PHONG.glsl")
    make.as_folder("long_student", "longer than", label=json.dumps({"assignment": "a3-brdf", "student": "7" * 500000}))
    make.as_folder("deep_label", "assignment.json", label="[" * 900000)
    make.as_folder("label_is_a_number", "assignment.json", label="7")
    make.as_folder("student_is_a_list", "assignment.json", label=json.dumps({"assignment": "a3-brdf", "student": ["7"]}))
    make.as_folder("wide_formula", "", label=json.dumps({"assignment": "a3-brdf", "student": "＝cmd|'/c calc'!A1"}))
    make.as_folder("blank_formula", "", label=json.dumps({"assignment": "a3-brdf", "student": "\t=1+1"}))
    make.as_folder("other_results", "", files={"results.json": '{"score": 100}', "marks.csv": "=1+1", "hidden.json": "{}", "result.json": "{}"})


def make_archives(make: Maker):
    make.as_archive("folder_is_a_link", "a link", [(link("shaders.glsl"), "/etc")])
    make.as_archive("folder_for_a_text", "no file", [("phong.glsl/", "")], without=["phong.glsl"])
    make.as_archive("long_entry", "other signs", [("x" * 60000 + ".glsl", "x")])
    make.as_archive("lines_in_a_name", "other signs", [("a\nb.glsl", "x")])
    inner = make.as_archive("inner", "")
    outer = make.folder / "zip_in_zip.zip"
    with zipfile.ZipFile(outer, "w") as packed:
        packed.write(inner, "inner.zip")
    make.musts["zip_in_zip"] = "no .glsl file"
    deep = make.folder / "in_deep_zip"
    (deep / "a" / "b" / "c").mkdir(parents=True)
    inner.rename(deep / "a" / "b" / "c" / "my.zip")
    del make.musts["inner"]
    make.musts["in_deep_zip"] = ""
    broken = make.as_archive("damaged_texts", "8 MiB", [(f"{i}.glsl", bytes(1 << 20)) for i in range(40)])
    data = bytearray(broken.read_bytes())
    for name in range(40):
        at = data.rfind(f"{name}.glsl".encode()) - 46  # the sum of the entry in the directory
        if data[at:at + 4] == b"PK\1\2":
            data[at + 16] ^= 0xFF
    broken.write_bytes(data)


def make_folders(make: Maker):
    for name in ("-rf", "con", "--hidden=x"):
        make.as_folder(name, "", key={"-rf": "_-rf", "--hidden=x": "_--hidden_x"}.get(name, name))
    make.as_folder("bytes_\udcff\udcfe", "no file", key="bytes___")
    (make.folder / "bytes_\udcff\udcfe" / "phong.glsl").unlink()
    sparse = make.as_folder("sparse_files", "")
    for i in range(40):
        (sparse / f"{i}.bin").touch()
        os.truncate(sparse / f"{i}.bin", 60 << 20)
    many = make.as_folder("many_small_files", "more than 10000 files")
    for i in range(12000):
        os.close(os.open(many / f"{i}.txt", os.O_CREAT))
    deep = make.as_folder("very_deep", "")
    here = os.getcwd()
    os.chdir(deep)
    for _ in range(600):
        os.mkdir("d" * 60)
        os.chdir("d" * 60)
    os.chdir(here)
    try:
        os.mknod(make.as_folder("a_device", "") / "zero.glsl", 0o666 | stat.S_IFCHR, os.makedev(1, 5))
        make.musts["a_device"] = "no regular file"
    except PermissionError:  # only root makes one
        pass
    closed = make.as_folder("closed", "")
    closed.chmod(0)


def make_all(folder: Path, reference: Path) -> dict[str, str]:
    make = Maker(folder, reference)
    make_code(make)
    make_texts(make)
    make_archives(make)
    make_folders(make)
    return make.musts
