import copy

import pytest

import scanfuse


def test_options_are_attributes_with_docs_and_ranges():
    options = scanfuse.Options("road-users")
    options.track.max_gap_s = 1.25
    assert options.track.max_gap_s == 1.25
    assert "[" in type(options.track).max_gap_s.__doc__
    options.set("track.max_gap_s=2")
    assert options.track.max_gap_s == 2
    assert scanfuse.Options("road-users", set=["track.max_gap_s=3"]).track.max_gap_s == 3


def test_every_section_of_the_configuration_is_an_attribute():
    options = scanfuse.Options()
    for row in options.describe():
        value = getattr(getattr(options, row["section"]), row["name"])
        assert str(value).lower() == row["value"] or float(value) == float(row["value"])


def test_a_copy_is_another_object():
    options = scanfuse.Options()
    other = copy.deepcopy(options)
    other.segment.method = "euclidean"
    assert options.segment.method == "pag"


def test_typing_errors_name_the_nearest_option():
    options = scanfuse.Options()
    with pytest.raises(scanfuse.Error, match="max_gap_s"):
        options.track.max_gap = 1
    with pytest.raises(scanfuse.Error, match="max_gap_s"):
        options.set("track.max_gap=1")
    with pytest.raises(scanfuse.Error, match="outside"):
        options.track.max_gap_s = -1
    with pytest.raises(scanfuse.Error, match="none of"):
        options.segment.method = "magic"
    with pytest.raises(scanfuse.Error, match="road-users"):
        scanfuse.Options("rod-users")


def test_keywords_make_options():
    options = scanfuse.EvaluateOptions(match_m=3, similarity="bev_iou")
    assert (options.match_m, options.similarity) == (3, "bev_iou")
    assert "match_m=3" in repr(options)
