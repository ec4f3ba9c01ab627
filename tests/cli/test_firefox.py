"""The pages in Firefox: what people mostly do. The tests are those that Chromium runs."""

import pytest
import test_index_views
import test_page
import test_page_asking
import test_page_heading
import test_page_player

pytestmark = pytest.mark.browser

TESTS = (
    test_page.test_page_plays_the_clip,
    test_page.test_page_points_at_moments,
    test_page.test_page_shows_a_preview_of_what_browsers_cannot_play,
    test_page.test_page_of_a_clip_that_has_gone,
    test_page.test_page_steps_through_events,
    test_page_asking.test_page_lists_what_crossed_a_line,
    test_page_heading.test_page_heading_of_a_clip_in_an_archive,
    test_page_player.test_page_space_is_play_and_pause_whatever_was_clicked,
    test_page_player.test_page_keys_of_players,
    test_page_player.test_page_strip_scrubs_zooms_and_has_keys,
    test_index_views.test_index_card_shows_each_event,
    test_index_views.test_index_leads_from_clip_to_clip,
)


@pytest.mark.parametrize("test", TESTS, ids=lambda test: test.__name__)
def test_in_firefox(t, test, monkeypatch):
    monkeypatch.setenv("VVR_BROWSER", "firefox")
    test(t)
