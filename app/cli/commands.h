// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace isoscope::cli {

class CommandLine;

/// Each adds one subcommand.
void addEvaluateCommand(CommandLine& line);
void addTraceCommand(CommandLine& line);
void addInsideCommand(CommandLine& line);
void addRenderCommand(CommandLine& line);
void addFramesCommand(CommandLine& line);
void addCheckCommand(CommandLine& line);
void addExportCommand(CommandLine& line);
void addMeshCommand(CommandLine& line);
void addRootsCommand(CommandLine& line);
void addPolynomialCommand(CommandLine& line);
void addFunctionsCommand(CommandLine& line);
void addGradientCommand(CommandLine& line);
void addAccuracyCommand(CommandLine& line);
void addPredictCommand(CommandLine& line);
void addContainerCommand(CommandLine& line);
void addThresholdsCommand(CommandLine& line);
void addCompareCommand(CommandLine& line);
void addRangesCommand(CommandLine& line);
void addSweepCommand(CommandLine& line);
void addSheetCommand(CommandLine& line);
void addReportCommand(CommandLine& line);
void addHealthCommand(CommandLine& line);
void addRewritesCommand(CommandLine& line);
void addDerivativeCommand(CommandLine& line);
void addDifferenceCommand(CommandLine& line);
void addEvaluateAdviceCommand(CommandLine& line);

}  // namespace isoscope::cli
