"""Deliberate bugs, one of which mutate.py puts into the sources at a time. Each text to replace occurs once in its file."""

from typing import NamedTuple


class Break(NamedTuple):
    file: str
    old: str
    new: str
    test: str  # which notices it: of the default set


BREAKS = [
    # core/base
    Break("core/base/file.cpp", "if (filled > most) refuse_length(path, most);", "",
          "ReadFile.TakesNoMoreFromAPipeThanItMay"),
    Break("core/base/file.cpp", "wait ? LOCK_EX : LOCK_EX | LOCK_NB", "wait ? LOCK_SH : LOCK_SH | LOCK_NB",
          "LockFile.HasOneOwner"),
    Break("core/base/lock_file.cpp", "if (!is_same_file(file, path)) {", "if (file < 0) {",
          "Archive.HasOneOwnerHoweverManyAsk"),
    Break("core/base/text.cpp", "host.rfind('@')", "host.find('@')",
          "ShownText.TellsNoSecrets"),
    Break("core/base/wall_clock.cpp", "best && !near && utc < *best", "best && !near && utc > *best",
          "LocalTime.OfAnHourThatComesTwiceIsTheFirstOrTheNearer"),
    # core/kernels
    Break("core/kernels/colour_rows.cpp", "luma[i] < 16 ? 0 : luma[i] - 16", "luma[i] < 16 ? 0 : luma[i] - 15",
          "FullRange.IsRoundedWhereverAPixelStands"),
    Break("core/kernels/colour_rows.cpp", "fixed(-2 * (1 - red) * red / green * stretch)", "fixed(-2 * (1 - red) * blue / green * stretch)",
          "ColourRows.AreTheStandardsMatrix"),
    # core/detector
    Break("core/detector/formats.cpp", "pixel(box.left, image.width), pixel(box.top, image.height)",
          "pixel(box.left, image.height), pixel(box.top, image.width)",
          "Letterbox.ReturnsBoxesToTheImage"),
    Break("core/detector/model_file.cpp", "listed > 0 ? listed == elements", "listed > 0 ? listed <= elements",
          "ModelFile.HasAsManyWeightsAsItsShapesSay"),
    # core/media
    Break("core/media/frame_sampler.cpp", "if (i->is_key && first >= i->stamp)", "if (i->is_key)",
          "Sample.HasTheFramesThatThePassHas"),
    Break("core/media/frame_span.cpp", "pts >= *span.end - time_tolerance", "pts >= *span.end + time_tolerance",
          "FrameSpan.ToleratesTimesThatWereRounded"),
    Break("core/media/frame_span.cpp", "day_at(clock, begin) - 1; date", "day_at(clock, begin); date",
          "Between.IsAPartOfEachDay"),
    Break("core/media/crop.cpp", "(box.left + place.left) * ratio.x", "(box.left - place.left) * ratio.x",
          "Crop.FollowsAnAlignedFrame"),
    Break("core/media/picture_source.cpp", "++damaged_;", "",
          "Pictures.ThoseThatDoNotDecodeAreCounted"),
    Break("core/media/packet_range.cpp", "if (packets[k].key && packets[k].stamp <= wanted) first = k;", "if (packets[k].key) first = k;",
          "cli/test_cut.py::test_cut_of_groups_that_lean_on_the_one_before"),
    Break("core/footage/name_expression.cpp", "return west ? -ahead : ahead;", "return west ? ahead : -ahead;",
          "RecorderNames.OfKnownRecordersTellCameraAndTime"),
    # core/fields
    Break("core/fields/seeds.cpp", "std::min(then + 1, most)", "then + 1 + 0 * most",
          "Age.StaysAtItsMaximum"),
    Break("core/fields/region.cpp", "p = p >= 128 ? 255 : 0", "p = p > 128 ? 255 : 0",
          "cli/test_region_editor.py::test_a_picture_is_an_area_where_it_is_128_or_brighter"),
    Break("core/fields/blobs.cpp", "merge_neighbours(gaps, 0);", "merge_neighbours(gaps, 1);",
          "Blobs.HolesAreFilledAndBaysAreNot"),
    Break("core/fields/shadows.cpp", "shares.least > thresholds.shadow.darkest && shares.most < 1", "shares.least > thresholds.shadow.darkest && shares.most < 2",
          "Shadows.AreNotObjectsAndDarkThingsAre"),
    Break("core/fields/shadows.cpp", "!has_colours(frame.colour) || !has_colours(empty.colour)", "frame.colour.empty() || empty.colour.empty()",
          "Shadows.AreUnknownWhereNothingHasAColour"),
    Break("core/fields/field_stages.cpp", "(scene.infrared == infrared ? 1 : 0)", "(scene.infrared == infrared ? 0 : 1)",
          "Dusk.EachModeHasItsEmptyScene"),
    Break("core/tracking/event.cpp", "if (!lies || ", "if (lies || ",
          "Events.AreBusyWhereTheyMove"),
    Break("core/fields/frame_files.cpp", "last() < frames", "last() <= frames",
          "FrameFiles.HaveTheNumbersOfTheirNames"),
    Break("core/fields/seed_list.cpp", "rounding * (1 + std::abs(a))", "(1 + std::abs(a))",
          "Seeds.FitTheFlowThatTheyHave"),
    # core/tracking
    Break("core/tracking/association.cpp", "if (*most < thresholds.association.shared_part * tracks", "if (*most > thresholds.association.shared_part * tracks",
          "Associate.LetsTwoShareABlob"),
    Break("core/tracking/tracklet.cpp", "kind == EventKind::taken ? bearer.begin : bearer.end",
          "kind == EventKind::taken ? bearer.end : bearer.begin",
          "EventFinder.WhoStoodThereFromTheFirstFrameMayLeaveAThing"),
    Break("core/tracking/conclude.cpp", "span_.stretches[k - 1].view == stretch_of(tracklet).view", "k > 0",
          "Infrared.AGhostAtTheChangeIsAThingPutDownLater"),
    Break("core/tracking/identify.cpp", "*other = places[**other];", "*other = order[**other];",
          "Claims.OfAPersonInTheEmptySceneAreOfWhoStoodThere"),
    Break("core/tracking/path.cpp", "other.last.frame >= stay.first.frame;", "other.last.frame > stay.last.frame;",
          "Stays.ThatAreKnownExactlyReplaceThoseTheyMeet"),
    Break("core/tracking/track.cpp", "(std::ssize(moments) - 1) * 9 / 10", "(std::ssize(moments) - 1) * 1 / 10",
          "EventFinder.ABoxBeginsWhenItIsPutDownAndEndsWhenItIsTaken"),
    Break("core/tracking/tracklet.cpp", "if (end.at_border && !touches_border(place, field)) return true;", "static_cast<void>(field);",
          "EventFinder.WhoLeavesThePictureIsNotTheThingThatStays"),
    Break("core/tracking/track.cpp", "!settled || !is_unchanged(", "!settled || is_unchanged(",
          "EventFinder.ABagThatWasHiddenForAnInstantIsTheSameBag"),
    # core/space
    Break("core/space/camera.cpp", "std::max({x.half() / tan_x, y.half() / tan_y, 1e-9 - z.low})", "std::max({x.half() / tan_x, 1e-9 - z.low})",
          "FitCamera.HoldsEveryPointAndTouchesTheMargins"),
    Break("core/space/horseshoe.cpp", "if (before_open_side) std::ranges::reverse(order);", "",
          "EveryLayout.DrawsFartherSectionsFirst"),
    # core/volume
    Break("core/volume/brick.cpp", "if (at > 0) owners.spread(layers_[at - 1]->owner);", "",
          "BrickLayers.GiveAnOwnerItsNeighboursInTimeToo"),
    Break("core/volume/brick.cpp", "if (layer <= rest.first || layer", "if (layer < rest.first || layer",
          "Cut.AtLayersLeavesNoBrickEmpty"),
    # core/scene
    Break("core/scene/slices.cpp", "found == 2 && places[0] > places[1]", "found == 2 && places[0] < places[1]",
          "EveryView.AgreesWithTheRayCaster"),
    Break("core/scene/transfer_function.cpp", "values[0] <= points.back().value", "values[0] < points.back().value",
          "TransferFile.SaysWhichLineIsWrong"),
    # core/image
    Break("core/base/atomic_file.cpp", "if (error != EWOULDBLOCK && sure && is_same_file(file, path))", "if (sure && is_same_file(file, path))",
          "ImageTest.RemovesWhatAKilledProgramLeft"),
    Break("core/image/comparison.cpp", "constexpr int stride = patch_size / 2;", "constexpr int stride = patch_size;",
          "Compare.APatchThatChangedIsSeenWhereverItIs"),
    # core/annotation
    Break("core/annotation/time_ticks.cpp", "intervals.back().half_open = true;", "",
          "TimeTicks.GoOnAcrossSummerTimeAndMidnight"),
    # core/annotation
    Break("core/annotation/time_strip.cpp", "until = std::max(until, period.end);", "until = period.end;",
          "IdlePeriods.AreTheRestOfTheClip"),
    Break("core/annotation/crops.cpp", "crops_.size() > max_crops || bytes_ > max_bytes", "crops_.size() > max_crops && bytes_ > max_bytes",
          "Crops.TakeNoMoreMemoryForMoreTracks"),
    Break("core/annotation/objects.cpp", "!row_of(events[k].kind).is_thing, -weight_of", "row_of(events[k].kind).is_thing, -weight_of",
          "MostTelling.WhatWasLeftOrTakenThenTheLongest"),
    Break("core/annotation/objects.cpp", "length > 0 ? (seconds - before.at.seconds) / length", "length > 0 ? (after->at.seconds - seconds) / length",
          "PlaceAt.IsOnThePath"),
    # core/dataset
    Break("core/dataset/manifest.cpp", "frame.pts < frames.back().pts", "frame.pts < frames.front().pts",
          "ManifestText.HasNoValueThatCannotBe"),
    Break("core/dataset/data_folder.cpp", "lock_.emplace(lock_folder(folder_));", "",
          "Store.IsWrittenByOneAtATime"),
    # core/page
    Break("core/page/preview.cpp", "if (taken_ > 0) tick = std::max(tick, last_tick_ + 1);", "",
          "Preview.TakesFramesOfOneTime"),
    # core/archive
    Break("core/archive/prune.cpp", "::lstat(path.c_str(), &status) != 0 && (errno == ENOENT || errno == ENOTDIR)", "::lstat(path.c_str(), &status) != 0",
          "Gone.IsOnlyWhatIsCertainlyNotThere"),
    # gl
    Break("gl/framebuffer.cpp", "std::min(left + width, picture.width)", "left + width",
          "Tiles.CoverEachPixelOnce"),
    Break("gl/brick_window.cpp", "return same_before && same_after ?", "return same_before || same_after ?",
          "MovingWindow.LooksOnlyAtTheEndsOfABrickThatIsThere"),
    # cli
    Break("cli/plan/make_plan.cpp", "while (extent.frames > bricks.max_layers * extent.step) extent.step *= 2;", "",
          "LayersOfAPlan.FollowFromHeaderAndSettings"),
    Break("cli/compose/compose.cpp", "volume::cut_at(composed.bricks, layers)", "composed.bricks",
          "ComposedPieces.EndAtBricksAndKeyFrames"),
    Break("cli/observe/window.cpp", "key.number -= plan_.volume.window.brick_frames();", "key.number += plan_.volume.window.brick_frames();",
          "cli/test_annotations.py::test_keyframes_of_a_series_stand_in_each_brick"),
    Break("cli/excerpt/footage.cpp", "part.span.start = std::max(0.0, from - file.begin);", "part.span.start = std::max(0.0, file.begin - from);",
          "cli/test_cut_recording.py::test_cut_joins_the_files_of_a_recording"),
    Break("cli/options/parse_value.cpp", "(!last && *value != std::floor(*value))", "(last && *value != std::floor(*value))",
          "ParseTime.RefusesEverythingElse"),
    Break("cli/workers/worker_message.cpp", "if (message.warnings.size() == most_warnings) break;", "",
          "WorkerMessage.HasNoMoreWarningsThanItMay"),
]
