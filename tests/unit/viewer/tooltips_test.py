#!/usr/bin/env python3
"""Every field, button and head of the viewer's panels has a tooltip, and fields of numbers have room for their texts, as its sources say.

usage: tooltips_test.py VIEWER_SOURCES
"""
import re
import sys
from pathlib import Path

# What a person sees a value in, sets one by, or reads a column by, and rows with texts of ours. Other rows of lists are texts of the file.
FIELD = re.compile(r"(?:\b(?:number_field|color_field)|ImGui::(?:Checkbox|RadioButton|Slider\w+|Drag(?:Float|Int)\w*|Input(?:Text|Float|Int)\w*|ColorEdit\d|ColorButton|Combo|BeginCombo|"
                   r"Button|SmallButton|ArrowButton|CollapsingHeader|BeginTabItem|TableHeader|PlotHistogram|"
                   r"(?:Selectable|MenuItem|TreeNode\w*)(?=\((?:\"|variable\.|commands\[|std::string\(factor))))\(")
# A number beside a label is drawn by fields.hpp, which chooses digits and place. One without a label has a text of known width.
LABELLED = re.compile(r"ImGui::(?:Slider(?:Float|Scalar)|Drag(?:Float|Int|Scalar))\d?N?\((?!\"##)|ImGui::ColorEdit\d\((?!\"##)")
TIP = re.compile(r"\btooltip\(")
# A block ends where its function does, or where a field follows.
END = re.compile(r"^}", re.MULTILINE)


def missing_in(source: str) -> list[int]:
    """Lines of fields that no tooltip follows before the next field. Two fields in one condition share a tooltip."""
    lines = []
    starts = [found.start() for found in FIELD.finditer(source)]
    for start, following in zip(starts, [*starts[1:], len(source)]):
        end = END.search(source, start)
        part = source[start:min(following, end.start() if end else len(source))]
        is_shared = ";" not in part  # cond ? ColorEdit4(...) : ColorEdit3(...)
        if not is_shared and not TIP.search(part):
            lines.append(source.count("\n", 0, start) + 1)
    return lines


def main() -> int:
    wrong = 'void f() {\n    if (ImGui::Button("a")) g();\n    ImGui::Checkbox("b", &b);\n    tooltip("of b");\n}\n'
    assert missing_in(wrong) == [2], "the rule does not see a button without a tooltip"
    assert not missing_in(wrong.replace("g();", 'g();\n    tooltip("of a");'))
    assert missing_in(wrong.replace("Button", "Selectable")) == [2], "the rule does not see a row without a tooltip"
    assert not missing_in(wrong.replace('Button("a")', "Selectable(name)")), "a row with a text of the file needs none"
    sources = [source for source in sorted(Path(sys.argv[1]).rglob("*.cpp")) if source.name != "fields.cpp"]
    assert LABELLED.search('ImGui::SliderFloat("a"') and not LABELLED.search('ImGui::SliderFloat("##a"')
    fields = sum(len(FIELD.findall(source.read_text())) for source in sources)
    assert fields > 60, f"only {fields} fields were found"
    missing = [f"{source}:{line}" for source in sources for line in missing_in(source.read_text())]
    for place in missing:
        print(f"{place}: a field without a tooltip that says its meaning and unit", file=sys.stderr)
    cut = [f"{source}:{source.read_text().count(chr(10), 0, found.start()) + 1}" for source in sources
           for found in LABELLED.finditer(source.read_text())]
    for place in cut:
        print(f"{place}: a number that may be cut: use number_field or color_field of fields.hpp", file=sys.stderr)
    return 1 if missing or cut else 0


if __name__ == "__main__":
    sys.exit(main())
