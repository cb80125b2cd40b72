// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The statements that describe themselves, a row each: `statements::NAME` stands in the source of its parser
/// (statement_description.h). Camera, light sources, background, objects and `default` are read by
/// SceneParser.
#define ISOSCOPE_STATEMENTS(row) row(skySphere) row(fog) row(media) row(rainbow) row(globalSettings)
