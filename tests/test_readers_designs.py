"""CSV files of designs: blocks of any number, everything kept as written, one line for each mistake."""

import pytest

from chainrule.errors import DescriptionError
from chainrule.readers import designs
from chainrule.readers.designs import read_designs


def blocks(tmp_path, text):
    path = tmp_path / "designs.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return list(read_designs(path))


def test_columns_in_any_order_among_others(tmp_path):
    (block,) = blocks(tmp_path, "name,R2,d4,d3,d2\nfish, 1.50 ,2,3e0,1\n\n")
    assert block.header == ("name", "R2", "d4", "d3", "d2")
    assert block.cells == (("fish", "1.50", "2", "3e0", "1"),)
    assert block.lengths == (("1", "3e0", "2", "1.50"),)


def test_blocks_of_a_long_file(tmp_path, monkeypatch):
    monkeypatch.setattr(designs, "BLOCK", 7)
    text = "d2,d3,d4,r2\n" + "".join(f"1,{k},2,3\n" for k in range(21))
    found = blocks(tmp_path, text)
    assert [len(block.cells) for block in found] == [7, 7, 7]
    assert [row[1] for block in found for row in block.lengths] == [str(k) for k in range(21)]
    assert [len(block.cells) for block in blocks(tmp_path, text + "1,1,1,1\n")] == [7, 7, 7, 1]


def test_no_designs_is_one_empty_block(tmp_path):
    (block,) = blocks(tmp_path, "d2,d3,d4,r2\r\n")
    assert block.cells == ()


def test_it_is_read_as_it_is_asked_for(tmp_path, monkeypatch):
    monkeypatch.setattr(designs, "BLOCK", 1)
    path = tmp_path / "designs.csv"
    path.write_text("d2,d3,d4,r2\n1,2,3,4\n1,2,3,x\n")
    reading = read_designs(path)
    assert next(reading).lengths == (("1", "2", "3", "4"),)
    with pytest.raises(DescriptionError, match="row 3, r2: 'x' is not a decimal number"):
        next(reading)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no rows"),
        ("d2,d3,d4\n1,2,3\n", "none of the columns is named r2"),
        ("d2,d3,d4,r2,D2\n", "more than one of the columns is named d2"),
        ("1,2,3,4\n", "row 1: none of the columns is named d2"),
        ("d2,d3,d4,r2\n1,2,3\n", "row 2: 3 entries; 4 are accepted"),
        ("d2,d3,d4,r2\n1,2,3,4,5\n", "row 2: 5 entries"),
        ("d2,d3,d4,r2\n1,nan,3,4\n", "row 2, d3: 'nan' is not a decimal number"),
        ("d2,d3,d4,r2\n1,1/2,3,4\n", "row 2, d3: '1/2'"),
        ("d2,d3,d4,r2\n1,1_0,3,4\n", "row 2, d3: '1_0'"),
        ("d2,d3,d4,r2\n1,1e9999,3,4\n", "row 2, d3: '1e9999'"),
        ("d2,d3,d4,r2\n1,,3,4\n", "row 2, d3: ''"),
        ("d2,d3,d4,r2\n1," + "1" * 500 + ",3,4\n", "is not a decimal number"),
        ('d2,d3,d4,r2\n1,"2,3,4\n', "row 2: not CSV that is accepted"),
        (b"d2,d3,d4,r2\n1,\xff,3,4\n", "not UTF-8 text"),
        ("d2,d3,d4,r2" + ",x" * 300 + "\n", "304 columns"),
    ],
)
def test_refused_in_one_line(tmp_path, text, message):
    with pytest.raises(DescriptionError) as caught:
        blocks(tmp_path, text)
    assert message in str(caught.value)
    assert "designs.csv: " in str(caught.value)
    assert "\n" not in str(caught.value)


def test_no_file(tmp_path):
    with pytest.raises(DescriptionError, match="cannot be read"):
        next(read_designs(tmp_path / "none.csv"))
