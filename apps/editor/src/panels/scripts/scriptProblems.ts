import { t } from '@farol/editing';
import type { DocumentScripts } from '../../model/DocumentScripts';
import type { ScriptDiagnostic } from '../../scripts/language/LanguageAnswers';

/** A problem of a script, from TypeScript, the compiler or a run. */
export type ScriptProblem = Pick<ScriptDiagnostic, 'message' | 'line' | 'severity'> &
  Partial<Pick<ScriptDiagnostic, 'from' | 'to'>>;

/**
 * Problems of a script: errors that it threw while the scene played, compile errors, and TypeScript's diagnostics.
 * Duplicates in a line are left out.
 */
export function problemsOf(
  name: string,
  scripts: Pick<DocumentScripts, 'errors' | 'failures'>,
  found: readonly ScriptDiagnostic[],
): readonly ScriptProblem[] {
  const problems: ScriptProblem[] = [];
  const failure = scripts.failures.get(name);
  if (failure) {
    const { line, component, object, message } = failure;
    const words = { component, object, reason: message };
    problems.push({ line, severity: 'error', message: t('{component} of {object} threw: {reason}', words) });
  }
  const error = scripts.errors.get(name);
  // for syntax errors only TypeScript's message is shown, which is clearer
  const isTold = found.some(({ kind, line }) => kind === 'syntax' || line === error?.line);
  if (error && !isTold) problems.push({ line: error.line, severity: 'error', message: error.problem });
  return [...problems, ...found];
}
